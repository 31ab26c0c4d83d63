// Changes of a simulation from the present on: motions, and what begins it anew.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "motion/pieces.hpp"
#include "session/simulation_impl.hpp"
#include "taut/pose.hpp"

namespace taut {

using namespace internal;

void Simulation::Impl::check_body(BodyId body) const {
  const auto count = static_cast<BodyId>(scene.bodies.size());
  if (body < 0 || body >= count)
    throw InputError("", "there is no body " + std::to_string(body), "bodies are 0 to " + std::to_string(count - 1));
  if (removed[static_cast<std::size_t>(body)])
    throw InputError("", "body " + std::to_string(body) + " was removed", "name a body that is still there");
}

void Simulation::Impl::set_motion(BodyId body, const Motion& motion) {
  check_body(body);
  if (world->over() && !in_contact()) return;
  changed_since_contact = true;
  if (world->time() == begun_anew) {
    // Right where a world begins there is nothing before, from which a bridge could lead.
    world->check_motion(body, motion);
    Scene next = scene;
    next.bodies[static_cast<std::size_t>(body)].motion = motion;
    return begin_anew(std::move(next));
  }
  world->set_motion(body, motion);
  scene.bodies[static_cast<std::size_t>(body)].motion = motion;
  if (options.record) record.change(body, motion, world->time());
}

void Simulation::Impl::begin_anew(Scene next) {
  const double now = world->time();
  next.start = now;
  next.at_rest = world->at_rest();
  std::vector<bool> gone = removed;
  gone.resize(next.bodies.size(), false);
  std::unique_ptr<WorldSimulation> fresh = make_world(next);
  next.at_rest = scene.at_rest;
  const Answer& answer = fresh->answer();
  if (answer.outcome == Outcome::overlap_at_start) {
    const auto name = [&](int k) {
      return next.bodies[static_cast<std::size_t>((*answer.pair)[static_cast<std::size_t>(k)])].name;
    };
    throw InputError(name(1), fmt::format("it would overlap \"{}\" at the present, t = {}", name(0), now),
                     "move it, or ignore the pair first");
  }
  events_before += world->events();
  certificates_max_before = std::max(certificates_max_before, world->certificates_max());
  fresh->carry_on(*world);
  world = std::move(fresh);
  begun_anew = now;
  scene = std::move(next);
  removed = std::move(gone);
  if (!options.record) return;
  record.end(now);
  record.begin(scene, removed);
}

BodyId Simulation::add_body(const Body& body) {
  Impl& impl = usable();
  impl.expect_changeable();
  impl.changing([&] {
    impl.world->settle();
    Scene next = impl.scene;
    next.bodies.push_back(body);
    impl.begin_anew(std::move(next));
  });
  return static_cast<BodyId>(impl.scene.bodies.size()) - 1;
}

/// The body stays in the scene, ignored by all others, under a name that no other one has.
void Simulation::remove_body(BodyId body) {
  Impl& impl = usable();
  impl.expect_changeable();
  impl.check_body(body);
  impl.changing([&] {
    impl.world->settle();
    Scene next = impl.scene;
    std::string& name = next.bodies[static_cast<std::size_t>(body)].name;
    for (std::size_t k = 0; k < next.bodies.size(); ++k) {
      if (next.bodies[k].relative_to == name && !impl.removed[k])
        throw InputError(next.bodies[k].name, "it is attached to \"" + name + "\", which is to be removed",
                         "attach it to another body first: set_parent()");
    }
    const auto names_it = [&](const std::array<std::string, 2>& pair) { return pair[0] == name || pair[1] == name; };
    std::erase_if(next.ignore, names_it);
    std::erase_if(next.clearances, [&](const PairClearance& entry) { return names_it(entry.pair); });
    name = name + " (body " + std::to_string(body) + ", removed)";
    next.ignore.push_back({name, "*"});
    std::vector<bool> before = impl.removed;
    impl.removed[static_cast<std::size_t>(body)] = true;
    try {
      impl.begin_anew(std::move(next));
    } catch (...) {
      impl.removed = std::move(before);
      throw;
    }
  });
}

void Simulation::ignore(BodyId a, BodyId b) {
  Impl& impl = usable();
  impl.expect_changeable();
  impl.check_body(a);
  impl.check_body(b);
  if (a == b) throw InputError("", "a body is no pair", "name two bodies");
  impl.changing([&] {
    impl.world->settle();
    Scene next = impl.scene;
    next.ignore.push_back(
        {next.bodies[static_cast<std::size_t>(a)].name, next.bodies[static_cast<std::size_t>(b)].name});
    impl.begin_anew(std::move(next));
  });
}

namespace {

/// The largest distance between where two poses put a corner of the box.
double gap_between(const BodyPose& a, const BodyPose& b, const AxisBox& box) {
  const double ox = b.origin.x - a.origin.x, oy = b.origin.y - a.origin.y;
  const double ax = b.axis.x - a.axis.x, ay = b.axis.y - a.axis.y;
  double gap = 0;
  for (const double x : {box.lo_x, box.hi_x}) {
    for (const double y : {box.lo_y, box.hi_y})
      gap = std::max(gap, std::hypot(ox + ax * x - ay * y, oy + ay * x + ax * y));
  }
  return gap;
}

}  // namespace

void Simulation::set_parent(BodyId body, std::optional<BodyId> parent, const Motion& motion) {
  Impl& impl = usable();
  impl.expect_changeable();
  impl.check_body(body);
  if (parent) impl.check_body(*parent);
  impl.changing([&] {
    impl.world->settle();
    const auto k = static_cast<std::size_t>(body);
    Scene next = impl.scene;
    next.bodies[k].motion = motion;
    next.bodies[k].relative_to = parent ? next.bodies[static_cast<std::size_t>(*parent)].name : std::string();
    const double now = impl.world->time();
    const BodyPose before = poses_at(impl.scene, now)[k], after = poses_at(next, now)[k];
    const AxisBox box = impl.world->instance().bodies()[k].rings->input_bounds();
    const double magnitude = std::fabs(before.origin.x) + std::fabs(before.origin.y) + diagonal(box);
    const double room = joint_tolerance * impl.world->extent() + joint_rounding * magnitude;
    const double gap = gap_between(before, after, box);
    if (!(gap <= room))
      throw InputError(next.bodies[k].name,
                       fmt::format("it would jump by {:.6g} in the world at the present, t = {}", gap, now),
                       "the motion is seen from the new parent, and must have the body where it is");
    impl.begin_anew(std::move(next));
  });
}

const Scene& Simulation::scene() const { return usable().scene; }

std::vector<Scene> Simulation::record() const {
  const Impl& impl = usable();
  if (!impl.options.record)
    throw InputError("record", "motions were not recorded", "set SimulationOptions::record before");
  return impl.record.scenes(time());
}

}  // namespace taut

namespace taut::internal {

void MotionRecord::begin(const Scene& scene, const std::vector<bool>& removed) {
  current_ = scene;
  current_.bodies.clear();
  places_.clear();
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    places_.push_back(removed[k] ? -1 : static_cast<int>(current_.bodies.size()));
    if (!removed[k]) current_.bodies.push_back(scene.bodies[k]);
  }
  const auto is_there = [&](const std::string& name) {
    return name == "*" || std::any_of(current_.bodies.begin(), current_.bodies.end(),
                                      [&](const Body& body) { return body.name == name; });
  };
  const auto is_gone = [&](const std::array<std::string, 2>& pair) { return !is_there(pair[0]) || !is_there(pair[1]); };
  std::erase_if(current_.ignore, is_gone);
  std::erase_if(current_.clearances, [&](const PairClearance& entry) { return is_gone(entry.pair); });
}

/// In place, as there may be many pieces. One that would begin at t or later is replaced.
void MotionRecord::change(BodyId body, const Motion& motion, double t) {
  Motion& own = current_.bodies[static_cast<std::size_t>(places_[static_cast<std::size_t>(body)])].motion;
  if (!(t > current_.start)) {
    own = motion;
    return;
  }
  std::vector<MotionPiece>& pieces = own.pieces;
  if (pieces.empty()) pieces.emplace_back();
  while (pieces.size() > 1 && pieces[pieces.size() - 2].until >= t) pieces.pop_back();
  pieces.back().until = t;
  if (motion.pieces.empty()) pieces.emplace_back();
  for (const MotionPiece& piece : motion.pieces) {
    if (piece.until > t) pieces.push_back(piece);
  }
}

void MotionRecord::end(double t) {
  if (t > current_.start) ended_ = scenes(t);
}

std::vector<Scene> MotionRecord::scenes(double t) const {
  std::vector<Scene> all = ended_;
  all.push_back(current_);
  all.back().end = t;
  if (!(t > current_.start)) return all;
  // What begins at t, and the jump to it, has not been done.
  for (Body& body : all.back().bodies) {
    std::vector<MotionPiece>& pieces = body.motion.pieces;
    while (pieces.size() > 1 && pieces[pieces.size() - 2].until >= t) pieces.pop_back();
  }
  return all;
}

}  // namespace taut::internal
