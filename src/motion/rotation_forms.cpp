#include "motion/rotation_forms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "motion/polynomial_search.hpp"

namespace taut::internal {
std::optional<RotationFault> RotationForm<DirectionRotation>::fault(const DirectionRotation& r, double origin,
                                                                    double start, double end) {
  const auto t = common_zero(r.a, r.b, origin, start, end);
  if (!t) return std::nullopt;
  return RotationFault{fmt::format("the direction (a, b) vanishes near t = {:.17g}", *t),
                       "a direction must have a length at all times of its piece"};
}

std::optional<RotationFault> RotationForm<CosineRotation>::fault(const CosineRotation& r, double origin, double start,
                                                                 double end) {
  const auto t = beyond_one(r.a, origin, start, end);
  if (!t) return std::nullopt;
  const Ball<double> value = Jet<double>::polynomial(r.a, time_since(Ball<double>::exact(*t), origin)).v;
  return RotationFault{fmt::format("the cosine is beyond 1 in magnitude at t = {:.17g}: {:.17g}", *t, value.mid),
                       "a cosine must stay within [-1, 1] at all times of its piece"};
}

Rotation rotation_of_form(std::size_t index) {
  Rotation rotation;
  for_each_form([&](auto form) {
    const Rotation candidate = std::move(form);
    if (candidate.index() == index) rotation = candidate;
  });
  return rotation;
}

bool varies(const Rotation& rotation) {
  bool varies = std::holds_alternative<JointFollower>(rotation);
  for_each_polynomial(rotation, [&](const Coefficients& c) { varies = varies || c.size() > 1; });
  return varies;
}

bool same_rotation(const Rotation& a, const Rotation& b) {
  if (const auto* x = std::get_if<JointFollower>(&a), *y = std::get_if<JointFollower>(&b); x && y)
    return x->functions == y->functions && x->joint == y->joint && x->exponent == y->exponent;
  std::vector<const Coefficients*> of_a, of_b;
  for_each_polynomial(a, [&](const Coefficients& c) { of_a.push_back(&c); });
  for_each_polynomial(b, [&](const Coefficients& c) { of_b.push_back(&c); });
  return a.index() == b.index() && std::equal(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                                              [](const auto* x, const auto* y) { return *x == *y; });
}

}  // namespace taut::internal
