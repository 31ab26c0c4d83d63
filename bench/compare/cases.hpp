// The scenes of the comparison, by family and size, each with the answer it must get.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "families.hpp"

namespace taut::bench {

/// A question that is asked again and again: one motion, or a sequence of plans for the same two shapes.
struct Contest {
  std::string family;
  int n = 0;  ///< about as many vertices a polygon
  Scene scene;
  /// What check() must answer for the whole scene; of the time of a contact only what is known independently.
  Outcome outcome = Outcome::free;
  std::optional<double> contact_time;
  /// If not empty: the second body's motions in turn, number k from time k to k + 1.
  std::vector<Motion> plans;
};

struct ContestFamily {
  const char* name;
  const char* what;
  std::vector<int> sizes;
  Contest (*make)(int n);
  /// Why the scenes cannot be made here; empty if they can. May be null.
  std::string (*obstacle)() = nullptr;
};

const std::vector<ContestFamily>& contest_families();

/// Those named in `only`, or all of them. What cannot be made here is left out, with a message on standard error.
std::vector<ContestFamily> chosen_families(const std::vector<std::string>& only);

}  // namespace taut::bench
