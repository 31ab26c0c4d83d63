#include "certificate/expansion_cache.hpp"

#include <algorithm>

namespace taut::internal {
namespace {

std::size_t mixed(const CertificateFunction& function) {
  const std::size_t all = function.a.value * std::size_t{0x9e3779b1} + function.b.value * std::size_t{0x85ebca77} +
                          function.c.value * std::size_t{0xc2b2ae3d} + static_cast<std::size_t>(function.measure);
  return all >> 8 ^ all >> 16 ^ all;
}

}  // namespace

ExpansionCache::Place& ExpansionCache::place_of(const FrameExpansion& frame, const CertificateFunction& function) {
  reserve();
  if (is_stale_) {
    for (Place& place : kept_->places) place.used = false;
    is_stale_ = false;
  }
  Place& place = kept_->places[mixed(function) % kept_->places.size()];
  if (place.used && place.about == frame.about && place.function == function) return place;
  place.has_expansion = place.has_near = false;
  place.root.reset();
  place.roots_seen = 0;
  place.function = function;
  place.about = frame.about;
  place.used = true;
  return place;
}

const FixedPointExpansion& ExpansionCache::of(const FrameExpansion& frame, const MotionSegment& segment,
                                              const PairGeometry& g, const CertificateFunction& function) {
  Place& place = place_of(frame, function);
  if (!place.has_expansion) {
    place.expansion = FixedPointExpansion(frame, segment, g, function);
    place.has_expansion = true;
  }
  return place.expansion;
}

const RelativeRoot& ExpansionCache::near_of(Place& place, const FrameExpansion& frame, const MotionSegment& segment,
                                            const PairGeometry& g) {
  if (!place.has_near) {
    place.near = RelativeRoot(frame, segment, g, place.function);
    place.has_near = true;
  }
  return place.near;
}

const RootOfExpansion* ExpansionCache::root_near(const FrameExpansion& frame, const MotionSegment& segment,
                                                 const PairGeometry& g, const CertificateFunction& function,
                                                 double enough) {
  if (roots_noted_ == 0) return nullptr;
  Place& place = place_of(frame, function);
  if (place.root && place.root->error < enough) return &*place.root;
  const RelativeRoot& near = near_of(place, frame, segment, g);
  if (near.slope_sign() == 0) return nullptr;
  // None of the roots examined gave an error below the one requested then; or there is none at all.
  const bool seen_in_vain = place.enough == enough || (place.enough > enough && !place.root);
  const std::uint64_t most = kept_->roots.size(), seen = seen_in_vain ? place.roots_seen : 0;
  place.roots_seen = roots_noted_;
  place.enough = enough;
  // The root noted last is the nearest.
  for (std::uint64_t k = roots_noted_; k-- > std::max(seen, roots_noted_ - std::min(roots_noted_, most));) {
    const KnownRoot& known = kept_->roots[static_cast<std::size_t>(k % most)];
    if (!near.has_same_reference(known.function)) continue;
    const auto distance = near.distance_from(frame, segment, known);
    if (!distance || !(distance->error < enough)) continue;
    place.root = RootOfExpansion{known.at_distance(*distance), near.slope_sign(), distance->error};
    return &*place.root;
  }
  return nullptr;
}

void ExpansionCache::note_root(const FrameExpansion& frame, const MotionSegment& segment, const PairGeometry& g,
                               const CertificateFunction& function, const PreciseTime& root) {
  const RelativeRoot& near = near_of(place_of(frame, function), frame, segment, g);
  if (near.slope_sign() == 0) return;
  const std::uint64_t place = roots_noted_++ % kept_->roots.size();
  kept_->roots[static_cast<std::size_t>(place)] = KnownRoot(near, frame, root);
}

}  // namespace taut::internal
