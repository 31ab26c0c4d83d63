// Dormant certificates: those that need no evaluation while the motion stays in a region around its current position.
//
// When a segment begins, every certificate of the active set is due, because its function of time is a new one. But
// most certificates hold by a wide margin. Therefore the engine keeps a region: a range for each of the frame
// functions. The certificates that hold everywhere in the region are dormant. They become due again only when the
// motion leaves the region, and a single bound on the motion decides this for all of them. A motion that changes
// repeatedly in the same place, or that oscillates, then costs little more than the certificates that are not dormant.
#pragma once

#include <optional>
#include <vector>

#include "certificate/frame_range.hpp"
#include "kinetic/certificate.hpp"
#include "kinetic/event_queue.hpp"

namespace taut::internal {

/// Records which certificates are dormant, and until when. The engine adds certificates and reports when a segment
/// begins or ends. This class chooses regions, keeps those that serve well, and stops trying where none does.
class DormantCertificates {
 public:
  DormantCertificates(const PairGeometry& geometry, const std::vector<Certificate>& certificates)
      : geometry_(geometry), certificates_(certificates) {}

  void reserve(std::size_t room);
  std::size_t bytes() const { return dormant_.capacity() + open_.capacity() * sizeof(CertificateId); }
  /// Adds one certificate.
  void add() {
    dormant_.push_back(false);
    listed_.push_back(false);
  }
  /// The certificate is scheduled, and from now on it is not dormant.
  void wake(CertificateId id);

  /// Allows a limited number of regions to be tried on each segment.
  void begin_segment();
  /// The motion went from the segment's start to `until`. The range that it has covered is the best prediction of its
  /// future range.
  void note_motion(const MotionSegment& segment, double until);

  /// The action that the engine must take after evaluate().
  enum class Due : unsigned char {
    nothing,     ///< nothing has changed
    those_open,  ///< the certificates of open() are due
    as_marked,   ///< is_dormant() is new; certificates that were_dormant() and no longer are dormant are due, too
  };
  /// Determines which of the `active` certificates are dormant from t on. `all_due`: none is scheduled yet.
  Due evaluate(const MotionSegment& segment, double t, std::size_t active, bool all_due);
  bool is_dormant(CertificateId id) const { return dormant_[id.value]; }
  bool was_dormant(CertificateId id) const { return dormant_before_[id.value]; }
  /// The certificates that are not dormant. Some of them may have been removed.
  const std::vector<CertificateId>& open() const { return open_; }
  /// The time at which the motion leaves the region on the current segment.
  double until() const { return until_; }

 private:
  bool choose(const MotionSegment& segment, double t, std::size_t active);
  bool improve(const MotionSegment& segment, double t, std::size_t active);
  bool worth_trying(const FrameRange& region) const;
  bool accept(const FrameRange& region, double share, std::size_t active);
  bool accept_with_last(const FrameRange& way, std::size_t active);
  bool is_dormant_in(const FrameRange& region, std::size_t certificate) const;
  void list_open();

  const PairGeometry& geometry_;
  const std::vector<Certificate>& certificates_;
  std::vector<bool> dormant_;  ///< by certificate: it holds wherever the motion is in region_
  std::vector<bool> dormant_before_, trial_;
  std::vector<CertificateId> open_;
  std::vector<bool> listed_;  ///< by certificate: it is in open_
  std::optional<FrameRange> region_;
  std::optional<FrameRange> seen_;  ///< the range of the motion since the region was chosen
  std::size_t spent_ = 0;           ///< certificates scheduled since the region was chosen
  double until_ = never;
  int regions_left_ = 0;         ///< on the current segment
  int failures_ = 0, skip_ = 0;  ///< segments without a region, and segments still to be skipped
};

}  // namespace taut::internal
