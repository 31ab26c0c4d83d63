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

void Simulation::Impl::check_named(BodyId body) const {
  if (scene.bodies[static_cast<std::size_t>(body)].name.empty())
    throw InputError("", "body " + std::to_string(body) + " has no name, by which the scene could refer to it",
                     "give it one");
}

void Simulation::Impl::set_motion(BodyId body, const Motion& motion) {
  check_body(body);
  if (world->over() && !in_contact()) return;
  changed_since_contact = true;
  if (world->time() == began) {
    // Right where pairs begin there is nothing before, from which a bridge could lead.
    world->check_motion(body, motion);
    Scene next = scene;
    next.bodies[static_cast<std::size_t>(body)].motion = motion;
    return begin_anew(std::move(next), removed);
  }
  world->set_motion(body, motion);
  scene.bodies[static_cast<std::size_t>(body)].motion = motion;
  if (options.record) record.change(body, motion, world->time());
}

void Simulation::Impl::change(const std::function<bool()>& in_place,
                              const std::function<void(Scene& scene, std::vector<bool>& removed)>& edit) {
  const bool was_in_contact = in_contact();
  if (!in_place()) {
    Scene next = scene;
    std::vector<bool> gone = removed;
    edit(next, gone);
    begin_anew(std::move(next), std::move(gone));
  } else {
    edit(scene, removed);
    scene.start = world->time();
    begin_record();
  }
  if (!was_in_contact) note_contact();
}

void Simulation::Impl::begin_record() {
  if (!options.record) return;
  record.end(world->time());
  record.begin(scene, removed);
}

void Simulation::Impl::begin_anew(Scene next, std::vector<bool> gone) {
  const double now = world->time();
  next.start = now;
  next.at_rest = world->at_rest();
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
  began = now;
  scene = std::move(next);
  removed = std::move(gone);
  begin_record();
}

BodyId Simulation::add_body(const Body& body) {
  Impl& impl = usable();
  impl.expect_changeable();
  impl.changing([&] {
    impl.world->settle();
    impl.began = impl.world->time();
    impl.change([&] { return impl.world->add_body(body); },
                [&](Scene& scene, std::vector<bool>& removed) {
                  scene.bodies.push_back(body);
                  removed.push_back(false);
                });
  });
  return static_cast<BodyId>(impl.scene.bodies.size()) - 1;
}

/// The body stays in the scene, at rest and ignored by all others, under a name that no other one has.
void Simulation::remove_body(BodyId body) {
  Impl& impl = usable();
  impl.expect_changeable();
  impl.check_body(body);
  impl.changing([&] {
    impl.world->settle();
    const std::string before = impl.scene.bodies[static_cast<std::size_t>(body)].name;
    const std::string name = before + " (body " + std::to_string(body) + ", removed)";
    for (const int k : impl.world->instance().followers(body)) {
      const auto follower = static_cast<std::size_t>(k);
      if (k != body && follower < impl.scene.bodies.size() && impl.scene.bodies[follower].relative_to == before)
        throw InputError(impl.scene.bodies[follower].name,
                         "it is attached to \"" + before + "\", which is to be removed",
                         "attach it to another body first: set_parent()");
    }
    const bool is_named =
        impl.world->instance().ignored().names(body) || impl.world->instance().ignored().has_all(body);
    impl.change([&] { return impl.world->remove_body(body, name); },
                [&](Scene& scene, std::vector<bool>& removed) {
                  const auto names_it = [&](const std::array<std::string, 2>& pair) {
                    return pair[0] == before || pair[1] == before;
                  };
                  if (is_named) std::erase_if(scene.ignore, names_it);
                  std::erase_if(scene.clearances, [&](const PairClearance& entry) { return names_it(entry.pair); });
                  Body& gone = scene.bodies[static_cast<std::size_t>(body)];
                  gone.name = name;
                  gone.relative_to.clear();
                  gone.motion = {};
                  scene.ignore.push_back({name, "*"});
                  removed[static_cast<std::size_t>(body)] = true;
                });
  });
}

void Simulation::ignore(BodyId a, BodyId b) {
  Impl& impl = usable();
  impl.expect_changeable();
  impl.check_body(a);
  impl.check_body(b);
  if (a == b) throw InputError("", "a body is no pair", "name two bodies");
  impl.check_named(a);
  impl.check_named(b);
  impl.changing([&] {
    impl.world->settle();
    impl.change([&] { return impl.world->ignore(a, b); },
                [&](Scene& scene, std::vector<bool>&) {
                  const auto name = [&](BodyId k) { return scene.bodies[static_cast<std::size_t>(k)].name; };
                  scene.ignore.push_back({name(a), name(b)});
                });
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

/// Where the last body is of those that are attached to each other in turn, the outermost first.
BodyPose pose_of_last(Scene chain, double t) {
  for (std::size_t k = 0; k < chain.bodies.size(); ++k) {
    chain.bodies[k].name = std::to_string(k);
    chain.bodies[k].relative_to = k > 0 ? chain.bodies[k - 1].name : std::string();
  }
  return poses_at(chain, t).back();
}

}  // namespace

void Simulation::set_parent(BodyId body, std::optional<BodyId> parent, const Motion& motion) {
  Impl& impl = usable();
  impl.expect_changeable();
  impl.check_body(body);
  if (parent) impl.check_body(*parent);
  if (parent) impl.check_named(*parent);
  impl.changing([&] {
    impl.world->settle();
    const double now = impl.world->time();
    const Instance& instance = impl.world->instance();
    const std::string& name = impl.scene.bodies[static_cast<std::size_t>(body)].name;
    const auto pose = [&](int outer, const Motion& own) {
      Scene chain;
      chain.start = impl.scene.start;
      chain.end = impl.scene.end;
      chain.bodies.push_back({{}, {}, own});
      for (int k = outer; k >= 0; k = instance.bodies()[static_cast<std::size_t>(k)].parent)
        chain.bodies.insert(chain.bodies.begin(), {{}, {}, impl.scene.bodies[static_cast<std::size_t>(k)].motion});
      return pose_of_last(std::move(chain), now);
    };
    const int held_by = instance.bodies()[static_cast<std::size_t>(body)].parent;
    const BodyPose before = pose(held_by, impl.scene.bodies[static_cast<std::size_t>(body)].motion);
    const BodyPose after = pose(parent.value_or(-1), motion);
    const AxisBox box = instance.bodies()[static_cast<std::size_t>(body)].rings->input_bounds();
    const double magnitude = std::fabs(before.origin.x) + std::fabs(before.origin.y) + diagonal(box);
    const double room = joint_tolerance * impl.world->extent() + joint_rounding * magnitude;
    const double gap = gap_between(before, after, box);
    if (!(gap <= room))
      throw InputError(name, fmt::format("it would jump by {:.6g} in the world at the present, t = {}", gap, now),
                       "the motion is seen from the new parent, and must have the body where it is");
    // Even if it is refused: the body's pairs begin again then.
    impl.began = now;
    impl.change([&] { return impl.world->set_parent(body, parent, motion); },
                [&](Scene& scene, std::vector<bool>&) {
                  Body& attached = scene.bodies[static_cast<std::size_t>(body)];
                  attached.motion = motion;
                  attached.relative_to = parent ? scene.bodies[static_cast<std::size_t>(*parent)].name : std::string();
                });
    impl.changed_since_contact = true;
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
