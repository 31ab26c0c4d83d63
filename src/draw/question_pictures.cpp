// Answers as pictures of the bodies: where they are closest, where they can go, and what they pass over.
#include <fmt/format.h>

#include "draw/world_marks.hpp"
#include "io/text.hpp"
#include "scene/untested.hpp"
#include "taut/clearance.hpp"
#include "taut/io.hpp"
#include "taut/separate.hpp"
#include "taut/swept.hpp"

namespace taut {
using namespace internal;
namespace {

double middle_of_ends(const DirectionInterval& angle) { return angle.lo + (angle.hi - angle.lo) / 2; }

DrawnRose rose_of(const BodyDirections& body) {
  DrawnRose rose{body.body, {}};
  if (body.all) rose.arcs.push_back({0, 360});
  for (const DirectionArc& arc : body.all ? std::vector<DirectionArc>() : body.free) {
    const double from = middle_of_ends(arc.from), to = middle_of_ends(arc.to);
    rose.arcs.push_back({from, arc.point ? from : to < from ? to + 360 : to});
  }
  return rose;
}

}  // namespace

std::string clearance_svg(const Scene& scene, const Clearance& answer, int width) {
  DrawOptions options;
  options.width = width;
  const std::string note = untested_note(answer.coverage);
  if (!answer.nearest) {
    options.title = io::world_title(scene) + (answer.outcome == Outcome::undecided ? ": undecided" : "") + note;
    return draw_svg(scene, scene.start, options);
  }
  const NearestPoints& n = *answer.nearest;
  const std::string pair = io::pair_text(scene, n.pair[0], n.pair[1]);
  options.title = fmt::format("{}: the least distance, at t = {}", io::world_title(scene),
                              io::instant_text(n.time.lo, scene.start, scene.end, 10));
  if (n.hi > 0) {
    options.distances.push_back({n.points, fmt::format("{}: {:.7g}", pair, n.hi)});
  } else {
    options.title += ", is 0: " + pair;
  }
  options.title += note;
  return draw_svg(scene, n.time.lo, options);
}

std::string margin_svg(const Scene& scene, double clearance, const MarginAnswer& answer, int width) {
  DrawOptions options;
  options.width = width;
  const std::string note = untested_note(answer.coverage);
  if (!answer.first || answer.first->outcome == Outcome::undecided) {
    options.title = io::world_title(scene);
    if (answer.outcome == Outcome::undecided) options.title += ": undecided";
    if (answer.outcome == Outcome::free)
      options.title += fmt::format(": all keep {} on [{}, {}]",
                                   scene.clearances.empty() ? fmt::format("{:.7g}", clearance) : "their clearances",
                                   io::instant_text(scene.start, scene.start, scene.end, 7),
                                   io::instant_text(scene.end, scene.start, scene.end, 7));
    options.title += note;
    return draw_svg(scene, scene.start, options);
  }
  const PairMargin& first = *answer.first;
  const double t = first.outcome == Outcome::contact ? first.time.lo : scene.start;
  options.title = fmt::format("{}: closer than {:.7g} at t = {}{}", io::world_title(scene), first.margin_at,
                              io::instant_text(t, scene.start, scene.end, 10), note);
  const std::string pair = io::pair_text(scene, first.bodies[0], first.bodies[1]);
  if (first.nearest) {
    options.distances.push_back({first.nearest->points, fmt::format("{}: {:.7g}", pair, first.nearest->hi)});
  } else {
    options.overlaps.push_back(first.bodies);
  }
  return draw_svg(scene, t, options);
}

std::string separation_svg(const Scene& scene, const Separation& answer, int width) {
  DrawOptions options;
  options.width = width;
  options.title = io::world_title(scene) + ": free directions" + untested_note(answer.coverage);
  if (answer.overlap) options.overlaps.push_back(*answer.overlap);
  for (const BodyDirections& body : answer.bodies) options.roses.push_back(rose_of(body));
  return draw_svg(scene, scene.start, options);
}

std::string swept_svg(const Scene& scene, BodyId body, const SweptRegion& region, int width) {
  DrawOptions options;
  options.width = width;
  options.title = fmt::format("{} passes over {:.7g}, on [{}, {}]", scene.bodies[static_cast<std::size_t>(body)].name,
                              region.area, io::instant_text(scene.start, scene.start, scene.end, 7),
                              io::instant_text(scene.end, scene.start, scene.end, 7));
  options.regions.push_back({body, region.parts});
  return draw_svg(scene, scene.start, options);
}

}  // namespace taut
