#include "coverage_text.hpp"
#include "io/text.hpp"

#include <fmt/format.h>

namespace taut::cli {

std::string coverage_text(const Coverage& c) {
  if (c.pairs == 1 && c.untested() == 0) return "";
  std::string text = fmt::format("  {}: {} tested", internal::io::counted(c.pairs, "pair"), c.tested);
  if (c.apart > 0) text += fmt::format(", {} apart by their boxes", c.apart);
  std::string left_out;
  const auto add = [&](std::uint64_t count, const char* what) {
    if (count > 0) left_out += fmt::format("{}{} {}", left_out.empty() ? "" : ", ", count, what);
  };
  add(c.ignored, "ignored");
  add(c.layers, "on different layers");
  add(c.at_rest, "at rest");
  add(c.moving_alike, "moving alike");
  add(c.not_reached, "not reached");
  if (left_out.empty()) return text + "\n";
  const char* const hint = c.at_rest + c.moving_alike > 0 ? " (--at-rest test)" : "";
  return text + "; NOT TESTED: " + left_out + hint + "\n";
}

}  // namespace taut::cli
