// Certificates that need no look: those that hold wherever the motion stays in a region around where it is.
//
// When a leg begins, every certificate of the active set is due: the functions of time are new ones. But most
// certificates hold by far. So the engine keeps a region, a range of each of the frame functions, and settles the
// certificates that hold all over it. They are due again only when the motion leaves the region, which one bound on the
// motion tells for all. A motion that is changed again and again in the same place, or that goes to and fro, costs
// little more than the certificates that are not settled.
#include <algorithm>

#include "kinetic/engine.hpp"

namespace taut {
namespace {

/// With fewer certificates, looking at each is cheaper than a region.
constexpr std::size_t few_certificates = 64;
/// A region is kept if it settles this share of the active set.
constexpr double good_share = 0.75;
constexpr std::size_t sample_size = 64;
constexpr int regions_per_leg = 4;

}  // namespace

void Engine::enter_leg() {
  parameter_ = reached_ = leg().start;
  queue_.clear();
  solver_.enter(leg());
  regions_left_ = regions_per_leg;
  settle(leg().start, true);
}

/// The motion leaves the region within the leg.
void Engine::leave_region() { settle(settled_until_, false); }

/// Sees to it that every certificate is settled or scheduled from t on. `all_due`: none is scheduled yet; otherwise
/// those that were not settled are.
void Engine::settle(double t, bool all_due) {
  settled_until_ = region_ ? region_->left_at(leg(), t) : t;
  std::vector<bool>& before = settled_before_;
  before = settled_;
  if (!(settled_until_ > t) && !choose_region(t)) {
    region_.reset();
    std::fill(settled_.begin(), settled_.end(), false);
    settled_until_ = never;
  }
  for (std::size_t i = 0; i < certificates_.size(); ++i) {
    Certificate& c = certificates_[i];
    if (!c.corner.valid()) continue;
    const CertificateId id(i);
    if (settled_[i]) {
      queue_.remove(id);
      solver_.rest(c);
    } else if (all_due || before[i]) {
      solver_.start(c, t);
      queue_.update(id);
    }
  }
}

/// A region around the motion from t on, as long as that settles enough certificates: if possible, one that holds the
/// last region, too.
bool Engine::choose_region(double t) {
  if (active_ < few_certificates || regions_left_ == 0) return false;
  if (skip_ > 0) {
    --skip_;
    return false;
  }
  --regions_left_;
  for (const double share : {1.0, 0x1p-4, 0x1p-8}) {
    const PlanRange way = PlanRange::over(leg(), t, t + (leg().end - t) * share).widened();
    if (region_) {
      PlanRange both = *region_;
      both.include(way);
      if (accept(both)) break;
    }
    if (accept(way)) break;
    if (share == 0x1p-8) {
      skip_ = 1 << std::min(++failures_, 6);
      return false;
    }
  }
  failures_ = 0;
  settled_until_ = region_->left_at(leg(), t);
  return settled_until_ > t;
}

/// Makes it the region if it settles enough certificates; a sample tells soon if it does not.
bool Engine::accept(const PlanRange& region) {
  std::size_t settled = 0, seen = 0;
  for (std::size_t i = 0; i < certificates_.size(); ++i) {
    const Certificate& c = certificates_[i];
    if (!c.corner.valid()) continue;
    settled_[i] = region.keeps_sign(geometry_, MixedTriple::of(geometry_, c.u, c.v, c.w), c.sign);
    settled += settled_[i] ? 1 : 0;
    if (++seen == sample_size && static_cast<double>(settled) < good_share * sample_size) return false;
  }
  if (static_cast<double>(settled) < good_share * static_cast<double>(active_)) return false;
  region_ = region;
  return true;
}

}  // namespace taut
