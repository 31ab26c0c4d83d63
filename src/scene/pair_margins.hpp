// Which distance each pair of bodies is to keep.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "scene/margin.hpp"
#include "taut/feature.hpp"

namespace taut::internal {

/// By the bodies' numbers in the scene, in its units.
class PairMargins {
 public:
  /// One for all pairs.
  explicit PairMargins(double all) : others_(constant_margin(all)) {}
  explicit PairMargins(Margin all) : others_(std::move(all)) {}
  /// What the scene has for its pairs, and one for the others. The scene must be valid.
  PairMargins(const Scene& scene, double others);

  const Margin& of(BodyId a, BodyId b) const;
  /// Has every pair the same one?
  bool all_alike() const { return pairs_.empty() && bodies_.empty(); }
  /// A share for each of so many bodies, in the scene's units: no margin is greater at any time of [from, to] than the
  /// sum of its bodies' shares.
  std::vector<double> shares(std::size_t bodies, double from, double to) const;

 private:
  Margin others_;
  std::map<BodyId, Margin> bodies_;
  std::map<std::pair<BodyId, BodyId>, Margin> pairs_;  ///< the smaller number first
};

/// Throws InputError unless the scene's clearances name bodies, are distances at all of its times, and say one thing
/// about each pair.
void validate_clearances(const Scene& scene);

}  // namespace taut::internal
