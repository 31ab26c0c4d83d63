#include "proof/motion_window.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace taut::internal::proof {
namespace {

/// Two functions of a frame that are the parts of one vector: about the window's middle, and what that leaves out.
struct SecondOrder {
  Vector value, rate, second;
  double error = INFINITY;
};

/// Where a bound is not known, products of it with 0 are not numbers.
double known(double bound) { return bound >= 0 ? bound : INFINITY; }

/// Functions i and i + 1 of a model, within r of t.
SecondOrder from_model(const FrameModel& m, int i, double t, double r) {
  double value[4], slope[4], second[4];
  m.evaluate(t, std::min(i, 2), value, slope, second);
  const int at = i < 4 ? 0 : 2;
  SecondOrder f{{value[at], value[at + 1]}, {slope[at], slope[at + 1]}, {second[at], second[at + 1]}, 0};
  for (int k = i; k < i + 2; ++k) {
    // The model's own bound of how far the second derivative is from that in its middle is the better one there.
    double spread = m.error_dd[k] + r * m.third[k];
    if (t == m.middle) spread = std::fmin(spread, m.second_rad[k]);
    f.error += m.error[k] + r * (m.error_d[k] + r / 2 * spread);
  }
  return f;
}

/// From the frame at the middle, and a bound of the next order over the window.
SecondOrder from_jets(const Jet<double>& x, const Jet<double>& y, const ThirdSeries& x_over, const ThirdSeries& y_over,
                      double r) {
  SecondOrder f{{x.v.mid, y.v.mid}, {x.d.mid, y.d.mid}, {x.dd.mid, y.dd.mid}, 0};
  const auto third = [](const ThirdSeries& over) { return over.terms > 3 ? over.c[3].magnitude() : 0; };
  f.error = x.v.rad + y.v.rad +
            r * (x.d.rad + y.d.rad + r * ((x.dd.rad + y.dd.rad) / 2 + r * (third(x_over) + third(y_over))));
  return f;
}

/// The same to first order, for bridges.
SecondOrder from_jets(const Jet<double>& x, const Jet<double>& y, const Jet<double>& x_over, const Jet<double>& y_over,
                      double r) {
  SecondOrder f{{x.v.mid, y.v.mid}, {x.d.mid, y.d.mid}, {}, 0};
  f.error = x.v.rad + y.v.rad + r * (x.d.rad + y.d.rad) + r * r / 2 * (x_over.dd.magnitude() + y_over.dd.magnitude());
  return f;
}

SecondOrder from_range(const Ball<double>& x, const Ball<double>& y) { return {{x.mid, y.mid}, {}, {}, x.rad + y.rad}; }

double distance_from_one(const Ball<double>& x) { return std::fabs(x.mid - 1) + x.rad; }

/// The segment sees a vertex at v + offset, up to rounding: the offsets become part of the shift.
WindowModel model_of(const SecondOrder& shift, const SecondOrder& rotation, double scale_error,
                     const ExactVector& fixed, const ExactVector& moving, double r) {
  const Vector from{fixed.x, fixed.y}, own{moving.x, moving.y};
  WindowModel s;
  s.shift = shift.value + rotation.value * own - from;
  s.shift_rate = shift.rate + rotation.rate * own;
  s.shift_second = shift.second + rotation.second * own;
  s.rotation = rotation.value;
  s.rotation_rate = rotation.rate;
  s.rotation_second = rotation.second;
  const auto reach = [r](const SecondOrder& f) {
    return l1_norm(f.value) + r * (l1_norm(f.rate) + r / 2 * l1_norm(f.second));
  };
  s.size = reach(shift) + reach(rotation) * (1 + l1_norm(own)) + l1_norm(from);
  s.rotation_error = known(rotation.error);
  s.scale_error = known(scale_error);
  s.shift_error = known(shift.error + rotation.error * l1_norm(own) + scale_error * l1_norm(from));
  return s;
}

/// conj(x_P) D, conj(x_Q) D, and c + i s; and how far the frames' scales are from 1.
struct Motion {
  SecondOrder seen_from_p, seen_from_q, rotation;
  double scale_error_p = 0, scale_error_q = 0;

  static Motion of_model(const FrameModel& m, double middle, double r) {
    return {from_model(m, 0, middle, r), from_model(m, 2, middle, r), from_model(m, 4, middle, r)};
  }
  static Motion of_frame(const MotionSegment& segment, double from, double to, double middle, double r) {
    const auto [pp, qq] = frame(segment, Ball<double>::exact(middle));
    const auto [pp_over, qq_over] = frame_to_third_order(segment, Ball<double>::between(from, to));
    return {from_jets(pp[1], pp[2], pp_over[1], pp_over[2], r), from_jets(qq[1], qq[2], qq_over[1], qq_over[2], r),
            from_jets(pp[3], pp[4], pp_over[3], pp_over[4], r)};
  }
  static Motion of_bridge(const MotionSegment& segment, double from, double to, double middle, double r) {
    const Frame<double> at = frame(segment, Ball<double>::exact(middle)),
                        over = frame(segment, Ball<double>::between(from, to));
    const auto& [pp, qq] = at;
    const auto& [pp_over, qq_over] = over;
    return {from_jets(pp[1], pp[2], pp_over[1], pp_over[2], r), from_jets(qq[1], qq[2], qq_over[1], qq_over[2], r),
            from_jets(pp[3], pp[4], pp_over[3], pp_over[4], r), distance_from_one(pp_over[0].v),
            distance_from_one(qq_over[0].v)};
  }
  static Motion of_range(const MotionSegment& segment, double from, double to) {
    const auto [pp, qq] = frame_values(segment, Ball<double>::between(from, to));
    return {from_range(pp[1], pp[2]), from_range(qq[1], qq[2]), from_range(pp[3], pp[4]), distance_from_one(pp[0]),
            distance_from_one(qq[0])};
  }

  bool bounded() const {
    return std::isfinite(seen_from_p.error + seen_from_q.error + rotation.error + scale_error_p + scale_error_q);
  }
};

/// As P sees Q, and as Q sees P.
std::pair<WindowModel, WindowModel> models(const MotionSegment& segment, const Motion& given,
                                           const MotionWindow& window) {
  const Motion motion = given.bounded() ? given : Motion::of_range(segment, window.from(), window.to());
  SecondOrder back = motion.seen_from_q, rotation_back = motion.rotation;
  for (Vector* v : {&back.value, &back.rate, &back.second}) *v = -*v;
  for (Vector* v : {&rotation_back.value, &rotation_back.rate, &rotation_back.second}) *v = conj(*v);
  const double r = window.half();
  return {model_of(motion.seen_from_p, motion.rotation, motion.scale_error_p, segment.offset_p, segment.offset_q, r),
          model_of(back, rotation_back, motion.scale_error_q, segment.offset_q, segment.offset_p, r)};
}

}  // namespace

MotionWindow::MotionWindow(double from, double to) : from_(from), to_(to) {
  middle_ = from + (to - from) / 2;
  half_ = std::max(to - middle_, middle_ - from) * (1 + 0x1p-50);
}

MotionWindow::MotionWindow(const MotionSegment& segment, const FrameModel& model, double from, double to)
    : MotionWindow(from, to) {
  std::tie(from_p_, from_q_) = models(segment, Motion::of_model(model, middle_, half_), *this);
}

MotionWindow::MotionWindow(const MotionSegment& segment, double from, double to) : MotionWindow(from, to) {
  const Motion motion = segment.bridge ? Motion::of_bridge(segment, from, to, middle_, half_)
                                       : Motion::of_frame(segment, from, to, middle_, half_);
  std::tie(from_p_, from_q_) = models(segment, motion, *this);
}

/// What the second order leaves out is about the third root of what the ninth one does.
bool MotionWindow::may_be_sharp() const {
  constexpr double share = 0x1p-12;
  return from_p_.rotation_error <= share && from_p_.shift_error <= share * from_p_.size &&
         from_q_.shift_error <= share * from_q_.size;
}

}  // namespace taut::internal::proof
