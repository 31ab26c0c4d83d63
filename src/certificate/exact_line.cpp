#include "certificate/exact_line.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/budget.hpp"

namespace taut::internal {
namespace {

/// In units of checkpoint(), as measured.
constexpr std::uint64_t work_of_line = 5, work_of_sign_on_line = 6, work_of_root_on_line = 7;

}  // namespace

ExactLine::ExactLine(const MotionSegment& segment, const PairGeometry& g, const CertificateFunction& function) {
  count_work(work_of_line);
  // The segment shifts P, so that the motion is zero at segment.about(), or nearly.
  const auto zero = ExactNumber();
  const auto points = points_of<ExactNumber>(segment, g, function, Shape::displaced);
  const auto c = translation_coefficients(function.pp, points, zero);
  const auto change = [&](std::size_t k) {
    return dot(c[1], c[2], segment.way_coefficient<ExactNumber>(true, k),
               segment.way_coefficient<ExactNumber>(false, k));
  };
  const ExactNumber slope = change(1);
  ExactNumber start = segment.far() ? c[0] + change(0) : c[0];
  if (segment.about() != 0) start = start - dot(slope, zero, ExactNumber::exact(segment.about()), zero);
  exact_ = start.is_exact() && slope.is_exact() && slope.sum().size() <= slope_terms;
  start_.assign(start.sum(), 1);
  farthest_ = std::max(std::fabs(segment.start), std::fabs(segment.end));
  if (exact_) slope_.take(slope.sum());
}

/// Adds slope * time, exactly except for terms that are negligible at this precision. Returns false if that is not
/// possible.
template <std::size_t Terms>
bool ExactLine::add_change(NearlyExact<Terms>& value, double time) const {
  for (std::size_t i = slope_.size(); i-- > 0;) {
    const double product = slope_.term(i) * time;
    if (std::fabs(product) < value.negligible) {
      value.error += std::fabs(product);
    } else if (!add_exact_product(value.sum, slope_.term(i), time)) {
      return false;
    }
  }
  return true;
}

template <std::size_t Terms>
void ExactLine::begin(NearlyExact<Terms>& value, double sign) const {
  value.sum.assign(start_, sign);
  value.negligible = std::max(0x1p-300 * std::fabs(start_.approximate()), 0x1p-1000);
}

int ExactLine::sign_over(const PreciseTime& t) const {
  count_work(work_of_sign_on_line);
  NearlyExact<start_terms + 2 * slope_terms * ShortSum::capacity> value;
  begin(value, 1);
  const double slope = std::fabs(slope_.approximate()), width = t.width_of_sums();
  const ShortSum& first = t.sum_lo();
  for (std::size_t k = first.size();; --k) {
    // Parts from k on are included. The others change the instant by less than twice the largest of them.
    const double open = k > 0 ? 2 * std::fabs(first.part(k - 1)) : 0;
    if (std::fabs(value.sum.approximate()) > (value.error + slope * (open + width)) * (1 + 0x1p-40)) {
      return value.sum.sign();
    }
    if (k == 0 || !add_change(value, first.part(k - 1))) return 0;
  }
}

std::optional<PreciseTime> ExactLine::root(Stage stage, double enough) const {
  count_work(work_of_root_on_line);
  constexpr std::size_t digits = 5;
  NearlyExact<start_terms + 2 * slope_terms * digits> rest;  // -start - slope * quotient
  begin(rest, -1);
  const double slope = slope_.approximate();
  ExactSum<digits + 1> quotient;
  double digit = rest.sum.approximate() / slope, error = INFINITY;
  for (std::size_t k = 0; k < digits && error > enough; ++k) {
    if (digit != 0) {
      if (!(std::fabs(digit) > 0x1p-900 && std::fabs(digit) < 0x1p900)) return std::nullopt;
      quotient.add(digit);
      if (!add_change(rest, -digit)) return std::nullopt;
    }
    // The root is at the quotient plus rest / slope.
    digit = rest.sum.approximate() / slope;
    error = (std::fabs(digit) + rest.error / std::fabs(slope)) * (1 + 0x1p-40);
  }
  if (!(error <= std::max(enough, 0x1p-200 * (farthest_ + std::fabs(quotient.approximate()))))) return std::nullopt;
  ExactSum<digits + 1> lo = quotient, hi = quotient;
  lo.add(-error);
  hi.add(error);
  return PreciseTime(ShortSum::of(lo), ShortSum::of(hi), stage);
}

}  // namespace taut::internal
