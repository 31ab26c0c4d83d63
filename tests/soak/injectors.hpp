// What makes a scene degenerate, or nearly so.
#pragma once

#include "support/rng.hpp"
#include "taut/scene.hpp"

namespace taut::testing {

/// A way to spoil a scene; some need an answer to start from.
enum class Injection : std::uint8_t {
  none,
  nudges,      ///< coordinates moved by one unit in the last place
  shared,      ///< coordinates copied from other vertices
  collinear,   ///< vertices put into edges, exactly on them where that can be
  symmetric,   ///< the second body is a copy of the first one, mirrored, and so is its motion
  scaled,      ///< everything times a factor between 1e-12 and 1e12
  offset,      ///< everything 1e6 to 1e9 away from the origin
  near_start,  ///< the time starts just before the contact, or just after
  tangency,    ///< the second body approaches its place of contact as a power of t, of degree 2 to 4
};

inline constexpr Injection all_injections[] = {Injection::none,      Injection::nudges,     Injection::shared,
                                               Injection::collinear, Injection::symmetric,  Injection::scaled,
                                               Injection::offset,    Injection::near_start, Injection::tangency};

const char* to_string(Injection injection);

/// The scene with the injection; it may be invalid (shared coordinates make boundaries cross).
Scene inject(Rng& rng, Injection injection, Scene scene);

}  // namespace taut::testing
