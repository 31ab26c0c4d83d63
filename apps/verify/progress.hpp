// A line on the terminal while a long question goes on.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

#include "numeric/budget.hpp"
#include "taut/scene.hpp"

namespace taut::cli {
using namespace internal;

/// While it lives, a line on stderr says what its meter does: only if stderr is a terminal, and once a second has
/// passed. The line is wiped at the end.
class ProgressLine {
 public:
  /// `scene`: whose time the meter's is; may be null.
  explicit ProgressLine(const Scene* scene = nullptr);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  ProgressMeter& meter() { return meter_; }

 private:
  void show();

  ProgressMeter meter_;
  double start_ = 0, end_ = 0;  ///< of the scene's time; equal if there is none
  std::mutex mutex_;
  std::condition_variable ended_;
  bool over_ = false;
  std::thread thread_;
};

/// Such a line about this thread's question.
class Progress {
 public:
  Progress() : scope_(line_.meter()) {}
  /// Of a question about the scene's time.
  explicit Progress(const Scene& scene) : line_(&scene), scope_(line_.meter()) {}

 private:
  ProgressLine line_;
  ProgressScope scope_;
};

/// What the line says after so many seconds, at most `width` characters.
std::string progress_line(const ProgressMeter& meter, double start, double end, double seconds, std::size_t width);

}  // namespace taut::cli
