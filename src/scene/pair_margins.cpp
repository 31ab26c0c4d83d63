#include "scene/pair_margins.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "motion/polynomial_search.hpp"
#include "numeric/budget.hpp"
#include "scene/names.hpp"
#include "scene/untested.hpp"
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

NumberedPair numbered(const Scene& scene, const PairClearance& entry, const std::map<std::string, int>& by_name,
                      const std::string& place) {
  std::array<int, 2> ids{};
  for (std::size_t side = 0; side < 2; ++side) {
    const std::string& name = entry.pair[side];
    const auto found = by_name.find(name);
    if (name != "*" && found == by_name.end())
      throw no_such_body(names_of(scene.bodies), name, place, "",
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
    const auto [at, added] = entries.emplace(numbered(scene, scene.clearances[k], by_name, entry_name(k)), k);
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

namespace {

double middle_of(double from, double to) { return from + (to - from) / 2; }

/// Nothing negative and nothing that changes its sign in powers of the time after an instant, or before it.
bool shows_no_negative(const DyadicPolynomial& about, bool before) {
  for (std::size_t k = 0; k < about.size(); ++k) {
    if (about[k].sign() * (before && k % 2 == 1 ? -1 : 1) < 0) return false;
  }
  return true;
}

bool negative_there(const Margin& margin, double t) {
  const LocalPolynomials::Known known = expanded_about(margin, t);
  return !known.exact().empty() && known.exact()[0].sign() < 0;
}

bool nowhere_negative(const Margin& margin, double from, double to) {
  if (shows_no_negative(expanded_about(margin, from).exact(), false) ||
      shows_no_negative(expanded_about(margin, to).exact(), true))
    return true;
  const double middle = middle_of(from, to);
  const BallPolynomial<RealMax> c = expanded_about(margin, middle).rounded<RealMax>().p;
  const double reach = std::max(to - middle, middle - from) * (1 + 0x1p-50);
  return c.size > 0 && polynomial_value(c, Ball<RealMax>(RealMax(0), reach)).sign() > 0;
}

}  // namespace

bool is_constant(const Margin& margin) {
  const Coefficients& c = margin.coefficients;
  return c.empty() || std::all_of(c.begin() + 1, c.end(), [](double x) { return x == 0; });
}

bool same_margin(const Margin& a, const Margin& b) {
  if (is_constant(a) && is_constant(b)) return constant_term(a) == constant_term(b);
  return a.coefficients == b.coefficients && a.origin == b.origin;
}

Margin scaled(Margin margin, int exponent) {
  for (double& c : margin.coefficients) c = std::ldexp(c, exponent);
  return margin;
}

LocalPolynomials::Known expanded_about(const Margin& margin, double instant) {
  return LocalPolynomials::Known(LocalPolynomials(instant).exact(margin.coefficients, margin.origin));
}

Ball<double> margin_over(const Margin& margin, double from, double to) {
  if (is_constant(margin)) return Ball<double>::exact(constant_term(margin));
  const double middle = middle_of(from, to), reach = std::max(to - middle, middle - from) * (1 + 0x1p-50);
  return polynomial_value(expanded_about(margin, middle).rounded<double>().p, Ball<double>(0, reach));
}

double margin_at(const Margin& margin, double t) {
  const LocalPolynomials::Known known = expanded_about(margin, t);
  if (known.exact().empty()) return 0;
  const Dyadic& exact = known.exact()[0];
  double above = nearest_double(exact);
  while ((exact - Dyadic::exact(above)).sign() > 0) above = std::nextafter(above, INFINITY);
  return above;
}

std::optional<double> negative_at(const Margin& margin, double start, double end) {
  for (const double t : {start, end}) {
    if (negative_there(margin, t)) return t;
  }
  if (!(start < end)) return std::nullopt;
  std::vector<std::pair<double, double>> open{{start, end}};
  for (int left = most_intervals; !open.empty(); --left) {
    checkpoint();
    const auto [from, to] = open.back();
    open.pop_back();
    if (nowhere_negative(margin, from, to)) continue;
    const double middle = middle_of(from, to);
    if (left == 0 || !(from < middle && middle < to) || negative_there(margin, middle)) return middle;
    open.insert(open.end(), {{middle, to}, {from, middle}});
  }
  return std::nullopt;
}

}  // namespace taut::internal
