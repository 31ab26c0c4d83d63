// A leg's frame functions in doubles with error bounds: the first stage of every certificate evaluation.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "motion/frame_model.hpp"
#include "motion/mixed_function.hpp"

namespace taut {

/// The five functions of Leg::Frame for one kind of triple, at one instant.
struct FastSide {
  double f[5], d[5];
  double size_a, size_b, size_0;        ///< bounds of |f1|+|f2|, |f3|+|f4|, |f0|
  double size_ad, size_bd, size_0d;     ///< of the derivatives
  double error_a, error_b, error_0;     ///< bounds of the errors of f
  double error_ad, error_bd, error_0d;  ///< and of d
};

/// Second derivatives over a segment: middle and radius of each.
struct FastCurvature {
  double mid[5], rad[5];
};

/// A value with a bound of its error.
struct Bounded {
  double value, error;
};

/// A mixed triple's function as coefficients of the frame functions, in doubles.
/// Level 0 is the function of the input's points. Where that vanishes identically, level 1 is the part that is linear
/// in the displacement, scaled by 2^200.
struct FastFunction {
  double a[5];
  double m0, m34, w;  ///< magnitudes that bound rounding: of a[0]; of a[3], a[4]; of a[1], a[2]
  bool pp = false;
  bool level1 = false;

  static FastFunction level_zero(const Leg& leg, const PairGeometry& g, const MixedTriple& triple,
                                 Measure measure = Measure::orientation);
  /// The next level if level 0 is exactly zero at all times of a translation leg; false otherwise.
  static bool level_one(const Leg& leg, const PairGeometry& g, const MixedTriple& triple, FastFunction& result);

  Bounded value(const FastSide& s) const {
    const double v = a[0] * s.f[0] + a[1] * s.f[1] + a[2] * s.f[2] + a[3] * s.f[3] + a[4] * s.f[4];
    const double e =
        0x1p-49 * (m0 * s.size_0 + w * s.size_a + m34 * s.size_b) + m0 * s.error_0 + w * s.error_a + m34 * s.error_b;
    return {v, e * (1 + 0x1p-40) + floor_error};
  }
  Bounded slope(const FastSide& s) const {
    const double v = a[0] * s.d[0] + a[1] * s.d[1] + a[2] * s.d[2] + a[3] * s.d[3] + a[4] * s.d[4];
    const double e = 0x1p-49 * (m0 * s.size_0d + w * s.size_ad + m34 * s.size_bd) + m0 * s.error_0d + w * s.error_ad +
                     m34 * s.error_bd;
    return {v, e * (1 + 0x1p-40) + floor_error};
  }
  Bounded curvature(const FastCurvature& c) const {
    double v = 0, e = 0;
    for (int i = 0; i < 5; ++i) {
      const double m = i == 0 ? m0 : (i < 3 ? w : m34);
      v += a[i] * c.mid[i];
      e += m * (c.rad[i] + 0x1p-49 * (c.mid[i] < 0 ? -c.mid[i] : c.mid[i]));
    }
    return {v, e * (1 + 0x1p-40) + floor_error};
  }
  /// Covers the displacement at level 0, its square at level 1, and underflow.
  double floor_error = 0;
};

/// A dyadic part of a leg's interval, with a model of the frame over it.
struct ClockCell {
  int level;            ///< the leg is cut into 2^level parts,
  std::uint64_t index;  ///< and this is one of them
  double start, end;
  bool leaf;   ///< fine enough: values come from this cell
  bool sharp;  ///< the model's values are good; if not, the frame itself is evaluated
  FrameModel model;
  FastCurvature pp, qq;

  /// Bounds of the second derivatives over the cell.
  const FastCurvature& curvature(bool of_pp) const { return of_pp ? pp : qq; }
};

/// Evaluates a leg's frame from Taylor models over a dyadic subdivision of its interval, which is as fine as the motion
/// asks for: cells shrink towards an instant at which the motion is singular. Cells are made when first used, and the
/// last ones are kept, so that memory does not depend on
/// the leg.
class LegClock {
 public:
  /// Prepares a leg; the reference must stay valid.
  void reset(const Leg& leg);
  const Leg& leg() const { return *leg_; }
  /// Functions at parameter t (remembers the last instant).
  const FastSide& at(double t, bool pp) {
    if (t != cached_t_ || !cached_) evaluate(t);
    return pp ? pp_ : qq_;
  }
  /// The cell for parameter t. Like every reference to a cell, valid until the clock is next asked for anything else.
  const ClockCell& cell(double t);
  /// The next larger cell around this one; none around the whole leg.
  const ClockCell* wider(const ClockCell& cell);

 private:
  /// Cells down to the eighth level never get into each other's way.
  static constexpr std::size_t slots = 512;

  const ClockCell& at_level(int level, std::uint64_t index);
  const ClockCell& find_leaf(double t);
  double boundary(int level, std::uint64_t index) const;
  std::uint64_t index_of(int level, double t) const;
  void make(ClockCell& cell);
  void evaluate(double t);
  void evaluate_exactly(double t);

  const Leg* leg_ = nullptr;
  bool cached_ = false;
  double cached_t_ = 0;
  int level_ = 0;  ///< of the leaf last used, with its place
  std::uint64_t index_ = 0;
  double last_start_ = 0, last_end_ = 0;
  FastSide pp_{}, qq_{};
  /// Cell (level, index) is number 2^level + index, and lies in the slot of its number modulo `slots` if that is what
  /// keys_ says. The cells' memory is not touched before it is used.
  std::array<std::uint64_t, slots> keys_{};
  std::unique_ptr<ClockCell[]> cells_{new ClockCell[slots]};
};

}  // namespace taut
