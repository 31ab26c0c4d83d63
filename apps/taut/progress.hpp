// A line on the terminal while a long run goes on.
#pragma once

#include <chrono>
#include <cstdint>

#include "taut/scene.hpp"
#include "taut/tracer.hpp"

namespace taut::cli {

/// Shows events and time on stderr, only if that is a terminal and the run takes longer than a second.
class Progress : public Tracer {
 public:
  explicit Progress(const Scene& scene);
  ~Progress() override;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void on_event(const TraceEvent& event) override;
  /// Wipes the line, before anything else is printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  double start_, end_;
  bool terminal_, shown_ = false;
  Clock::time_point next_;
};

}  // namespace taut::cli
