#include "io/answer_writer.hpp"

#include "taut/motions.hpp"

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
