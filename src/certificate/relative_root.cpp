#include "certificate/relative_root.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "certificate/fast_function.hpp"
#include "geometry/displacement.hpp"
#include "numeric/budget.hpp"

namespace taut::internal {
namespace {

/// In units of checkpoint(), as measured.
constexpr std::uint64_t work_of_relative_root = 5, work_of_distance = 3, work_of_root_near = 5;
constexpr double bound_up = 1 + 0x1p-45;
/// Residuals of nearly proportional functions are below this share of the coefficients.
constexpr double nearly = 0x1p-40;
/// Parts of a sum below this share of the error are left out of an enclosure.
constexpr double part_that_matters = 0x1p-10;

/// All terms but the motion's, which contain the edge alone.
constexpr std::size_t terms_of_points[] = {0, 3, 4};

/// The edge of the first function, and the differences of its points from those of the second.
template <class N>
FunctionPoints<N> edge_and_differences(const FunctionPoints<N>& p, const FunctionPoints<N>& o) {
  return {p.ex, p.ey, N(p.ax - o.ax), N(p.ay - o.ay), N(p.cx - o.cx), N(p.cy - o.cy)};
}

FunctionPoints<double> rounded(const FunctionPoints<DoubleDouble>& p) {
  return {p.ex.leading(), p.ey.leading(), p.ax.leading(), p.ay.leading(), p.cx.leading(), p.cy.leading()};
}

double size_of_edge(const FunctionPoints<double>& p) { return std::fabs(p.ex) + std::fabs(p.ey); }

}  // namespace

RelativeRoot::RelativeRoot(const FrameExpansion& frame, const MotionSegment& segment, const PairGeometry& g,
                           const CertificateFunction& function)
    : about_(frame.about), pp_(function.pp) {
  count_work(work_of_relative_root);
  const FrameSample& over = frame.over(pp_);
  slope_ = FastFunction::undisplaced(segment, g, function).slope(over);
  if (slope_sign() == 0) return;
  displaced_ = FastFunction::displacement_part(segment, g, function).value(over);
  given_ = points_of<DoubleDouble>(segment, g, function, Shape::given);
  rough_ = rounded(given_);
}

/// Uses doubles without bounds. An error only misses an opportunity.
bool RelativeRoot::may_be_proportional_to(const MotionSegment& segment, const RelativeRoot& o) const {
  const double size = size_of_edge(rough_), other = size_of_edge(o.rough_);
  if (!(std::fabs(cross(rough_.ex, rough_.ey, o.rough_.ex, o.rough_.ey)) <= nearly * size * other)) return false;
  const auto c = coefficients_on(segment, pp_, edge_and_differences(rough_, o.rough_), 0.0);
  return std::fabs(c[0]) <= nearly * size && std::fabs(c[3]) <= nearly * size && std::fabs(c[4]) <= nearly * size;
}

/// The value of this function at the other's root, times the larger coordinate of the other's edge. `turned` means that
/// this is y.
Bounded RelativeRoot::scaled_value(const FrameSample& over, const MotionSegment& segment, const RelativeRoot& other,
                                   bool turned) const {
  const FunctionPoints<DoubleDouble>&p = given_, &o = other.given_;
  const DoubleDouble &mine = turned ? p.ey : p.ex, &others = turned ? o.ey : o.ex;
  const DoubleDouble crossed = cross(p.ex, p.ey, o.ex, o.ey), zero;
  const FunctionPoints<DoubleDouble> d{turned ? crossed : zero, turned ? zero : -crossed, o.ax, o.ay, o.cx, o.cy};
  std::array<DoubleDouble, 5> residual = coefficients_on(segment, pp_, d, zero);
  const auto more = coefficients_on(segment, pp_, edge_and_differences(p, o), zero);
  for (const std::size_t i : terms_of_points) residual[i] = residual[i] + others * more[i];
  const double error_of[] = {over.error_0, over.error_a, over.error_a, over.error_b, over.error_b};
  Bounded sum{0, 0};
  for (std::size_t i = 0; i < residual.size(); ++i) {
    const double size = std::fabs(over.f[i]), most = residual[i].most();
    sum.value += residual[i].leading() * over.f[i];
    sum.error += most * (error_of[i] + size * 0x1p-49) + residual[i].error() * size;
  }
  const double gained = others.leading() * displaced_.value, lost = mine.leading() * other.displaced_.value;
  const double error = (others.most() * displaced_.error + mine.most() * other.displaced_.error) +
                       (std::fabs(gained) + std::fabs(lost)) * 0x1p-49;
  sum.value += displacement_unit * (gained - lost);
  sum.error += displacement_unit * error;
  return {sum.value, (sum.error + std::fabs(sum.value) * 0x1p-49) * bound_up};
}

std::optional<Bounded> RelativeRoot::distance_from(const FrameExpansion& frame, const MotionSegment& segment,
                                                   const KnownRoot& known) const {
  count_work(work_of_distance);
  const RelativeRoot& other = known.function;
  if (!may_be_proportional_to(segment, other)) return std::nullopt;
  const bool turned = std::fabs(other.rough_.ey) > std::fabs(other.rough_.ex);
  const Bounded value = scaled_value(frame.over(pp_), segment, other, turned);
  // By the mean value theorem.
  const double factor = turned ? other.rough_.ey : other.rough_.ex;
  const double least = (std::fabs(slope_.value) - slope_.error) / bound_up;
  const double h = -value.value / (factor * slope_.value);
  const double error = (value.error + std::fabs(value.value) * (slope_.error / least + 0x1p-48)) * bound_up /
                       (std::fabs(factor) * least) * bound_up;
  if (!(error < 0x1p-30 * frame.reach)) return std::nullopt;
  if (!((known.farthest + std::fabs(h) + error) * bound_up < frame.reach)) return std::nullopt;
  return Bounded{h, error};
}

KnownRoot::KnownRoot(const RelativeRoot& of, const FrameExpansion& frame, const PreciseTime& root)
    : function(of),
      from(root.sum_lo()),
      width(root.width_of_sums()),
      farthest(std::max(frame.about - root.floor(), root.ceiling() - frame.about) * bound_up) {}

/// Rounded to the digits that matter relative to the error.
PreciseTime KnownRoot::at_distance(const Bounded& h) const {
  count_work(work_of_root_near);
  ExactSum<ShortSum::capacity - 1> middle;
  std::size_t left = from.size();
  for (; left > 0 && middle.size() < ShortSum::capacity - 2; --left) {
    if (std::fabs(from.part(left - 1)) <= part_that_matters * h.error) break;
    middle.add(from.part(left - 1));
  }
  middle.add(h.value);
  // Parts that do not overlap sum to less than twice the largest.
  const double room = (h.error + (left > 0 ? 2 * std::fabs(from.part(left - 1)) : 0)) * bound_up;
  ExactSum<ShortSum::capacity> lo, hi;
  lo.take(middle);
  hi.take(middle);
  lo.add(-room);
  hi.add((room + width) * bound_up);
  return {ShortSum::of(lo), ShortSum::of(hi), Stage::relative};
}

}  // namespace taut::internal
