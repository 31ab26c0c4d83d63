#include "path/translations.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "path/convex_pieces.hpp"
#include "path/displacement_graph.hpp"
#include "path/goal.hpp"
#include "scene/ring_set.hpp"

namespace taut::internal::path {
namespace {

/// Above, cells are faster.
constexpr std::size_t most_obstacles = 4000;

/// How the body is displaced: by `offset`, and by the axes' joints times 1 or another power of two, if it moves.
struct Slides {
  Dyadic offset_x, offset_y;
  std::optional<int> joint_x, joint_y;
  double times_x = 0, times_y = 0;

  bool moves() const { return joint_x || joint_y; }
  bool like(const Slides& o) const {
    return joint_x == o.joint_x && joint_y == o.joint_y && times_x == o.times_x && times_y == o.times_y;
  }
};

bool is_power_of_two(double x) {
  int exponent = 0;
  return x != 0 && std::fabs(std::frexp(x, &exponent)) == 0.5;
}

/// Adds a motion, if it is along an axis and exact.
bool add(Slides& slides, const JointMotion& motion) {
  const auto* slide = std::get_if<Slide>(&motion.kind);
  if (!slide || (slide->direction.x != 0) == (slide->direction.y != 0)) return false;
  const bool along_x = slide->direction.x != 0;
  const double direction = along_x ? slide->direction.x : slide->direction.y, times = motion.times * direction;
  if (!is_power_of_two(motion.times) || !is_power_of_two(direction)) return false;
  std::optional<int>& joint = along_x ? slides.joint_x : slides.joint_y;
  if (joint) return false;
  joint = motion.joint;
  (along_x ? slides.times_x : slides.times_y) = times;
  Dyadic& offset = along_x ? slides.offset_x : slides.offset_y;
  offset = offset + Dyadic::exact(motion.plus) * Dyadic::exact(direction);
  return true;
}

class Translation {
 public:
  Translation(const PathProblem& problem, const JointSpace& space) : problem_(problem), space_(space) {
    valid_ = find_slides() && find_pieces();
  }
  bool valid() const { return valid_; }

  std::optional<std::vector<JointValues>> way(const Dyadic& growth, bool& decided) const {
    std::vector<Obstacle> obstacles;
    decided = true;
    for (const auto& pair : space_.pairs().pairs()) {
      const auto [a, b] = pair->bodies;
      const bool first = slides_of(a).moves();
      const int mover = first ? a : b, rest = first ? b : a;
      for (const Polygon& moving : pieces_.at(mover)) {
        for (const Polygon& resting : pieces_.at(rest)) {
          obstacles.push_back(forbidden(resting, moving, slides_of(rest).offset_x - slides_of(mover).offset_x,
                                        slides_of(rest).offset_y - slides_of(mover).offset_y, growth));
          if (obstacles.back().empty()) decided = false;
        }
      }
    }
    if (!decided) return std::nullopt;
    const DisplacementGraph graph(std::move(obstacles), range());
    const auto found = graph.way(displaced(problem_.start), goals());
    if (!found) return std::nullopt;
    return values_of(*found);
  }
  std::size_t obstacles() const {
    std::size_t n = 0;
    for (const auto& pair : space_.pairs().pairs())
      n += pieces_.at(pair->bodies[0]).size() * pieces_.at(pair->bodies[1]).size();
    return n;
  }

 private:
  const Slides& slides_of(int body) const { return slides_[static_cast<std::size_t>(body)]; }
  const Joint& joint_x() const { return problem_.linkage.joints[static_cast<std::size_t>(*mover_.joint_x)]; }
  const Joint& joint_y() const { return problem_.linkage.joints[static_cast<std::size_t>(*mover_.joint_y)]; }

  /// Every body that is tested follows both axes in the same way, or does not move.
  bool find_slides() {
    const std::vector<Body>& bodies = problem_.linkage.scene.bodies;
    std::map<std::string, std::size_t> by_name;
    for (std::size_t i = 0; i < bodies.size(); ++i) by_name[bodies[i].name] = i;
    std::set<int> asked;
    for (const auto& pair : space_.pairs().pairs()) asked.insert(pair->bodies.begin(), pair->bodies.end());
    slides_.resize(bodies.size());
    for (const int i : asked) {
      Slides& slides = slides_[static_cast<std::size_t>(i)];
      for (auto body = static_cast<std::size_t>(i);; body = by_name.at(bodies[body].relative_to)) {
        const auto& motion = problem_.linkage.motions[body];
        for (const JointMotion& m : motion ? single_motions(*motion) : std::vector<JointMotion>()) {
          if (!add(slides, m)) return false;
        }
        if (bodies[body].relative_to.empty()) break;
      }
      if (!slides.moves()) continue;
      if (!slides.joint_x || !slides.joint_y || *slides.joint_x == *slides.joint_y) return false;
      if (mover_.moves() && !mover_.like(slides)) return false;
      mover_ = slides;
    }
    return mover_.moves();
  }
  /// Of bodies that have no layers: each of these would be a body of its own.
  bool find_pieces() {
    const std::vector<Body>& bodies = problem_.linkage.scene.bodies;
    if (space_.pairs().world().bodies().size() != bodies.size()) return false;
    for (const auto& pair : space_.pairs().pairs()) {
      for (const int body : pair->bodies) {
        if (pieces_.count(body)) continue;
        for (const Part& part : parts_of(bodies[static_cast<std::size_t>(body)])) {
          const auto pieces = convex_pieces(part);
          if (!pieces) return false;
          pieces_[body].insert(pieces_[body].end(), pieces->begin(), pieces->end());
        }
      }
    }
    return obstacles() <= most_obstacles;
  }

  ExactPoint displaced(const JointValues& values) const {
    return ExactPoint::of(
        Dyadic::exact(values[static_cast<std::size_t>(*mover_.joint_x)]) * Dyadic::exact(mover_.times_x),
        Dyadic::exact(values[static_cast<std::size_t>(*mover_.joint_y)]) * Dyadic::exact(mover_.times_y));
  }
  AxisBox range() const {
    return {Point{joint_x().lo * mover_.times_x, joint_y().lo * mover_.times_y},
            Point{joint_x().hi * mover_.times_x, joint_y().hi * mover_.times_y}};
  }
  /// Of a range, the point of it that is nearest to the start, its corners and its middle.
  std::vector<ExactPoint> goals() const {
    std::vector<ExactPoint> found;
    const auto choices = [&](int joint) {
      const auto k = static_cast<std::size_t>(joint);
      const Joint& j = problem_.linkage.joints[k];
      const auto goal = problem_.goal[k] ? *problem_.goal[k] : std::array<double, 2>{j.lo, j.hi};
      const double lo = std::max(goal[0], j.lo), hi = std::min(goal[1], j.hi);
      return std::array<double, 4>{lo, hi, lo + (hi - lo) / 2, std::clamp(problem_.start[k], lo, hi)};
    };
    for (const double x : choices(*mover_.joint_x)) {
      for (const double y : choices(*mover_.joint_y)) {
        JointValues values{};
        values[static_cast<std::size_t>(*mover_.joint_x)] = x;
        values[static_cast<std::size_t>(*mover_.joint_y)] = y;
        found.push_back(displaced(values));
      }
    }
    return found;
  }
  /// Joints that move nothing go to the goal with the last step.
  std::vector<JointValues> values_of(const std::vector<ExactPoint>& way) const {
    std::vector<JointValues> all;
    for (const ExactPoint& p : way) {
      JointValues values = problem_.start;
      values[static_cast<std::size_t>(*mover_.joint_x)] = p.near.x / mover_.times_x;
      values[static_cast<std::size_t>(*mover_.joint_y)] = p.near.y / mover_.times_y;
      all.push_back(values);
    }
    for (std::size_t k = 0; k < space_.dimension(); ++k) {
      const int joint = static_cast<int>(k);
      if (joint == *mover_.joint_x || joint == *mover_.joint_y || !problem_.goal[k]) continue;
      all.back()[k] = std::clamp(problem_.start[k], (*problem_.goal[k])[0], (*problem_.goal[k])[1]);
    }
    if (all.size() == 1) all.push_back(all.front());
    return all;
  }

  const PathProblem& problem_;
  const JointSpace& space_;
  std::vector<Slides> slides_;
  Slides mover_;
  std::map<int, std::vector<Polygon>> pieces_;
  bool valid_ = false;
};

/// Is the goal one place? Joints that move nothing do not matter.
bool has_one_goal(const PathProblem& problem, const JointSpace& space) {
  for (std::size_t k = 0; k < space.dimension(); ++k) {
    const auto& pairs = space.pairs().pairs();
    const bool matters =
        std::any_of(pairs.begin(), pairs.end(), [&](const auto& pair) { return space.pairs().follows(*pair, k); });
    if (matters && (!problem.goal[k] || (*problem.goal[k])[0] != (*problem.goal[k])[1])) return false;
  }
  return true;
}

}  // namespace

bool decide_translation(const PathProblem& problem, const PathOptions& options, const JointSpace& space,
                        const WayChecker& checker, PathAnswer& answer) {
  if (options.clearance > 0 || problem.goal_outside) return false;
  const Translation translation(problem, space);
  if (!translation.valid()) return false;
  bool decided = false;
  const Dyadic least = options.touch == Touch::open ? Dyadic() : Dyadic(1, -200);
  const auto tight = translation.way(least, decided);
  if (!decided || (!tight && !has_one_goal(problem, space))) return false;
  answer.exact = true;
  if (!tight) {
    answer.outcome = PathOutcome::none;
    return true;
  }
  // A way with some room is better, and nothing depends on rounding.
  for (const int exponent : {-3, -6, -10, -16, -26, -34, -42, -50}) {
    const auto roomy = translation.way(Dyadic(1, exponent), decided);
    if (!roomy || !checker.proves(*roomy)) continue;
    answer.outcome = PathOutcome::path;
    answer.waypoints = *roomy;
    return true;
  }
  if (checker.proves(*tight)) {
    answer.outcome = PathOutcome::path;
    answer.waypoints = *tight;
    return true;
  }
  answer.reason = "there is a way that fits exactly, but its corners are not representable as doubles";
  return true;
}

}  // namespace taut::internal::path
