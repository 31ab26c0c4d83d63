// A form near an instant at which much happens at once: see frame_expansion.hpp.
#pragma once

#include <array>
#include <optional>

#include "sign/certificate_function.hpp"
#include "sign/frame_expansion.hpp"
#include "sign/precise_time.hpp"

namespace taut::internal {

/// The form as a polynomial in the time since the frame's instant, in units of its reach, the displacement included.
/// Everything is enclosed; what these numbers are too short for is left to other stages.
class FixedPointExpansion {
 public:
  FixedPointExpansion() = default;
  FixedPointExpansion(const FrameExpansion& frame, const MotionSegment& segment, const PairGeometry& g,
                      const CertificateFunction& function);

  /// At all instants of the enclosure, whose ends are sums of doubles; 0 if it may change there, or is not known.
  int sign_over(const PreciseTime& t) const;
  /// The root within the frame's reach, if the form has the sign `sign` before it, and is monotone all over there or
  /// turns once and has a root on either side; no better enclosed than `enough`. Nothing if that is not known.
  std::optional<PreciseTime> root(int sign, Stage stage, double enough) const;

  /// Where the function turns: as symmetric mechanisms touch zero without the displacement.
  struct Turn {
    Fixed at;            ///< about there, since the frame's instant, in units of its reach
    int value_sign;      ///< of its extreme value
    int second_sign;     ///< of its second derivative, all over the reach
    double half_gap;     ///< about how far from it the roots are, if the two signs differ, in these units
    double second_most;  ///< a bound of the second derivative's magnitude within reach
  };
  /// The only one within reach, if there is no other for certain, and its value's sign is known.
  std::optional<Turn> turn() const;
  /// The root before it (-1) or after it (1), if the two signs differ.
  std::optional<PreciseTime> root_beside(const Turn& turn, int side, Stage stage) const;

 private:
  /// A double and a bound of its error.
  struct Steepness {
    double least, most;   ///< of the slope's magnitude within reach
    double signed_about;  ///< the slope at the frame's instant
  };

  /// The times no farther from `middle` than `half`, and the slope there.
  struct Bracket {
    Fixed middle;
    double half;
    Steepness steep;
  };

  void set_steepness();
  FixedBall value(const FixedBall& h) const;
  FixedBall slope(const FixedBall& h) const;
  Fixed slope_near(const Fixed& h) const;
  Bracket bracket_beside(const Turn& turn, int side) const;
  template <class SlopeAt>
  std::optional<PreciseTime> root_within(const Bracket& bracket, FixedBall v, const SlopeAt& slope_at, Stage stage,
                                         double enough) const;
  std::optional<PreciseTime> around(const Fixed& h, double error, Stage stage) const;

  double about_ = 0;
  int exponent_ = 0;  ///< of the unit
  std::array<FixedBall, FrameExpansion::terms> c_;
  std::size_t terms_ = 0;  ///< those from there on are zero
  double rest_ = 0;        ///< a bound of the next coefficient
  Steepness steep_{};
};

}  // namespace taut::internal
