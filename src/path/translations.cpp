#include "path/translations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "path/boxes_overlap.hpp"
#include "path/convex_pieces.hpp"
#include "path/displacement_graph.hpp"
#include "path/slides.hpp"
#include "scene/ring_set.hpp"

namespace taut::internal::path {
namespace {

/// Shares by which obstacles are larger than they are, so that there is some room.
constexpr std::array rooms = {-3, -6, -10, -16, -26, -34, -42, -50};

/// Above, cells are faster.
constexpr std::size_t most_obstacles = 4000;

/// A convex piece of a body, and the layers that it reaches through.
struct Piece {
  Polygon outline;
  Layers z;
};

/// Pieces of a body that rests and of one that moves, which overlap at some displacements.
struct PieceNumbers {
  std::array<BodyId, 2> bodies;
  std::array<std::size_t, 2> pieces;
};

class Translation {
 public:
  /// Nothing if the problem is of another kind.
  static std::optional<Translation> of(const PathProblem& problem, const JointSpace& space) {
    Translation translation(problem, space);
    const bool valid = translation.find_slides() && translation.find_pieces() && translation.find_obstacles() &&
                       translation.find_goal();
    return valid ? std::optional(std::move(translation)) : std::nullopt;
  }

  using Way = std::optional<std::vector<JointValues>>;
  /// The shortest way past obstacles that are larger by this share. `decided`: whether there are such obstacles.
  Way way(const Dyadic& growth, bool& decided) const {
    const auto obstacles = enlarged(obstacles_, growth);
    decided = obstacles.has_value();
    return decided ? way(*obstacles, goal_) : std::nullopt;
  }
  /// The same with some room to the obstacles, but for those that the start has no room to, and to what is not outside.
  Way roomy_way(const Dyadic& growth) const {
    const auto obstacles = enlarged(obstacles_, growth, map_->displaced(problem_.start)),
               excluded = enlarged(goal_.excluded, growth);
    return obstacles && excluded ? way(*obstacles, {goal_.region, *excluded}) : std::nullopt;
  }
  double length(const std::vector<JointValues>& way) const {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < way.size(); ++i)
      sum += distance(map_->displaced(way[i]), map_->displaced(way[i + 1]));
    return sum;
  }
  /// More than rounding adds to, or takes from, the length of a way that turns at each corner once at the most: each
  /// distance is rounded by less than 2^-48 of the size.
  double rounding() const {
    const AxisBox range = bounds_of(range_);
    std::size_t corners = 2;
    for (const ConvexRing& ring : obstacles_) corners += ring.size();
    return static_cast<double>(corners) * 0x1p-46 *
           std::max({std::fabs(range.lo_x), std::fabs(range.lo_y), std::fabs(range.hi_x), std::fabs(range.hi_y)});
  }
  /// Why there is no way, if that is found.
  std::optional<Barrier> barrier(bool touching) const {
    const std::vector<Obstacle> obstacles = obstacles_with_pieces();
    BarrierProblem barriers{obstacles, beyond_ranges(), map_->displaced(problem_.start), goal_.region, {}, touching};
    if (!problem_.goal_outside) return find_barrier(barriers);
    for (const BoxesOverlap& boxes : boxes_) {
      if (!boxes.moves_like_the_map || !is_inside(boxes.ring, barriers.start)) continue;
      barriers.within = boxes.ring;
      if (auto found = find_barrier(barriers)) {
        found->boxes = boxes.bodies;
        return found;
      }
    }
    return std::nullopt;
  }
  /// The joints' ranges hold; is it out of the way of all that it has to be?
  bool is_goal(const JointValues& values) const {
    return goal_.excluded.empty() || goal_.contains(map_->displaced(values));
  }

 private:
  Translation(const PathProblem& problem, const JointSpace& space) : problem_(problem), space_(space) {}

  const Slides& slides(int body) const { return slides_.at(body); }
  bool moves(int body) const { return slides(body).moves(); }

  /// All that is tested and moves follows the joints in the same way.
  bool find_slides() {
    std::set<int> asked;
    for (const auto& pair : space_.pairs().pairs()) asked.insert(pair->bodies.begin(), pair->bodies.end());
    const Slides* mover = nullptr;
    for (const int body : asked) {
      const std::optional<Slides> found = slides_of(problem_.linkage, body);
      if (!found) return false;
      const Slides& slides = slides_.emplace(body, *found).first->second;
      if (!slides.moves()) continue;
      if (mover && !mover->moves_like(slides)) return false;
      mover = &slides;
    }
    if (!mover) return false;
    map_ = SlideMap::of(*mover);
    if (!map_) return false;
    const auto [lo, hi] = ranges();
    range_ = map_->displaced(lo, hi);
    return true;
  }
  bool find_pieces() {
    for (const auto& pair : space_.pairs().pairs()) {
      for (const int body : pair->bodies) {
        if (pieces_.count(body)) continue;
        const Body& of_scene = problem_.linkage.scene.bodies[static_cast<std::size_t>(body)];
        for (const Part& part : parts_of(of_scene)) {
          const auto outlines = convex_pieces(part);
          if (!outlines) return false;
          for (const Polygon& outline : *outlines) pieces_[body].push_back({outline, part.z.value_or(of_scene.z)});
        }
      }
    }
    return true;
  }
  /// False if there are too many, or two bodies overlap that move alike.
  bool find_obstacles() {
    std::set<std::array<BodyId, 2>> pairs;
    for (const auto& pair : space_.pairs().pairs()) pairs.insert(pair->bodies);
    const ExactPoint nowhere = ExactPoint::of({}, {});
    for (const auto& [a, b] : pairs) {
      const int mover = moves(a) ? a : b, rest = moves(a) ? b : a;
      const ExactVector &own = slides(mover).offset, &other = slides(rest).offset;
      for (std::size_t i = 0; i < pieces_.at(mover).size(); ++i) {
        for (std::size_t k = 0; k < pieces_.at(rest).size(); ++k) {
          const Piece &moving = pieces_.at(mover)[i], &resting = pieces_.at(rest)[k];
          if (!moving.z.meet(resting.z)) continue;
          ConvexRing ring = forbidden(resting.outline, moving.outline, other.x - own.x, other.y - own.y);
          if (!moves(rest)) {
            obstacles_.push_back(std::move(ring));
            sources_.push_back({{rest, mover}, {k, i}});
          } else if (is_inside(ring, nowhere)) {
            return false;
          }
          if (obstacles_.size() > most_obstacles) return false;
        }
      }
    }
    return true;
  }
  /// Where the goal is outside, bodies count that are not tested. False if these move in other ways.
  bool find_goal() {
    goal_.region = range_;
    if (problem_.goal_outside) {
      const auto boxes = boxes_overlap(problem_.linkage, *map_, space_.pairs());
      if (!boxes) return false;
      boxes_ = *boxes;
      for (const BoxesOverlap& one : boxes_) goal_.excluded.push_back(one.ring);
      return true;
    }
    JointValues lo{}, hi{};
    for (std::size_t k = 0; k < space_.dimension(); ++k) {
      const auto [from, to] = goal_range(k);
      lo[k] = from;
      hi[k] = to;
    }
    goal_.region = map_->displaced(lo, hi);
    return true;
  }
  std::array<JointValues, 2> ranges() const {
    std::array<JointValues, 2> range{};
    for (std::size_t k = 0; k < space_.dimension(); ++k) {
      range[0][k] = problem_.linkage.joints[k].lo;
      range[1][k] = problem_.linkage.joints[k].hi;
    }
    return range;
  }
  /// What the goal says of the joint, within its range.
  std::array<double, 2> goal_range(std::size_t k) const {
    const Joint& joint = problem_.linkage.joints[k];
    if (!problem_.goal[k]) return {joint.lo, joint.hi};
    return {std::max((*problem_.goal[k])[0], joint.lo), std::min((*problem_.goal[k])[1], joint.hi)};
  }

  /// Those stay as they are that would hold the point.
  static std::optional<std::vector<ConvexRing>> enlarged(const std::vector<ConvexRing>& rings, const Dyadic& growth,
                                                         const std::optional<ExactPoint>& except = {}) {
    if (growth.is_zero()) return rings;
    std::vector<ConvexRing> larger;
    for (const ConvexRing& ring : rings) {
      std::optional<ConvexRing> one = enlarged_by(ring, growth);
      if (!one) return std::nullopt;
      larger.push_back(except && is_inside(*one, *except) ? ring : std::move(*one));
    }
    return larger;
  }

  Way way(const std::vector<ConvexRing>& obstacles, const DisplacementGoal& goal) const {
    const auto found = DisplacementGraph(obstacles, range_).way(map_->displaced(problem_.start), goal);
    if (!found) return std::nullopt;
    return values_of(*found);
  }
  /// Joints that move nothing go to the goal with the last step.
  std::vector<JointValues> values_of(const std::vector<ExactPoint>& way) const {
    std::vector<JointValues> all = {problem_.start};
    for (std::size_t i = 1; i < way.size(); ++i) {
      all.push_back(map_->values_at(way[i], problem_.start));
      for (std::size_t k = 0; k < space_.dimension(); ++k)
        all[i][k] = std::clamp(all[i][k], problem_.linkage.joints[k].lo, problem_.linkage.joints[k].hi);
    }
    if (all.size() == 1) all.push_back(all.front());
    if (problem_.goal_outside) return all;
    for (std::size_t k = 0; k < space_.dimension(); ++k) {
      const auto [lo, hi] = goal_range(k);
      all.back()[k] = std::clamp(all.back()[k], lo, hi);
    }
    return all;
  }

  /// A piece where joints do not move it.
  ConvexRing placed(BodyId body, std::size_t piece) const {
    const ExactVector& by = slides(body).offset;
    ConvexRing ring;
    for (const Point& p : pieces_.at(body)[piece].outline)
      ring.push_back(ExactPoint::of(Dyadic::exact(p.x) + by.x, Dyadic::exact(p.y) + by.y));
    return ring;
  }
  std::vector<Obstacle> obstacles_with_pieces() const {
    std::vector<Obstacle> all;
    for (std::size_t i = 0; i < obstacles_.size(); ++i) {
      const auto& [bodies, pieces] = sources_[i];
      all.push_back({obstacles_[i], bodies, {placed(bodies[0], pieces[0]), placed(bodies[1], pieces[1])}});
    }
    return all;
  }
  /// As wide as the ranges, around them. One joint's range has no width: to the left and right of it.
  std::array<ConvexRing, 4> beyond_ranges() const {
    const std::vector<std::size_t>& moving = map_->joints();
    const ExactVector u = map_->slides().joint[moving[0]];
    const ExactVector v = moving.size() == 2 ? map_->slides().joint[moving[1]] : ExactVector{-u.y, u.x};
    const Joint &first = problem_.linkage.joints[moving[0]],
                second = moving.size() == 2 ? problem_.linkage.joints[moving[1]] : Joint{"", 0, 0};
    const double width = std::max({first.hi - first.lo, second.hi - second.lo, 1.0});
    const bool turned = (u.x * v.y - u.y * v.x).sign() < 0;
    const auto strip = [&](double lo, double hi, double other_lo, double other_hi, bool of_second) {
      const auto corner = [&](double a, double b) {
        const Dyadic s = Dyadic::exact(of_second ? b : a), t = Dyadic::exact(of_second ? a : b);
        return ExactPoint::of(s * u.x + t * v.x, s * u.y + t * v.y);
      };
      ConvexRing ring = {corner(lo, other_lo), corner(hi, other_lo), corner(hi, other_hi), corner(lo, other_hi)};
      if (turned != of_second) std::reverse(ring.begin(), ring.end());
      return ring;
    };
    const auto below = [&](const Joint& joint, const Joint& other, bool of_second) {
      return strip(joint.lo - width, joint.lo, other.lo - width, other.hi + width, of_second);
    };
    const auto above = [&](const Joint& joint, const Joint& other, bool of_second) {
      return strip(joint.hi, joint.hi + width, other.lo - width, other.hi + width, of_second);
    };
    return {below(first, second, false), above(first, second, false), below(second, first, true),
            above(second, first, true)};
  }

  const PathProblem& problem_;
  const JointSpace& space_;
  std::map<int, Slides> slides_;
  std::optional<SlideMap> map_;
  std::map<int, std::vector<Piece>> pieces_;
  std::vector<ConvexRing> obstacles_;
  std::vector<PieceNumbers> sources_;  ///< of each obstacle
  std::vector<BoxesOverlap> boxes_;    ///< if the goal is "outside"
  ConvexRing range_;
  DisplacementGoal goal_;
};

/// No way is shorter than the one that fits exactly, but for rounding.
bool measured(const Translation& translation, const std::vector<JointValues>& tight, PathAnswer& answer) {
  const double way = translation.length(answer.waypoints);
  // Where it stays, nothing is rounded.
  const double rounding = way > 0 ? translation.rounding() : 0;
  answer.length = PathLength{way + rounding, std::max(0.0, std::min(way, translation.length(tight)) - rounding), {}};
  return true;
}

}  // namespace

bool decide_translation(const PathProblem& problem, const PathOptions& options, const JointSpace& space,
                        const WayChecker& checker, const OnBarrier& on_barrier, PathAnswer& answer) {
  if (options.clearance > 0) return false;
  const std::optional<Translation> translation = Translation::of(problem, space);
  if (!translation) return false;
  bool decided = false;
  const Dyadic least = options.touch == Touch::open ? Dyadic() : Dyadic(1, -200);
  const auto tight = translation->way(least, decided);
  if (!decided) return false;
  answer.exact = true;
  if (!tight) {
    answer.outcome = PathOutcome::none;
    if (!on_barrier) return true;
    const auto barrier = translation->barrier(options.touch == Touch::closed);
    if (barrier && on_barrier(space, *barrier)) return true;
    answer.outcome = PathOutcome::undecided;
    return false;
  }
  const auto accept = [&](const std::vector<JointValues>& way) {
    if (!translation->is_goal(way.back()) || !checker.proves(way)) return false;
    answer.outcome = PathOutcome::path;
    answer.waypoints = way;
    return true;
  };
  // A way with some room is better, and nothing depends on rounding.
  // Not so where it has to be short.
  if (options.shortest && accept(*tight)) return measured(*translation, *tight, answer);
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    const auto roomy = translation->roomy_way(Dyadic(1, options.shortest ? rooms[rooms.size() - 1 - i] : rooms[i]));
    if (roomy && accept(*roomy)) return !options.shortest || measured(*translation, *tight, answer);
  }
  if (!accept(*tight))
    answer.reason = "there is a way that fits exactly, but its corners are not representable as doubles";
  return true;
}

}  // namespace taut::internal::path
