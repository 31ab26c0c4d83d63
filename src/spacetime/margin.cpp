#include "spacetime/margin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "certificate/margin_function.hpp"
#include "certificate/precise_root.hpp"
#include "numeric/errors.hpp"
#include "spacetime/walk.hpp"

namespace taut::internal::spacetime {
namespace {

/// Which features come as close as the margin first on one segment: what the walk asks.
class MarginOnSegment {
 public:
  MarginOnSegment(const PairGeometry& geometry, const TreePair& trees, const MotionSegment& segment,
                  const Margin& margin)
      : shortest(shortest_stretch * (segment.end - segment.start)),
        geometry_(geometry),
        approaches_(geometry, segment, margin),
        greatest_(approaches_.margin().over(segment.start, segment.end).most),
        walk_(trees, segment, *this),
        proved_(segment.start) {}

  /// On [from, to] of the segment's parameter.
  std::optional<Approach> run(double from, double to) {
    at_instant_ = true;
    walk_.at(from);
    at_instant_ = false;
    if (!best_) walk_.through(from, to);
    return best_;
  }
  /// Up to when they are certainly no closer.
  double proved() const { return proved_; }

  const double shortest;
  double distance_of_interest() const { return greatest_; }
  bool begins(double start) {
    if (best_) return start < best_->hi;
    proved_ = start;
    return true;
  }
  BoxDecision evaluate(const StretchOfTime& time, const BoxNode& p, const BoxNode& q) {
    const Stretch& s = time.bounds;
    const SegmentMargin::Bounds margin = approaches_.margin().over(time.start, time.end);
    const Path relative = s.in_p.place(q.box.centre, p.box.centre);
    const Vector towards{relative.x.a, relative.y.a};
    if (farther(s, p.box, q.box, towards, margin.most)) return BoxDecision::done;
    const bool leaf = p.count == 1 && q.count == 1;
    if (time.divisible && (motion(s, p.box, q.box) + margin.change >
                               subdivision_threshold * (p.box.radius + q.box.radius + (leaf ? margin.most : 0)) ||
                           (leaf && farther_around_middle(s, worth_trying, p.box, q.box, towards, margin.most))))
      return BoxDecision::deferred;
    if (!leaf) return BoxDecision::divided;
    // Each edge stands for its first vertex.
    const VertexId of_p(p.first), of_q(geometry_.np + q.first);
    if (!vertices_farther(s, point(of_p), point(of_q), margin.most)) resolve(time, {of_p, of_q, false});
    if (!misses_edge(s.in_q, s, of_p, of_q, margin.most)) resolve(time, {of_p, of_q, true});
    if (!misses_edge(s.in_p, s, of_q, of_p, margin.most)) resolve(time, {of_q, of_p, true});
    return BoxDecision::done;
  }

 private:
  Vector point(VertexId v) const { return {geometry_.point(v).x, geometry_.point(v).y}; }
  bool misses_edge(const RelativePose& relative_pose, const Stretch& s, VertexId vertex, VertexId edge,
                   double margin) const {
    return misses(s, relative_pose, point(vertex), point(edge), point(geometry_.next(edge)), margin);
  }
  /// The pair's first approach within the stretch becomes the best if it is.
  void resolve(const StretchOfTime& time, const VertexPeer& pair) {
    if (at_instant_) {
      if (!best_ && approaches_.close_at(pair, time.start)) best_ = Approach{pair, time.start, time.start, {}};
      return;
    }
    double end = time.end;
    if (best_) end = std::min(end, std::nextafter(best_->hi, std::numeric_limits<double>::infinity()));
    if (!(time.start < end)) return;
    std::optional<Approach> found = approaches_.first(pair, time.start, end);
    if (!found) return;
    const double lo = best_ ? std::min(best_->lo, found->lo) : found->lo;
    if (!best_ || approaches_.before(*found, *best_)) best_ = std::move(found);
    // Where their order stays open, the enclosure begins with that of the one that may be earlier.
    if (best_->lo > lo) best_->lo = lo;
  }

  const PairGeometry& geometry_;
  PreciseApproaches approaches_;
  double greatest_;  ///< the margin is not greater on the segment
  Walk<MarginOnSegment> walk_;
  std::optional<Approach> best_;
  bool at_instant_ = false;
  double proved_;
};

void note_approach(const Approach& found, MarginResult& result) {
  result.outcome = MarginResult::close;
  result.lo = found.lo;
  result.hi = found.hi;
  result.pair = found.pair;
  result.at_once = found.precise.stage < Stage::precise;
}

}  // namespace

MarginResult first_closer(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
                          const Margin& margin, const TimeInterval& window) {
  MarginResult result;
  for (std::size_t i = segments.first_until(window.lo); i < segments.size(); ++i) {
    const SegmentPlace at = segments.place(i);
    if (at.start > window.hi) break;
    if (at.bridge) continue;
    const std::shared_ptr<const MotionSegment> held = segments.hold(i);
    const MotionSegment& segment = *held;
    MarginOnSegment search(geometry, trees, segment, margin);
    result.segment = i;
    try {
      if (const auto found = search.run(std::max(segment.start, window.lo), std::min(segment.end, window.hi))) {
        note_approach(*found, result);
        return result;
      }
      continue;
    } catch (const Undecidable& limit) {
      result.reason = not_decided(limit);
    } catch (const Interrupted& limit) {
      result.reason = limit.reason;
    }
    result.outcome = MarginResult::undecided;
    result.lo = search.proved();
    return result;
  }
  return result;
}

namespace {

/// A vertex and an edge: does the vertex project onto the edge?
template <class Real>
class BesideEdge {
 public:
  BesideEdge(const MotionSegment& segment, const PairGeometry& g, const VertexEdge& pair, TaylorFrames* models)
      : from_start_(segment, g, pair.from_start(g), models), from_end_(segment, g, pair.from_end(g), models) {}

  bool operator()(const Ball<Real>& t) const {
    const int a = from_start_.telling_value(t).sign(), b = from_end_.telling_value(t).sign();
    if (a < 0 || b < 0) return false;
    if (a > 0 && b > 0) return true;
    throw PrecisionExhausted{};
  }

 private:
  PreciseFunction<Real> from_start_, from_end_;
};

/// Goes from root to root until one is an approach.
template <class Real, class Function, class Test>
std::optional<PreciseTime> first_root(const MotionSegment& segment, const Function& f, const Test& counts, double from,
                                      double to, Stage stage) {
  PreciseTime at = PreciseTime::between(from, from);
  for (int sign = f.value(Ball<Real>::exact(from)).sign(); sign != 0; sign = -sign) {
    const auto root = first_change<Real>(segment, f, sign, at, to, stage);
    if (!root || (sign < 0 && counts(ball_of<Real>(*root)))) return root;
    at = *root;
  }
  throw PrecisionExhausted{};
}

template <class Real>
bool is_close(const VertexMargin<Real>& f, const Ball<Real>& t) {
  const int sign = f.value(t).sign();
  if (sign == 0) throw PrecisionExhausted{};
  return sign > 0;
}
template <class Real>
bool is_close(const LineMargin<Real>& f, const Ball<Real>& t) {
  const int sign = f.value(t).sign();
  if (sign == 0) throw PrecisionExhausted{};
  // If the vertex is behind the line by more than the margin, the near edge is another one.
  return sign > 0 && f.not_behind(t);
}

void store_approach(const PreciseTime& t, Approach& a) {
  a.precise = t;
  a.lo = t.floor();
  a.hi = t.ceiling();
}

/// The answer of the first stage that decides.
template <class Ask>
auto decided(const char* what, const Ask& ask) {
  auto found = at_some_stage(ask);
  if (!found) throw Undecidable{what};
  return std::move(*found);
}

}  // namespace

/// Calls `use` with the function of the pair and a test of its roots, at one precision.
template <class Real, class Use>
auto PreciseApproaches::with_functions(const VertexPeer& pair, const Use& use) const {
  TaylorFrames* const models = &models_;
  if (!pair.is_edge) {
    return use(VertexMargin<Real>(segment_, geometry_, pair.vertex, pair.peer, margin_.terms<Real>(), models),
               [](const Ball<Real>&) { return true; });
  }
  const VertexEdge edge{pair.vertex, pair.peer};
  return use(LineMargin<Real>(segment_, geometry_, edge.line(geometry_), margin_.terms<Real>(), models),
             BesideEdge<Real>(segment_, geometry_, edge, models));
}

template <class Real>
std::optional<PreciseTime> PreciseApproaches::first_root(const VertexPeer& pair, double from, double to,
                                                         Stage stage) const {
  return with_functions<Real>(pair, [&](const auto& f, const auto& counts) {
    return spacetime::first_root<Real>(segment_, f, counts, from, to, stage);
  });
}

/// Of a hundred pairs tested here, hardly one comes as close as the margin, and doubles nearly always show it.
bool PreciseApproaches::none_in_doubles(const VertexPeer& pair, double from, double to) const {
  try {
    return !first_root<double>(pair, from, to, Stage::doubles);
  } catch (const PrecisionExhausted&) {
    return false;
  }
}

std::optional<Approach> PreciseApproaches::first(const VertexPeer& pair, double from, double to) const {
  if (none_in_doubles(pair, from, to)) return std::nullopt;
  const auto root = decided("whether two bodies come as close as the clearance",
                            [&](auto zero, Stage stage) { return first_root<decltype(zero)>(pair, from, to, stage); });
  if (!root) return std::nullopt;
  Approach found;
  found.pair = pair;
  store_approach(*root, found);
  return found;
}

bool PreciseApproaches::close_at(const VertexPeer& pair, double t) const {
  return decided("whether two bodies are closer than the clearance", [&](auto zero, Stage) {
    using Real = decltype(zero);
    return with_functions<Real>(pair, [&](const auto& f, const auto& counts) {
      const Ball<Real> at = Ball<Real>::exact(t);
      return is_close(f, at) && counts(at);
    });
  });
}

int PreciseApproaches::side(const VertexPeer& pair, double t) const {
  return decided_sign([&](auto zero) {
    using Real = decltype(zero);
    const auto value = [&](const auto& f, const auto&) { return f.value(Ball<Real>::exact(t)); };
    return with_functions<Real>(pair, value);
  });
}

/// An approach that a stage cannot improve stays as it is.
void PreciseApproaches::refine(Approach& a, Stage stage) const {
  if (a.precise.stage < Stage::precise || a.precise.stage >= stage) return;
  with_stage(stage, [&](auto zero) {
    using Real = decltype(zero);
    with_functions<Real>(a.pair, [&](const auto& f, const auto&) {
      try {
        store_approach(refined_change<Real>(segment_, f, -1, a.precise, stage), a);
      } catch (const PrecisionExhausted&) {
      }
    });
  });
}

bool PreciseApproaches::before(Approach& a, Approach& b) const {
  const auto order = first_decisive([&](Stage stage) {
    refine(a, stage);
    refine(b, stage);
    return a.precise.is_first(b.precise);
  });
  // If their order cannot be decided, the choice makes no difference to the time.
  return order.value_or(false);
}

}  // namespace taut::internal::spacetime
