// Of BodyMaker: outlines that keep their curves.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "import/bodies.hpp"
#include "import/kept_curves.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

/// Each traverses all of the body.
constexpr int most_touching = 200;

/// A part with its curves, ring by ring.
struct FoundPart {
  CurvedPart part;
  std::vector<std::vector<const KeptCurve*>> curves;
  std::set<const KeptCurve*> cut;
};

FoundPart found_part(const Part& part, const CurveFinder& finder, const std::set<const KeptCurve*>& chorded) {
  FoundPart found;
  const auto add = [&](const Polygon& ring) {
    FoundOutline outline = finder.outline(ring, chorded);
    found.curves.push_back(std::move(outline.curves));
    found.cut.merge(outline.cut);
    return std::move(outline.outline);
  };
  found.part.outline = add(part.outline);
  for (const Polygon& hole : part.holes) found.part.holes.push_back(add(hole));
  return found;
}

/// One of the curves that an error names; null if it names none.
const KeptCurve* culprit_of(const InputError& error, const FoundPart& found) {
  for (const EdgeRef& edge : error.culprits().edges) {
    const auto ring = static_cast<std::size_t>(edge.ring), segment = static_cast<std::size_t>(edge.index);
    if (ring < found.curves.size() && segment < found.curves[ring].size() && found.curves[ring][segment])
      return found.curves[ring][segment];
  }
  return nullptr;
}

std::size_t count_curves(const std::vector<CurvedPart>& parts) {
  std::size_t curves = 0;
  const auto count = [&curves](const Outline& outline) {
    for (const CurveSegment& segment : outline.segments) curves += std::holds_alternative<LineTo>(segment) ? 0 : 1;
  };
  for (const CurvedPart& part : parts) {
    count(part.outline);
    std::for_each(part.holes.begin(), part.holes.end(), count);
  }
  return curves;
}

}  // namespace

/// The curves that the rings were made of, if there are any. Where curves meet each other, which scenes do not have,
/// the chords of one of them stand for it.
void BodyMaker::take_curves(const std::vector<Part>& parts, Body& body) {
  if (!finder_) return;
  std::set<const KeptCurve*> chorded, cut;
  std::optional<InputError> first;
  bool all_chords = false;
  for (std::size_t k = 0; k < parts.size() && !all_chords;) {
    FoundPart found = found_part(parts[k], *finder_, chorded);
    try {
      flatten({found.part}, CurveSide::outer, 1e300, body.name);
      found.part.z = parts[k].z;
      body.curves.push_back(std::move(found.part));
      cut.merge(found.cut);
      ++k;
    } catch (const InputError& error) {
      if (!first) first = error;
      const KeptCurve* culprit = culprit_of(error, found);
      all_chords = !culprit || static_cast<int>(chorded.size()) == most_touching;
      if (culprit) chorded.insert(culprit);
      // Another part may have the curve, too.
      body.curves.clear();
      cut.clear();
      k = 0;
    }
  }
  const std::size_t kept = count_curves(body.curves);
  if (kept == 0) body.curves.clear();
  file_.kept += kept;
  if (!cut.empty())
    file_.notes.push_back(
        fmt::format("body {}: {} where lines meet or cross {}, and chords there, at most {:.3g} away (--tolerance)",
                    io::excerpt(body.name),
                    cut.size() == 1 ? "1 curve is divided" : fmt::format("{} curves are divided", cut.size()),
                    cut.size() == 1 ? "it" : "them", file_.fineness.tolerance));
  if (!first) return;
  const std::string how_much = kept == 0 ? "all of it is chords"
                               : chorded.size() == 1
                                   ? "1 curve there is chords"
                                   : fmt::format("{} curves at such places are chords", chorded.size());
  file_.notes.push_back(
      fmt::format("body {}: {}, and scenes with curves need a gap there: {}, at most {:.3g} away (--tolerance)",
                  io::excerpt(body.name), first->problem(), how_much, file_.fineness.tolerance));
}

}  // namespace taut::drawing
