// What the npm package calls: a question about a scene, as JSON text in and out, and proof logs as bytes.
#include <emscripten.h>

#include <chrono>
#include <functional>
#include <string>

#include "numeric/budget.hpp"
#include "replies.hpp"
#include "taut/ask.hpp"

/// Calls the module's onProgress: an object of what is known.
EM_JS(void, taut_progress, (const char* kind, double done, double all, double share, double time), {
  const progress = {};
  if (kind) Object.assign(progress, {kind : UTF8ToString(kind), done});
  if (kind && all > 0) progress.all = all;
  if (share >= 0) progress.share = share;
  if (time > -Infinity) progress.time = time;
  if (Module["onProgress"] && Object.keys(progress).length > 0) Module["onProgress"](progress);
});

namespace taut::web {
using namespace internal;
namespace {

std::string proof_log;

/// While it lives, checkpoints say how far the question is, ten times a second at most.
class Watch {
 public:
  using Clock = std::chrono::steady_clock;

  void look() {
    if (Clock::now() < next_) return;
    next_ = Clock::now() + std::chrono::milliseconds(100);
    taut_progress(meter_.kind, static_cast<double>(meter_.done), static_cast<double>(meter_.all), meter_.share,
                  meter_.time);
  }

 private:
  ProgressMeter meter_;
  ProgressScope scope_{meter_};
  Clock::time_point next_ = Clock::now() + std::chrono::milliseconds(100);
  std::function<void()> look_ = [this] { look(); };
  Budget budget_{look_};
};

bool watched = false;

Reply watched_reply(const Question& asked, const char* scene) {
  if (!watched) return ask_about_text(asked, scene);
  const Watch watch;
  return ask_about_text(asked, scene);
}

}  // namespace
}  // namespace taut::web

using namespace taut;
using namespace taut::web;

extern "C" {

/// The answer to a question as JSON, valid until the next call.
EMSCRIPTEN_KEEPALIVE const char* taut_ask(const char* question, const char* scene, const char* options, const char* log,
                                          int log_size) {
  proof_log.clear();
  return replied([&] {
    const Question asked{question, options, std::string(log, static_cast<std::size_t>(log_size))};
    Reply reply = watched_reply(asked, scene);
    proof_log = std::move(reply.log);
    return reply.json;
  });
}

/// Whether the next questions say how far they are.
EMSCRIPTEN_KEEPALIVE void taut_watch(int on) { watched = on != 0; }

/// question_descriptions(), valid until the next call: the package's functions and types are made from it.
EMSCRIPTEN_KEEPALIVE const char* taut_questions() { return kept(question_descriptions()); }

/// The log of the last question, if that writes one.
EMSCRIPTEN_KEEPALIVE const char* taut_log() { return proof_log.data(); }
EMSCRIPTEN_KEEPALIVE int taut_log_size() { return static_cast<int>(proof_log.size()); }

}  // extern "C"
