// What the JSON of several answers has in common.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "io/json_writer.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/envelope.hpp"
#include "taut/scene.hpp"
#include "taut/tracer.hpp"

namespace taut::internal::io {

/// Writes the members of answers about one scene, which must outlive it. Bodies are named as in the scene, with their
/// ids if they have some.
class AnswerWriter : public JsonWriter {
 public:
  explicit AnswerWriter(const Scene& scene) : scene_(scene) {}

  /// The members with which every answer begins: "id", if the scene has one, and "outcome".
  void verdict(const char* outcome);
  /// The member "reason", unless it is empty.
  void reason(const std::string& why);
  /// The members with which every answer ends, before its scope: "geometry" of curves, and "coverage".
  void grounds(const std::optional<CurveGeometry>& geometry, const Coverage& coverage);
  void lock(const MechanismLock& lock);
  /// Also the "lock" of the scene's mechanism, if there is one.
  void coverage(const Coverage& c);
  void geometry(const CurveGeometry& g);
  /// The member "scope": the scene's time and, if given, what touching means.
  void scope(const std::optional<Touch>& touch = std::nullopt);

  /// Members of that name.
  void time(const char* name, const TimeInterval& t) { member(name, {t.lo, t.hi}); }
  void pair(const char* name, const std::array<BodyId, 2>& bodies);
  /// An element: a cell of the values of so many joints.
  void cell(const EnvelopeCell& cell, std::size_t joints);
  /// The angle in degrees of the first body of the pair that sweeps; left out if none does.
  void degrees(const char* name, const std::array<BodyId, 2>& bodies, const TimeInterval& t);
  void vertex(const char* name, const VertexRef& vertex);
  void edge(const char* name, const EdgeRef& edge);

  /// The members "t" and "contact".
  void contact(const Contact& contact);
  /// The members "vertex" and "edge", or "other_vertex".
  void features(const CloseFeatures& features);
  /// Values.
  void name(BodyId id) { string(body(id).name); }
  void vertex(const VertexRef& vertex);
  void edge(const EdgeRef& edge);
  /// Two nearest points and their edges, as members.
  void nearest(const NearestPoints& nearest);
  void pair_answer(const PairAnswer& pair);
  void pair_answers(const char* name, const std::vector<PairAnswer>& pairs);

  const Body& body(BodyId id) const { return scene_.bodies[static_cast<std::size_t>(id)]; }
  const Scene& scene() const { return scene_; }

 private:
  template <class Ref>
  void feature(const Ref& ref);

  const Scene& scene_;
};

/// The answer about a scene whose members `write(json)` writes.
template <class Write>
std::string answer_text(const Scene& scene, const Write& write) {
  AnswerWriter json(scene);
  json.object([&] { write(json); });
  return json.text();
}

}  // namespace taut::internal::io

namespace taut::internal {

// Answers of check() as JSON, with the parts that taut/check.hpp leaves out.

/// Wall time in seconds. Left out unless asked for: without it, the same scene always gives the same bytes.
struct AnswerTiming {
  double read = 0, build = 0, run = 0;
};

/// As answer_json() in taut/check.hpp, with a member "timing" if given.
std::string answer_json(const Scene& scene, const Answer& answer, Touch touch,
                        const std::optional<AnswerTiming>& timing);

namespace io {

/// An object of the members "t" and "contact" of an answer.
std::string contact_json(const Scene& scene, const Contact& contact);
std::string pair_answer_json(const Scene& scene, const PairAnswer& pair);

}  // namespace io

}  // namespace taut::internal

namespace taut::internal::io {

// Events as `taut trace` prints them.

/// Writes events of one scene as JSON objects, each on one line, without a line break.
class TraceWriter {
 public:
  explicit TraceWriter(const Scene& scene);

  std::string line(const TraceEvent& event) const;

 private:
  std::vector<std::string> names_;  ///< of the bodies, quoted
};

}  // namespace taut::internal::io
