// A stretch of a segment on which every point moves along a parabola, up to a certified error that is the same for all
// points.
#pragma once

#include <cmath>

#include "geometry/vector.hpp"
#include "spacetime/frame_window.hpp"

namespace taut::internal::spacetime {

/// A coordinate or a distance as a function of the time h from the stretch's middle: a + b h + c h^2.
struct Parabola {
  double a = 0, b = 0, c = 0;
  /// The least value for |h| <= r.
  double least(double r) const {
    return c > 0 && std::fabs(b) < 2 * c * r ? a - b * b / (4 * c) : a - std::fabs(b) * r + c * r * r;
  }
  /// For |h| <= r and up to rounding, bounds of the distance from the middle value, and of the magnitude.
  double swing(double r) const { return r * (std::fabs(b) + r * std::fabs(c)); }
  double reach(double r) const { return std::fabs(a) + swing(r); }
};
inline Parabola operator-(const Parabola& f) { return {-f.a, -f.b, -f.c}; }
inline Parabola operator+(const Parabola& f, const Parabola& g) { return {f.a + g.a, f.b + g.b, f.c + g.c}; }
inline Parabola operator-(const Parabola& f, const Parabola& g) { return {f.a - g.a, f.b - g.b, f.c - g.c}; }
inline Parabola operator*(double k, const Parabola& f) { return {k * f.a, k * f.b, k * f.c}; }

/// A moving point or direction. The functions of a coordinate are adjacent in memory, so that they can be computed in
/// parallel.
struct Path {
  Parabola x, y;
};
inline Path operator+(const Path& p, const Path& q) { return {p.x + q.x, p.y + q.y}; }
inline Path operator*(const Path& p, Vector v) { return {v.x * p.x - v.y * p.y, v.y * p.x + v.x * p.y}; }
inline Path conj(const Path& p) { return {p.x, -p.y}; }
inline Parabola along(Vector n, const Path& p) { return n.x * p.x + n.y * p.y; }

/// The motion of one body in the other's frame: its point v is at shift + rotation v.
struct RelativePose {
  Path shift, rotation;
  double swing = 0;  ///< bounds the distance of `rotation` from its middle value
  double error = 0;  ///< see Stretch
  double reach = 0;  ///< bounds the size of every intermediate vector

  /// The path of v relative to a point of the other body.
  Path place(Vector v, Vector from) const {
    Path p = shift + rotation * v;
    p.x.a -= from.x;
    p.y.a -= from.y;
    return p;
  }
};

/// A translation's relative motion, without the segment's shift, in doubles: one for each segment.
struct TranslationPolynomial {
  explicit TranslationPolynomial(const MotionSegment& segment);
  double about = 0;  ///< the polynomial is in powers of the time since then
  int size = 0;      ///< number of coefficients
  double x[max_degree + 1], y[max_degree + 1];
  double magnitude[max_degree + 1];  ///< of each pair of coefficients
};

/// The parameters t with |t - middle| <= r. The law holds for either relative pose, points v of the moving body and a
/// of the fixed one (both of length 5 at most), a direction n no longer than 1 + 2^-40, and t of the stretch:
///   |n . (shift(h) + rotation(h) v - a) - n . (v(t) - a)| <= error, on a bridge up to its scale,
/// where v(t) is the true position of v at t. The error also covers the rounding of at most 40 subsequent operations,
/// as long as their results are no larger than reach.
struct Stretch {
  double middle = 0, r = 0;
  double rest = 0;          ///< the part of the errors that shrinks with the stretch
  RelativePose in_p, in_q;  ///< Q's points in P's frame, and P's points in Q's frame

  static Stretch of_translation(const MotionSegment& segment, const TranslationPolynomial& polynomial, double start,
                                double end);
  /// A part of a smooth window.
  static Stretch of_window(const MotionSegment& segment, FrameWindow& window, double start, double end);
  /// An instant of a segment that is not a bridge, at high precision. There the errors are those of rounding to
  /// doubles, even where the motion is singular.
  static Stretch at_instant(const MotionSegment& segment, double t);
  /// The whole of a window that is not smooth: everything rests, up to the error.
  static Stretch of_range(const MotionSegment& segment, const FrameWindow& window);
};

}  // namespace taut::internal::spacetime
