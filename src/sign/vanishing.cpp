#include "sign/vanishing.hpp"

#include <algorithm>

#include "numeric/exact_number.hpp"
#include "relative/frame_identities.hpp"
#include "relative/frame_looks.hpp"

namespace taut {
namespace {

/// Is it the zero polynomial? D's constant part is the shift, which the points have in them.
bool vanishes_on_translation(const Leg& leg, const PairGeometry& g, const Form& form) {
  const auto points = points_of<ExactNumber>(leg, g, form, Shape::given, Origin::powers);
  const auto c = translation_coefficients(form.pp, points, ExactNumber());
  const auto is_zero = [](const ExactNumber& x) { return x.is_exact() && x.is_zero(); };
  if (!is_zero(c[0])) return false;
  const auto change = [](const Coefficients& q, const Coefficients& p, std::size_t k) {
    return ExactNumber::exact(coefficient(q, k)) - ExactNumber::exact(coefficient(p, k));
  };
  const std::size_t n = std::max({leg.p.x.size(), leg.p.y.size(), leg.q.x.size(), leg.q.y.size()});
  for (std::size_t k = 1; k < n; ++k) {
    if (!is_zero(dot(c[1], c[2], change(leg.q.x, leg.p.x, k), change(leg.q.y, leg.p.y, k)))) return false;
  }
  return true;
}

}  // namespace

bool vanishes_before_displacement(const Leg& leg, const PairGeometry& g, const Form& form) {
  if (leg.translation) return vanishes_on_translation(leg, g, form);
  const auto given = [&](auto zero) {
    return form_coefficients(form.pp, points_of<decltype(zero)>(leg, g, form, Shape::given));
  };
  return !leg.looks().differs_from_zero(form.pp, given(Ball<double>())) &&
         leg.identities().vanishes(form.pp, given(Dyadic()));
}

Portion portion_of(const Leg& leg, const PairGeometry& g, const Form& form) {
  if (leg.translation || leg.bridge) return Portion::whole;
  if (form.measure == Measure::offset_x || form.measure == Measure::offset_y) return Portion::whole;
  return vanishes_before_displacement(leg, g, form) ? Portion::displacement : Portion::whole;
}

}  // namespace taut
