#include "import/outlines.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "geometry/part_rings.hpp"
#include "geometry/predicates.hpp"
#include "geometry/segment_strips.hpp"
#include "import/closed_pieces.hpp"
#include "import/contours.hpp"
#include "numeric/budget.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

/// Moved ends may come near to others: rarely more than twice.
constexpr int most_joinings = 12;
/// An open ring whose gaps are no longer than this part of its lines is taken for one that was meant to be closed, if
/// no other ends are nearly as near; one in material that encloses closed contours, if they are no longer than half of
/// its lines. Of those outside of material see find_open_outlines().
constexpr double small_gap = 0.1, large_gap = 0.5, clear_gap = 2;

std::vector<Strand> strands_of(const std::vector<Chain>& chains) {
  std::vector<Strand> strands;
  for (std::size_t k = 0; k < chains.size(); ++k) {
    Strand strand{chains[k].points, chains[k].closed, k};
    if (strand.points.size() > 2 && strand.points.front() == strand.points.back()) {
      strand.points.pop_back();
      strand.closed = true;
    }
    strands.push_back(std::move(strand));
  }
  return strands;
}

class OutlineMaker {
 public:
  OutlineMaker(std::vector<Strand> strands, const OutlineSettings& settings)
      : settings_(settings), strands_(std::move(strands)) {}

  Outlines of_lines() {
    join();
    thin_doubled_lines(graph_, alive_, settings_.join, settings_.repair, out_.repairs);
    prune(true);
    find_suspicious(settings_.close);
    if (settings_.close && !out_.suspicious.empty()) close();
    const FaceMap faces = mend();
    if (!any_alive()) return std::move(out_);
    const Contours contours = contours_of(graph_, alive_);
    find_crossings(contours);
    LineFaces material = faces_of_lines(graph_, alive_, contours, faces, settings_.crossing);
    out_.crossed = std::move(material.crossings);
    finish(faces, material.keys);
    return std::move(out_);
  }

  Outlines of_fill(Fill fill) {
    graph_ = split_at_crossings(strands_, settings_.most_cuts, settings_.file);
    alive_.assign(graph_.edges.size(), true);
    prune(false);
    if (cut_loops(graph_, alive_, settings_.repair, out_.repairs)) prune(false);
    const FaceMap faces(graph_, alive_);
    FaceKeys keys;
    for (const Turns& turns : turns_around(graph_, faces)) keys.push_back(is_inside(turns, fill) ? 1 : 0);
    find_crossings(contours_of(graph_, alive_));
    finish(faces, keys);
    return std::move(out_);
  }

  Outlines of_repair() {
    graph_ = split_at_crossings(strands_, settings_.most_cuts, settings_.file);
    alive_.assign(graph_.edges.size(), true);
    cut_spikes(graph_, alive_, out_.repairs);
    prune(false);
    if (cut_loops(graph_, alive_, settings_.repair, out_.repairs)) prune(false);
    if (!any_alive()) return std::move(out_);
    const FaceMap faces(graph_, alive_);
    const std::vector<Turns> turns = turns_around(graph_, faces);
    FaceKeys keys;
    for (const Turns& face : turns) keys.push_back(face.winding > 0 ? 1 : 0);
    std::map<int, std::pair<int, AxisBox>> changed;  // faces: a half-edge, and the box around
    for (int h = 0; h < faces.map.half_edges(); ++h) {
      const int f = faces.map.face(h);
      const Turns& face = turns[static_cast<std::size_t>(f)];
      if ((face.winding > 0) == (face.times % 2 != 0)) continue;
      const AxisBox box(faces.map.point(faces.map.origin(h)), faces.map.point(faces.map.target(h)));
      changed.try_emplace(f, h, box).first->second.second.include(box);
    }
    for (const auto& [face, place] : changed)
      out_.repairs.push_back({Repair::Kind::crossing, faces.map.point(faces.map.origin(place.first)),
                              place.second.longest(),
                              graph_.edges[static_cast<std::size_t>(faces.edge(place.first))].source});
    finish(faces, keys);
    return std::move(out_);
  }

  std::vector<Point> loose() {
    join();
    std::vector<Point> ends;
    const Incidence incidence(graph_, alive_);
    for (int node = 0; node < static_cast<int>(graph_.nodes.size()); ++node)
      if (incidence.degree(node) == 1) ends.push_back(graph_.point(node));
    return ends;
  }

 private:
  static bool is_inside(const Turns& turns, Fill fill) {
    if (fill == Fill::even_odd) return turns.times % 2 != 0;
    return fill == Fill::nonzero ? turns.winding != 0 : turns.winding == 1;
  }

  bool any_alive() const { return std::find(alive_.begin(), alive_.end(), true) != alive_.end(); }

  void join() {
    std::size_t points = 0;
    for (const Strand& strand : strands_) points += strand.points.size();
    report_parts("points of lines", points);
    graph_ = split_at_crossings(strands_, settings_.most_cuts, settings_.file);
    for (int k = 0; k < most_joinings && close_gaps(strands_, graph_, settings_.join, out_.gaps); ++k)
      graph_ = split_at_crossings(strands_, settings_.most_cuts, settings_.file);
    alive_.assign(graph_.edges.size(), true);
    out_.repeated = 0;
    for (const LineGraph::Edge& edge : graph_.edges) out_.repeated += static_cast<std::size_t>(edge.times - 1);
  }

  /// Edges on no cycle enclose nothing.
  void prune(bool report) {
    const std::vector<bool> before = alive_;
    std::vector<bool> removed(alive_.size(), false);
    const std::vector<int> block = blocks_of(graph_, alive_);
    std::vector<int> size(graph_.edges.size(), 0);
    for (const int b : block)
      if (b >= 0) ++size[static_cast<std::size_t>(b)];
    for (std::size_t e = 0; e < block.size(); ++e) {
      if (block[e] < 0 || size[static_cast<std::size_t>(block[e])] > 1) continue;
      alive_[e] = false;
      removed[e] = true;
    }
    if (!report) return;
    out_.open = open_lines(graph_, before, removed);
    // Lines drawn a little beyond a crossing, and specks.
    std::erase_if(out_.open, [this](const OpenLine& line) { return line.length() <= settings_.join; });
  }

  /// `closing`: what a person wants closed need not be clear.
  void find_suspicious(bool closing) {
    std::vector<Point> enclosed;
    for (std::size_t e = 0; e < alive_.size(); ++e)
      if (alive_[e]) enclosed.push_back(graph_.point(graph_.edges[e].from));
    std::sort(enclosed.begin(), enclosed.end(), lexicographically_less);
    enclosed.erase(std::unique(enclosed.begin(), enclosed.end()), enclosed.end());
    find_nearest_ends(out_.open);
    std::vector<Closure> closures = find_closures(out_.open);
    for (Closure& closure : closures_across_lines(out_.open)) {
      const std::size_t line = closure.lines.front();
      std::erase_if(closures, [&](const Closure& other) {
        return std::find(other.lines.begin(), other.lines.end(), line) != other.lines.end();
      });
      closures.push_back(std::move(closure));
    }
    find_open_outlines(closures);
    for (Closure& closure : closures) {
      const double around = closure.line_length + closure.gap_length;
      if (!closure.encloses && std::fabs(doubled_area(closure.ring)) <= settings_.join * around) continue;
      const bool clear = closure.gap_length <= small_gap * closure.line_length && closure.clearness >= clear_gap;
      const bool meant = clear || closure.encloses ||
                         (closure.gap_length <= large_gap * closure.line_length && holds_any(closure.ring, enclosed));
      if (meant || (closing && closure.gap_length <= closure.line_length))
        out_.suspicious.push_back(std::move(closure));
    }
  }

  /// Lines outside of all that is closed, in whose hull something closed lies, or a part of it: however wide their gap
  /// is, they may be its outline. Several that do not meet may if each bends, they are longer than the gaps, and all of
  /// it lies in the hull. So may two that bend, and of which other lines cross the rest, whatever lies in them.
  void find_open_outlines(std::vector<Closure>& closures) const {
    if (!any_alive() || out_.open.empty()) return;
    ClosedPieces closed(graph_, alive_);
    std::vector<bool> used(out_.open.size(), false);
    const auto on_material = [&](const Closure& closure) {
      return std::any_of(closure.lines.begin(), closure.lines.end(),
                         [&](std::size_t k) { return closed.surround(out_.open[k].points); });
    };
    const auto examine = [&](Closure& closure, bool partly) {
      const auto piece = closed.in_hull(closure.ring, partly);
      if (!piece || on_material(closure)) return;
      closure.encloses = piece->source;
      closure.partly = !piece->whole;
      for (const std::size_t k : closure.lines) used[k] = true;
    };
    const auto look_further = [&](std::vector<Closure> more, bool several) {
      for (Closure& closure : more) {
        if (std::any_of(closure.lines.begin(), closure.lines.end(), [&used](std::size_t k) { return used[k]; }))
          continue;
        if (several && (closure.gap_length > closure.line_length ||
                        std::any_of(closure.lines.begin(), closure.lines.end(),
                                    [this](std::size_t k) { return out_.open[k].is_straight(); })))
          continue;
        examine(closure, !several);
        const bool across = !several && closure.clearness > 0 && !on_material(closure) &&
                            std::any_of(closure.lines.begin(), closure.lines.end(),
                                        [this](std::size_t k) { return !out_.open[k].is_straight(); });
        if (closure.encloses || across) closures.push_back(std::move(closure));
      }
    };
    for (Closure& closure : closures)
      if (closure.lines.size() == 1 || closure.gap_length <= closure.line_length)
        examine(closure, closure.lines.size() == 1);
    look_further(closures_of_groups(out_.open), false);
    look_further(find_closures(out_.open, true), true);
    std::erase_if(closures, [&used](const Closure& closure) {
      return !closure.encloses &&
             std::any_of(closure.lines.begin(), closure.lines.end(), [&used](std::size_t k) { return used[k]; });
    });
  }

  static bool holds_any(const Polygon& ring, const std::vector<Point>& points) {
    AxisBox box(ring[0], ring[0]);
    for (const Point& p : ring) box.include(AxisBox(p, p));
    auto p = std::lower_bound(points.begin(), points.end(), Point{box.lo_x, box.lo_y}, lexicographically_less);
    for (; p != points.end() && p->x <= box.hi_x; ++p)
      if (box.meets(AxisBox(*p, *p)) && roughly_inside(ring, *p)) return true;
    return false;
  }

  void close() {
    for (Closure& closure : out_.suspicious) {
      const std::size_t source = out_.open[closure.lines.front()].source;
      for (const auto& [from, to] : closure.gaps) strands_.push_back({{from, to}, false, source});
      out_.closed.emplace_back(source, std::move(closure));
    }
    out_.suspicious.clear();
    join();
    prune(true);
    // What straight lines did not close.
    find_suspicious(false);
  }

  /// What is larger than a loop that is cut off.
  void find_crossings(const Contours& contours) {
    for (const auto& [node, ring] : self_meetings(graph_, contours))
      out_.crossings.emplace_back(graph_.point(node), graph_.edge(contours.rings[ring].front()).source);
  }

  /// The faces that are left.
  FaceMap mend() {
    for (;; prune(false)) {
      if (cut_loops(graph_, alive_, settings_.repair, out_.repairs)) continue;
      FaceMap faces(graph_, alive_);
      if (!dissolve_small_faces(graph_, alive_, faces, settings_.join, settings_.repair, out_.repairs)) return faces;
    }
  }

  void finish(const FaceMap& faces, const FaceKeys& keys) {
    out_.regions = regions_of(faces, keys);
    for (Region& region : out_.regions) {
      as_drawn(region.part.outline, region.outline.front());
      for (std::size_t k = 0; k < region.holes.size(); ++k) as_drawn(region.part.holes[k], region.holes[k]);
      std::map<std::size_t, double> lengths;
      for (const int e : region.outline)
        lengths[graph_.edges[static_cast<std::size_t>(e)].source] += graph_.length(2 * e);
      out_.sources.push_back(std::max_element(lengths.begin(), lengths.end(), [](const auto& a, const auto& b) {
                               return a.second < b.second;
                             })->first);
      out_.lengths.push_back(std::move(lengths));
      out_.hole_sources.emplace_back();
      for (const int e : region.holes)
        out_.hole_sources.back().push_back(graph_.edges[static_cast<std::size_t>(e)].source);
    }
    const std::vector<bool> bounds = find_boundaries(faces, keys);
    for (std::size_t s = 0; s < graph_.walks.size(); ++s) {
      const std::vector<int>& walk = graph_.walks[s];
      const auto in = [](const std::vector<bool>& set) {
        return [&set](int h) { return set[static_cast<std::size_t>(h / 2)]; };
      };
      if (std::none_of(walk.begin(), walk.end(), in(alive_)))
        out_.empty.push_back(strands_[s].source);
      else if (std::none_of(walk.begin(), walk.end(), in(bounds)))
        out_.idle.push_back(strands_[s].source);
    }
  }

  /// The edges between what has different keys; those with a part on either side are cuts.
  std::vector<bool> find_boundaries(const FaceMap& faces, const FaceKeys& keys) {
    std::vector<bool> bounds(graph_.edges.size(), false);
    const std::vector<double> areas = areas_of_faces(faces);
    std::map<int, double> area_of_key;
    for (std::size_t f = 0; f < keys.size(); ++f) area_of_key[keys[f]] += areas[f];
    const auto key = [&](int h) { return keys[static_cast<std::size_t>(faces.map.face(h))]; };
    for (int h = 0; h < faces.map.half_edges(); ++h) {
      if (key(h) == key(h ^ 1)) continue;
      bounds[static_cast<std::size_t>(faces.edge(h))] = true;
      if (h % 2 != 0 || key(h) == 0 || key(h ^ 1) == 0) continue;
      const double least = std::min(area_of_key[key(h)], area_of_key[key(h ^ 1)]);
      if (out_.cuts++ == 0) out_.first_cut = faces.map.point(faces.map.origin(h));
      out_.smallest_cut = out_.cuts == 1 ? least : std::min(out_.smallest_cut, least);
    }
    return bounds;
  }

  /// A ring that is one chain has its vertices in the order of the chain.
  void as_drawn(Polygon& ring, int edge) const {
    const std::size_t source = graph_.edges[static_cast<std::size_t>(edge)].source;
    Polygon chain = strands_[source].points;
    chain.erase(std::unique(chain.begin(), chain.end()), chain.end());
    if (chain.size() != ring.size()) return;
    Polygon turned = ring;
    if (ring_direction(chain) != ring_direction(ring)) std::reverse(turned.begin(), turned.end());
    std::rotate(turned.begin(), std::find(turned.begin(), turned.end(), chain.front()), turned.end());
    if (turned == chain) ring = std::move(chain);
  }

  const OutlineSettings& settings_;
  std::vector<Strand> strands_;
  LineGraph graph_;
  std::vector<bool> alive_;  ///< edges that may still bound something
  Outlines out_;
};

}  // namespace

Outlines outlines_of_lines(const std::vector<Chain>& chains, const OutlineSettings& settings) {
  return OutlineMaker(strands_of(chains), settings).of_lines();
}

Outlines outlines_of_fill(const std::vector<Chain>& chains, Fill fill, const OutlineSettings& settings) {
  std::vector<Strand> strands = strands_of(chains);
  for (Strand& strand : strands) strand.closed = true;
  return OutlineMaker(std::move(strands), settings).of_fill(fill);
}

bool encloses_area(const Chain& chain, Fill fill, std::size_t most_cuts, const std::string& file) {
  double around = 0;
  for (std::size_t i = 0; i < chain.points.size(); ++i) {
    const Point &a = chain.points[i], &b = chain.points[(i + 1) % chain.points.size()];
    around += std::hypot(a.x - b.x, a.y - b.y);
  }
  constexpr double rounding = 1e-9;
  if (std::fabs(doubled_area(chain.points)) > rounding * around * around) return true;
  // Thin, or with as much on one side as on the other one.
  return !outlines_of_fill({chain}, fill, {0, 0, false, Crossing::parts, most_cuts, file}).regions.empty();
}

Outlines outlines_of_repair(const std::vector<Chain>& rings, const OutlineSettings& settings) {
  return OutlineMaker(strands_of(rings), settings).of_repair();
}

std::vector<Point> loose_ends(const std::vector<Chain>& chains, const OutlineSettings& settings) {
  return OutlineMaker(strands_of(chains), settings).loose();
}

}  // namespace taut::drawing
