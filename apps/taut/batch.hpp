// Many tasks on several threads, with results in the tasks' order.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "junit_report.hpp"

namespace taut::cli {

/// A scene to be read: a file, or a text that came from somewhere.
struct BatchTask {
  std::string place;  ///< what the scene is called in messages
  std::optional<std::string> text;
};

/// What becomes of it.
struct BatchResult {
  std::string out, err;  ///< for standard output and standard error
  int code = 0;
  JunitCase test;  ///< for a report, if one was asked for
};

/// Takes tasks from `next` until there are none, works on them in `threads` threads, and hands the results to `emit` in
/// the order of the tasks: what is printed does not depend on the threads. `next` and `emit` are called by one thread
/// at a time, `work` by several; none of them may throw. At most `ahead` tasks for each thread are read before their
/// turn.
void run_batch(unsigned threads, const std::function<std::optional<BatchTask>()>& next,
               const std::function<BatchResult(const BatchTask&)>& work,
               const std::function<void(const BatchResult&)>& emit);

}  // namespace taut::cli
