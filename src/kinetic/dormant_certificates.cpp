#include "kinetic/dormant_certificates.hpp"

#include <algorithm>

#include "numeric/budget.hpp"

namespace taut::internal {
namespace {

/// With fewer certificates, evaluating each is cheaper than a region.
constexpr std::size_t few_certificates = 64;
/// A region is kept if it makes this share of the active set dormant.
constexpr double good_share = 0.75;
/// If a region leaves this share or more open, a better region is tried once the open certificates have cost several
/// times the active set.
constexpr double open_share = 0.0625;
constexpr std::size_t subdivision_threshold = 4;
/// All certificates are tested only if this share of a sample of this size is dormant in the region.
constexpr std::size_t sample_size = 64;
constexpr double worthwhile_share = 0.6;
constexpr int regions_per_segment = 4;

}  // namespace

void DormantCertificates::reserve(std::size_t room) {
  dormant_.reserve(room);
  dormant_before_.reserve(room);
  open_.reserve(room);
  listed_.reserve(room);
  trial_.reserve(room);
}

void DormantCertificates::wake(CertificateId id) {
  dormant_[id.value] = false;
  if (listed_[id.value]) return;
  listed_[id.value] = true;
  open_.push_back(id);
}

void DormantCertificates::begin_segment() { regions_left_ = regions_per_segment; }

void DormantCertificates::note_motion(const MotionSegment& segment, double until) {
  if (!region_) return;
  const FrameRange seen = FrameRange::over(segment, segment.start, until);
  if (seen_) {
    seen_->include(seen);
  } else {
    seen_ = seen;
  }
}

DormantCertificates::Due DormantCertificates::evaluate(const MotionSegment& segment, double t, std::size_t active,
                                                       bool all_due) {
  until_ = region_ ? region_->left_at(segment, t) : t;
  dormant_before_ = dormant_;
  if (until_ > t) {
    if (!all_due) return Due::nothing;
    if (!improve(segment, t, active)) {
      spent_ += open_.size();
      return Due::those_open;
    }
  } else if (!choose(segment, t, active)) {
    region_.reset();
    seen_.reset();
    std::fill(dormant_.begin(), dormant_.end(), false);
    until_ = never;
  }
  spent_ = 0;
  list_open();
  return Due::as_marked;
}

/// Rebuilds the list of open certificates. Once there is a region, they are few.
void DormantCertificates::list_open() {
  open_.clear();
  listed_.assign(certificates_.size(), false);
  for (std::size_t i = 0; i < certificates_.size(); ++i) {
    if (certificates_[i].corner.valid() && !dormant_[i]) wake(CertificateId(i));
  }
}

/// Chooses a region around the motion from t on, provided that it makes enough certificates dormant. If possible, the
/// region also contains the last one.
bool DormantCertificates::choose(const MotionSegment& segment, double t, std::size_t active) {
  if (active < few_certificates || regions_left_ == 0) return false;
  if (skip_ > 0) {
    --skip_;
    return false;
  }
  --regions_left_;
  for (const double share : {1.0, 0x1p-4, 0x1p-8}) {
    const double until = t + (segment.end - t) * share;
    if (!worth_trying(FrameRange::around_instants(segment, t, until))) continue;
    const FrameRange way = FrameRange::over(segment, t, until).widened();
    if (!accept_with_last(way, active) && !accept(way, good_share, active)) continue;
    failures_ = 0;
    until_ = region_->left_at(segment, t);
    return until_ > t;
  }
  skip_ = 1 << std::min(++failures_, 6);
  return false;
}

bool DormantCertificates::accept_with_last(const FrameRange& way, std::size_t active) {
  if (!region_) return false;
  FrameRange both = *region_;
  both.include(way);
  return accept(both, good_share, active);
}

/// If the region leaves many certificates open, replaces it by one around the motion actually seen, if that is much
/// better.
bool DormantCertificates::improve(const MotionSegment& segment, double t, std::size_t active) {
  const double left = static_cast<double>(open_.size()) / static_cast<double>(active);
  if (!seen_ || left < open_share || spent_ < subdivision_threshold * active) return false;
  spent_ = 0;
  const FrameRange seen = seen_->widened();
  const double until = seen.left_at(segment, t);
  if (!(until > t) || !accept(seen, 1 - left / 2, active)) return false;
  until_ = until;
  return true;
}

/// Does a sample of the active set suggest that testing the region is worthwhile?
bool DormantCertificates::worth_trying(const FrameRange& region) const {
  std::size_t dormant = 0, seen = 0;
  for (std::size_t k = 0; k < sample_size; ++k) {
    const std::size_t i = k * certificates_.size() / sample_size;
    if (!certificates_[i].corner.valid()) continue;
    ++seen;
    dormant += is_dormant_in(region, i);
  }
  return static_cast<double>(dormant) >= worthwhile_share * static_cast<double>(seen);
}

/// Makes this the current region if it makes the given share of the active set dormant.
bool DormantCertificates::accept(const FrameRange& region, double share, std::size_t active) {
  if (!worth_trying(region)) return false;
  count_work(certificates_.size());
  std::size_t dormant = 0;
  trial_.assign(certificates_.size(), false);
  for (std::size_t i = 0; i < certificates_.size(); ++i) {
    if (!certificates_[i].corner.valid()) continue;
    trial_[i] = is_dormant_in(region, i);
    dormant += trial_[i];
  }
  if (static_cast<double>(dormant) < share * static_cast<double>(active)) return false;
  region_ = region;
  dormant_.swap(trial_);
  return true;
}

bool DormantCertificates::is_dormant_in(const FrameRange& region, std::size_t i) const {
  const Certificate& c = certificates_[i];
  return region.keeps_sign(geometry_, CertificateFunction::of(geometry_, c.u, c.v, c.w), c.sign);
}

}  // namespace taut::internal
