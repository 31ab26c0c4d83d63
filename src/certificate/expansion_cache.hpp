// Certificate functions near an instant of many simultaneous events, expanded once for all queries.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "certificate/fixed_point_expansion.hpp"
#include "certificate/relative_root.hpp"
#include "numeric/thread_local_pool.hpp"

namespace taut::internal {

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
