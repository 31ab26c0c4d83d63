#include "certificate/frame_expansion.hpp"

#include <algorithm>
#include <cmath>

#include "motion/uniform_rotation.hpp"
#include "numeric/budget.hpp"

namespace taut::internal {
namespace {

double rest_of(const ModelSeries<double>& f, double reach) {
  double rest = f.terms > static_cast<int>(FrameExpansion::terms) ? f.c[FrameExpansion::terms].magnitude() : 0;
  for (std::size_t k = 0; k < FrameExpansion::terms; ++k) rest *= reach;
  return rest * (1 + 0x1p-44);
}

void take(const std::array<ModelSeries<Real320>, 5>& at, const std::array<ModelSeries<double>, 5>& over,
          const FrameExpansion& frame, std::array<std::array<FixedBall, FrameExpansion::terms>, 5>& functions,
          std::array<double, 5>& rest) {
  for (std::size_t i = 0; i < 5; ++i) {
    for (int k = 0; k < static_cast<int>(FrameExpansion::terms); ++k) {
      FixedBall& to = functions[i][static_cast<std::size_t>(k)];
      to = k < at[i].terms ? FixedBall::of(scaled(at[i].c[k], k * frame.exponent)) : FixedBall();
    }
    rest[i] = rest_of(over[i], frame.reach);
  }
}

/// A sample over the whole ball of the series.
FrameSample sample_over(const std::array<ModelSeries<double>, 5>& over) {
  std::array<Jet<double>, 5> f;
  for (std::size_t i = 0; i < 5; ++i) {
    const auto term = [&](int k) { return over[i].terms > k ? over[i].c[k] : Ball<double>::exact(0); };
    f[i] = {term(0), term(1), Ball<double>::exact(0)};
  }
  return sample_of(f);
}

/// Where bodies rotate uniformly, the coefficients are known.
bool take_uniform(const MotionSegment& segment, const UniformRotation& even, FrameExpansion& frame) {
  if (!(even.rest_within(segment, frame.about, frame.exponent) < Fixed::lost_in_product)) return false;
  const UniformRotation::Expansion at = even.expansion(segment, frame.about, frame.exponent);
  const auto take_side = [&](std::size_t first, auto& functions, auto& rest) {
    functions[0][0] = FixedBall::exact(1);
    std::array<Jet<double>, 5> over{Jet<double>::constant(1)};
    for (std::size_t i = 1; i < 5; ++i) {
      const std::size_t from = i < 3 ? first + i - 1 : i + 1;  // the order of FrameModel
      functions[i] = at.c[from];
      rest[i] = at.rest[from];
      over[i] = at.over[from];
    }
    return sample_of(over);
  };
  frame.pp_over = take_side(0, frame.pp, frame.pp_rest);
  frame.qq_over = take_side(2, frame.qq, frame.qq_rest);
  return true;
}

using FrameAround = FrameOf<ModelSeries<double>>;

bool leaves_out_nothing(const FrameAround& over, double reach) {
  double rest = 0;
  for (std::size_t i = 0; i < 5; ++i) rest += rest_of(over.for_pp[i], reach) + rest_of(over.for_qq[i], reach);
  return rest < Fixed::lost_in_product;
}

bool take_any(const MotionSegment& segment, FrameExpansion& frame) {
  const FrameAround over = frame_series(segment, Ball<double>(frame.about, frame.reach));
  if (!leaves_out_nothing(over, frame.reach)) return false;
  const auto at = frame_series(segment, Ball<Real320>::exact(frame.about));
  take(at.for_pp, over.for_pp, frame, frame.pp, frame.pp_rest);
  take(at.for_qq, over.for_qq, frame, frame.qq, frame.qq_rest);
  frame.pp_over = sample_over(over.for_pp);
  frame.qq_over = sample_over(over.for_qq);
  return true;
}

/// The frame about an instant. Its reach is so short that the terms give the functions to within the resolution of the
/// numbers. The reach is zero if the motion is singular there.
FrameExpansion frame_about(const MotionSegment& segment, const UniformRotation* even, double about) {
  FrameExpansion made;
  made.about = about;
  const double length = segment.end - segment.start, least = 0x1p-50 * std::max(std::fabs(about), length);
  if (!(length > 0x1p-800 && length < 0x1p60)) return made;
  // Polynomials of a low degree omit nothing. Other functions mostly omit nothing at the second length.
  for (int e = std::ilogb(length) - (segment.translation ? 34 : 37); power_of_two(e) > least; e -= 2) {
    made.exponent = e;
    made.reach = power_of_two(e);
    if (even ? take_uniform(segment, *even, made) : take_any(segment, made)) return made;
  }
  made.reach = 0;
  return made;
}

}  // namespace

const FrameExpansion* FrameExpansionCache::known(double lo, double hi) const {
  if (!kept_) return nullptr;
  const auto reaches = [&](const FrameExpansion& f) {
    return f.reach > 0 && lo >= f.about - f.reach && hi <= f.about + f.reach;
  };
  const auto found = std::find_if(kept_->begin(), kept_->end(), reaches);
  return found == kept_->end() ? nullptr : &*found;
}

const FrameExpansion* FrameExpansionCache::around(double lo, double hi) {
  if (!segment_ || segment_->bridge || (segment_->translation && segment_->degree <= 1)) return nullptr;
  if (const FrameExpansion* const frame = known(lo, hi)) return frame;
  const auto is_singular = [&](const FrameExpansion& f) { return f.reach == 0 && lo <= f.about && f.about <= hi; };
  if (kept_ && std::any_of(kept_->begin(), kept_->end(), is_singular)) return nullptr;
  const UniformRotation* const even = segment_->uniform_rotation().get();
  count_work(segment_->translation ? 75 : even ? 50 : 300);
  FrameExpansion& made = slot();
  made = frame_about(*segment_, even, lo + (hi - lo) / 2);
  return hi - made.about <= made.reach && made.about - lo <= made.reach ? &made : nullptr;
}

FrameExpansion& FrameExpansionCache::slot() {
  reserve();
  if (kept_->size() < most_kept) return kept_->emplace_back();
  next_ = (next_ + 1) % most_kept;
  return (*kept_)[next_];
}

}  // namespace taut::internal
