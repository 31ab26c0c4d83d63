// Forms near an instant at which much happens, made once for all that is asked about them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/thread_local_pool.hpp"
#include "sign/fixed_point_expansion.hpp"
#include "sign/relative_root.hpp"

namespace taut::internal {

/// A root, and the sign of the slope there and all over a frame's reach.
struct RootOfExpansion {
  PreciseTime at;
  int slope_sign = 0;
  double error = 0;  ///< of its distance from a root that is known to all digits
};

/// A certificate that begins at such an instant often fails at it, too: its sign is asked for first, then its root, and
/// to make the form costs as much as either. So the last forms of a segment are kept, each in the one place that its
/// vertices tell. The last roots are kept with them, for forms that are nearly proportional to theirs.
class ExpansionCache {
 public:
  /// Makes room, so that nothing is allocated when it is asked for.
  void reserve() {
    if (!kept_) kept_ = ThreadLocalPool<Kept>::take();
  }
  void clear() {
    roots_noted_ = 0;
    is_stale_ = true;
  }
  /// The form about the frame's instant, valid until the next call. All frames are of the same segment, all forms of
  /// the same bodies, until it is cleared.
  const FixedPointExpansion& of(const FrameExpansion& frame, const MotionSegment& segment, const PairGeometry& g,
                                const CertificateFunction& function);
  /// Its root within reach, if one that is known tells it with an error below `enough`; valid as long.
  const RootOfExpansion* root_beside(const FrameExpansion& frame, const MotionSegment& segment, const PairGeometry& g,
                                     const CertificateFunction& function, double enough);
  /// From now on its root, which is given by sums, is known.
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
    std::uint64_t roots_seen = 0;  ///< how many had been noted when one was looked for,
    double enough = 0;             ///< with such an error
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
  bool is_stale_ = true;  ///< forms that are kept are of another segment, or of another owner
};

}  // namespace taut::internal
