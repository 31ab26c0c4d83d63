// The relative motion of the two bodies over one interval on which both follow a single piece, or over the bridge
// between two pieces. Everything downstream sees only this: ten functions of one parameter.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "motion/local_time.hpp"
#include "motion/pose.hpp"
#include "numeric/series.hpp"
#include "relative/symbolic.hpp"

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

/// Enough terms that a model of a segment that turns by an eighth of a radian is exact to a few ulps.
inline constexpr int model_degree = 9;
template <class Real>
using ModelSeries = Series<Real, model_degree>;
/// In s a function that vanishes to order m in time does to order 2 m: it takes more terms to see that.
inline constexpr int last_from_end = 16;
template <class Real>
using SeriesFromEnd = Series<Real, last_from_end>;

/// A constant vector known exactly as two doubles per coordinate; three where there are pivots.
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
  /// Where a body has parents or an orbit, the frame is not one of polynomials and a turn: it is composed of the poses
  /// of these chains, whose last pieces are the ones above, and there are no offsets.
  bool composed = false;
  PieceChain p_chain, q_chain, p_chain_next, q_chain_next;
  bool bridge = false;
  double joint = 0;           ///< the time of the bridge
  double joint_before = 0;    ///< and that for which the pieces before it say where it begins: the same, as a rule
  double start = 0, end = 0;  ///< of the parameter: time, or [0, 1] on a bridge

  bool translation = false;  ///< neither body turns
  int degree = 0;            ///< of D on a translation
  bool aligned = false;      ///< both turn alike: c = 1, s = 0
  /// Both angles are given: the difference of the two is turn + turn_low, exactly.
  bool angles = false;
  Coefficients turn, turn_low;
  bool pivots = false;  ///< a body turns about a point that is not its origin
  /// A body that does not turn absorbs the constant part of D into its coordinates: p - shift, or q + shift. Sliding
  /// and pivoting contacts then have coefficients that are exactly zero.
  bool shift_p = false, shift_q = false;
  ExactVector shift;
  /// Added to the coordinates of P and of Q: the shift, or of a body that turns minus its pivot, so that the frame is
  /// about the pivot.
  ExactVector offset_p, offset_q;
  /// Far from time 0 polynomials are taken about an instant of the segment, and the shift is D there, as nearly as two
  /// doubles are: a little is left. Then these are the offsets for which D in powers of the absolute time has no
  /// constant, as `offset_p` and `offset_q` are on other segments.
  ExactVector far_offset_p, far_offset_q;

  static MotionSegment motion(const MotionPiece& p, const MotionPiece& q, double start, double end);
  static MotionSegment motion_of_chains(const PieceChain& p, const PieceChain& q, double start, double end);
  static MotionSegment bridging(const MotionPiece& p, const MotionPiece& q, const MotionPiece& p_next,
                                const MotionPiece& q_next, double joint, bool far = false);
  static MotionSegment bridging_chains(const PieceChain& p, const PieceChain& q, const PieceChain& p_next,
                                       const PieceChain& q_next, double joint, bool far = false);
  /// From where pieces are at one time to where others are at another one, which is the bridge's.
  static MotionSegment bridging_between(const MotionPiece& p, const MotionPiece& q, double before,
                                        const MotionPiece& p_next, const MotionPiece& q_next, double joint, bool far);
  /// Where a body is at a parameter of the segment, rounded; on a bridge after it, which differs by rounding only.
  Pose<double> pose_of_body(bool of_p, double parameter) const;

  /// Does a body turn with infinite speed at that end of the segment? TimeFromEnd makes it smooth.
  bool singular_at(double t) const;
  /// Of a body's piece, or of a link of its chain.
  const SingularCosine* singular_cosine(bool of_p, std::size_t link, double t) const;
  const ExactVector& offset(bool of_p) const { return of_p ? offset_p : offset_q; }
  const ExactVector& offset_of_powers(bool of_p) const {
    return far() ? (of_p ? far_offset_p : far_offset_q) : offset(of_p);
  }
  bool far() const { return local_ != nullptr; }
  /// What polynomials are about an instant of a segment that is far from time 0; null on others.
  const LocalPolynomials* local() const { return local_.get(); }
  template <class Real>
  LocalTime<Real> local_time(const Ball<Real>& t) const {
    return local_ ? LocalTime<Real>(*local_, t) : LocalTime<Real>(t);
  }
  /// On such a segment with a shift, the coordinates of D less the shift.
  const LocalPolynomials::Known& way(bool of_x) const { return (*ways_)[of_x ? 0 : 1]; }
  /// In powers of the absolute time, D's constant less the shift: doubles to be added up.
  std::array<double, 7> constant_left(bool of_x) const;
  /// A bound of what the offsets add to a coordinate's magnitude.
  double offset_size() const {
    return (std::fabs(offset_p.x) + std::fabs(offset_q.x)) + (std::fabs(offset_p.y) + std::fabs(offset_q.y));
  }
  /// The time of the world at this parameter.
  double time(double parameter) const { return bridge ? joint : parameter; }
  /// Made when first asked for, by one thread at a time.
  const FrameIdentities& identities() const;
  const FrameEvaluator& looks() const;
  /// What models of segments that turn evenly, and often, share; null on others.
  const std::shared_ptr<const UniformRotation>& uniform_rotation() const;
  /// Drops what was made when it was first asked for. Of many segments only the present one is asked much.
  void forget() const {
    identities_.reset();
    looks_.reset();
    uniform_rotation_.reset();
    if (local_) local_->forget();
  }

 private:
  void take_far_offsets();
  void find_singular_ends(bool of_p, std::size_t link, const MotionPiece& piece);

  /// Shared by copies: what is dropped is made again, the same.
  std::shared_ptr<const LocalPolynomials> local_;
  std::shared_ptr<const std::array<LocalPolynomials::Known, 2>> ways_;
  /// A cosine about an end of the segment; few segments have one.
  struct SingularLink {
    bool of_p;
    std::size_t link;  ///< of the body's chain; 0 where there is none
    std::shared_ptr<const SingularCosine> cosine;
  };
  std::vector<SingularLink> singular_;
  mutable std::shared_ptr<const FrameIdentities> identities_;
  mutable std::shared_ptr<const FrameEvaluator> looks_;
  mutable std::optional<std::shared_ptr<const UniformRotation>> uniform_rotation_;
};

/// The frame over the ball t of the segment's parameter. Like those below, for doubles and at every precision.
template <class Real>
Frame<Real> frame(const MotionSegment& segment, const Ball<Real>& t);
/// The same as functions of s, at an end at which the segment is singular.
template <class Real>
Frame<Real> frame(const MotionSegment& segment, const TimeFromEnd<Real>& t);
/// Without derivatives.
template <class Real>
FrameValues<Real> frame_values(const MotionSegment& segment, const Ball<Real>& t);
/// Its Taylor series about the ball t,
template <class Real>
FrameOf<ModelSeries<Real>> frame_series(const MotionSegment& segment, const Ball<Real>& t);
/// and in s about a place near a singular end.
template <class Real>
FrameOf<SeriesFromEnd<Real>> frame_series(const MotionSegment& segment, const TimeFromEnd<Real>& t);

/// For the bodies' own coordinates, without the offsets: comparable between segments.
Frame<double> unshifted_frame(const MotionSegment& segment, const Ball<double>& t);
/// The first terms of the series.
using ThirdSeries = Series<double, 3>;
FrameOf<ThirdSeries> frame_to_third_order(const MotionSegment& segment, const Ball<double>& t);
/// Of a motion segment that is not composed: the two coordinates of D, as its frame has them.
template <class Real>
std::array<ModelSeries<Real>, 2> way_series(const MotionSegment& segment, const Ball<Real>& t);
/// As exact expressions (not of a bridge).
FrameOf<Symbolic> symbolic_frame(const MotionSegment& segment, SymbolicSegment& symbols);

/// Turns a vertex of P or Q into what the segment sees of it, in numbers that can be given exactly.
template <class B>
void add_offset(const MotionSegment& segment, bool of_p, const ExactVector& s, B& x, B& y) {
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
template <class B>
void add_offset(const MotionSegment& segment, bool of_p, B& x, B& y) {
  add_offset(segment, of_p, segment.offset(of_p), x, y);
}

}  // namespace taut::internal
