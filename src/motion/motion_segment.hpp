// The relative motion of the two bodies over one interval on which both follow a single piece, or over the bridge
// between two pieces. All other code uses only this: ten functions of one parameter.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "motion/local_time.hpp"
#include "motion/pose.hpp"
#include "motion/symbolic.hpp"
#include "numeric/series.hpp"

namespace taut::internal {

/// The orientation of two vertices of one body and one of the other is a fixed linear combination of five functions
/// of time. With world frames (o, x) as complex numbers and D = o_Q - o_P:
///   two vertices of P:  |x_P|^2, conj(x_P) D (two parts), and conj(x_P) x_Q = c + i s;
///   two vertices of Q:  |x_Q|^2, conj(x_Q) D (two parts), and the same c and s.
/// On a bridge the frames are similarities, so |x| may differ from 1 by rounding; elsewhere it is exactly 1.
template <class J>
struct FrameOf {
  std::array<J, 5> for_pp, for_qq;
};
template <class Real>
using Frame = FrameOf<Jet<Real>>;
/// The functions without their derivatives.
template <class Real>
using FrameValues = FrameOf<Ball<Real>>;

/// The number of terms with which a model of a segment that rotates by an eighth of a radian is exact to a few ulps.
inline constexpr int model_degree = 9;
template <class Real>
using ModelSeries = Series<Real, model_degree>;
/// In s, a function that vanishes to order m in time vanishes to order 2 m. More terms are required to detect that.
inline constexpr int last_from_end = 16;
template <class Real>
using SeriesFromEnd = Series<Real, last_from_end>;

/// A constant vector, given exactly as two doubles per coordinate, or three if there are pivots.
struct ExactVector {
  double x = 0, x_low = 0, y = 0, y_low = 0;
  double x_rest = 0, y_rest = 0;

  ExactVector operator-() const { return {-x, -x_low, -y, -y_low, -x_rest, -y_rest}; }
};

class FrameIdentities;
class FrameEvaluator;
class UniformRotation;

/// One segment of the relative motion.
struct MotionSegment {
  /// The pieces the bodies follow; on a bridge, those before the joint.
  MotionPiece p, q;
  /// On a bridge, the pieces after the joint.
  MotionPiece p_next, q_next;
  /// If a body has parents or an orbit, the frame does not consist of polynomials and a rotation. It is composed of the
  /// poses of these chains, whose last pieces are the ones above, and there are no offsets.
  bool composed = false;
  PieceChain p_chain, q_chain, p_chain_next, q_chain_next;
  bool bridge = false;
  double joint = 0;           ///< the time of the bridge
  double start = 0, end = 0;  ///< of the parameter: time, or [0, 1] on a bridge
  double origin = 0;          ///< of both pieces' polynomials, on a segment that is not far

  bool translation = false;  ///< neither body rotates
  int degree = 0;            ///< of D on a translation, or a bound of it
  bool aligned = false;      ///< both rotate alike: c = 1, s = 0
  /// True if both angles are given. On a segment that is not far, their difference is turn + turn_low, exactly.
  bool angles = false;
  Coefficients turn, turn_low;
  bool pivots = false;  ///< a body rotates about a point that is not its origin
  /// A body that does not rotate absorbs the constant part of D into its coordinates: p - shift, or q + shift. Sliding
  /// and pivoting contacts then have coefficients that are exactly zero.
  bool shift_p = false, shift_q = false;
  ExactVector shift;
  /// Added to the coordinates of P and of Q: the shift or, for a body that rotates, minus its pivot, so that the frame
  /// is about the pivot.
  ExactVector offset_p, offset_q;

  static MotionSegment motion(MotionPiece of_p, MotionPiece of_q, double start, double end);
  static MotionSegment motion_of_chains(const PieceChain& p, const PieceChain& q, double start, double end);
  static MotionSegment bridging(const MotionPiece& p, const MotionPiece& q, const MotionPiece& p_next,
                                const MotionPiece& q_next, double joint, bool far = false);
  static MotionSegment bridging_chains(const PieceChain& p, const PieceChain& q, const PieceChain& p_next,
                                       const PieceChain& q_next, double joint, bool far = false);
  /// The pose of a body at a parameter of the segment, rounded. On a bridge it is the pose after it, which differs by
  /// rounding only.
  Pose<double> pose_of_body(bool of_p, double parameter) const;

  /// Does a body rotate with infinite speed at that end of the segment? TimeFromEnd makes the motion smooth.
  bool singular_at(double t) const;
  /// The singular cosine of a body's piece, or of a link of its chain.
  const SingularCosine* singular_cosine(bool of_p, std::size_t link, double t) const;
  const ExactVector& offset(bool of_p) const { return of_p ? offset_p : offset_q; }
  /// Are polynomials expanded about an instant of the segment? They are where it is far from a piece's origin, or where
  /// the two bodies' pieces have different origins.
  bool far() const { return local_ != nullptr; }
  /// These polynomials; null on other segments.
  const LocalPolynomials* local() const { return local_.get(); }
  template <class Real>
  LocalTime<Real> local_time(const Ball<Real>& t) const {
    return local_ ? LocalTime<Real>(*local_, t) : LocalTime<Real>(t);
  }
  /// D is a polynomial in the time since this instant: that of the expansion, or the origin that both pieces share.
  double about() const { return local_ ? local_->about() : origin; }
  /// The difference of the angles, less whole turns. Requires a far segment with `angles`.
  const LocalPolynomials::Known& far_turn() const { return *far_turn_; }
  /// The coordinates of D minus the shift. Requires a far segment with a shift.
  const LocalPolynomials::Known& way(bool of_x) const { return (*ways_)[of_x ? 0 : 1]; }
  /// A coefficient of D minus the shift in powers of the time since about(), in numbers that represent doubles exactly.
  /// Requires a segment with a shift.
  template <class N>
  N way_coefficient(bool of_x, std::size_t k) const {
    if (far()) return way(of_x).template coefficient<N>(k);
    if (k == 0) return N::exact(0);
    return N::exact(coefficient(of_x ? q.x : q.y, k)) - N::exact(coefficient(of_x ? p.x : p.y, k));
  }
  /// A bound of the offsets' contribution to a coordinate's magnitude.
  double offset_size() const {
    return (std::fabs(offset_p.x) + std::fabs(offset_q.x)) + (std::fabs(offset_p.y) + std::fabs(offset_q.y));
  }
  /// The world time at this parameter.
  double time(double parameter) const { return bridge ? joint : parameter; }
  /// Constructed on first use, by one thread at a time.
  const FrameIdentities& identities() const;
  const FrameEvaluator& looks() const;
  /// The data shared by models of segments with uniform rotations; null on others.
  const std::shared_ptr<const UniformRotation>& uniform_rotation() const;
  /// Drops the data constructed on first use. Of many segments, only the current one is used heavily.
  void forget() const {
    identities_.reset();
    looks_.reset();
    uniform_rotation_.reset();
    if (local_) local_->forget();
  }

 private:
  void take_difference();
  void take_far_difference();
  void find_singular_ends(bool of_p, std::size_t link, const MotionPiece& piece);

  /// Shared by copies. Dropped data is reconstructed identically.
  std::shared_ptr<const LocalPolynomials> local_;
  std::shared_ptr<const std::array<LocalPolynomials::Known, 2>> ways_;
  std::shared_ptr<const LocalPolynomials::Known> far_turn_;
  /// A cosine that is singular at an end of the segment; few segments have one.
  struct SingularLink {
    bool of_p;
    std::size_t link;  ///< of the body's chain; 0 if there is none
    std::shared_ptr<const SingularCosine> cosine;
  };
  std::vector<SingularLink> singular_;
  mutable std::shared_ptr<const FrameIdentities> identities_;
  mutable std::shared_ptr<const FrameEvaluator> looks_;
  mutable std::optional<std::shared_ptr<const UniformRotation>> uniform_rotation_;
};

/// The frame over the ball t of the segment's parameter. This and the following functions exist for doubles and at
/// every precision.
template <class Real>
Frame<Real> frame(const MotionSegment& segment, const Ball<Real>& t);
/// The frame as functions of s, at an end at which the segment is singular.
template <class Real>
Frame<Real> frame(const MotionSegment& segment, const TimeFromEnd<Real>& t);
/// The frame without derivatives.
template <class Real>
FrameValues<Real> frame_values(const MotionSegment& segment, const Ball<Real>& t);
/// The Taylor series of the frame about the ball t,
template <class Real>
FrameOf<ModelSeries<Real>> frame_series(const MotionSegment& segment, const Ball<Real>& t);
/// and in s about a place near a singular end.
template <class Real>
FrameOf<SeriesFromEnd<Real>> frame_series(const MotionSegment& segment, const TimeFromEnd<Real>& t);

/// The frame for the bodies' own coordinates, without the offsets: comparable between segments.
Frame<double> unshifted_frame(const MotionSegment& segment, const Ball<double>& t);
/// The first terms of the series of the frame.
using ThirdSeries = Series<double, 3>;
FrameOf<ThirdSeries> frame_to_third_order(const MotionSegment& segment, const Ball<double>& t);
/// The two coordinates of D, as used in the frame of a motion segment that is not composed.
template <class Real>
std::array<ModelSeries<Real>, 2> way_series(const MotionSegment& segment, const Ball<Real>& t);
/// The frame as exact expressions (not of a bridge).
FrameOf<Symbolic> symbolic_frame(const MotionSegment& segment, SymbolicSegment& symbols);

/// Converts a vertex of P or Q to the coordinates of the segment, in numbers that represent doubles exactly.
template <class B>
void add_offset(const MotionSegment& segment, bool of_p, B& x, B& y) {
  const ExactVector& s = segment.offset(of_p);
  if (of_p ? segment.shift_p : segment.shift_q) {
    x = x + B::exact(s.x) + B::exact(s.x_low);
    y = y + B::exact(s.y) + B::exact(s.y_low);
  }
  if (!segment.pivots) return;
  if (of_p ? segment.shift_p : segment.shift_q) {
    x = x + B::exact(s.x_rest);
    y = y + B::exact(s.y_rest);
  } else {
    x = x + B::exact(s.x);
    y = y + B::exact(s.y);
  }
}

}  // namespace taut::internal
