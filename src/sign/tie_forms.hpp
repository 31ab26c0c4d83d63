// Forms near an instant at which much happens, made once for all that is asked about them.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "sign/tie_form.hpp"

namespace taut {

/// A certificate that begins at such an instant often fails at it, too: its sign is asked for first, then its root, and
/// to make the form costs as much as either. So the last forms of a leg are kept, each in the one place that its
/// vertices tell.
class TieForms {
 public:
  /// Makes room, so that nothing is allocated when it is asked for.
  void reserve() {
    if (!kept_) kept_.reset(new std::array<Kept, places>);
  }
  void clear() {
    if (!kept_ || is_clear_) return;
    for (Kept& k : *kept_) k.used = false;
    is_clear_ = true;
  }
  /// The form about the frame's instant, valid until the next call. All frames are of the same leg, all forms of the
  /// same bodies, until it is cleared.
  const TieForm& of(const TieFrame& frame, const Leg& leg, const PairGeometry& g, const Form& form) {
    reserve();
    Kept& kept = (*kept_)[place_of(form)];
    if (kept.used && kept.about == frame.about && kept.form == form) return kept.tie;
    is_clear_ = kept.used = false;
    kept.tie = TieForm(frame, leg, g, form);
    kept.form = form;
    kept.about = frame.about;
    kept.used = true;
    return kept.tie;
  }

 private:
  static constexpr std::size_t places = 128;

  struct Kept {
    bool used = false;
    double about = 0;
    Form form;
    TieForm tie;
  };
  static std::size_t place_of(const Form& form) {
    const std::size_t mixed = form.a.value * std::size_t{0x9e3779b1} + form.b.value * std::size_t{0x85ebca77} +
                              form.c.value * std::size_t{0xc2b2ae3d} + static_cast<std::size_t>(form.measure);
    return (mixed >> 8 ^ mixed >> 16 ^ mixed) % places;
  }

  std::unique_ptr<std::array<Kept, places>> kept_;
  bool is_clear_ = true;
};

}  // namespace taut
