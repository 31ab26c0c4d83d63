#include "scene/overlap_witness.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/predicates.hpp"
#include "motion/motion_segments.hpp"
#include "motion/pieces.hpp"
#include "motion/pose.hpp"
#include "numeric/budget.hpp"
#include "scene/placement.hpp"

namespace taut::internal {
namespace {

/// A square in a body's own coordinates, in which a point certainly lies.
struct Square {
  Point centre;
  double reach = 0;  ///< half its side; 0 if the point is known exactly
};

using RingView = std::vector<const std::vector<Point>*>;

/// Where a body is: its pose, which is not known exactly, unless it rests.
class PlacedFrame {
 public:
  PlacedFrame(const PieceChain& chain, double t)
      : pose_(pose_of<Jet<double>>(chain, Ball<double>::exact(t))),
        at_rest_(std::all_of(chain.begin(), chain.end(), rests)) {}

  /// Rounded.
  Point world(const Point& p) const {
    const double c = pose_.xx.v.mid, s = pose_.xy.v.mid;
    return {pose_.ox.v.mid + (c * p.x - s * p.y), pose_.oy.v.mid + (s * p.x + c * p.y)};
  }

  /// The point in the body's own coordinates: the inverse of a turn is its conjugate.
  Square local(const Point& point) const {
    if (at_rest_) return {point, 0};
    const Ball<double> dx = Ball<double>::exact(point.x) - pose_.ox.v, dy = Ball<double>::exact(point.y) - pose_.oy.v;
    const Ball<double> u = pose_.xx.v * dx + pose_.xy.v * dy, v = pose_.xx.v * dy - pose_.xy.v * dx;
    const double largest = std::max(std::fabs(u.mid), std::fabs(v.mid));
    // Room for the rounding of the corners, and for making those tidy that are as good as zero.
    const double reach = std::max(u.rad, v.rad) * (1 + 0x1p-40) + largest * 0x1p-50 + 0x1p-290;
    return {{tidy(u.mid), tidy(v.mid)}, reach};
  }

 private:
  static bool rests(const MotionPiece& piece) {
    const auto zero = [](const Coefficients& c) {
      return std::all_of(c.begin(), c.end(), [](double a) { return a == 0; });
    };
    return !turns(piece) && zero(piece.x) && zero(piece.y) && piece.orbit.angle.empty();
  }

  Pose<double> pose_;
  bool at_rest_;
};

/// A part at an instant: its outline, and its holes. Candidates come from rounded positions; only contains() is
/// certain.
class PlacedPart {
 public:
  PlacedPart(RingView rings, const PlacedFrame& frame) : rings_(std::move(rings)), frame_(frame) {
    for (const auto* ring : rings_) {
      world_.emplace_back();
      for (const Point& p : *ring) world_.back().push_back(frame.world(p));
    }
  }

  /// Where the rings' vertices are, rounded; the outline's first.
  const std::vector<std::vector<Point>>& world() const { return world_; }

  /// Is the point certainly in the interior? The square that holds it in the body's own coordinates must keep clear of
  /// the boundary, and its centre must be inside; both are decided exactly.
  bool contains(const Point& point) const {
    const Square square = frame_.local(point);
    // What is not finite fails this, too.
    if (!(std::fabs(square.centre.x) <= 2 && std::fabs(square.centre.y) <= 2 && square.reach <= 1)) return false;
    bool inside = false;
    for (const auto* ring : rings_) {
      for (std::size_t i = 0; i < ring->size(); ++i) {
        const Point &a = (*ring)[i], &b = (*ring)[i + 1 < ring->size() ? i + 1 : 0];
        if (!clear_of(a, b, square)) return false;
        if ((a.y > square.centre.y) != (b.y > square.centre.y) && (orientation(a, b, square.centre) > 0) == (b.y > a.y))
          inside = !inside;
      }
    }
    return inside;
  }

 private:
  /// Does the edge certainly not meet the square?
  static bool clear_of(const Point& a, const Point& b, const Square& square) {
    const Point low{tidy(square.centre.x - square.reach), tidy(square.centre.y - square.reach)};
    const Point high{tidy(square.centre.x + square.reach), tidy(square.centre.y + square.reach)};
    if (std::max(a.x, b.x) < low.x || std::min(a.x, b.x) > high.x) return true;
    if (std::max(a.y, b.y) < low.y || std::min(a.y, b.y) > high.y) return true;
    const int side = orientation(a, b, low);
    return side != 0 && orientation(a, b, high) == side && orientation(a, b, {low.x, high.y}) == side &&
           orientation(a, b, {high.x, low.y}) == side;
  }

  RingView rings_;
  const PlacedFrame& frame_;
  std::vector<std::vector<Point>> world_;
};

/// A stretch of a scan line.
struct Span {
  double low, high;
};

double along(const Point& p, bool horizontal) { return horizontal ? p.x : p.y; }
double across(const Point& p, bool horizontal) { return horizontal ? p.y : p.x; }

/// Where the line at `level` is inside the part, about.
std::vector<Span> spans(const PlacedPart& part, bool horizontal, double level) {
  std::vector<double> cuts;
  for (const std::vector<Point>& ring : part.world()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = ring[i], &b = ring[i + 1 < ring.size() ? i + 1 : 0];
      const double low = across(a, horizontal), high = across(b, horizontal);
      if ((low > level) == (high > level)) continue;
      const double share = (level - low) / (high - low);
      const double cut = along(a, horizontal) + share * (along(b, horizontal) - along(a, horizontal));
      if (std::isfinite(cut)) cuts.push_back(cut);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  std::vector<Span> out;
  for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) out.push_back({cuts[i], cuts[i + 1]});
  return out;
}

/// A point that may lie in both, and how much room there is about it.
struct Candidate {
  Point point;
  double room = 0;
};

/// The middle of the longest stretch that a line has in both parts.
Candidate on_line(const PlacedPart& p, const PlacedPart& q, bool horizontal, double level) {
  const std::vector<Span> in_p = spans(p, horizontal, level), in_q = spans(q, horizontal, level);
  Candidate best;
  for (std::size_t i = 0, j = 0; i < in_p.size() && j < in_q.size();) {
    const double low = std::max(in_p[i].low, in_q[j].low), high = std::min(in_p[i].high, in_q[j].high);
    if (high - low > best.room) {
      const double middle = tidy(low + (high - low) / 2), at = tidy(level);
      best = {horizontal ? Point{middle, at} : Point{at, middle}, high - low};
    }
    ++(in_p[i].high < in_q[j].high ? i : j);
  }
  return best;
}

/// Candidates on lines through the box that both parts' boxes have in common, the roomiest first.
std::vector<Candidate> scanned(const PlacedPart& in_p, const PlacedPart& in_q) {
  constexpr int lines = 8;
  const std::vector<Point>&p = in_p.world()[0], &q = in_q.world()[0];
  std::vector<Candidate> out;
  for (const bool horizontal : {true, false}) {
    const auto less = [&](const Point& a, const Point& b) { return across(a, horizontal) < across(b, horizontal); };
    const auto [p_low, p_high] = std::minmax_element(p.begin(), p.end(), less);
    const auto [q_low, q_high] = std::minmax_element(q.begin(), q.end(), less);
    const double low = std::max(across(*p_low, horizontal), across(*q_low, horizontal));
    const double high = std::min(across(*p_high, horizontal), across(*q_high, horizontal));
    if (low > high) return {};
    for (int k = 0; k < lines; ++k) {
      const Candidate found = on_line(in_p, in_q, horizontal, low + (high - low) * ((k + 0.5) / lines));
      if (found.room > 0) out.push_back(found);
    }
  }
  std::stable_sort(out.begin(), out.end(), [](const Candidate& a, const Candidate& b) { return a.room > b.room; });
  return out;
}

Point unit(const Point& from, const Point& to) {
  const double x = to.x - from.x, y = to.y - from.y, size = length(x, y);
  return {x / size, y / size};
}

/// Points ever closer to where edge a-b of P and edge c-d of Q cross, in the wedge to the left of both.
std::vector<Point> wedge(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point e = unit(a, b), f = unit(c, d);
  const double turn = e.x * f.y - e.y * f.x;
  const double share = ((c.x - a.x) * f.y - (c.y - a.y) * f.x) / (turn * length(b.x - a.x, b.y - a.y));
  const Point apex{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
  // The wedge lies between the ray along the one edge that is left of the other, and the same the other way round.
  const double side = turn > 0 ? 1 : -1;
  Point way{side * (f.x - e.x), side * (f.y - e.y)};
  // The rays may be all but opposite; then the inner normals say where the wedge is.
  if (length(way.x, way.y) < 0.5) way = {-(e.y + f.y), e.x + f.x};
  std::vector<Point> out;
  double step = std::min(length(b.x - a.x, b.y - a.y), length(d.x - c.x, d.y - c.y)) / 4;
  for (int k = 0; k < 24; ++k, step /= 4) out.push_back({tidy(apex.x + step * way.x), tidy(apex.y + step * way.y)});
  return out;
}

/// The wedge at an edge of P and one of Q that cross, if the inward shapes have such edges.
std::vector<Point> beside_crossing(const BodyPair& bodies, const MotionSegment& segment, double t, const PlacedFrame& p,
                                   const PlacedFrame& q) {
  const std::optional<PairGeometry> inner = displaced_pair_if_possible(bodies, Offset::inward);
  if (!inner) return {};
  const auto crossing = crossing_edges(Placement(*inner, segment, t));
  if (!crossing) return {};
  const auto world = [&](const PlacedFrame& frame, VertexId v) {
    return frame.world({inner->point(v).x, inner->point(v).y});
  };
  const VertexId e = crossing->p, f = crossing->q;
  return wedge(world(p, e), world(p, inner->next(e)), world(q, f), world(q, inner->next(f)));
}

using PlacedParts = std::vector<PlacedPart>;

std::optional<Point> found_point(const BodyPair& bodies, const MotionSegment& segment, double t,
                                 const std::array<PlacedFrame, 2>& frames, const PlacedParts& p, const PlacedParts& q) {
  const auto in_some = [](const PlacedParts& parts, const Point& point) {
    return std::any_of(parts.begin(), parts.end(), [&](const PlacedPart& part) { return part.contains(point); });
  };
  const auto in_input_units = [&](const Point& point) {
    return Point{std::ldexp(point.x, -bodies.exponent), std::ldexp(point.y, -bodies.exponent)};
  };
  for (const PlacedPart& a : p) {
    for (const PlacedPart& b : q) {
      for (const Candidate& candidate : scanned(a, b)) {
        if (a.contains(candidate.point) && b.contains(candidate.point)) return in_input_units(candidate.point);
      }
    }
  }
  for (const Point& candidate : beside_crossing(bodies, segment, t, frames[0], frames[1])) {
    if (in_some(p, candidate) && in_some(q, candidate)) return in_input_units(candidate);
  }
  return std::nullopt;
}

PlacedParts placed_parts(const RingSet& body, const PlacedFrame& frame) {
  PlacedParts parts;
  RingView rings;
  for (std::size_t i = 0; i < body.rings().size(); ++i) {
    rings.push_back(&body.points(i));
    const bool last = i + 1 == body.rings().size() || body.rings()[i + 1].ring == 0;
    if (!last) continue;
    parts.emplace_back(std::move(rings), frame);
    rings.clear();
  }
  return parts;
}

}  // namespace

std::optional<Point> common_point(const BodyPair& bodies, double t) {
  const auto frame = [&](std::size_t side) {
    MotionChain chain = bodies.common;
    chain.insert(chain.end(), bodies.motions[side].begin(), bodies.motions[side].end());
    return PlacedFrame(pieces_at(chain, t), t);
  };
  const std::array<PlacedFrame, 2> frames{frame(0), frame(1)};
  return found_point(bodies, segments_of(bodies, t, t).front(), t, frames, placed_parts(*bodies.rings[0], frames[0]),
                     placed_parts(*bodies.rings[1], frames[1]));
}

std::optional<Point> common_point(const Instance& instance, const std::array<BodyId, 2>& pair) {
  for (const int a : instance.sections(pair[0])) {
    for (const int b : instance.sections(pair[1])) {
      if (instance.excluded(a, b)) continue;
      if (const auto point = common_point(instance.pair(a, b), instance.start())) return point;
    }
  }
  return std::nullopt;
}

namespace {

/// An edge's rectangle, with room for the error of its ends' positions.
struct Extent {
  VertexId edge;
  double left, right, low, high;
};

bool cross(const Placement& place, VertexId e, VertexId f) {
  const PairGeometry& g = place.geometry();
  const VertexId e2 = g.next(e), f2 = g.next(f);
  return place.orientation(e, e2, f) != place.orientation(e, e2, f2) &&
         place.orientation(f, f2, e) != place.orientation(f, f2, e2);
}

std::vector<Extent> sorted_edges(const Placement& place) {
  const double room = place.position_error();
  std::vector<Extent> edges;
  for (std::uint32_t i = 0; i < place.size(); ++i) {
    const VertexId v(i);
    const Point a = place.approximate(v), b = place.approximate(place.geometry().next(v));
    edges.push_back({v, std::min(a.x, b.x) - room, std::max(a.x, b.x) + room, std::min(a.y, b.y) - room,
                     std::max(a.y, b.y) + room});
  }
  std::sort(edges.begin(), edges.end(), [](const Extent& a, const Extent& b) {
    return a.left != b.left ? a.left < b.left : a.edge.value < b.edge.value;
  });
  return edges;
}

}  // namespace

std::optional<EdgePair> crossing_edges(const Placement& place) {
  const PairGeometry& g = place.geometry();
  std::vector<Extent> open[2];  // of P and of Q: those that the sweep line may still meet
  for (const Extent& e : sorted_edges(place)) {
    const bool of_p = g.in_p(e.edge);
    std::vector<Extent>& others = open[of_p ? 1 : 0];
    others.erase(std::remove_if(others.begin(), others.end(), [&](const Extent& f) { return f.right < e.left; }),
                 others.end());
    for (const Extent& f : others) {
      checkpoint();
      if (e.low > f.high || f.low > e.high || !cross(place, e.edge, f.edge)) continue;
      return of_p ? EdgePair{e.edge, f.edge} : EdgePair{f.edge, e.edge};
    }
    open[of_p ? 0 : 1].push_back(e);
  }
  return std::nullopt;
}

}  // namespace taut::internal
