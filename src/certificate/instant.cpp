#include "certificate/instant.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "certificate/precise_triple.hpp"
#include "numeric/stages.hpp"

namespace taut::internal {
namespace {

/// The instant of a contact, refined stage by stage.
class ClosingInstant {
 public:
  explicit ClosingInstant(const ContactInstant& instant)
      : segment_(*instant.segment),
        root_(segment_, *instant.geometry,
              {instant.contact.edge, instant.geometry->next(instant.contact.edge), instant.contact.vertex,
               instant.geometry->in_p(instant.contact.edge)}),
        parameter_(instant.contact.at ? *instant.contact.at
                                      : PreciseTime::between(instant.contact.lo, instant.contact.hi)) {}

  /// An enclosure that a stage cannot improve stays as it is. A vertex is outside before it meets an edge.
  void refine(Stage stage, double enough) { root_.refine(-1, parameter_, stage, enough); }
  const PreciseTime& parameter() const { return parameter_; }
  /// The instant in world time.
  PreciseTime time() const {
    return segment_.bridge ? PreciseTime::between(segment_.joint, segment_.joint) : parameter_;
  }

 private:
  const MotionSegment& segment_;
  PreciseTriple root_;
  PreciseTime parameter_;
};

}  // namespace

int order_of(const ContactInstant& a, const ContactInstant& b) {
  const bool one_bridge = a.segment == b.segment && a.segment->bridge;
  ClosingInstant x(a), y(b);
  const auto order = [&] { return one_bridge ? x.parameter().is_first(y.parameter()) : x.time().is_first(y.time()); };
  std::optional<bool> a_first = order();
  if (!a_first) {
    a_first = first_decisive([&](Stage stage) {
      x.refine(stage, 0);
      y.refine(stage, 0);
      return order();
    });
  }
  return !a_first ? 0 : *a_first ? -1 : 1;
}

namespace {

/// A contact that may be the first, with room for its shift due to the bodies' displacement.
class Rival {
 public:
  Rival(std::size_t index, const ContactCandidate& candidate)
      : index_(index), lo_(candidate.time.lo), hi_(candidate.time.hi) {
    if (!candidate.instant) return;
    const ContactInstant& at = *candidate.instant;
    sway_ = displacement_sway(*at.geometry, *at.segment, at.contact);
    if (std::isfinite(sway_)) root_ = std::make_unique<ClosingInstant>(at);
  }

  std::size_t index() const { return index_; }
  const RealMax& lo() const { return lo_; }
  const RealMax& hi() const { return hi_; }
  void refine(Stage stage) {
    if (!root_) return;
    root_->refine(stage, sway_);
    const PreciseTime t = root_->time();
    lo_ = std::max(lo_, RealMax(t.lo() - sway_));
    hi_ = std::min(hi_, RealMax(t.hi() + sway_));
  }

 private:
  std::size_t index_;
  RealMax lo_, hi_;
  double sway_ = 0;
  std::unique_ptr<ClosingInstant> root_;
};

/// Removes those that certainly come after another one.
template <class Interval>
void keep_first(std::vector<Interval>& all) {
  const auto ends_first = [](const Interval& a, const Interval& b) { return a.hi() < b.hi(); };
  const RealMax least = std::min_element(all.begin(), all.end(), ends_first)->hi();
  std::erase_if(all, [&](const Interval& a) { return a.lo() > least; });
}

}  // namespace

std::vector<std::size_t> possibly_first(const std::vector<ContactCandidate>& contacts) {
  double least = std::numeric_limits<double>::infinity();
  for (const ContactCandidate& c : contacts) least = std::min(least, c.time.hi);
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (contacts[i].time.lo <= least) left.push_back(i);
  }
  if (left.size() < 2) return left;
  std::vector<Rival> rivals;
  for (const std::size_t i : left) rivals.emplace_back(i, contacts[i]);
  for (Stage stage = Stage::precise; stage <= last_stage && rivals.size() > 1; stage = next_precise(stage)) {
    for (Rival& rival : rivals) rival.refine(stage);
    keep_first(rivals);
  }
  left.clear();
  for (const Rival& rival : rivals) left.push_back(rival.index());
  return left;
}

}  // namespace taut::internal
