// A certificate function near an instant of many simultaneous events: see frame_expansion.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "certificate/certificate_function.hpp"
#include "certificate/frame_expansion.hpp"
#include "certificate/precise_time.hpp"
#include "certificate/relative_root.hpp"
#include "numeric/thread_local_pool.hpp"

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

// Certificate functions near an instant of many simultaneous events, expanded once for all queries.

/// A root, and the sign of the slope there and over the whole reach of a frame.
struct RootOfExpansion {
  PreciseTime at;
  int slope_sign = 0;
  double error = 0;  ///< of its distance from a root that is known to full precision
};

/// A certificate that begins at such an instant often fails at it, too. Its sign is evaluated first, then its root, and
/// the expansion costs as much as either. So the last expansions of a segment are kept, each in the one slot determined
/// by its vertices. The last roots are kept with them, for certificate functions that are nearly proportional to
/// theirs.
class ExpansionCache {
 public:
  /// Makes room, so that later queries allocate nothing.
  void reserve() {
    if (!kept_) kept_ = ThreadLocalPool<Kept>::take();
  }
  void clear() {
    roots_noted_ = 0;
    is_stale_ = true;
  }
  /// Gives the room back, for others in this thread to use.
  void release() {
    clear();
    kept_.reset();
  }
  /// The function expanded about the frame's instant, valid until the next call. Until the cache is cleared, all frames
  /// must belong to one segment and all functions to the same bodies.
  const FixedPointExpansion& of(const FrameExpansion& frame, const MotionSegment& segment, const PairGeometry& g,
                                const CertificateFunction& function);
  /// The root within reach, if a known root determines it with an error below `enough`; valid until the next call.
  const RootOfExpansion* root_near(const FrameExpansion& frame, const MotionSegment& segment, const PairGeometry& g,
                                   const CertificateFunction& function, double enough);
  /// Records the root of the function, which is given by sums.
  void note_root(const FrameExpansion& frame, const MotionSegment& segment, const PairGeometry& g,
                 const CertificateFunction& function, const PreciseTime& root);

 private:
  struct Place {
    bool used = false, has_expansion = false, has_near = false;
    double about = 0;
    CertificateFunction function;
    FixedPointExpansion expansion;
    RelativeRoot near;
    std::optional<RootOfExpansion> root;
    std::uint64_t roots_seen = 0;  ///< the number of roots noted at the last search for one,
    double enough = 0;             ///< and the error requested then
  };
  struct Kept {
    std::array<Place, 128> places;
    std::array<KnownRoot, 32> roots;
  };

  Place& place_of(const FrameExpansion& frame, const CertificateFunction& function);
  const RelativeRoot& near_of(Place& place, const FrameExpansion& frame, const MotionSegment& segment,
                              const PairGeometry& g);

  ThreadLocalPool<Kept>::Pointer kept_;
  std::uint64_t roots_noted_ = 0;
  bool is_stale_ = true;  ///< kept expansions belong to another segment, or to another owner
};

}  // namespace taut::internal
