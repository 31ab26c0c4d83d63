// The answer as JSON, with the parts that a plain answer leaves out.
#pragma once

#include <optional>
#include <string>

#include "taut/check.hpp"
#include "taut/proof.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

/// Wall time in seconds. Left out unless asked for: without it, the same scene always gives the same bytes.
struct AnswerTiming {
  double read = 0, build = 0, run = 0;
};

/// As answer_json() in taut/io.hpp, with a member "timing" if given.
std::string answer_json(const Scene& scene, const Answer& answer, Touch touch,
                        const std::optional<AnswerTiming>& timing);

}  // namespace taut::internal

namespace taut::internal::io {

/// The members "t" and "contact" of an answer, each with a comma before it.
std::string contact_json(const Scene& scene, const Contact& contact);
/// The names of a pair, and which features meet.
std::string pair_names_json(const Scene& scene, const std::array<BodyId, 2>& pair);
std::string features_json(const Scene& scene, const Contact& contact);
/// Where on a curve: the members "index", of the segment, and "at", and "part" and "ring" where there are several.
std::string curve_place_json(const Body& body, int part, int ring, int segment, double parameter);
/// The member "geometry" with a comma before it, if there is one.
std::string geometry_json(const std::optional<CurveGeometry>& geometry);
/// The member "coverage" with a comma before it.
std::string coverage_json(const Coverage& coverage);
/// The members with which every answer begins: "id", if the scene has one, and "outcome"; with the opening brace.
std::string verdict_json(const Scene& scene, const char* outcome);
std::string vertex_json(const Scene& scene, const VertexRef& vertex);
std::string edge_json(const Scene& scene, const EdgeRef& edge);
/// Of a proof about a clearance: the members "clearance", and "closer" if bodies come closer, each with a comma before.
std::string proved_clearance_json(const Scene& scene, const Verified& proved);
std::string pair_answer_json(const Scene& scene, const PairAnswer& pair);

}  // namespace taut::internal::io
