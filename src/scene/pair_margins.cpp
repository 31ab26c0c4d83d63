#include "scene/pair_margins.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numeric/budget.hpp"
#include "scene/ignored_pairs.hpp"
#include "taut/error.hpp"

namespace taut::internal {
namespace {

std::string entry_name(std::size_t k) { return fmt::format("clearances[{}]", k); }

void validate_coefficient(double x, const std::string& place, const std::string& name) {
  if (x == 0 || (std::fabs(x) <= 0x1p400 && std::fabs(x) >= 0x1p-400)) return;
  throw InputError(place, fmt::format("{} = {} is not a number between 2^-400 and 2^400", name, x),
                   "choose other units");
}

void validate_margin(const Margin& margin, const std::string& place, double start, double end) {
  const Coefficients& c = margin.coefficients;
  if (c.size() > max_degree + 1)
    throw InputError(place, fmt::format("the margin has degree {}", c.size() - 1),
                     fmt::format("the highest degree supported is {}", max_degree));
  for (std::size_t k = 0; k < c.size(); ++k) validate_coefficient(c[k], place, fmt::format("margin[{}]", k));
  validate_coefficient(margin.origin, place, "origin");
  const bool zero = std::all_of(c.begin(), c.end(), [](double x) { return x == 0; });
  if (zero || (is_constant(margin) && c[0] < 0))
    throw InputError(place, fmt::format("the margin is {}, which is not positive", constant_term(margin)),
                     "write how far apart the two have to be; without a clearance, `check` asks whether bodies touch");
  if (const auto t = negative_at(margin, start, end))
    throw InputError(place, fmt::format("the margin is {} at t = {}", margin_over(margin, *t, *t).mid, *t),
                     "a margin must not be negative at any time of the scene, nor reach 0 between two doubles");
}

/// A pair by the bodies' numbers, the smaller one first; -1 is every other body.
using NumberedPair = std::pair<int, int>;

NumberedPair numbered(const PairClearance& entry, const std::map<std::string, int>& by_name, const std::string& place) {
  std::array<int, 2> ids{};
  for (std::size_t side = 0; side < 2; ++side) {
    const std::string& name = entry.pair[side];
    const auto found = by_name.find(name);
    if (name != "*" && found == by_name.end())
      throw InputError(place, "there is no body \"" + name + "\"",
                       "write names of bodies of the scene, or \"*\" for every other one");
    ids[side] = name == "*" ? -1 : found->second;
  }
  if (ids[0] == ids[1] && ids[0] >= 0)
    throw InputError(place, "it pairs \"" + entry.pair[0] + "\" with itself",
                     "write the names of two bodies, or \"*\" for every other one");
  return std::minmax(ids[0], ids[1]);
}

/// The entry for each pair that has one.
using Entries = std::map<NumberedPair, std::size_t>;

Entries entries_of(const Scene& scene) {
  const std::map<std::string, int> by_name = bodies_by_name(scene);
  Entries entries;
  for (std::size_t k = 0; k < scene.clearances.size(); ++k) {
    const auto [at, added] = entries.emplace(numbered(scene.clearances[k], by_name, entry_name(k)), k);
    if (!added)
      throw InputError(entry_name(k), "it is about the same pair as " + entry_name(at->second),
                       "write one clearance for each pair");
  }
  return entries;
}

/// Of a pair, each of which has something to say about every other body, one must count.
void validate_one_counts(const Scene& scene, const Entries& entries) {
  for (auto a = entries.begin(); a != entries.end(); ++a) {
    const auto [star_a, body_a] = a->first;
    if (star_a >= 0 || body_a < 0) continue;
    for (auto b = std::next(a); b != entries.end() && b->first.first < 0; ++b) {
      checkpoint();
      const int body_b = b->first.second;
      if (entries.count({body_a, body_b}) > 0 ||
          same_margin(scene.clearances[a->second].margin, scene.clearances[b->second].margin))
        continue;
      const std::string &first = scene.bodies[static_cast<std::size_t>(body_a)].name,
                        &second = scene.bodies[static_cast<std::size_t>(body_b)].name;
      throw InputError(entry_name(std::max(a->second, b->second)),
                       fmt::format("of \"{}\" and \"{}\" it says something else than {}", first, second,
                                   entry_name(std::min(a->second, b->second))),
                       fmt::format("add one for the pair [\"{}\", \"{}\"]", first, second));
    }
  }
}

}  // namespace

void validate_clearances(const Scene& scene) {
  if (scene.clearances.empty()) return;
  for (std::size_t k = 0; k < scene.clearances.size(); ++k)
    validate_margin(scene.clearances[k].margin, entry_name(k), scene.start, scene.end);
  validate_one_counts(scene, entries_of(scene));
}

PairMargins::PairMargins(const Scene& scene, double others) : others_(constant_margin(others)) {
  for (const auto& [pair, k] : entries_of(scene)) {
    const Margin& margin = scene.clearances[k].margin;
    if (pair.second < 0) {
      others_ = margin;
    } else if (pair.first < 0) {
      bodies_.emplace(pair.second, margin);
    } else {
      pairs_.emplace(pair, margin);
    }
  }
}

std::vector<double> PairMargins::shares(std::size_t bodies, double from, double to) const {
  // Halves are exact.
  const double least = margin_over(others_, from, to).upper() / 2;
  std::vector<double> shares(bodies, least);
  const auto raise = [&](BodyId body, double share) {
    double& own = shares[static_cast<std::size_t>(body)];
    own = std::max(own, share);
  };
  // Every other body has `least` at least.
  for (const auto& [body, margin] : bodies_)
    raise(body, std::nextafter(margin_over(margin, from, to).upper() - least, INFINITY));
  for (const auto& [pair, margin] : pairs_) {
    const double half = margin_over(margin, from, to).upper() / 2;
    raise(pair.first, half);
    raise(pair.second, half);
  }
  return shares;
}

const Margin& PairMargins::of(BodyId a, BodyId b) const {
  if (!pairs_.empty()) {
    const auto pair = pairs_.find(std::minmax(a, b));
    if (pair != pairs_.end()) return pair->second;
  }
  for (const BodyId body : {a, b}) {
    const auto found = bodies_.find(body);
    if (found != bodies_.end()) return found->second;
  }
  return others_;
}

}  // namespace taut::internal
