#include "path/barrier.hpp"

#include <algorithm>
#include <deque>
#include <utility>

#include "numeric/budget.hpp"
#include "path/convex_pieces.hpp"

namespace taut::internal::path {
namespace {

/// What is left of an obstacle, on one side of one of the goal's edges, say.
struct Cut {
  ConvexRing ring;
  /// Which of a segment's two long sides it is cut off along, if it is: 1 to the left, -1 to the right.
  int along = 0;
};

/// A convex polygon, within which a barrier may lead anywhere. If touching is enough, it may be a segment or a point.
struct Region {
  ConvexRing ring;
  int along;                 ///< of a cut
  const Obstacle* obstacle;  ///< null: it is beyond a side of the ranges
  int side;
  AxisBox box;
  ExactPoint middle;  ///< or a corner, if it has no area
};

/// A point that a region and another one have in common.
struct Passage {
  std::size_t to;
  ExactPoint at;
  bool crosses;  ///< from the one middle to the other by that point, an odd number of rays is crossed
};

/// What is on the ray's line is taken to be to the right of it, as seen along the ray.
struct Ray {
  ExactPoint from, ahead;

  static Ray to_the_right(const ExactPoint& p) { return {p, ExactPoint::of(p.x + p.w, p.y, p.w)}; }
  /// From where the segment begins, away from it.
  static Ray behind(const ExactPoint& begin, const ExactPoint& end) {
    const auto mirrored = [&](const Dyadic& b, const Dyadic& e) { return b * end.w + b * end.w - e * begin.w; };
    return {begin, ExactPoint::of(mirrored(begin.x, end.x), mirrored(begin.y, end.y), begin.w * end.w)};
  }
  bool holds(const ExactPoint& p) const {
    return same(p, from) || contains({from, p}, ahead) || contains({from, ahead}, p);
  }
  /// The way from a to b, where it may come to where the ray begins.
  bool crosses(const ExactPoint& a, const ExactPoint& b) const {
    const bool up = turn_sign(from, ahead, b) > 0;
    if ((turn_sign(from, ahead, a) > 0) == up) return false;
    return turn_sign(a, b, from) * (up ? 1 : -1) >= 0;
  }
};

/// From region to region, and around the start or the goal: a closed chain of regions that crosses the rays from these
/// an odd number of times in all. Regions do not hold what is inside of the goal. Those to the left and to the right of
/// a goal that is a segment may have points of it in common, and do not lead from the one to the other there.
class BarrierSearch {
 public:
  explicit BarrierSearch(const BarrierProblem& problem) : problem_(problem) {
    rays_.push_back(Ray::to_the_right(problem.start));
    if (!problem.within) rays_.push_back(ray_of_goal());
    for (const Obstacle& obstacle : problem.obstacles) add(obstacle.ring, &obstacle, 0);
    for (int side = 0; side < 4; ++side) add(problem.beyond[static_cast<std::size_t>(side)], nullptr, side);
    connect();
  }

  std::optional<Barrier> run() const {
    if (auto at_goal = barrier_at_goal()) return at_goal;
    const std::optional<std::size_t> first = on_odd_chain();
    if (!first) return std::nullopt;
    return barrier_along(shortest_odd_chain(*first));
  }

 private:
  using Chain = std::vector<std::pair<std::size_t, const Passage*>>;

  Ray ray_of_goal() const {
    const ConvexRing& goal = problem_.goal;
    if (goal.size() == 2) return Ray::behind(goal[0], goal[1]);
    return Ray::to_the_right(middle_of(goal));
  }
  void add(const ConvexRing& ring, const Obstacle* obstacle, int side) {
    const bool flat = problem_.touching && obstacle;
    for (Cut& cut : problem_.within ? cuts_within(ring, flat) : cuts_beside_goal(ring, flat)) {
      const AxisBox box = bounds_of(cut.ring);
      ExactPoint middle = middle_of(cut.ring);
      regions_.push_back({std::move(cut.ring), cut.along, obstacle, side, box, std::move(middle)});
    }
  }
  std::vector<Cut> cuts_within(ConvexRing ring, bool flat) const {
    const ConvexRing& within = *problem_.within;
    for (std::size_t k = 0; k < within.size() && !ring.empty(); ++k)
      ring = left_of(ring, within[k], within[(k + 1) % within.size()], flat);
    return ring.empty() ? std::vector<Cut>() : std::vector<Cut>{{std::move(ring)}};
  }
  /// What is on the other side of one of the goal's edges; beside a segment, and beyond its ends.
  std::vector<Cut> cuts_beside_goal(const ConvexRing& ring, bool flat) const {
    const ConvexRing& goal = problem_.goal;
    if (goal.size() < 2 || !bounds_of(ring).meets(bounds_of(goal))) return {{ring}};
    std::vector<Cut> cuts;
    const auto add_right = [&](const ExactPoint& a, const ExactPoint& b, int along) {
      ConvexRing part = left_of(ring, b, a, flat);
      if (!part.empty()) cuts.push_back({std::move(part), along});
    };
    for (std::size_t k = 0; k < goal.size(); ++k) {
      const ExactPoint &a = goal[k], &b = goal[(k + 1) % goal.size()];
      add_right(a, b, goal.size() > 2 ? 0 : k == 0 ? -1 : 1);
      if (goal.size() == 2) add_right(b, across(a, b), 0);
    }
    return cuts;
  }
  /// From b, straight to the left of the way from a.
  static ExactPoint across(const ExactPoint& a, const ExactPoint& b) {
    const Dyadic w = a.w * b.w;
    return ExactPoint::of(b.x * a.w - (b.y * a.w - a.y * b.w), b.y * a.w + (b.x * a.w - a.x * b.w), w);
  }

  /// Within a region. To the right of a segment, nothing crosses the ray from it, not even along that.
  bool crosses_rays(const Region& region, const ExactPoint& to) const {
    bool odd = rays_[0].crosses(region.middle, to);
    if (rays_.size() > 1 && region.along >= 0 && rays_[1].crosses(region.middle, to)) odd = !odd;
    return odd;
  }
  /// From the one's middle to the other's: within both, and where they meet, if only one is to the right of a segment.
  bool crosses_rays(const Region& a, const Region& b, const ExactPoint& at) const {
    const bool there = (a.along < 0) != (b.along < 0) && rays_[1].holds(at);
    return (crosses_rays(a, at) != crosses_rays(b, at)) != there;
  }
  void connect() {
    passages_.resize(regions_.size());
    for (std::size_t i = 0; i < regions_.size(); ++i) {
      for (std::size_t k = i + 1; k < regions_.size(); ++k) {
        const Region &a = regions_[i], &b = regions_[k];
        if (!a.box.meets(b.box) || a.along * b.along < 0) continue;
        checkpoint();
        // What is beyond one side and another one is not on either.
        const bool touching = problem_.touching && (a.obstacle || b.obstacle);
        const std::optional<ExactPoint> at = common_point(a.ring, b.ring, touching);
        if (!at) continue;
        const bool crosses = crosses_rays(a, b, *at);
        passages_[i].push_back({k, *at, crosses});
        passages_[k].push_back({i, *at, crosses});
      }
    }
  }

  /// A region on a closed chain that crosses the rays oddly, if there is one: where two ways to it from another one do
  /// not cross them alike.
  std::optional<std::size_t> on_odd_chain() const {
    std::vector<int> crossed(regions_.size(), -1);
    for (std::size_t first = 0; first < regions_.size(); ++first) {
      if (crossed[first] >= 0) continue;
      crossed[first] = 0;
      std::deque<std::size_t> todo = {first};
      while (!todo.empty()) {
        const std::size_t at = todo.front();
        todo.pop_front();
        for (const Passage& p : passages_[at]) {
          const int there = crossed[at] ^ (p.crosses ? 1 : 0);
          if (crossed[p.to] >= 0 && crossed[p.to] != there) return p.to;
          if (crossed[p.to] >= 0) continue;
          crossed[p.to] = there;
          todo.push_back(p.to);
        }
      }
    }
    return std::nullopt;
  }
  /// Each region once for either number of crossings, even or odd: from the first one, even, to itself, odd.
  Chain shortest_odd_chain(std::size_t first) const {
    const auto state = [](std::size_t region, bool odd) { return 2 * region + (odd ? 1 : 0); };
    std::vector<std::pair<std::size_t, const Passage*>> from(2 * regions_.size(), {SIZE_MAX, nullptr});
    std::deque<std::size_t> todo = {state(first, false)};
    while (from[state(first, true)].second == nullptr) {
      const std::size_t at = todo.front();
      todo.pop_front();
      for (const Passage& p : passages_[at / 2]) {
        const std::size_t next = state(p.to, (at % 2 == 1) != p.crosses);
        if (next == state(first, false) || from[next].second) continue;
        from[next] = {at, &p};
        todo.push_back(next);
      }
    }
    Chain chain;
    for (std::size_t at = state(first, true); at != state(first, false); at = from[at].first)
      chain.emplace_back(from[at].first / 2, from[at].second);
    std::reverse(chain.begin(), chain.end());
    return chain;
  }

  /// Where bodies collide at a goal that is a point, that is all.
  std::optional<Barrier> barrier_at_goal() const {
    if (problem_.within || problem_.goal.size() != 1) return std::nullopt;
    const ExactPoint& goal = problem_.goal[0];
    for (const Obstacle& obstacle : problem_.obstacles) {
      if (!(problem_.touching ? contains(obstacle.ring, goal) : is_inside(obstacle.ring, goal))) continue;
      const auto place = common_place(obstacle, goal);
      if (place) return Barrier{{{goal, obstacle.bodies, {*place, *place}}}};
    }
    return std::nullopt;
  }
  /// Through each obstacle straight, since it is convex and holds neither the start nor the goal; beyond the ranges by
  /// the middle of the region, whose ends may be where the ranges end.
  std::optional<Barrier> barrier_along(const Chain& chain) const {
    Barrier barrier;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const ExactPoint &from = chain[(i + chain.size() - 1) % chain.size()].second->at, &to = chain[i].second->at;
      const Region& region = regions_[chain[i].first];
      BarrierEdge edge;
      edge.from = from;
      edge.side = region.side;
      if (region.obstacle) {
        edge.bodies = region.obstacle->bodies;
        const auto begin = common_place(*region.obstacle, from), end = common_place(*region.obstacle, to);
        if (!begin || !end) return std::nullopt;
        edge.common = {*begin, *end};
        barrier.edges.push_back(std::move(edge));
        continue;
      }
      barrier.edges.push_back(edge);
      edge.from = region.middle;
      barrier.edges.push_back(std::move(edge));
    }
    return barrier;
  }
  /// A point that both pieces have at a displacement.
  std::optional<ExactPoint> common_place(const Obstacle& obstacle, const ExactPoint& displacement) const {
    ConvexRing moved;
    for (const ExactPoint& p : obstacle.pieces[1])
      moved.push_back(ExactPoint::of(p.x + displacement.x, p.y + displacement.y));
    return common_point(obstacle.pieces[0], moved, problem_.touching);
  }

  const BarrierProblem& problem_;
  std::vector<Ray> rays_;
  std::vector<Region> regions_;
  std::vector<std::vector<Passage>> passages_;
};

}  // namespace

std::optional<Barrier> find_barrier(const BarrierProblem& problem) { return BarrierSearch(problem).run(); }

}  // namespace taut::internal::path
