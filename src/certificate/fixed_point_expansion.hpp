// A certificate function near an instant of many simultaneous events: see frame_expansion.hpp.
#pragma once

#include <array>
#include <optional>

#include "certificate/certificate_function.hpp"
#include "certificate/frame_expansion.hpp"
#include "certificate/precise_time.hpp"

namespace taut::internal {

/// The function as a polynomial in the time since the frame's instant, in units of its reach, including the
/// displacement. All values are enclosed. Cases beyond the precision of these numbers are left to other stages.
class FixedPointExpansion {
 public:
  FixedPointExpansion() = default;
  FixedPointExpansion(const FrameExpansion& frame, const MotionSegment& segment, const PairGeometry& g,
                      const CertificateFunction& function);

  /// The sign at all instants of the enclosure, whose ends are sums of doubles; 0 if it may change there, or is not
  /// known.
  int sign_over(const PreciseTime& t) const;
  /// The root within the frame's reach. Requires that the function has the sign `sign` before it, and either is
  /// monotone over the whole reach or has one extremum with a root on either side. The enclosure need not be tighter
  /// than `enough`. Nothing if this is not known.
  std::optional<PreciseTime> root(int sign, Stage stage, double enough) const;

  /// An extremum of the function; without the displacement, symmetric mechanisms touch zero there.
  struct Extremum {
    Fixed at;            ///< approximate position since the frame's instant, in units of its reach
    int value_sign;      ///< of its extreme value
    int second_sign;     ///< of its second derivative, over the whole reach
    double half_gap;     ///< approximate distance to the roots, if the two signs differ, in these units
    double second_most;  ///< a bound of the second derivative's magnitude within reach
  };
  /// The only extremum within reach, if it is certainly the only one and the sign of its value is known.
  std::optional<Extremum> extremum() const;
  /// The root before it (-1) or after it (1), if the two signs differ.
  std::optional<PreciseTime> root_near(const Extremum& extremum, int side, Stage stage) const;

 private:
  /// Bounds of the slope.
  struct Steepness {
    double least, most;   ///< of the slope's magnitude within reach
    double signed_about;  ///< the slope at the frame's instant
  };

  /// The times within `half` of `middle`, and the slope there.
  struct Bracket {
    Fixed middle;
    double half;
    Steepness steep;
  };

  void set_steepness();
  FixedBall value(const FixedBall& h) const;
  FixedBall slope(const FixedBall& h) const;
  Fixed slope_near(const Fixed& h) const;
  Bracket bracket_near(const Extremum& extremum, int side) const;
  template <class SlopeAt>
  std::optional<PreciseTime> root_within(const Bracket& bracket, FixedBall v, const SlopeAt& slope_at, Stage stage,
                                         double enough) const;
  std::optional<PreciseTime> around(const Fixed& h, double error, Stage stage) const;

  double about_ = 0;
  int exponent_ = 0;  ///< of the time unit
  std::array<FixedBall, FrameExpansion::terms> c_;
  std::size_t terms_ = 0;  ///< terms from this index on are zero
  double rest_ = 0;        ///< a bound of the next coefficient
  Steepness steep_{};
};

}  // namespace taut::internal
