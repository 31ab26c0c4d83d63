#include "import/overlaps.hpp"

#include <algorithm>
#include <cmath>

#include "import/body_text.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

bool all_inside(const Polygon& ring, const Part& part) {
  return std::all_of(ring.begin(), ring.end(), [&part](const Point& p) { return roughly_inside(part, p); });
}

void add_ring(const Polygon& ring, bool outline, std::vector<Strand>& strands) {
  strands.push_back({ring, true, strands.size()});
  if ((doubled_area(ring) > 0) != outline) std::reverse(strands.back().points.begin(), strands.back().points.end());
}

/// How much of the plane is in more than one of the parts, as often as it is too often.
double excess_of(const std::vector<const Part*>& parts, const OutlineSettings& settings) {
  std::vector<Strand> strands;
  for (const Part* part : parts) {
    add_ring(part->outline, true, strands);
    for (const Polygon& hole : part->holes) add_ring(hole, false, strands);
  }
  const LineGraph graph = split_at_crossings(strands, settings.most_cuts, settings.file);
  const FaceMap faces(graph, std::vector<bool>(graph.edges.size(), true));
  const std::vector<Turns> turns = turns_around(graph, faces);
  const std::vector<double> areas = areas_of_faces(faces);
  double excess = 0, all = 0;
  for (std::size_t f = 1; f < areas.size(); ++f) {
    all += areas[f];
    if (turns[f].winding > 1) excess += (turns[f].winding - 1) * areas[f];
  }
  // What rounding makes of boundaries that touch is none.
  return excess > 1e-9 * all ? excess : 0;
}

}  // namespace

Overlaps overlaps_of(const std::vector<SourcedPart>& parts, const OutlineSettings& settings) {
  Overlaps overlaps;
  if (std::all_of(parts.begin(), parts.end(),
                  [&parts](const SourcedPart& part) { return part.source == parts.front().source; }))
    return overlaps;
  std::vector<AxisBox> boxes;
  for (const SourcedPart& part : parts) boxes.push_back(box_of(part.part->outline));
  std::vector<bool> near(parts.size(), false), within(parts.size(), false), in_lines(parts.size(), false);
  SegmentStrips(boxes).each_pair([&](std::size_t i, std::size_t j) {
    if (parts[i].source == parts[j].source) return;
    near[i] = near[j] = true;
    if (parts[i].lines && parts[j].lines) return;
    for (const auto& [inner, outer] : {std::pair(i, j), std::pair(j, i)})
      if (!within[inner] && boxes[outer].holds(boxes[inner]) &&
          all_inside(parts[inner].part->outline, *parts[outer].part)) {
        within[inner] = true;
        in_lines[inner] = parts[outer].lines;
      }
  });
  std::vector<const Part*> chosen;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (near[k]) chosen.push_back(parts[k].part);
    if (!within[k]) continue;
    (parts[k].lines ? overlaps.lines_in_filled
     : in_lines[k]  ? overlaps.filled_in_lines
                    : overlaps.filled_in_filled)
        .push_back(k);
  }
  if (!chosen.empty()) overlaps.area = excess_of(chosen, settings);
  return overlaps;
}

}  // namespace taut::drawing
