// What a log should prove, so that a CI job fails where it proves less.
#pragma once

#include <optional>
#include <string>

#include "taut/path_proof.hpp"
#include "taut/proof.hpp"
#include "taut/scene.hpp"

namespace taut::cli {

struct Expectation {
  std::optional<Outcome> outcome;  ///< free or contact
  bool no_way = false;             ///< of a scene with a start and a goal, instead of an outcome
  std::optional<Touch> touch;
  /// free: before this time. contact: no later than this time. Without it, the scene's whole interval is meant.
  std::optional<double> until;

  /// free: this distance is kept. contact: bodies come closer than this distance, which is no contact.
  std::optional<double> clearance;

  bool any() const { return outcome || no_way || touch || clearance; }
};

/// Throws InputError unless `until` is an instant of the scene that something can be said about.
void validate(const Expectation& expected, const Scene& scene);

/// Does the log prove all of it?
bool is_met(const Expectation& expected, const Scene& scene, const Verified& proved);
bool is_met(const Expectation& expected, const VerifiedPath& proved);

/// In words: "free on [0, 10], touch closed".
std::string text_of(const Expectation& expected, const Scene& scene);

}  // namespace taut::cli
