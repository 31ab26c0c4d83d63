// Distances that bodies keep, as functions of time, and which pair is to keep which.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "motion/local_time.hpp"
#include "taut/feature.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

// A distance that bodies keep, as a function of time.

inline Margin constant_margin(double m) { return {{m}, 0}; }
/// The value of a constant one, or the first coefficient.
inline double constant_term(const Margin& margin) { return margin.coefficients.empty() ? 0 : margin.coefficients[0]; }
/// Is it the same at all times, as its coefficients show?
bool is_constant(const Margin& margin);
/// The same function of time, as the coefficients show it?
bool same_margin(const Margin& a, const Margin& b);
/// The same margin in lengths multiplied by 2^exponent, exactly.
Margin scaled(Margin margin, int exponent);
/// In powers of the time since an instant, exactly.
LocalPolynomials::Known expanded_about(const Margin& margin, double instant);
/// Encloses the margin at all times of [from, to].
Ball<double> margin_over(const Margin& margin, double from, double to);
/// The least double that is certainly not below the margin at that instant, or one next to it.
double margin_at(const Margin& margin, double t);
/// An instant of [start, end] at which it is negative, or so close to 0 that no precision decides.
std::optional<double> negative_at(const Margin& margin, double start, double end);

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
