// What comes after a contact, where the page is told what bodies do there.
#pragma once

#include <cstdint>
#include <string>

#include "taut/check.hpp"

namespace taut::web {

struct AftermathOptions {
  Touch touch = Touch::open;
  /// At a contact bodies bounce, as rigid bodies of density 1 without friction; or those that move stop.
  bool bounce = true;
  std::uint64_t max_contacts = 1000;
  double max_seconds = 1e300;
};

/// {"scene": what was done from the start on, as a scene that is free, "contacts": [{"t", "pair", "point"}], "state":
/// how it ended, "reason": why, if it is undecided}. Bodies at rest stay there. Throws InputError for bodies that hang
/// on others, or on joints.
std::string aftermath_text(const Scene& scene, const AftermathOptions& options);

}  // namespace taut::web
