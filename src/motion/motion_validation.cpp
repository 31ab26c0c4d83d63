#include <cmath>
#include <functional>
#include <sstream>

#include "motion/motion_plan.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

std::string number(double x) {
  std::ostringstream s;
  s.precision(17);
  s << x;
  return s.str();
}

using Test = std::function<bool(const Ball<double>&)>;

/// A time in [lo, hi] at which something is certainly wrong, by bisection: `fine` proves that nothing is wrong over a
/// ball, `wrong` that something is at a point. Nothing if neither is shown at the resolution of doubles.
bool find_time(double lo, double hi, const Test& fine, const Test& wrong, double& t, int depth = 0) {
  const double middle = lo + (hi - lo) / 2;
  for (const double candidate : {lo, middle, hi}) {
    if (wrong(Ball<double>::exact(candidate))) {
      t = candidate;
      return true;
    }
  }
  if (fine(Ball<double>::between(lo, hi)) || depth > 48 || !(lo < middle && middle < hi)) return false;
  return find_time(lo, middle, fine, wrong, t, depth + 1) || find_time(middle, hi, fine, wrong, t, depth + 1);
}

class PieceCheck {
 public:
  PieceCheck(const MotionPiece& piece, std::string place, double start, double end)
      : piece_(piece), place_(std::move(place)), start_(start), end_(end) {}

  void run() const {
    coefficients("x", piece_.x);
    coefficients("y", piece_.y);
    coefficients("pivot", {piece_.pivot.x, piece_.pivot.y});
    if (const auto* r = std::get_if<AngleRotation>(&piece_.rotation)) coefficients("rotation.angle", r->angle);
    if (const auto* r = std::get_if<HalfAngleRotation>(&piece_.rotation)) {
      coefficients("rotation.half_angle_tangent", r->s);
    }
    if (const auto* r = std::get_if<DirectionRotation>(&piece_.rotation)) direction(*r);
    if (const auto* r = std::get_if<CosineRotation>(&piece_.rotation)) cosine(*r);
  }

 private:
  void coefficients(const char* what, const Coefficients& c) const {
    for (std::size_t i = 0; i < c.size(); ++i) {
      if (!std::isfinite(c[i]))
        throw InputError(place_, std::string(what) + "[" + std::to_string(i) + "] is not a finite number");
      if (std::fabs(c[i]) > 0x1p400 || (c[i] != 0 && std::fabs(c[i]) < 0x1p-400))
        throw InputError(place_,
                         std::string(what) + "[" + std::to_string(i) + "] = " + number(c[i]) +
                             " is outside the range of magnitudes that taut computes with, 2^-400 to 2^400",
                         "choose other units");
    }
    if (c.size() > max_degree + 1)
      throw InputError(place_, std::string(what) + " has degree " + std::to_string(c.size() - 1),
                       "the highest degree supported is " + std::to_string(max_degree));
  }

  void direction(const DirectionRotation& r) const {
    coefficients("rotation.direction.a", r.a);
    coefficients("rotation.direction.b", r.b);
    const auto square = [&r](const Ball<double>& t) {
      const Ball<double> a = Jet<double>::polynomial(r.a, t).v, b = Jet<double>::polynomial(r.b, t).v;
      return a * a + b * b;
    };
    const double size = square(Ball<double>::between(start_, end_)).magnitude();
    double t = 0;
    // Zero is never certain in rounded arithmetic: shorter than 2^-40 of the longest is refused as well.
    const auto fine = [&](const Ball<double>& x) {
      return (square(x) - Ball<double>::exact(size * 0x1p-80)).sign() > 0;
    };
    const auto wrong = [&](const Ball<double>& x) {
      return (square(x) - Ball<double>::exact(size * 0x1p-80)).sign() <= 0;
    };
    const double middle = start_ + (end_ - start_) / 2;
    if (!(size > 0) || find_vanishing(start_, end_, fine, wrong, t)) {
      throw InputError(place_, "the direction (a, b) vanishes near t = " + number(size > 0 ? t : middle),
                       "a direction must have a length at all times of its piece");
    }
  }
  /// As find_time, but what cannot be shown to be fine at the finest resolution counts as wrong.
  static bool find_vanishing(double lo, double hi, const Test& fine, const Test& wrong, double& t, int depth = 0) {
    if (fine(Ball<double>::between(lo, hi))) return false;
    const double middle = lo + (hi - lo) / 2;
    if (depth > 60 || !(lo < middle && middle < hi)) {
      t = middle;
      return wrong(Ball<double>::exact(lo)) || wrong(Ball<double>::exact(middle)) || wrong(Ball<double>::exact(hi)) ||
             depth > 60;
    }
    return find_vanishing(lo, middle, fine, wrong, t, depth + 1) ||
           find_vanishing(middle, hi, fine, wrong, t, depth + 1);
  }

  void cosine(const CosineRotation& r) const {
    coefficients("rotation.cosine", r.a);
    BallPolynomial<double> coefficient_balls;
    for (const double c : r.a) coefficient_balls.push_back(Ball<double>::exact(c));
    if (coefficient_balls.size == 0) return;
    // An excess below 2^-40 is taken for rounding of the coefficients; the sine is 0 there.
    const auto excess = [&](const Ball<double>& t) {
      const Ball<double> a = polynomial_range(coefficient_balls, t).v;
      return a * a - Ball<double>::exact(1 + 0x1p-40);
    };
    double t = 0;
    const auto fine = [&](const Ball<double>& x) { return excess(x).sign() < 0; };
    const auto wrong = [&](const Ball<double>& x) { return excess(x).sign() > 0; };
    if (find_time(start_, end_, fine, wrong, t)) {
      throw InputError(place_,
                       "the cosine is beyond 1 in magnitude at t = " + number(t) + ": " +
                           number(Jet<double>::polynomial(r.a, Ball<double>::exact(t)).v.mid),
                       "a cosine must stay within [-1, 1] at all times of its piece");
    }
  }

  const MotionPiece& piece_;
  std::string place_;
  double start_, end_;
};

}  // namespace

void validate_motion(const Motion& motion, const std::string& body, const Bounds& polygon, double start, double end,
                     double extent) {
  const std::size_t n = motion.pieces.size();
  const auto place = [&](std::size_t i) {
    return body + ": motion" + (n > 1 ? " piece " + std::to_string(i) : std::string());
  };
  double from = start;
  for (std::size_t i = 0; i < n; ++i) {
    const MotionPiece& piece = motion.pieces[i];
    if (std::isnan(piece.until)) throw InputError(place(i), "`until` is not a number");
    if (i > 0 && piece.until <= motion.pieces[i - 1].until)
      throw InputError(place(i),
                       "`until` " + number(piece.until) + " does not come after that of the piece before, " +
                           number(motion.pieces[i - 1].until),
                       "pieces are in order of time");
    const bool last = i + 1 == n;
    if (last && piece.until < end)
      throw InputError(place(i),
                       "the motion ends at " + number(piece.until) + ", before the scene does, at " + number(end),
                       "leave out `until` in the last piece, or add a piece");
    if (piece.until <= start && !last) {
      PieceCheck(piece, place(i), from, from).run();
      continue;
    }
    if (from > end) break;
    const double to = std::min(piece.until, end);
    PieceCheck(piece, place(i), from, to).run();
    if (!last && piece.until < end) {
      const double gap = joint_gap(piece, motion.pieces[i + 1], polygon, piece.until);
      if (!(gap <= joint_tolerance * extent))
        throw InputError(
            place(i),
            "the motion jumps by " + number(gap) + " at t = " + number(piece.until) +
                ", where the next piece takes over",
            "pieces must join up to rounding (" + number(joint_tolerance * extent) +
                " here): coefficients are in powers of the absolute time t, not of the time since the joint");
    }
    from = to;
  }
}

}  // namespace taut
