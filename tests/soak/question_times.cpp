#include "question_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "taut/check.hpp"
#include "taut/error.hpp"

namespace taut::testing {
namespace {

/// Processor time of this thread.
double now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Asked {
  Outcome outcome;
  double seconds;
};

Asked ask(const Scene& scene, const CheckOptions& options) {
  const double start = now();
  const Outcome outcome = check(scene, options).outcome;
  return {outcome, now() - start};
}

void append(std::vector<std::string>& to, const std::vector<std::string>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

void QuestionTimes::ask_all(std::uint64_t number, const Scene& scene) {
  CheckOptions options;
  for (const Touch touch : {Touch::open, Touch::closed}) {
    for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime, EngineChoice::either}) {
      options.touch = touch;
      options.engine = engine;
      try {
        Asked asked = ask(scene, options);
        // What else the machine does makes one slower now and then, never faster.
        for (int again = 0; again < 4 && asked.seconds > limit_ / 2; ++again) {
          asked.seconds = std::min(asked.seconds, ask(scene, options).seconds);
        }
        const std::string question =
            fmt::format("{} {} {}: {:.1f} ms", number, to_string(engine), to_string(touch), 1e3 * asked.seconds);
        ++questions_;
        sum_ += asked.seconds;
        if (asked.seconds > most_) slowest_ = question;
        most_ = std::max(most_, asked.seconds);
        if (asked.seconds > limit_) slow_.push_back(question);
        if (asked.outcome == Outcome::undecided) undecided_.push_back(question);
      } catch (const InputError&) {
        ++invalid_;
        return;
      }
    }
  }
}

QuestionTimes& QuestionTimes::operator+=(const QuestionTimes& o) {
  questions_ += o.questions_;
  invalid_ += o.invalid_;
  sum_ += o.sum_;
  if (o.most_ > most_) slowest_ = o.slowest_;
  most_ = std::max(most_, o.most_);
  append(slow_, o.slow_);
  append(undecided_, o.undecided_);
  return *this;
}

std::string QuestionTimes::report() const {
  std::string text =
      fmt::format("{} questions, {:.2f} ms on average, {:.1f} ms at most ({}), {} scenes not valid\n", questions_,
                  questions_ > 0 ? 1e3 * sum_ / static_cast<double>(questions_) : 0, 1e3 * most_, slowest_, invalid_);
  for (const std::string& question : slow_) text += fmt::format("slow: {}\n", question);
  for (const std::string& question : undecided_) text += fmt::format("undecided: {}\n", question);
  return text;
}

}  // namespace taut::testing
