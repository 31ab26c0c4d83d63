#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace taut::cli {

Progress::Progress(const Scene& scene)
    : start_(scene.start),
      end_(scene.end),
      terminal_(isatty(STDERR_FILENO) != 0),
      next_(Clock::now() + std::chrono::seconds(1)) {}

Progress::~Progress() { clear(); }

void Progress::on_event(const TraceEvent& event) {
  // Asking the clock at every event would cost more than most events.
  if (!terminal_ || event.number % 64 != 0) return;
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(200);
  const double share = end_ > start_ ? (event.lo - start_) / (end_ - start_) : 1;
  fmt::print(stderr, "\r{:3.0f}%  t = {:.6g}  {} events \x1b[K", 100 * share, event.lo, event.number);
  std::fflush(stderr);
  shown_ = true;
}

void Progress::clear() {
  if (shown_) fmt::print(stderr, "\r\x1b[K");
  shown_ = false;
}

}  // namespace taut::cli
