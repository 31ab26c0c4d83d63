#include "junit_report.hpp"

#include <fmt/format.h>

#include "draw/svg_canvas.hpp"
#include "io/text.hpp"

namespace taut::cli {
using internal::io::escape_xml;

namespace {

std::string case_tag(const std::string& scene, double seconds) {
  const std::string name = escape_xml(internal::io::line_for_terminal(scene));
  return fmt::format("    <testcase classname=\"taut.check\" name=\"{}\" time=\"{:.6f}\">\n", name, seconds);
}

/// `kind` is what outcomes and errors are called in answers.
std::string result_tag(const char* tag, const std::string& kind, const std::string& words) {
  return fmt::format("      <{0} type=\"{1}\" message=\"{2}\">{3}</{0}>\n", tag, kind,
                     escape_xml(words.substr(0, words.find('\n'))), escape_xml(words));
}

const char* const case_end = "    </testcase>\n";

JunitVerdict verdict_on(Outcome outcome, bool allow_untested) {
  switch (outcome) {
    case Outcome::free:
      return JunitVerdict::passed;
    case Outcome::contact:
    case Outcome::overlap_at_start:
    case Outcome::closer_at_start:
      return JunitVerdict::failed;
    case Outcome::untested:
      return allow_untested ? JunitVerdict::skipped : JunitVerdict::error;
    case Outcome::undecided:
    case Outcome::locked:
      break;
  }
  return JunitVerdict::error;
}

}  // namespace

JunitCase junit_case(const std::string& scene, Outcome outcome, bool allow_untested, const std::string& words,
                     double seconds) {
  const JunitVerdict verdict = verdict_on(outcome, allow_untested);
  std::string result;
  if (verdict == JunitVerdict::failed) result = result_tag("failure", to_string(outcome), words);
  if (verdict == JunitVerdict::error) result = result_tag("error", to_string(outcome), words);
  if (verdict == JunitVerdict::skipped)
    result = fmt::format("      <skipped message=\"{}\"/>\n", escape_xml(words.substr(0, words.find('\n'))));
  if (verdict == JunitVerdict::passed) result = fmt::format("      <system-out>{}</system-out>\n", escape_xml(words));
  return {verdict, seconds, case_tag(scene, seconds) + result + case_end};
}

JunitCase junit_error(const std::string& scene, const std::string& kind, const std::string& words, double seconds) {
  return {JunitVerdict::error, seconds, case_tag(scene, seconds) + result_tag("error", kind, words) + case_end};
}

void JunitReport::add(const JunitCase& scene) {
  ++counts_[static_cast<std::size_t>(scene.verdict)];
  seconds_ += scene.seconds;
  cases_ += scene.xml;
}

std::string JunitReport::text() const {
  const auto count = [this](JunitVerdict verdict) { return counts_[static_cast<std::size_t>(verdict)]; };
  const std::size_t failed = count(JunitVerdict::failed), errors = count(JunitVerdict::error),
                    skipped = count(JunitVerdict::skipped);
  const std::size_t all = count(JunitVerdict::passed) + failed + errors + skipped;
  const std::string numbers =
      fmt::format("name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\"", escape_xml(suite_), all, failed, errors);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {0} time=\"{2:.6f}\">\n"
      "  <testsuite {0} skipped=\"{1}\" time=\"{2:.6f}\">\n{3}  </testsuite>\n</testsuites>\n",
      numbers, skipped, seconds_, cases_);
}

}  // namespace taut::cli
