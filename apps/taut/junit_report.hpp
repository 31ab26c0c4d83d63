// Answers about scenes as a JUnit report, which CI servers read.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "taut/check.hpp"

namespace taut::cli {

/// What an answer is in a report: `free` passes, a contact fails, and what is not decided, or not read, is an error.
/// Skipped is what was not tested where that is allowed.
enum class JunitVerdict { passed, failed, error, skipped };

/// One scene of a report.
struct JunitCase {
  JunitVerdict verdict = JunitVerdict::passed;
  double seconds = 0;
  std::string xml;
};

/// `scene`: what it is called in answers; `words`: the answer in words, whose first line becomes the message.
JunitCase junit_case(const std::string& scene, Outcome outcome, bool allow_untested, const std::string& words,
                     double seconds);
/// The same where there is no answer; `kind` is "bad_input" or "internal".
JunitCase junit_error(const std::string& scene, const std::string& kind, const std::string& words, double seconds);

/// Collects cases in the order in which they come.
class JunitReport {
 public:
  /// `suite`: what all scenes were asked.
  explicit JunitReport(std::string suite) : suite_(std::move(suite)) {}

  void add(const JunitCase& scene);
  /// The file's content: valid XML, whatever scenes and bodies are called. Times of cases are sums over all threads.
  std::string text() const;

 private:
  std::string suite_, cases_;
  std::size_t counts_[4] = {};
  double seconds_ = 0;
};

}  // namespace taut::cli
