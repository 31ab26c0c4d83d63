#include "proof/motion_window.hpp"

#include <algorithm>
#include <cmath>

#include "relative/frame_model.hpp"

namespace taut::proof {
namespace {

/// Two functions of a frame that are the parts of one vector: about the window's middle, and what that leaves out.
struct FirstOrder {
  Vector value, rate;
  double error = INFINITY;
};

/// conj(x_P) D, conj(x_Q) D, and c + i s; and how far the frames' scales are from 1.
struct Motion {
  FirstOrder seen_from_p, seen_from_q, turn;
  double scale_error_p = 0, scale_error_q = 0;

  bool bounded() const {
    return std::isfinite(seen_from_p.error + seen_from_q.error + turn.error + scale_error_p + scale_error_q);
  }
};

/// Where a bound is not known, products of it with 0 are not numbers.
double known(double bound) { return bound >= 0 ? bound : INFINITY; }

FirstOrder from_model(const FrameModel& m, const double* value, const double* slope, int i, double r) {
  FirstOrder f{{value[i], value[i + 1]}, {slope[i], slope[i + 1]}, 0};
  for (int k = i; k < i + 2; ++k)
    f.error += m.error[k] + r * (m.error_d[k] + r / 2 * (std::fabs(m.bend[k]) + m.bend_rad[k]));
  return f;
}

Motion from_model(const Leg& leg, double from, double to, double middle, double r) {
  const FrameModel model = FrameModel::over(leg, from, to);
  double value[FrameModel::functions], slope[FrameModel::functions];
  model.evaluate(middle, value, slope);
  return {from_model(model, value, slope, 0, r), from_model(model, value, slope, 2, r),
          from_model(model, value, slope, 4, r)};
}

/// Bridges are short, and rare: from the frame at the middle and over all of the window.
FirstOrder from_jets(const Jet<double>& x, const Jet<double>& y, const Jet<double>& x_over, const Jet<double>& y_over,
                     double r) {
  FirstOrder f{{x.v.mid, y.v.mid}, {x.d.mid, y.d.mid}, 0};
  f.error = x.v.rad + y.v.rad + r * (x.d.rad + y.d.rad) + r * r / 2 * (x_over.dd.magnitude() + y_over.dd.magnitude());
  return f;
}

double distance_from_one(const Ball<double>& x) { return std::fabs(x.mid - 1) + x.rad; }

Motion from_bridge(const Leg& leg, double from, double to, double middle, double r) {
  const Frame<double> at = frame(leg, Ball<double>::exact(middle)), over = frame(leg, Ball<double>::between(from, to));
  const auto& [pp, qq] = at;
  const auto& [pp_over, qq_over] = over;
  return {from_jets(pp[1], pp[2], pp_over[1], pp_over[2], r), from_jets(qq[1], qq[2], qq_over[1], qq_over[2], r),
          from_jets(pp[3], pp[4], pp_over[3], pp_over[4], r), distance_from_one(pp_over[0].v),
          distance_from_one(qq_over[0].v)};
}

FirstOrder in_range(const Ball<double>& x, const Ball<double>& y) { return {{x.mid, y.mid}, {0, 0}, x.rad + y.rad}; }

Motion from_range(const Leg& leg, double from, double to) {
  const auto [pp, qq] = frame_values(leg, Ball<double>::between(from, to));
  return {in_range(pp[1], pp[2]), in_range(qq[1], qq[2]), in_range(pp[3], pp[4]), distance_from_one(pp[0]),
          distance_from_one(qq[0])};
}

/// The leg sees a vertex at v + offset, up to rounding: the offsets become part of the shift.
Sight sight_of(FirstOrder shift, const FirstOrder& turn, double scale_error, const ExactVector& fixed,
               const ExactVector& moving, double r) {
  const Vector from{fixed.x, fixed.y}, own{moving.x, moving.y};
  Sight s;
  s.shift = shift.value + turn.value * own - from;
  s.shift_rate = shift.rate + turn.rate * own;
  s.turn = turn.value;
  s.turn_rate = turn.rate;
  const double turns = size(turn.value) + r * size(turn.rate);
  s.size = size(shift.value) + r * size(shift.rate) + turns * (1 + size(own)) + size(from);
  s.turn_error = known(turn.error);
  s.scale_error = known(scale_error);
  s.shift_error = known(shift.error + turn.error * size(own) + scale_error * size(from));
  return s;
}

}  // namespace

MotionWindow::MotionWindow(const Leg& leg, double from, double to) : from_(from), to_(to) {
  const double middle = from + (to - from) / 2;
  half_ = std::max(to - middle, middle - from) * (1 + 0x1p-50);
  Motion motion = leg.bridge ? from_bridge(leg, from, to, middle, half_) : from_model(leg, from, to, middle, half_);
  if (!motion.bounded()) motion = from_range(leg, from, to);
  from_p_ = sight_of(motion.seen_from_p, motion.turn, motion.scale_error_p, leg.offset_p, leg.offset_q, half_);
  FirstOrder shift = motion.seen_from_q, turn = motion.turn;
  shift.value = -shift.value;
  shift.rate = -shift.rate;
  turn.value = conj(turn.value);
  turn.rate = conj(turn.rate);
  from_q_ = sight_of(shift, turn, motion.scale_error_q, leg.offset_q, leg.offset_p, half_);
}

}  // namespace taut::proof
