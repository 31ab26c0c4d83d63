// Certificates that need no look: those that hold wherever the motion stays in a region around where it is.
//
// When a segment begins, every certificate of the active set is due: the functions of time are new ones. But most
// certificates hold by far. So there is a region, a range of each of the frame functions, and the certificates that
// hold all over it are settled. They are due again only when the motion leaves the region, which one bound on the
// motion tells for all. A motion that is changed again and again in the same place, or that goes to and fro, costs
// little more than the certificates that are not settled.
#pragma once

#include <optional>
#include <vector>

#include "kinetic/certificate.hpp"
#include "kinetic/event_queue.hpp"
#include "sign/frame_range.hpp"

namespace taut::internal {

/// Which certificates are settled, and until when. The engine adds certificates and says when a segment begins or ends;
/// this chooses regions, keeps those that serve well, and gives up looking for them where none does.
class DormantCertificates {
 public:
  DormantCertificates(const PairGeometry& geometry, const std::vector<Certificate>& certificates)
      : geometry_(geometry), certificates_(certificates) {}

  void reserve(std::size_t room);
  std::size_t bytes() const { return dormant_.capacity() + open_.capacity() * sizeof(CertificateId); }
  /// There is one certificate more.
  void add() {
    dormant_.push_back(false);
    listed_.push_back(false);
  }
  /// The certificate is scheduled: it is not settled from now on.
  void unsettle(CertificateId id);

  /// As if no segment had been seen.
  void forget();
  /// Some regions may be tried on each segment.
  void begin_segment();
  /// One that is passed once, with so many certificates: no region is looked for unless these are so many that it costs
  /// less than they do.
  void begin_passage(std::size_t active);
  /// The motion went from the segment's start to `until`: what it has seen is the best guess of what it will.
  void note_motion(const MotionSegment& segment, double until);

  /// What the engine has to do after look().
  enum class Due : unsigned char {
    nothing,     ///< all is as it was
    unknown,     ///< that has not been seen yet; never what look() says
    those_open,  ///< the certificates of open() are due
    as_marked,   ///< is_dormant() is new: those were_dormant() and are no more are due, too
  };
  /// Sees which certificates are settled from t on, of `active` ones. `all_due`: none is scheduled yet. May be
  /// interrupted before it begins.
  Due look(const MotionSegment& segment, double t, std::size_t active, bool all_due);
  bool is_dormant(CertificateId id) const { return dormant_[id.value]; }
  bool was_dormant(CertificateId id) const { return dormant_before_[id.value]; }
  /// Those that are not settled; some may be gone.
  const std::vector<CertificateId>& open() const { return open_; }
  /// When the motion leaves the region, on the present segment.
  double until() const { return until_; }

 private:
  bool choose(const MotionSegment& segment, double t, std::size_t active);
  bool improve(const MotionSegment& segment, double t, std::size_t active);
  bool worth_trying(const FrameRange& region) const;
  bool accept(const FrameRange& region, double share, std::size_t active);
  bool accept_with_last(const FrameRange& way, std::size_t active);
  bool settles(const FrameRange& region, std::size_t certificate) const;
  void list_open();

  const PairGeometry& geometry_;
  const std::vector<Certificate>& certificates_;
  std::vector<bool> dormant_;  ///< by certificate: it holds wherever the motion is in region_
  std::vector<bool> dormant_before_, trial_;
  std::vector<CertificateId> open_;
  std::vector<bool> listed_;  ///< by certificate: it is in open_
  std::optional<FrameRange> region_;
  std::optional<FrameRange> seen_;  ///< where the motion has been since there is a region
  std::size_t spent_ = 0;           ///< certificates scheduled since the region was chosen
  double until_ = never;
  int regions_left_ = 0;         ///< on the present segment
  int failures_ = 0, skip_ = 0;  ///< segments on which no region was found, and for how many none is looked for
};

}  // namespace taut::internal
