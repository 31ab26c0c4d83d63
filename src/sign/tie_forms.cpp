#include "sign/tie_forms.hpp"

#include <algorithm>

namespace taut {
namespace {

std::size_t mixed(const Form& form) {
  const std::size_t all = form.a.value * std::size_t{0x9e3779b1} + form.b.value * std::size_t{0x85ebca77} +
                          form.c.value * std::size_t{0xc2b2ae3d} + static_cast<std::size_t>(form.measure);
  return all >> 8 ^ all >> 16 ^ all;
}

}  // namespace

TieForms::Place& TieForms::place_of(const TieFrame& frame, const Form& form) {
  reserve();
  if (is_stale_) {
    for (Place& place : kept_->places) place.used = false;
    is_stale_ = false;
  }
  Place& place = kept_->places[mixed(form) % kept_->places.size()];
  if (place.used && place.about == frame.about && place.form == form) return place;
  place.has_tie = place.has_near = false;
  place.root.reset();
  place.roots_seen = 0;
  place.form = form;
  place.about = frame.about;
  place.used = true;
  return place;
}

const TieForm& TieForms::of(const TieFrame& frame, const Leg& leg, const PairGeometry& g, const Form& form) {
  Place& place = place_of(frame, form);
  if (!place.has_tie) {
    place.tie = TieForm(frame, leg, g, form);
    place.has_tie = true;
  }
  return place.tie;
}

const NearForm& TieForms::near_of(Place& place, const TieFrame& frame, const Leg& leg, const PairGeometry& g) {
  if (!place.has_near) {
    place.near = NearForm(frame, leg, g, place.form);
    place.has_near = true;
  }
  return place.near;
}

const RootOfTie* TieForms::root_beside(const TieFrame& frame, const Leg& leg, const PairGeometry& g, const Form& form,
                                       double enough) {
  if (roots_noted_ == 0) return nullptr;
  Place& place = place_of(frame, form);
  if (place.root && place.root->error < enough) return &*place.root;
  const NearForm& near = near_of(place, frame, leg, g);
  if (near.slope_sign() == 0) return nullptr;
  // None of those seen tells more than was asked for then; or more than none.
  const bool seen_in_vain = place.enough == enough || (place.enough > enough && !place.root);
  const std::uint64_t most = kept_->roots.size(), seen = seen_in_vain ? place.roots_seen : 0;
  place.roots_seen = roots_noted_;
  place.enough = enough;
  // What was noted last is nearest.
  for (std::uint64_t k = roots_noted_; k-- > std::max(seen, roots_noted_ - std::min(roots_noted_, most));) {
    const KnownRoot& known = kept_->roots[static_cast<std::size_t>(k % most)];
    if (!near.is_beside(known.form)) continue;
    const auto distance = near.distance_from(frame, leg, known);
    if (!distance || !(distance->error < enough)) continue;
    place.root = RootOfTie{known.at_distance(*distance), near.slope_sign(), distance->error};
    return &*place.root;
  }
  return nullptr;
}

void TieForms::note_root(const TieFrame& frame, const Leg& leg, const PairGeometry& g, const Form& form,
                         const PreciseTime& root) {
  const NearForm& near = near_of(place_of(frame, form), frame, leg, g);
  if (near.slope_sign() == 0) return;
  const std::uint64_t place = roots_noted_++ % kept_->roots.size();
  kept_->roots[static_cast<std::size_t>(place)] = KnownRoot(near, frame, root);
}

}  // namespace taut
