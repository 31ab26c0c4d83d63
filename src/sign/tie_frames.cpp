#include "sign/tie_frames.hpp"

#include <algorithm>
#include <cmath>

#include "base/interruption.hpp"

namespace taut {
namespace {

double rest_of(const ModelSeries<double>& f) {
  return f.terms > static_cast<int>(TieFrame::terms) ? f.c[TieFrame::terms].magnitude() : 0;
}

void take(const std::array<ModelSeries<Real320>, 5>& at, const std::array<ModelSeries<double>, 5>& over,
          std::array<std::array<FixedBall, TieFrame::terms>, 5>& functions, std::array<double, 5>& rest) {
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t k = 0; k < TieFrame::terms; ++k) {
      functions[i][k] = static_cast<int>(k) < at[i].terms ? FixedBall::of(at[i].c[k]) : FixedBall();
    }
    rest[i] = rest_of(over[i]);
  }
}

std::array<double, TieFrame::terms + 1> powers_of(double x) {
  std::array<double, TieFrame::terms + 1> power;
  power[0] = 1;
  for (std::size_t k = 1; k < power.size(); ++k) power[k] = power[k - 1] * x;
  return power;
}

using FrameAround = FrameOf<ModelSeries<double>>;

/// All over the ball that the series are made over.
FrameSample sample_over(const std::array<ModelSeries<double>, 5>& over) {
  std::array<Jet<double>, 5> f;
  for (std::size_t i = 0; i < 5; ++i) {
    const auto term = [&](int k) { return over[i].terms > k ? over[i].c[k] : Ball<double>::exact(0); };
    f[i] = {term(0), term(1), Ball<double>::exact(0)};
  }
  return sample_of(f);
}

bool leaves_out_nothing(const FrameAround& over, double last_power) {
  double rest = 0;
  for (std::size_t i = 0; i < 5; ++i) rest += rest_of(over.for_pp[i]) + rest_of(over.for_qq[i]);
  return rest * last_power < Fixed::lost_in_product;
}

/// It reaches so far that the terms make up the functions, up to less than the numbers resolve; nowhere, if the motion
/// is singular there.
TieFrame frame_about(const Leg& leg, double about) {
  TieFrame made;
  made.about = about;
  const double least = 0x1p-50 * std::max(std::fabs(about), leg.end - leg.start);
  for (double reach = 0x1p-34 * (leg.end - leg.start); reach > least; reach /= 4) {
    const FrameAround over = frame_series(leg, Ball<double>(about, reach));
    made.power = powers_of(reach);
    if (!leaves_out_nothing(over, made.power.back())) continue;
    made.reach = reach;
    const auto at = frame_series(leg, Ball<Real320>::exact(about));
    take(at.for_pp, over.for_pp, made.pp, made.pp_rest);
    take(at.for_qq, over.for_qq, made.qq, made.qq_rest);
    made.pp_over = sample_over(over.for_pp);
    made.qq_over = sample_over(over.for_qq);
    break;
  }
  return made;
}

}  // namespace

const TieFrame* TieFrames::known(double lo, double hi) const {
  if (!kept_) return nullptr;
  const auto reaches = [&](const TieFrame& f) {
    return f.reach > 0 && lo >= f.about - f.reach && hi <= f.about + f.reach;
  };
  const auto found = std::find_if(kept_->begin(), kept_->end(), reaches);
  return found == kept_->end() ? nullptr : &*found;
}

const TieFrame* TieFrames::around(double lo, double hi) {
  if (!leg_ || leg_->bridge || (leg_->translation && leg_->degree <= 1)) return nullptr;
  if (const TieFrame* const frame = known(lo, hi)) return frame;
  const auto is_singular = [&](const TieFrame& f) { return f.reach == 0 && lo <= f.about && f.about <= hi; };
  if (kept_ && std::any_of(kept_->begin(), kept_->end(), is_singular)) return nullptr;
  count_work(leg_->translation ? 75 : 430);
  TieFrame& made = slot();
  made = frame_about(*leg_, lo + (hi - lo) / 2);
  return hi - made.about <= made.reach && made.about - lo <= made.reach ? &made : nullptr;
}

TieFrame& TieFrames::slot() {
  reserve();
  if (kept_->size() < most_kept) return kept_->emplace_back();
  next_ = (next_ + 1) % most_kept;
  return (*kept_)[next_];
}

}  // namespace taut
