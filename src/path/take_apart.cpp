#include "path/take_apart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "geometry/vector.hpp"
#include "motion/pose.hpp"
#include "numeric/budget.hpp"
#include "query/separate_straight.hpp"
#include "scene/fitted_scene.hpp"
#include "scene/instance.hpp"
#include "scene/ring_set.hpp"
#include "scene/untested.hpp"
#include "taut/motions.hpp"
#include "taut/path.hpp"

namespace taut::internal::path {
namespace {

/// Each body is first given so many cells, so that one that leaves easily is found before much is spent on others.
constexpr std::uint64_t fewest_cells = 4096;
constexpr std::uint64_t cells_factor = 8;

/// One body and all that block it, as a body of their own.
struct MoverAndRest {
  Scene scene;  ///< the rest, then the mover
  AxisBox rest, mover;
  Point pivot;        ///< the middle of the mover
  double radius = 0;  ///< no vertex of the mover is farther from it
};

Scene moved(const MoverAndRest& two, const std::vector<WayPoint>& points) {
  Scene scene = two.scene;
  std::vector<Keyframe> frames;
  for (const WayPoint& at : points) frames.push_back({static_cast<double>(frames.size()), at.x, at.y, at.deg});
  scene.bodies[1].motion = from_keyframes(frames, two.pivot);
  scene.end = static_cast<double>(points.size()) - 1;
  return scene;
}

class Disassembly {
 public:
  Disassembly(const StandingScene& standing, const SeparateOptions& options, const Budget& budget, Separation& answer)
      : scene_(standing.scene), options_(options), budget_(budget), answer_(answer), left_(scene_.bodies.size()) {
    std::iota(left_.begin(), left_.end(), 0);
  }

  void run() {
    try {
      while (left_.size() > 1 && (take_straight() || take_along_way())) {
      }
    } catch (const Interrupted& limit) {
      answer_.stuck.clear();
      answer_.unsure = left_;
      answer_.reason = limit.reason;
    }
    answer_.outcome = left_.size() <= 1        ? SeparationOutcome::free
                      : answer_.unsure.empty() ? SeparationOutcome::locked
                                               : SeparationOutcome::undecided;
  }

 private:
  void note_progress() const {
    budget_.check();
    report_parts("bodies taken away", scene_.bodies.size() - left_.size(), scene_.bodies.size());
  }

  /// Of two bodies, the second one moves: what the one can do is what the other can.
  std::vector<BodyId> movers() const { return left_.size() == 2 ? std::vector{left_[1]} : left_; }

  MoverAndRest mover_and_rest(BodyId mover) const {
    const std::vector<BodyId> blockers = blockers_of(scene_, mover, left_);
    const Body& own = scene_.bodies[static_cast<std::size_t>(mover)];
    Body rest;
    rest.name = own.name == "the rest" ? "all others" : "the rest";
    for (const BodyId k : blockers) {
      const Body& body = scene_.bodies[static_cast<std::size_t>(k)];
      for (Part part : parts_of(body)) {
        if (!part.z) part.z = body.z;
        rest.parts.push_back(std::move(part));
      }
    }
    MoverAndRest two{{}, extent_of(scene_, blockers), extent_of(own), {}, 0};
    two.scene.bodies = {std::move(rest), own};
    two.pivot = {two.mover.lo_x + two.mover.width() / 2, two.mover.lo_y + two.mover.height() / 2};
    for (const Part& part : parts_of(own))
      for (const Point& p : part.outline)
        two.radius = std::max(two.radius, std::hypot(p.x - two.pivot.x, p.y - two.pivot.y) * (1 + 0x1p-40));
    return two;
  }

  void take(BodyId body, const MoverAndRest& two, std::vector<WayPoint> points) {
    answer_.ways.push_back({body, two.pivot, std::move(points)});
    left_.erase(std::find(left_.begin(), left_.end(), body));
  }

  /// Takes away those that leave straight, as far as that goes. Returns whether it took one.
  bool take_straight() {
    note_progress();
    Scene those = scene_;
    those.bodies.clear();
    for (const BodyId k : left_) those.bodies.push_back(scene_.bodies[static_cast<std::size_t>(k)]);
    those.clearances.clear();
    std::erase_if(those.ignore,
                  [&](const auto& pair) { return !is_there(those, pair[0]) || !is_there(those, pair[1]); });
    const Separation found = separate_straight(those, {});
    std::vector<RemovalStep> steps = found.order;
    if (found.bodies.size() == 1 && !found.bodies[0].free.empty()) steps = {widest_removal(found.bodies[0])};
    const std::vector<BodyId> names = left_;
    bool any = false;
    for (const RemovalStep& step : steps)
      any = take_straight(names[static_cast<std::size_t>(step.body)], step, names) || any;
    return any;
  }

  static bool is_there(const Scene& scene, const std::string& name) {
    return name == "*" ||
           std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const Body& body) { return body.name == name; });
  }

  /// The vertex at its place; `names`: the bodies that a reference counts.
  Point place(const VertexRef& vertex, const std::vector<BodyId>& names) const {
    const Part part = parts_of(scene_.bodies[static_cast<std::size_t>(
        names[static_cast<std::size_t>(vertex.body)])])[static_cast<std::size_t>(vertex.part)];
    const Polygon& ring = vertex.ring == 0 ? part.outline : part.holes[static_cast<std::size_t>(vertex.ring - 1)];
    return ring[static_cast<std::size_t>(vertex.index)];
  }

  /// A direction that fits exactly is known as a difference of vertices; false if a difference of doubles is not exact
  /// enough to go along it.
  bool take_straight(BodyId body, const RemovalStep& step, const std::vector<BodyId>& names) {
    const MoverAndRest two = mover_and_rest(body);
    const double angle = step.direction_deg * (std::acos(-1.0) / 180);
    // check() decides about the way, not the angle: along an axis, it goes exactly.
    const auto along_axis = [](double u) { return std::fabs(u) < 1e-12 ? 0 : u; };
    Point towards{along_axis(std::cos(angle)), along_axis(std::sin(angle))};
    if (step.free.point && step.free.from_vertices) {
      const auto& [own, other] = *step.free.from_vertices;
      const Point a = place(own, names), b = place(other, names);
      towards = {b.x - a.x, b.y - a.y};
    }
    const double times = exit_along(two, towards);
    // A power of two keeps a direction that fits exactly.
    const double factor = step.free.point ? std::exp2(std::ceil(std::log2(times))) : times;
    std::vector<WayPoint> points = {{}};
    if (times > 0) points.push_back({towards.x * factor, towards.y * factor, 0});
    if (times > 0 && !is_free(moved(two, points))) return false;
    take(body, two, std::move(points));
    return true;
  }

  /// Bodies without a common layer are no pair to test.
  static bool is_free(const Scene& scene) {
    const Outcome outcome = check(scene, {.tell_touching = false}).outcome;
    return outcome == Outcome::free || outcome == Outcome::untested;
  }

  /// How many times the vector leads out of the box of the rest; 0 if the mover is outside.
  static double exit_along(const MoverAndRest& two, const Point& towards) {
    const AxisBox &r = two.rest, &m = two.mover;
    const auto along = [](double u, double forwards, double back) {
      return u > 0 ? forwards / u : u < 0 ? back / -u : INFINITY;
    };
    const double x = along(towards.x, r.hi_x - m.lo_x, m.hi_x - r.lo_x);
    const double y = along(towards.y, r.hi_y - m.lo_y, m.hi_y - r.lo_y);
    const bool outside = r.hi_x <= m.lo_x || m.hi_x <= r.lo_x || r.hi_y <= m.lo_y || m.hi_y <= r.lo_y;
    return outside ? 0 : std::min(x, y) * (1 + 0x1p-10);
  }

  /// Takes away one body along a way, or sets what is left. Returns whether it took one.
  bool take_along_way() {
    const std::vector<BodyId> all = movers();
    std::vector<BodyId> open = all;
    answer_.stuck.clear();
    answer_.unsure.clear();
    std::string reason;
    for (std::uint64_t cells = fewest_cells; !open.empty(); cells *= cells_factor) {
      const std::uint64_t most = std::min(cells, options_.max_cells);
      std::vector<BodyId> later;
      for (const BodyId body : open) {
        note_progress();
        const MoverAndRest two = mover_and_rest(body);
        const PathAnswer found = find_way(two, most);
        if (found.outcome == PathOutcome::path) {
          std::vector<WayPoint> points;
          for (const JointValues& at : found.waypoints) points.push_back({at[0], at[1], at[2]});
          take(body, two, std::move(points));
          answer_.stuck.clear();
          answer_.unsure.clear();
          return true;
        }
        if (found.outcome == PathOutcome::none) {
          answer_.stuck.push_back(body);
        } else if (found.tight || most == options_.max_cells) {
          answer_.unsure.push_back(body);
          if (reason.empty()) reason = why_undecided(body, two, found);
        } else {
          later.push_back(body);
        }
      }
      open = std::move(later);
    }
    if (all.size() < left_.size()) (answer_.unsure.empty() ? answer_.stuck : answer_.unsure) = left_;
    std::sort(answer_.stuck.begin(), answer_.stuck.end());
    std::sort(answer_.unsure.begin(), answer_.unsure.end());
    answer_.reason = reason;
    return false;
  }

  PathAnswer find_way(const MoverAndRest& two, std::uint64_t cells) const {
    PathProblem problem = problem_of(two);
    PathOptions options;
    options.tolerance = options_.tolerance;
    options.max_cells = cells;
    // At first without turning: exact signs decide that also where bodies fit exactly.
    if (cells == std::min(fewest_cells, options_.max_cells)) {
      PathAnswer shifted = find_path(problem, options);
      if (shifted.outcome == PathOutcome::path) {
        cut_at_exit(two, shifted.waypoints);
        return shifted;
      }
    }
    std::get<FreeMotion>(problem.linkage.motions[1]->kind).deg = 2;
    problem.linkage.joints.push_back({"turn", 0, 360});
    problem.periodic[2] = true;
    problem.goal = {};
    problem.goal_outside = true;
    return find_path(problem, options);
  }

  static void cut_at_exit(const MoverAndRest& two, std::vector<JointValues>& shifts) {
    const auto outside = [&](const JointValues& by) {
      const AxisBox &r = two.rest, &m = two.mover;
      return m.lo_x + by[0] >= r.hi_x || m.hi_x + by[0] <= r.lo_x || m.lo_y + by[1] >= r.hi_y ||
             m.hi_y + by[1] <= r.lo_y;
    };
    const auto exit = std::find_if(shifts.begin(), shifts.end(), outside);
    if (exit != shifts.end()) shifts.erase(exit + 1, shifts.end());
  }

  /// Without turns, to one of the places around the rest, which are all joined. Before its box leaves the box of the
  /// rest, the mover is not farther from it than its radius: ways that go farther are not needed.
  static PathProblem problem_of(const MoverAndRest& two) {
    const auto range = [&](double lo, double hi, double at) {
      const double room = two.radius * (1 + 0x1p-4);
      return std::array{std::min(0.0, lo - room - at), std::max(0.0, hi + room - at)};
    };
    const auto [lo_x, hi_x] = range(two.rest.lo_x, two.rest.hi_x, two.pivot.x);
    const auto [lo_y, hi_y] = range(two.rest.lo_y, two.rest.hi_y, two.pivot.y);
    PathProblem problem;
    problem.linkage.joints = {{"x", lo_x, hi_x}, {"y", lo_y, hi_y}};
    problem.linkage.scene = two.scene;
    problem.linkage.motions = {std::nullopt, JointMotion{FreeMotion{0, 1, std::nullopt, two.pivot}}};
    problem.goal = {std::array{hi_x, hi_x}, std::array{hi_y, hi_y}};
    return problem;
  }

  std::string why_undecided(BodyId body, const MoverAndRest& two, const PathAnswer& found) const {
    const std::string& name = scene_.bodies[static_cast<std::size_t>(body)].name;
    if (!found.tight) return fmt::format("\"{}\": {}", name, found.reason);
    const JointValues& at = found.tight->values;
    return fmt::format(
        "it is too tight for \"{}\" to decide at this tolerance, where it is moved by ({:.6g}, {:.6g}) and turned by "
        "{:.6g} degrees about ({:.6g}, {:.6g})",
        name, at[0], at[1], at[2], two.pivot.x, two.pivot.y);
  }

  const Scene& scene_;
  const SeparateOptions& options_;
  const Budget& budget_;
  Separation& answer_;
  std::vector<BodyId> left_;  ///< those that have not been taken away
};

/// Where the body is at t. Returns a bound of what rounding moves a vertex by.
double put_in_place(Body& body, const MotionChain& motions, double t, int exponent) {
  if (motions.empty()) return 0;
  const Pose<double> pose = pose_of<Jet<double>>(pieces_at(motions, t), Ball<double>::exact(t));
  const Vector origin{std::ldexp(pose.ox.v.mid, -exponent), std::ldexp(pose.oy.v.mid, -exponent)};
  const Vector axis{pose.xx.v.mid, pose.xy.v.mid};
  const double shift = std::ldexp(pose.ox.v.rad + pose.oy.v.rad, -exponent), turn = pose.xx.v.rad + pose.xy.v.rad;
  const bool moves = origin.x != 0 || origin.y != 0 || axis.x != 1 || axis.y != 0;
  if (!moves && shift == 0 && turn == 0) return 0;
  double bound = 0;
  const auto place = [&](Polygon& ring) {
    for (Point& p : ring) {
      // Three roundings of each coordinate, and some room for this sum.
      const double size = l1_norm({p.x, p.y});
      bound = std::max(bound, shift + turn * size + 0x1p-50 * (l1_norm(origin) + 2 * size));
      const Vector q = origin + axis * Vector{p.x, p.y};
      p = {q.x, q.y};
    }
  };
  for (Part& part : body.parts) {
    place(part.outline);
    for (Polygon& hole : part.holes) place(hole);
  }
  return bound;
}

/// Whether rounding may have changed which ways fit exactly. `given`: the answer before rounding.
bool fits_exactly(const Separation& given, const Separation& rounded) {
  if (rounded.overlap) return true;
  for (std::size_t k = 0; k < given.bodies.size(); ++k) {
    const std::vector<DirectionArc>& before = given.bodies[k].free;
    const bool lost = !before.empty() && rounded.bodies[k].free.empty();
    if (lost || std::any_of(before.begin(), before.end(), [](const DirectionArc& arc) { return arc.point; }))
      return true;
  }
  return false;
}

/// Shrinks all bodies a little, so that those that fit exactly before rounding have room after it.
void part_what_touched(StandingScene& standing) {
  double largest = 0;
  for (const Body& body : standing.scene.bodies) {
    const AxisBox box = extent_of(body);
    largest = std::max({largest, -box.lo_x, -box.lo_y, box.hi_x, box.hi_y});
  }
  const double fit = std::max(4 * standing.rounded, 0x1p-39 * largest);
  standing.scene = FittedScene(standing.scene, fit).scene();
  standing.rounded += 2 * fit;
}

}  // namespace

StandingScene standing_scene(const Scene& scene) {
  StandingScene standing{scene, 0};
  const Instance instance(scene);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    Body& body = standing.scene.bodies[k];
    body.parts = parts_of(scene.bodies[k]);
    body.polygon.clear();
    body.prepared = nullptr;
    body.motion = {};
    body.relative_to.clear();
    const double moved = put_in_place(body, instance.bodies()[k].motions, instance.start(), instance.exponent());
    standing.rounded = std::max(standing.rounded, moved);
  }
  standing.scene.start = standing.scene.end = 0;
  standing.scene.at_rest = AtRest::test;
  standing.scene.mechanism.reset();
  standing.scene.lock.reset();
  standing.scene.assembly = nullptr;
  if (standing.rounded > 0 && fits_exactly(separate_straight(scene, {}), separate_straight(standing.scene, {})))
    part_what_touched(standing);
  return standing;
}

AxisBox extent_of(const Body& body) {
  AxisBox box;
  for (const Part& part : parts_of(body)) box.include(box_around(part.outline));
  return box;
}

AxisBox extent_of(const Scene& scene, const std::vector<BodyId>& bodies) {
  AxisBox box;
  for (const BodyId k : bodies) box.include(extent_of(scene.bodies[static_cast<std::size_t>(k)]));
  return box;
}

std::vector<BodyId> blockers_of(const Scene& scene, BodyId body, const std::vector<BodyId>& among) {
  const IgnoredPairs ignored(scene);
  std::vector<BodyId> blockers;
  for (const BodyId k : among) {
    if (k != body && !ignored.has(std::min(k, body), std::max(k, body))) blockers.push_back(k);
  }
  return blockers;
}

void take_apart(const StandingScene& standing, const SeparateOptions& options, const Budget& budget,
                Separation& answer) {
  answer.rounded = standing.rounded;
  Disassembly(standing, options, budget, answer).run();
}

}  // namespace taut::internal::path
