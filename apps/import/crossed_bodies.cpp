// Of BodyMaker: closed contours that cross each other.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "import/bodies.hpp"
#include "import/body_text.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

std::string with_others(std::size_t n) {
  return n < 2 ? "" : fmt::format("; {} {}, too", n - 1, n == 2 ? "other pair crosses" : "other pairs cross");
}

/// Of contours that are alike, nobody can say which is the smaller one.
bool is_alike(const ContourCrossing& crossing) {
  constexpr double rounding = 1e-9;
  return crossing.larger_area - crossing.smaller_area <= rounding * crossing.larger_area;
}

const char* consequence_of(Crossing crossing) {
  switch (crossing) {
    case Crossing::unite:
      return "contours that cross are one part (--crossing union)";
    case Crossing::subtract:
      return "the smaller one is taken out of the larger one (--crossing subtract)";
    default:
      return "they divide each other into parts (--crossing parts)";
  }
}

}  // namespace

/// A slot that is drawn across the edge of a plate is to be cut out of it, a tab is to be a part of it. Holes that
/// cross are one hole in any case.
void BodyMaker::take_crossed(const Outlines& outlines, const std::vector<Chain>& chains) {
  for (const bool hole : {true, false}) {
    const auto counts = [&](const ContourCrossing& crossing) { return crossing.hole == hole; };
    const auto n = static_cast<std::size_t>(std::count_if(outlines.crossed.begin(), outlines.crossed.end(), counts));
    if (n == 0) continue;
    const auto place = [&](const ContourCrossing& crossing) {
      return std::pair(chains[crossing.smaller].place, chains[crossing.larger].place);
    };
    const ContourCrossing* first = nullptr;
    for (const ContourCrossing& crossing : outlines.crossed) {
      if (!counts(crossing)) continue;
      const bool worse = first && is_alike(crossing) && !is_alike(*first);
      if (!first || worse || (is_alike(crossing) == is_alike(*first) && place(crossing) < place(*first)))
        first = &crossing;
    }
    const std::string what = fmt::format(
        "the closed contour at {} (area {:.6g}) crosses that at {} (area {:.6g}) near {}, with {:.6g} in common{}",
        chains[first->smaller].place, first->smaller_area, chains[first->larger].place, first->larger_area,
        point_text(first->at), first->common_area, with_others(n));
    if (hole)
      file_.notes.push_back(what + ": contours that cross in material are one hole");
    else if (settings_.crossing == Crossing::subtract && is_alike(*first))
      fail(chains[first->smaller].place, what + ": neither is the smaller one, to be taken out of the other one",
           "trim the lines");
    else if (settings_.crossing == Crossing::error)
      fail(chains[first->smaller].place, what + ": is it a cut, or a part?",
           "say --crossing subtract, if the smaller one is to be cut out of the larger one, --crossing union, if both "
           "are one part, or --crossing parts, if all lines are cuts; or trim the lines");
    else
      file_.notes.push_back(what + ": " + consequence_of(settings_.crossing));
  }
}

}  // namespace taut::drawing
