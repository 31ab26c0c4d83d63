// One body over one stretch of time on which its motion is analytic, ends included.
//
// With the pivot c, the body's point v is at origin + x (v - c) as complex numbers, and
//   x = (plain + rooted g) exp(i angle) / below,  g^2 = radicand,
// where all names are polynomials of a parameter u; the time is a polynomial of u, too. Where a cosine reaches 1 with
// infinite speed at an end e of its stretch, time is e + u^2 or e - u^2, and x is analytic in u.
#pragma once

#include <memory>
#include <optional>

#include "support/exact_formal.hpp"
#include "support/exact_series.hpp"
#include "taut/motion.hpp"

namespace taut::testing::exact {

/// A polynomial that is ready to be evaluated.
struct Curve {
  Poly exact;
  std::vector<Narrow> narrow;

  Curve() = default;
  Curve(Poly p) : exact(std::move(p)) {
    for (const Rational& c : exact) narrow.push_back(Narrow::of(c));
  }
  template <class I, int N>
  Series<I, N> series(const I& u) const;
};

/// What places the body: numerators and denominators as functions of u.
template <class I, int N>
struct Pose {
  Series<I, N> ox, oy;  ///< the origin
  Series<I, N> x, y;    ///< x times `below`
  Series<I, N> below;
  Series<I, N> square;  ///< |x|^2 below: not `below` only on a bridge
};

class BodyMotion {
 public:
  /// While time runs over [from, to], both rational, as `time` of u says. Nothing if the cosine exceeds 1 in between.
  static std::optional<BodyMotion> of(const MotionPiece& piece, const Poly& time, const Rational& from,
                                      const Rational& to);
  /// The straight way from one pose to the other as u runs over [0, 1]; the time is `joint`.
  static BodyMotion bridge(const MotionPiece& before, const MotionPiece& after, double joint);

  template <class I, int N>
  Pose<I, N> pose(const I& u) const;
  /// x times `below`; `which` names the root. Not for a bridge between irrational poses.
  Formal formal(int which) const;
  bool has_formal() const { return !ends_; }

  const Point& pivot_point() const { return pivot_point_; }
  const Complex& origin() const { return origin_; }
  const Poly& radicand() const { return radicand_.exact; }
  const Poly& below() const { return below_.exact; }
  const Poly& square() const { return square_.exact; }
  /// The pose at an instant in rational numbers, about the body's own origin, if it is rational.
  bool rational_pose(const Rational& u, Complex& origin, Complex& x) const;

 private:
  /// Two ends of a bridge, each at an instant of its own motion.
  struct Ends;

  void set_origin(const MotionPiece& piece, const Poly& time);
  bool set_rotation(const MotionPiece& piece, const Poly& time, const Rational& from, const Rational& to);
  bool set_cosine(const Poly& a, const Poly& time, const Rational& from, const Rational& to);
  void set_direction(const Poly& a, const Poly& b, const Rational& inside);
  void prepare();

  Point pivot_point_;
  Complex pivot_, origin_, plain_, rooted_;
  Curve ox_, oy_, plain_x_, plain_y_, rooted_x_, rooted_y_, radicand_, angle_, below_, square_;
  std::shared_ptr<const Ends> ends_;
};

/// Where, strictly within (from, to), must the stretch be cut so that the cosine's root is analytic? Nothing if the
/// cosine exceeds 1, or reaches it at an instant that is no double.
std::optional<std::vector<Rational>> cuts(const MotionPiece& piece, const Rational& from, const Rational& to);
/// Does the cosine reach 1 or -1 at that end with infinite speed?
bool infinite_speed(const MotionPiece& piece, const Rational& end);

}  // namespace taut::testing::exact
