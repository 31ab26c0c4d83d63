// Looks at a scene from all sides: both engines, the static construction, the proof, the plan changed on the way.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "taut/check.hpp"
#include "taut/scene.hpp"

namespace taut::fuzz {

enum class FindingKind : std::uint8_t {
  none,
  rejected,      ///< the scene is not valid: no defect
  structure,     ///< a broken invariant
  disagreement,  ///< the engines contradict each other
  tiling,        ///< the kinetic map is not the static one, or not a tiling of pseudo-triangles
  proof,         ///< the log of prove() is not accepted, or proves something else
  plan_change,   ///< the same motion, announced piece by piece, has another answer
  query,         ///< Simulation contradicts itself, or the answer
  undecided,     ///< not decided at the highest precision: a known limit, but worth a look
  exception,     ///< an exception that nothing documents
  crash,         ///< a signal, or a sanitizer's report
  hang,          ///< no answer in time
};

const char* to_string(FindingKind kind);

struct Finding {
  FindingKind kind = FindingKind::none;
  std::string message;

  bool is_defect() const { return kind != FindingKind::none && kind != FindingKind::rejected; }
  /// The kind and the message without its numbers: findings with the same signature count as the same.
  std::string signature() const;
};

struct Evaluations {
  std::vector<Touch> touch = {Touch::open, Touch::closed};
  std::uint64_t max_events = 2000;  ///< of each run
  double max_seconds = 1;           ///< of each run
  bool tilings = true;
  bool proofs = true;
  bool plan_changes = true;
  bool queries = true;
  bool undecided = false;  ///< counts as a finding
};

/// The first thing that is wrong. `report`, if given, gets a line for every answer.
Finding examine(const Scene& scene, const Evaluations& looks, std::string* report = nullptr);

/// Runs `look` in a process of its own, which may crash, or be ended after some seconds. `look` may add to the report.
Finding in_process_apart(const std::function<Finding(std::string& report)>& look, double seconds,
                         std::string* report = nullptr);

/// What contradicts what in two answers, by engines or by ways to ask; empty if nothing does.
std::string contradiction(const Answer& first, const Answer& second);

}  // namespace taut::fuzz
