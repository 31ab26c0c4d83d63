// Certificates that need no look: those that hold wherever the motion stays in a region around where it is.
//
// When a leg begins, every certificate of the active set is due: the functions of time are new ones. But most
// certificates hold by far. So the engine keeps a region, a range of each of the frame functions, and settles the
// certificates that hold all over it. They are due again only when the motion leaves the region, which one bound on the
// motion tells for all. A motion that is changed again and again in the same place, or that goes to and fro, costs
// little more than the certificates that are not settled.
#include <algorithm>

#include "base/interruption.hpp"
#include "kinetic/engine.hpp"

namespace taut {
namespace {

/// With fewer certificates, looking at each is cheaper than a region.
constexpr std::size_t few_certificates = 64;
/// A region is kept if it settles this share of the active set.
constexpr double good_share = 0.75;
/// A better one is looked for where this share or more is left open, once that has cost several times the active set.
constexpr double open_share = 0.0625;
constexpr std::size_t patience = 4;
/// A sample of this size must settle this share for all to be looked at.
constexpr std::size_t sample_size = 64;
constexpr double hopeful_share = 0.6;
constexpr int regions_per_leg = 4;

}  // namespace

void Engine::enter_leg() {
  parameter_ = reached_ = leg().start;
  queue_.clear();
  solver_.enter(leg());
  regions_left_ = regions_per_leg;
  settle(leg().start, true);
}

/// What the motion has seen is the best guess of what it will.
void Engine::leave_leg(double until) {
  if (!region_) return;
  const PlanRange seen = PlanRange::over(leg(), leg().start, until);
  if (seen_) {
    seen_->include(seen);
  } else {
    seen_ = seen;
  }
}

/// The motion leaves the region within the leg.
void Engine::leave_region() { settle(settled_until_, false); }

/// Sees to it that every certificate is settled or scheduled from t on. `all_due`: none is scheduled yet; otherwise
/// those that were not settled are.
void Engine::settle(double t, bool all_due) {
  settled_until_ = region_ ? region_->left_at(leg(), t) : t;
  settled_before_ = settled_;
  if (settled_until_ > t) {
    if (!all_due) return;
    if (!improve_region(t)) {
      spent_ += open_.size();
      for (const CertificateId id : open_) {
        if (certificates_[id.value].corner.valid()) schedule(id, t);
      }
      return;
    }
  } else if (!choose_region(t)) {
    region_.reset();
    seen_.reset();
    std::fill(settled_.begin(), settled_.end(), false);
    settled_until_ = never;
  }
  spent_ = 0;
  list_open();
  for (std::size_t i = 0; i < certificates_.size(); ++i) {
    Certificate& c = certificates_[i];
    if (!c.corner.valid()) continue;
    const CertificateId id(i);
    interruption_point();
    if (settled_[i]) {
      queue_.remove(id);
      solver_.rest(c);
    } else if (all_due || settled_before_[i]) {
      schedule(id, t);
    }
  }
}

void Engine::schedule(CertificateId id, double t) {
  solver_.start(certificates_[id.value], t);
  queue_.update(id);
}

/// The list of those that are not settled: few, once there is a region.
void Engine::list_open() {
  open_.clear();
  listed_.assign(certificates_.size(), false);
  for (std::size_t i = 0; i < certificates_.size(); ++i) {
    if (certificates_[i].corner.valid() && !settled_[i]) leave_open(CertificateId(i));
  }
}

void Engine::leave_open(CertificateId id) {
  settled_[id.value] = false;
  if (listed_[id.value]) return;
  listed_[id.value] = true;
  open_.push_back(id);
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
    const double until = t + (leg().end - t) * share;
    if (!hopeful(PlanRange::around_instants(leg(), t, until))) continue;
    const PlanRange way = PlanRange::over(leg(), t, until).widened();
    if (!accept_with_last(way) && !accept(way, good_share)) continue;
    failures_ = 0;
    settled_until_ = region_->left_at(leg(), t);
    return settled_until_ > t;
  }
  skip_ = 1 << std::min(++failures_, 6);
  return false;
}

bool Engine::accept_with_last(const PlanRange& way) {
  if (!region_) return false;
  PlanRange both = *region_;
  both.include(way);
  return accept(both, good_share);
}

/// A region that leaves much open is replaced by one around what the motion has really seen, if that is much better.
bool Engine::improve_region(double t) {
  const double open = static_cast<double>(open_.size()) / static_cast<double>(active_);
  if (!seen_ || open < open_share || spent_ < patience * active_) return false;
  spent_ = 0;
  const PlanRange seen = seen_->widened();
  const double until = seen.left_at(leg(), t);
  if (!(until > t) || !accept(seen, 1 - open / 2)) return false;
  settled_until_ = until;
  return true;
}

/// Does a sample of the active set say that the region is worth a look at all?
bool Engine::hopeful(const PlanRange& region) const {
  std::size_t settled = 0, seen = 0;
  for (std::size_t k = 0; k < sample_size; ++k) {
    const std::size_t i = k * certificates_.size() / sample_size;
    if (!certificates_[i].corner.valid()) continue;
    ++seen;
    settled += settles(region, i);
  }
  return static_cast<double>(settled) >= hopeful_share * static_cast<double>(seen);
}

/// Makes it the region if it settles this share of the active set.
bool Engine::accept(const PlanRange& region, double share) {
  if (!hopeful(region)) return false;
  std::size_t settled = 0;
  trial_.assign(certificates_.size(), false);
  for (std::size_t i = 0; i < certificates_.size(); ++i) {
    if (!certificates_[i].corner.valid()) continue;
    trial_[i] = settles(region, i);
    settled += trial_[i];
  }
  if (static_cast<double>(settled) < share * static_cast<double>(active_)) return false;
  region_ = region;
  settled_.swap(trial_);
  return true;
}

bool Engine::settles(const PlanRange& region, std::size_t i) const {
  const Certificate& c = certificates_[i];
  return region.keeps_sign(geometry_, Form::of(geometry_, c.u, c.v, c.w), c.sign);
}

}  // namespace taut
