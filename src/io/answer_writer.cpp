#include "io/answer_writer.hpp"

#include "io/json_writer.hpp"
#include "taut/motions.hpp"
#include "taut/path_proof.hpp"
#include "taut/proof.hpp"

namespace taut::internal::io {

void AnswerWriter::verdict(const char* outcome) {
  if (!scene_.id.empty()) key("id").raw(scene_.id);
  member("outcome", outcome);
}

void AnswerWriter::reason(const std::string& why) {
  if (!why.empty()) member("reason", why);
}

void AnswerWriter::coverage(const Coverage& c) {
  key("coverage").object([&] {
    member("pairs", c.pairs);
    member("tested", c.tested);
    member("apart", c.apart);
    member("ignored", c.ignored);
    member("moving_alike", c.moving_alike);
    member("at_rest", c.at_rest);
    member("layers", c.layers);
    member("not_reached", c.not_reached);
  });
  if (scene_.lock) lock(*scene_.lock);
}

void AnswerWriter::lock(const MechanismLock& lock) {
  key("lock").object([&] {
    member("t", {lock.time[0], lock.time[1]});
    member("kind", to_string(lock.kind));
    key("joints").array(lock.joints, [&](const std::string& joint) { string(joint); });
    key("links").array(lock.links, [&](const std::string& link) { string(link); });
  });
}

void AnswerWriter::geometry(const CurveGeometry& g) {
  key("geometry").object([&] {
    member("tolerance", g.tolerance);
    member("segments", g.segments);
  });
}

void AnswerWriter::grounds(const std::optional<CurveGeometry>& geometry, const Coverage& c) {
  if (geometry) this->geometry(*geometry);
  coverage(c);
}

void AnswerWriter::scope(const std::optional<Touch>& touch) {
  key("scope").object([&] {
    member("time", {scene_.start, scene_.end});
    if (touch) member("touch", to_string(*touch));
  });
}

void AnswerWriter::cell(const EnvelopeCell& cell, std::size_t joints) {
  const auto corner = [&](const char* name, const JointValues& values) {
    key(name).array([&] {
      for (std::size_t k = 0; k < joints; ++k) number(values[k]);
    });
  };
  object([&] {
    member("state", to_string(cell.state));
    corner("lo", cell.lo);
    corner("hi", cell.hi);
    if (cell.reached) member("reached", true);
    if (cell.may_lock) {
      member("may_lock", true);
    } else if (cell.state != CellState::free) {
      pair("pair", cell.pair);
    }
  });
}

void AnswerWriter::pair(const char* name, const std::array<BodyId, 2>& bodies) {
  key(name).array(bodies, [this](BodyId id) { this->name(id); });
}

void AnswerWriter::degrees(const char* name, const std::array<BodyId, 2>& bodies, const TimeInterval& t) {
  for (const BodyId id : bodies) {
    const auto angle = angle_at(body(id).motion, t);
    if (angle) return member(name, {angle->lo, angle->hi});
  }
}

/// Part and ring are left out where the body has but one of each.
template <class Ref>
void AnswerWriter::feature(const Ref& ref) {
  const Body& of = body(ref.body);
  object([&] {
    member("body", of.name);
    if (!of.id.empty()) key("id").raw(of.id);
    const bool several =
        ref.parameter ? of.curves.size() > 1 || (!of.curves.empty() && !of.curves[0].holes.empty()) : !of.parts.empty();
    if (several) {
      member("part", ref.part);
      member("ring", ref.ring);
    }
    member("index", ref.index);
    if (ref.parameter) member("at", *ref.parameter);
  });
}

void AnswerWriter::vertex(const VertexRef& vertex) { feature(vertex); }
void AnswerWriter::edge(const EdgeRef& edge) { feature(edge); }

void AnswerWriter::vertex(const char* name, const VertexRef& vertex) {
  key(name);
  feature(vertex);
}

void AnswerWriter::edge(const char* name, const EdgeRef& edge) {
  key(name);
  feature(edge);
}

void AnswerWriter::contact(const Contact& contact) {
  time("t", contact.time);
  if (contact.grazing) member("grazing", true);
  key("contact").object([&] {
    vertex("vertex", contact.vertex);
    edge("edge", contact.edge);
    member("point", contact.point);
    member("normal", contact.normal);
    if (const auto angle = contact_angle(scene_, contact)) member("angle_deg", {angle->lo, angle->hi});
  });
}

void AnswerWriter::features(const CloseFeatures& features) {
  vertex("vertex", features.vertex);
  if (features.edge) {
    edge("edge", *features.edge);
  } else {
    vertex("other_vertex", *features.other);
  }
}

void AnswerWriter::nearest(const NearestPoints& nearest) {
  key("points").array(nearest.points, [this](const Point& p) { point(p); });
  key("edges").array(nearest.edges, [this](const EdgeRef& e) { edge(e); });
}

void AnswerWriter::pair_answer(const PairAnswer& answer) {
  object([&] {
    pair("bodies", answer.bodies);
    member("outcome", to_string(answer.outcome));
    if (answer.contact) contact(*answer.contact);
    if (answer.outcome != Outcome::undecided) return;
    member("free_until", answer.free_until);
    member("reason", answer.reason);
  });
}

void AnswerWriter::pair_answers(const char* name, const std::vector<PairAnswer>& pairs) {
  key(name).array(pairs, [this](const PairAnswer& pair) { pair_answer(pair); });
}

}  // namespace taut::internal::io

// The answers of check() and verify() as JSON: what the verifier and the engines' observers write, too.

namespace taut::internal {
namespace {

using io::answer_text;
using io::AnswerWriter;

/// What check() was asked.
void write_scope(AnswerWriter& json, Touch touch, double fit) {
  const Scene& scene = json.scene();
  json.key("scope").object([&] {
    json.key("bodies").array(scene.bodies, [&](const Body& body) { json.string(body.name); });
    json.member("time", {scene.start, scene.end});
    json.member("touch", to_string(touch));
    if (fit > 0) json.member("fit", fit);
    if (scene.at_rest == AtRest::test) json.member("at_rest", "test");
  });
}

/// Which pairs the answer is about.
void write_pairs(AnswerWriter& json, const Answer& answer) {
  if (answer.pair) json.pair("pair", *answer.pair);
  if (!answer.also.empty()) json.pair_answers("also", answer.also);
  json.coverage(answer.coverage);
  if (answer.pairs) json.pair_answers("pairs", *answer.pairs);
  if (answer.geometry) json.geometry(*answer.geometry);
}

/// How it was found.
void write_effort(AnswerWriter& json, const Answer& answer) {
  json.member("engine", answer.compared ? "both" : to_string(answer.engine));
  json.member("events", answer.events);
  json.key("certificates").object([&] {
    json.member("initial", answer.certificates_initial);
    json.member("max", answer.certificates_max);
  });
}

void write_answer(AnswerWriter& json, const Answer& answer, Touch touch) {
  json.verdict(to_string(answer.outcome));
  if (answer.contact) json.contact(*answer.contact);
  if (answer.touching) {
    json.member("grazing", true);
    json.key("touching").object([&] { json.contact(*answer.touching); });
  }
  if (!answer.touching_undecided.empty()) json.member("touching_undecided", answer.touching_undecided);
  if (answer.overlap_point) json.key("overlap").object([&] { json.member("point", *answer.overlap_point); });
  if (answer.outcome == Outcome::undecided || answer.outcome == Outcome::locked)
    json.member("free_until", answer.free_until);
  json.reason(answer.reason);
  write_pairs(json, answer);
  write_effort(json, answer);
  write_scope(json, touch, answer.fit);
}

const char* name_of(ContactAt at) {
  return at == ContactAt::start ? "start" : at == ContactAt::joint ? "joint" : "motion";
}

/// Of a proof about a clearance.
void write_proved_clearance(AnswerWriter& json, const Verified& proved) {
  json.member("clearance", proved.clearance);
  if (!proved.closer) return;
  json.key("closer").object([&] {
    json.time("t", proved.closer->time);
    json.features(proved.closer->features);
  });
}

}  // namespace

std::string answer_json(const Scene& scene, const Answer& answer, Touch touch,
                        const std::optional<AnswerTiming>& timing) {
  return answer_text(scene, [&](AnswerWriter& json) {
    write_answer(json, answer, touch);
    if (!timing) return;
    json.key("timing").object([&] {
      json.member("read", timing->read);
      json.member("build", timing->build);
      json.member("run", timing->run);
    });
  });
}

std::string io::contact_json(const Scene& scene, const Contact& contact) {
  return answer_text(scene, [&](AnswerWriter& json) { json.contact(contact); });
}

std::string io::pair_answer_json(const Scene& scene, const PairAnswer& pair) {
  AnswerWriter json(scene);
  json.pair_answer(pair);
  return json.text();
}

}  // namespace taut::internal

namespace taut {
using namespace internal;

std::string answer_json(const Scene& scene, const Answer& answer, Touch touch) {
  return answer_json(scene, answer, touch, std::nullopt);
}

std::string verified_json(const Scene& scene, const Verified& proved) {
  return answer_text(scene, [&](AnswerWriter& json) {
    json.member("valid", true);
    json.member("outcome", to_string(proved.outcome));
    json.member("free_until", proved.free_until);
    if (proved.contact) {
      json.contact(*proved.contact);
      json.member("contact_at", name_of(proved.contact_at));
    }
    if (proved.clearance > 0) write_proved_clearance(json, proved);
    json.member("touch", to_string(proved.touch));
    json.member("events", proved.events);
    json.member("separations", proved.separations);
    if (proved.kind == ProofKind::curves) json.member("segments", proved.segments);
    json.coverage(proved.coverage);
    json.member("scene_sha256", to_hex(proved.fingerprint));
  });
}

std::string verified_path_json(const PathProblem& problem, const VerifiedPath& proved) {
  return answer_text(problem.linkage.scene, [&](AnswerWriter& json) {
    json.member("valid", true);
    json.member("outcome", to_string(PathOutcome::none));
    json.member("touch", to_string(proved.touch));
    if (proved.clearance > 0) json.member("clearance", proved.clearance);
    if (proved.barrier > 0) json.member("barrier", proved.barrier);
    json.member("cells", proved.cells);
    json.member("colliding", proved.colliding);
    json.member("reached", proved.reached);
    json.member("scene_sha256", to_hex(proved.fingerprint));
  });
}

std::string unverified_json(bool refuted, const std::string& reason) {
  return io::json_text([&](io::JsonWriter& json) {
    json.object([&] {
      json.key("valid");
      refuted ? json.boolean(false) : json.null();
      json.member("reason", reason);
    });
  });
}

}  // namespace taut

namespace taut::internal::io {

TraceWriter::TraceWriter(const Scene& scene) {
  for (const Body& body : scene.bodies) names_.push_back(string_text(body.name));
}

std::string TraceWriter::line(const TraceEvent& e) const {
  JsonWriter json;
  const auto vertex = [&](const VertexRef& v) {
    json.object([&] {
      json.key("body").raw(names_[static_cast<std::size_t>(v.body)]);
      json.member("index", v.index);
    });
  };
  const auto flag = [&](bool set, const char* name) {
    if (set) json.string(name);
  };
  json.object([&] {
    json.member("event", e.number);
    json.member("t", {e.lo, e.hi});
    json.member("repair", to_string(e.repair));
    json.key("corner").array(std::array{e.u, e.v, e.w}, vertex);
    json.key("flags").array([&] {
      flag(e.bridging, "bridging");
      flag(e.pinch_rule, "pinch_rule");
      flag(e.three_corners, "three_corners");
    });
    json.member("certificates", e.certificates);
  });
  return json.text();
}

}  // namespace taut::internal::io
