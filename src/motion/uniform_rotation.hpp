// Models of the frame in closed form, on segments on which bodies rotate uniformly.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "motion/frame_model.hpp"
#include "motion/frame_sample.hpp"
#include "numeric/fixed.hpp"
#include "numeric/thread_local_pool.hpp"

namespace taut::internal {

/// D about an instant: coefficients of its coordinates.
template <class N>
struct RelativeDisplacement {
  int terms = 1;
  std::array<N, model_degree + 1> x{}, y{};
};

/// With frames as complex numbers, the functions are e^(i a(t)), or that times D(t), where the angle a is linear in t.
/// About an instant m, e^(i a(m + h)) is e^(i a(m)) times the series of e^(i r h), where r is the rate. This series is
/// the same at all instants, up to a rotation by a(m), and so is the remainder of a polynomial in h. A model then takes
/// one sine and one cosine for each angle, while bounds are those of the last model of that length; nothing is
/// composed. The angle is reduced as an exact sum, so that it is as accurate after 10^5 rotations as in the first one,
/// which is not true of an angle in a double. The same holds in numbers of any length (Expansion).
class UniformRotation {
 public:
  /// Leaves the cached data uninitialized: most of it is never used.
  UniformRotation() {}
  /// Null if the segment is not of this kind.
  static std::shared_ptr<const UniformRotation> of(const MotionSegment& segment);
  /// The model of the part [start, end] of that segment. Nothing if an angle is too large.
  std::optional<FrameModel> model(const MotionSegment& segment, double start, double end) const;
  /// Gives memory back, for others in this thread to use. What was kept there is computed again when it is needed.
  void release() const { kept_.reset(); }
  /// Are bounds of the third derivatives the same over every part?
  bool is_steady() const { return constant_way_.has_value(); }
  /// Bounds of the third derivatives over a part.
  FrameThird third(const MotionSegment& segment, bool pp, double start, double end) const;

  /// The functions of FrameModel about an instant m, in fixed-point numbers: polynomials in (t - m) / 2^exponent, for
  /// times within that distance of m.
  struct Expansion {
    std::array<std::array<FixedBall, model_degree>, FrameModel::functions> c;
    std::array<double, FrameModel::functions> rest;       ///< bounds of the next coefficient
    std::array<Jet<double>, FrameModel::functions> over;  ///< values and slopes; second derivatives are not set
  };
  Expansion expansion(const MotionSegment& segment, double m, int exponent) const;
  /// A bound of the remainder of its polynomials.
  double rest_within(const MotionSegment& segment, double m, int exponent) const;

 private:
  /// The angle sign (c0 + c1 t), each coefficient a sum of two doubles.
  struct Angle {
    double sign = 1, c0 = 0, c0_low = 0, c1 = 0, c1_low = 0, origin = 0;
    /// Computes cosine and sine of the angle at m, the parts of e^(i a(m)). False if the angle is too large.
    bool at(double m, double& re, double& im) const;
    void at(double m, FixedBall& re, FixedBall& im) const;
  };
  static constexpr int last = model_degree;  ///< the power that models omit
  template <class N>
  using Powers = std::array<N, last + 1>;
  /// A rotation, and (i r)^k / k! without powers of i. A body that does not rotate has no angle.
  struct Spin {
    std::optional<Angle> angle;
    Powers<double> u{1};
    void set(const Angle& a);
    Powers<FixedBall> precise_powers(int exponent) const;
  };
  struct Way : RelativeDisplacement<double> {
    Powers<double> size{}, error{};  ///< bounds of |(x, y)|, and of its error
  };
  /// The data shared by all expansions with one exponent.
  struct Precise {
    int exponent;
    std::array<Powers<FixedBall>, FrameModel::functions / 2> u;
    std::optional<RelativeDisplacement<FixedBall>> constant_way;
  };
  /// The data shared by all models with one radius and relative displacements of these sizes: all but the coefficients.
  struct Bounds {
    double radius = -1;
    Way way;
    FrameModel model;
  };

  bool take(const MotionSegment& segment);
  static Angle difference_of_angles(const MotionSegment& segment);
  Way way_about(const MotionSegment& segment, double m) const;
  const Bounds& bounds_for(double radius, Way way) const;
  void bound(const Spin& spin, const Way& way, int i, FrameModel& model) const;
  static bool turn(const Spin& spin, const Way& way, double m, int i, FrameModel& out);
  const Spin& spin(int pair) const {
    return pair == 0 || (pair == 1 && aligned_) ? to_p_ : pair == 1 ? to_q_ : relative_;
  }
  static const Way& one_way();
  static Powers<double> sizes_within(const Way& way, double radius);
  static double size_of(const Spin& spin, const Powers<double>& sizes, int terms, int k);
  const Precise& precise(const MotionSegment& segment, int exponent) const;
  static RelativeDisplacement<FixedBall> precise_way(const MotionSegment& segment, double m, int exponent);
  template <class N, class Take>
  static void turned(const Powers<N>& u, const RelativeDisplacement<N>& way, const N& re, const N& im,
                     const Take& take);

  static constexpr int pairs = FrameModel::functions / 2;
  Spin to_p_, to_q_, relative_;  ///< for conj(x_P) and conj(x_Q), and for conj(x_P) x_Q
  bool aligned_ = false;
  std::optional<Way> constant_way_;
  /// The ones used last.
  struct Kept {
    std::array<Bounds, 3> bounds;
    std::size_t next = 0;
  };
  mutable ThreadLocalPool<Kept>::Pointer kept_;  ///< null until they are needed
  mutable std::unique_ptr<Precise> precise_;     ///< made on first use: few segments need more than doubles
};

}  // namespace taut::internal
