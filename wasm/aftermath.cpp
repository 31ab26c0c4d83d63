#include "aftermath.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include "elastic.hpp"
#include "io/json_writer.hpp"
#include "taut/contact_motions.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/pose.hpp"
#include "taut/shape.hpp"
#include "taut/simulation.hpp"

namespace taut::web {
using namespace internal;

namespace {

/// For velocities of planned motions, which need not be exact: what bodies do after a contact is a choice.
constexpr double share_for_velocities = 0x1p-20;

/// Of all parts together; holes count less.
elastic::RigidBody whole_body(const Body& body) {
  std::vector<std::pair<elastic::RigidBody, double>> rings;
  const auto add = [&](const Polygon& ring, double sign) { rings.push_back({elastic::rigid_body(ring), sign}); };
  if (body.parts.empty()) add(polygon_of(body), 1);
  for (const Part& part : body.parts) {
    add(part.outline, 1);
    for (const Polygon& hole : part.holes) add(hole, -1);
  }
  elastic::RigidBody all;
  for (const auto& [ring, sign] : rings) {
    all.mass += sign * ring.mass;
    all.centre = {all.centre.x + sign * ring.mass * ring.centre.x, all.centre.y + sign * ring.mass * ring.centre.y};
  }
  all.centre = {all.centre.x / all.mass, all.centre.y / all.mass};
  for (const auto& [ring, sign] : rings) {
    const double dx = ring.centre.x - all.centre.x, dy = ring.centre.y - all.centre.y;
    all.inertia += sign * (ring.inertia + ring.mass * (dx * dx + dy * dy));
  }
  return all;
}

Point place_of(const BodyPose& pose, const Point& p) {
  return {pose.origin.x + pose.axis.x * p.x - pose.axis.y * p.y, pose.origin.y + pose.axis.y * p.x + pose.axis.x * p.y};
}

/// Instants at which a body is looked at.
constexpr int looks = 32;

/// Which bodies are not always in the same place?
std::vector<bool> moving(const Scene& scene) {
  const std::vector<BodyPose> first = poses_at(scene, scene.start);
  std::vector<bool> moves(first.size(), false);
  for (int i = 1; i <= looks; ++i) {
    const std::vector<BodyPose> now = poses_at(scene, scene.start + (scene.end - scene.start) * i / looks);
    for (std::size_t k = 0; k < now.size(); ++k) {
      const BodyPose &a = now[k], &b = first[k];
      if (a.origin.x != b.origin.x || a.origin.y != b.origin.y || a.axis.x != b.axis.x || a.axis.y != b.axis.y)
        moves[k] = true;
    }
  }
  return moves;
}

/// The bodies of a scene between contacts: those that were in one move evenly, the others as planned.
class Bouncing {
 public:
  explicit Bouncing(const Scene& scene) : scene_(scene), was_hit_(scene.bodies.size(), false) {
    const std::vector<bool> moves = moving(scene);
    for (std::size_t k = 0; k < moves.size(); ++k)
      bodies_.push_back(moves[k] ? whole_body(scene.bodies[k]) : elastic::RigidBody{});
  }

  void respond(Simulation& simulation) {
    const Contact& contact = *simulation.contact();
    std::vector<BodyId> met{contact.vertex.body, contact.edge.body};
    for (const PairAnswer& other : simulation.also())
      met.insert(met.end(), {other.contact->vertex.body, other.contact->edge.body});
    for (const BodyId body : met) plan_of(static_cast<std::size_t>(body), simulation.time());
    elastic::Collisions collisions(bodies_, small_gap(simulation));
    collisions.respond(simulation);
    bodies_ = collisions.bodies();
  }

 private:
  /// The state of a body that moves as planned until now.
  void plan_of(std::size_t k, double t) {
    elastic::RigidBody& body = bodies_[k];
    if (was_hit_[k] || body.mass == 0) return;
    was_hit_[k] = true;
    const double step = (scene_.end - scene_.start) * share_for_velocities;
    const BodyPose now = poses_at(scene_, t)[k], before = poses_at(scene_, std::max(scene_.start, t - step))[k];
    const double passed = t - std::max(scene_.start, t - step);
    const Point centre = place_of(now, body.centre), from = place_of(before, body.centre);
    body.at = {centre.x - body.centre.x, centre.y - body.centre.y};
    body.angle = std::atan2(now.axis.y, now.axis.x);
    body.since = t;
    if (!(passed > 0)) return;
    body.velocity = {(centre.x - from.x) / passed, (centre.y - from.y) / passed};
    body.spin = std::atan2(before.axis.x * now.axis.y - before.axis.y * now.axis.x,
                           before.axis.x * now.axis.x + before.axis.y * now.axis.y) /
                passed;
  }

  const Scene& scene_;
  std::vector<bool> was_hit_;
  std::vector<elastic::RigidBody> bodies_;
};

/// Bodies that meet stop, if they have not done so before.
class Stopping {
 public:
  explicit Stopping(const Scene& scene) : moves_(moving(scene)) {}

  void respond(Simulation& simulation) {
    const Contact contact = *simulation.contact();
    const std::vector<PairAnswer> also = simulation.also();
    stop_both(simulation, contact);
    for (const PairAnswer& other : also) stop_both(simulation, *other.contact);
    simulation.resume();
  }

 private:
  void stop_both(Simulation& simulation, const Contact& contact) {
    for (const BodyId body : {contact.vertex.body, contact.edge.body}) {
      const auto k = static_cast<std::size_t>(body);
      if (!moves_[k]) continue;
      moves_[k] = false;
      stop(simulation, body);
    }
  }

  std::vector<bool> moves_;
};

struct Met {
  double t = 0;
  Contact contact;
};

template <class Response>
std::vector<Met> run(Simulation& simulation, Response response, const AftermathOptions& options) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begun = Clock::now();
  std::vector<Met> met;
  while (met.size() < options.max_contacts &&
         std::chrono::duration<double>(Clock::now() - begun).count() < options.max_seconds &&
         simulation.advance_to(simulation.scene().end) == SimulationState::contact) {
    met.push_back({simulation.time(), *simulation.contact()});
    response.respond(simulation);
  }
  return met;
}

void require_free_bodies(const Scene& scene) {
  if (scene.mechanism) throw InputError("", "the bodies are links of a mechanism", "bodies bounce or stop one by one");
  for (const Body& body : scene.bodies) {
    if (body.relative_to.empty()) continue;
    throw InputError("", "\"" + body.name + "\" moves with \"" + body.relative_to + "\"",
                     "bodies bounce or stop one by one: none may hang on another one");
  }
}

}  // namespace

std::string aftermath_text(const Scene& scene, const AftermathOptions& options) {
  require_free_bodies(scene);
  SimulationOptions how;
  how.touch = options.touch;
  how.limits.max_seconds = options.max_seconds;
  how.record = true;
  Simulation simulation(scene, how);
  const std::vector<Met> met =
      options.bounce ? run(simulation, Bouncing(scene), options) : run(simulation, Stopping(scene), options);
  return io::json_text([&](io::JsonWriter& json) {
    json.object([&] {
      json.key("scene").raw(write_scene(simulation.record().front()));
      json.key("contacts").array(met, [&](const Met& each) {
        json.object([&] {
          json.member("t", each.t);
          json.key("pair").array([&] {
            for (const BodyId body : {each.contact.vertex.body, each.contact.edge.body})
              json.string(scene.bodies[static_cast<std::size_t>(body)].name);
          });
          json.member("point", each.contact.point);
        });
      });
      json.member("state", to_string(simulation.state()));
      json.member("reason", simulation.reason());
    });
  });
}

}  // namespace taut::web
