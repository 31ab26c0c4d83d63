#include "certificate/certificate_function.hpp"

#include <algorithm>

#include "motion/frame_model.hpp"
#include "motion/frame_sample.hpp"
#include "numeric/exact_number.hpp"

namespace taut::internal {
namespace {

/// Is it the zero polynomial? D's constant part is the shift, which the points include, up to a remainder.
bool vanishes_on_translation(const MotionSegment& segment, const PairGeometry& g, const CertificateFunction& function) {
  const auto points = points_of<ExactNumber>(segment, g, function, Shape::given);
  const auto c = translation_coefficients(function.pp, points, ExactNumber());
  const auto is_zero = [](const ExactNumber& x) { return x.is_exact() && x.is_zero(); };
  const auto change = [&](std::size_t k) {
    return dot(c[1], c[2], segment.way_coefficient<ExactNumber>(true, k),
               segment.way_coefficient<ExactNumber>(false, k));
  };
  if (!is_zero(segment.far() ? c[0] + change(0) : c[0])) return false;
  for (int k = 1; k <= segment.degree; ++k) {
    if (!is_zero(change(static_cast<std::size_t>(k)))) return false;
  }
  return true;
}

}  // namespace

bool vanishes_before_displacement(const MotionSegment& segment, const PairGeometry& g,
                                  const CertificateFunction& function) {
  if (segment.translation) return vanishes_on_translation(segment, g, function);
  const auto given = [&](auto zero) {
    return function_coefficients(function.pp, points_of<decltype(zero)>(segment, g, function, Shape::given));
  };
  return !segment.looks().differs_from_zero(function.pp, given(Ball<double>())) &&
         segment.identities().vanishes(function.pp, given(Dyadic()));
}

Portion portion_of(const MotionSegment& segment, const PairGeometry& g, const CertificateFunction& function) {
  if (segment.translation || segment.bridge) return Portion::whole;
  if (function.measure == Measure::offset_x || function.measure == Measure::offset_y) return Portion::whole;
  return vanishes_before_displacement(segment, g, function) ? Portion::displacement : Portion::whole;
}

}  // namespace taut::internal
