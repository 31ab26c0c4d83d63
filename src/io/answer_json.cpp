// The answers to all questions as JSON. docs/schema/answer.schema.json describes them.
#include "io/answer_json.hpp"

#include "io/answer_writer.hpp"
#include "scene/mechanism_lock.hpp"
#include "taut/io.hpp"

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
  if (answer.outcome == Outcome::undecided) json.member("free_until", answer.free_until);
  json.reason(answer.reason);
  write_pairs(json, answer);
  write_effort(json, answer);
  write_scope(json, touch, answer.fit);
}

/// What meets when an overlap begins, or parts when it ends.
void write_meeting(AnswerWriter& json, const char* name, const std::optional<Contact>& contact) {
  if (!contact) return;
  json.key(name).object([&] {
    json.vertex("vertex", contact->vertex);
    json.edge("edge", contact->edge);
    json.member("point", contact->point);
    if (contact->grazing) json.member("grazing", true);
  });
}

void write_overlap(AnswerWriter& json, const OverlapInterval& overlap) {
  json.object([&] {
    json.pair("pair", overlap.pair);
    json.time("from", overlap.from);
    json.time("to", overlap.to);
    json.degrees("from_deg", overlap.pair, overlap.from);
    json.degrees("to_deg", overlap.pair, overlap.to);
    write_meeting(json, "enter", overlap.enter);
    write_meeting(json, "exit", overlap.exit);
  });
}

void write_range(AnswerWriter& json, const Range& answer) {
  json.key("range");
  if (answer.outcome != Outcome::free) return json.null();
  const auto end = [&](const char* name, const std::optional<TimeInterval>& t) {
    json.key(name);
    t ? json.numbers({t->lo, t->hi}) : json.null();
  };
  json.object([&] {
    end("from", answer.from);
    const bool to_lock = !answer.to && ends_at_lock(json.scene());
    end("to", to_lock ? TimeInterval{json.scene().end, json.scene().lock->time[1]} : answer.to);
    if (to_lock) {
      json.key("to_lock");
      json.boolean(true);
    }
    if (answer.before) json.degrees("from_deg", answer.before->pair, *answer.from);
    if (answer.after) json.degrees("to_deg", answer.after->pair, *answer.to);
  });
}

void write_nearest(AnswerWriter& json, const NearestPoints& nearest) {
  json.object([&] {
    json.member("lo", nearest.lo);
    json.member("hi", nearest.hi);
    json.time("t", nearest.time);
    json.pair("pair", nearest.pair);
    json.degrees("angle_deg", nearest.pair, nearest.time);
    if (nearest.hi > 0) json.nearest(nearest);
  });
}

/// The members of one pair's answer.
void write_margin(AnswerWriter& json, const PairMargin& pair) {
  json.pair("bodies", pair.bodies);
  json.member("outcome", to_string(pair.outcome));
  if (pair.outcome == Outcome::contact) json.time("t", pair.time);
  if (pair.grazing) json.member("grazing", true);
  if (pair.features) json.features(*pair.features);
  if (pair.nearest) {
    json.member("distance", pair.nearest->hi);
    json.nearest(*pair.nearest);
  }
  if (pair.outcome != Outcome::free) json.member("free_until", pair.free_until);
  json.reason(pair.reason);
}

void write_margins(AnswerWriter& json, const char* name, const std::vector<PairMargin>& pairs) {
  if (pairs.empty()) return;
  json.key(name).array(pairs, [&](const PairMargin& pair) { json.object([&] { write_margin(json, pair); }); });
}

void write_curve(AnswerWriter& json, const DistanceCurve& curve) {
  json.object([&] {
    if (curve.pair) {
      json.pair("pair", *curve.pair);
    } else {
      json.key("pair").null();
    }
    json.key("largest").object([&] {
      json.member("lo", curve.largest_lo);
      json.member("hi", curve.largest_hi);
      json.member("t", curve.largest_at);
      json.member("settled", curve.settled);
      if (!curve.wide.empty()) json.member("wide", curve.wide);
    });
    json.key("instants").array(curve.instants, [&](const DistanceAt& d) { json.numbers({d.t, d.lo, d.hi}); });
    json.key("stretches").array(curve.stretches, [&](const DistanceWithin& d) {
      json.numbers({d.from, d.to, d.lo, d.hi});
    });
  });
}

void write_arc(AnswerWriter& json, const DirectionArc& arc) {
  const auto vertices = [&](const char* name, const std::optional<std::array<VertexRef, 2>>& pair) {
    if (pair) json.key(name).array(*pair, [&](const VertexRef& v) { json.vertex(v); });
  };
  const auto reach = [&](const char* name, const std::optional<VertexAtEdge>& at) {
    if (!at) return;
    json.key(name).object([&] {
      json.vertex("vertex", at->vertex);
      json.edge("edge", at->edge);
    });
  };
  json.object([&] {
    json.member("from_deg", {arc.from.lo, arc.from.hi});
    json.member("to_deg", {arc.to.lo, arc.to.hi});
    json.member("point", arc.point);
    vertices("from_vertices", arc.from_vertices);
    vertices("to_vertices", arc.to_vertices);
    reach("from_reach", arc.from_reach);
    reach("to_reach", arc.to_reach);
  });
}

/// The members about one body.
void write_directions(AnswerWriter& json, const BodyDirections& of) {
  json.member("body", json.body(of.body).name);
  json.member("all", of.all);
  json.key("directions").array(of.free, [&](const DirectionArc& arc) { write_arc(json, arc); });
}

void write_removal(AnswerWriter& json, const Separation& answer) {
  json.key("bodies").array(answer.bodies,
                           [&](const BodyDirections& body) { json.object([&] { write_directions(json, body); }); });
  json.key("order").array(answer.order, [&](const RemovalStep& step) {
    json.object([&] {
      json.member("body", json.body(step.body).name);
      json.member("direction_deg", step.direction_deg);
      json.key("within");
      write_arc(json, step.free);
    });
  });
  json.key("stuck").array(answer.stuck, [&](BodyId id) { json.name(id); });
}

void write_values(AnswerWriter& json, const char* name, const Linkage& linkage,
                  const std::array<double, max_joints>& values) {
  json.key(name).array([&] {
    for (std::size_t k = 0; k < linkage.joints.size(); ++k) json.number(values[k]);
  });
}

void write_cell(AnswerWriter& json, const Linkage& linkage, const EnvelopeCell& cell) {
  json.object([&] {
    json.member("state", to_string(cell.state));
    write_values(json, "lo", linkage, cell.lo);
    write_values(json, "hi", linkage, cell.hi);
    if (cell.state != CellState::free) json.pair("pair", cell.pair);
  });
}

void write_colliding(AnswerWriter& json, const Linkage& linkage, const std::optional<EnvelopeWitness>& witness) {
  json.key("witness");
  if (!witness) return json.null();
  json.object([&] {
    json.key("values").object([&] {
      for (std::size_t k = 0; k < linkage.joints.size(); ++k)
        json.user_key(linkage.joints[k].name).number(witness->values[k]);
    });
    json.pair("pair", witness->pair);
  });
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

std::string intervals_json(const Scene& scene, const Intervals& answer, Touch touch) {
  return answer_text(scene, [&](AnswerWriter& json) {
    json.verdict(to_string(answer.outcome));
    json.reason(answer.reason);
    json.key("intervals").array(answer.intervals, [&](const OverlapInterval& o) { write_overlap(json, o); });
    json.pair_answers("undecided", answer.undecided);
    json.grounds(answer.geometry, answer.coverage);
    json.scope(touch);
  });
}

std::string range_json(const Scene& scene, double from, const Range& answer, Touch touch) {
  return answer_text(scene, [&](AnswerWriter& json) {
    json.verdict(to_string(answer.outcome));
    json.reason(answer.reason);
    write_range(json, answer);
    json.member("around", from);
    const auto overlap = [&](const char* name, const std::optional<OverlapInterval>& o) {
      if (!o) return;
      json.key(name);
      write_overlap(json, *o);
    };
    overlap("before", answer.before);
    overlap("after", answer.after);
    json.grounds(answer.geometry, answer.coverage);
    json.scope(touch);
  });
}

std::string clearance_json(const Scene& scene, const Clearance& answer) {
  return answer_text(scene, [&](AnswerWriter& json) {
    json.verdict(to_string(answer.outcome));
    json.key("clearance");
    answer.nearest ? write_nearest(json, *answer.nearest) : json.null();
    if (!answer.pairs.empty())
      json.key("pairs").array(answer.pairs, [&](const NearestPoints& n) { write_nearest(json, n); });
    json.reason(answer.reason);
    if (!answer.wide.empty()) json.member("wide", answer.wide);
    json.grounds(answer.geometry, answer.coverage);
    json.scope();
  });
}

std::string profile_json(const Scene& scene, const DistanceProfile& answer) {
  return answer_text(scene, [&](AnswerWriter& json) {
    json.verdict(to_string(answer.outcome));
    json.key("profile").array(answer.curves, [&](const DistanceCurve& c) { write_curve(json, c); });
    json.reason(answer.reason);
    json.grounds(answer.geometry, answer.coverage);
    json.scope();
  });
}

std::string margin_json(const Scene& scene, double clearance, const MarginAnswer& answer, Touch touch) {
  return answer_text(scene, [&](AnswerWriter& json) {
    json.verdict(to_string(answer.outcome));
    json.member("clearance", clearance);
    if (answer.first) {
      const PairMargin& first = *answer.first;
      if (first.outcome == Outcome::contact) json.time("t", first.time);
      json.pair("pair", first.bodies);
      json.key("first").object([&] { write_margin(json, first); });
    }
    write_margins(json, "also", answer.also);
    write_margins(json, "pairs", answer.pairs);
    if (answer.outcome == Outcome::undecided) json.member("free_until", answer.free_until);
    json.reason(answer.reason);
    json.grounds(answer.geometry, answer.coverage);
    json.scope(touch);
  });
}

std::string separation_json(const Scene& scene, const Separation& answer) {
  return answer_text(scene, [&](AnswerWriter& json) {
    json.verdict(to_string(answer.outcome));
    json.reason(answer.reason);
    if (!answer.wide.empty()) json.member("wide", answer.wide);
    if (answer.overlap) json.pair("pair", *answer.overlap);
    if (scene.bodies.size() == 2) {
      write_directions(json, answer.bodies.empty() ? BodyDirections{1, {}, false} : answer.bodies[0]);
    } else {
      write_removal(json, answer);
    }
    json.grounds(answer.geometry, answer.coverage);
  });
}

const char* to_string(CellState state) {
  switch (state) {
    case CellState::free:
      return "free";
    case CellState::colliding:
      return "colliding";
    case CellState::undecided:
      break;
  }
  return "undecided";
}

std::string envelope_json(const Linkage& linkage, const Envelope& answer, double tolerance, bool cells) {
  return answer_text(linkage.scene, [&](AnswerWriter& json) {
    json.verdict(to_string(answer.outcome));
    json.key("joints").array(linkage.joints, [&](const Joint& joint) {
      json.object([&] {
        json.member("name", joint.name);
        json.member("range", {joint.lo, joint.hi});
      });
    });
    write_colliding(json, linkage, answer.witness);
    json.member("free", answer.free);
    json.member("colliding", answer.colliding);
    json.member("undecided", answer.undecided);
    json.member("tolerance", tolerance);
    json.reason(answer.reason);
    if (cells) json.key("cells").array(answer.cells, [&](const EnvelopeCell& c) { write_cell(json, linkage, c); });
    json.coverage(answer.coverage);
  });
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
