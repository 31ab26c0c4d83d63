#include "progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "io/platform.hpp"

namespace taut::cli {
namespace {

using ProgressClock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds silent{1000}, between_lines{200};

/// "1,234,567"
std::string grouped(std::uint64_t n) {
  std::string s = std::to_string(n);
  for (std::size_t i = s.size(); i > 3;) s.insert(i -= 3, ",");
  return s;
}

/// "75 s", "12 min" or "3.5 h"
std::string duration(double seconds) {
  if (seconds < 600) return fmt::format("{:.0f} s", std::floor(seconds));
  return seconds < 36000 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.1f} h", seconds / 3600);
}

std::string bar(double share) {
  constexpr int width = 24;
  std::string s(width, ' ');
  std::fill_n(s.begin(), static_cast<int>(share * width), '=');
  return "[" + s + "]";
}

}  // namespace

std::string progress_line(const ProgressMeter& meter, double start, double end, double seconds, std::size_t width) {
  const char* const kind = meter.kind.load();
  const std::uint64_t done = meter.done.load(), all = meter.all.load();
  const double t = meter.time.load();
  double share = meter.share.load();
  const bool in_time = end > start && t > start;
  if (share < 0 && in_time) share = (t - start) / (end - start);
  if (share < 0 && all > 0) share = static_cast<double>(done) / static_cast<double>(all);
  std::string s;
  if (share >= 0) {
    share = std::min(share, 1.0);
    s = fmt::format("{:3.0f}%  {}  ", std::floor(100 * share), bar(share));
  }
  if (in_time) s += fmt::format("up to t = {:.6g}, ", t);
  if (kind) s += grouped(done) + (all > 0 ? " of " + grouped(all) : "") + " " + kind + ", ";
  s += duration(seconds);
  const double left = meter.seconds_left.load();
  if (left >= 1) s += fmt::format(", about {} left", duration(left));
  return s.substr(0, width);
}

ProgressLine::ProgressLine(const Scene* scene) {
  if (!internal::io::is_terminal(stderr)) return;
  if (scene) {
    start_ = scene->start;
    end_ = scene->end;
  }
  thread_ = std::thread([this] { show(); });
}

ProgressLine::~ProgressLine() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  ended_.notify_one();
  thread_.join();
}

void ProgressLine::show() {
  const ProgressClock::time_point began = ProgressClock::now();
  std::unique_lock lock(mutex_);
  bool shown = false;
  for (auto next = began + silent; !ended_.wait_until(lock, next, [this] { return over_; }); next += between_lines) {
    const std::chrono::duration<double> spent = ProgressClock::now() - began;
    fmt::print(stderr, "\r{}\x1b[K",
               progress_line(meter_, start_, end_, spent.count(), internal::io::terminal_width() - 1));
    std::fflush(stderr);
    shown = true;
  }
  if (!shown) return;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
}

}  // namespace taut::cli
