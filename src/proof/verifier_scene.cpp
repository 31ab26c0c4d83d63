#include "proof/verifier_scene.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>

#include "motion/far_pieces.hpp"
#include "motion/pieces.hpp"
#include "taut/shape.hpp"

namespace taut::internal::proof {
namespace {

bool same_chain(const MotionChain& a, const MotionChain& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_pieces);
}

/// Of a chain, numbers that are the same for the same motions, and seldom for others.
std::vector<double> key_of(const MotionChain& chain) {
  std::vector<double> key;
  for (const PieceList& pieces : chain) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const MotionPiece piece = pieces[i];
      key.push_back(piece.until);
      for (const Coefficients* c : {&piece.x, &piece.y})
        key.push_back(std::accumulate(c->begin(), c->end(), 0.0, [](double sum, double x) { return 0.6 * sum + x; }));
    }
  }
  return key;
}

/// A body's parts at a height.
struct Section {
  Layers z;
  std::vector<std::size_t> parts;
};

/// From the lowest height up: the parts between each two neighbouring ends of any part's layers, without gaps, and
/// neighbours with the same parts taken together.
std::vector<Section> sections_of(const Body& body) {
  std::vector<Layers> layers;
  for (const Part& part : body.parts) layers.push_back(part.z ? *part.z : body.z);
  if (layers.empty()) layers.push_back(body.z);
  std::set<double> heights;
  for (const Layers& z : layers) heights.insert({z.lo, z.hi});
  std::vector<Section> sections;
  for (auto hi = std::next(heights.begin()); hi != heights.end(); ++hi) {
    const double lo = *std::prev(hi);
    Section section{{lo, *hi}, {}};
    for (std::size_t k = 0; k < layers.size(); ++k) {
      if (layers[k].lo <= lo && *hi <= layers[k].hi) section.parts.push_back(k);
    }
    const bool same = !sections.empty() && sections.back().parts == section.parts && sections.back().z.hi == lo;
    if (same) sections.back().z.hi = *hi;
    if (!same && !section.parts.empty()) sections.push_back(section);
  }
  return sections;
}

/// The power of two that brings all outlines within 1.
int exponent_for(const Scene& scene) {
  double largest = 0;
  for (const Body& body : scene.bodies) {
    for (const Part& part : parts_of(body)) {
      for (const Point& p : part.outline) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
    }
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return -exponent;
}

}  // namespace

VerifierScene::VerifierScene(const Scene& scene)
    : start_(scene.start), end_(scene.end), exponent_(exponent_for(scene)), ignored_(scene) {
  add_bodies(scene);
  add_motions(scene);
  find_alike();
  std::set<int> motions;
  for (int i = 0; i < in_scene_; ++i) {
    if (!ignored_.has_all(i)) motions.insert((*this)[i].alike);
  }
  tests_alike_ = scene.at_rest == AtRest::test || (scene.at_rest == AtRest::skip && motions.size() <= 1);
}

void VerifierScene::add_bodies(const Scene& scene) {
  in_scene_ = static_cast<int>(scene.bodies.size());
  std::vector<VerifierBody> above;
  for (int i = 0; i < in_scene_; ++i) {
    const Body& body = scene.bodies[static_cast<std::size_t>(i)];
    const std::vector<Section> sections = sections_of(body);
    for (const Section& section : sections) {
      layered_ = layered_ || !(section.z == Layers{});
      std::vector<VerifierBody>& list = &section == &sections.front() ? bodies_ : above;
      list.push_back({std::make_shared<const RingSet>(body, i, exponent_, section.parts), i, section.z, {}, 0});
    }
  }
  for (VerifierBody& body : above) bodies_.push_back(std::move(body));
  for (int i = 0; i < size(); ++i) bodies_[static_cast<std::size_t>(i)].alike = i;
}

void VerifierScene::find_alike() {
  std::map<std::vector<double>, std::vector<int>> first_of;
  for (int i = 0; i < size(); ++i) {
    VerifierBody& body = bodies_[static_cast<std::size_t>(i)];
    std::vector<int>& others = first_of[key_of(body.motions)];
    const auto same =
        std::find_if(others.begin(), others.end(), [&](int k) { return same_chain((*this)[k].motions, body.motions); });
    if (same != others.end()) {
      body.alike = *same;
    } else {
      others.push_back(i);
    }
  }
}

void VerifierScene::add_motions(const Scene& scene) {
  const std::map<std::string, int> by_name = bodies_by_name(scene);
  MotionChain own;
  std::vector<int> parent;
  for (const Body& body : scene.bodies) {
    own.push_back(PieceList::between(body.motion, start_, end_, exponent_));
    parent.push_back(body.relative_to.empty() ? -1 : by_name.at(body.relative_to));
  }
  for (VerifierBody& body : bodies_) {
    MotionChain& chain = body.motions;
    for (int k = body.in_scene; k >= 0; k = parent[static_cast<std::size_t>(k)]) {
      if (!own[static_cast<std::size_t>(k)].rests()) chain.push_back(own[static_cast<std::size_t>(k)]);
    }
    std::reverse(chain.begin(), chain.end());
  }
}

bool VerifierScene::asked(int a, int b) const {
  const VerifierBody &first = (*this)[a], &second = (*this)[b];
  if (first.in_scene == second.in_scene || !(std::max(first.z.lo, second.z.lo) < std::min(first.z.hi, second.z.hi)))
    return false;
  return (first.alike != second.alike || tests_alike_) && !ignored_.has(first.in_scene, second.in_scene);
}

Coverage VerifierScene::coverage() const {
  Coverage count;
  // Of each body, how many before it are not ignored by all; of these, how many move alike.
  std::uint64_t heard = 0, before = 0;
  std::map<int, std::uint64_t> alike_before;
  const auto alike = [&](int body) -> std::uint64_t& {
    return (*this)[body].rests() ? count.at_rest : count.moving_alike;
  };
  for (int body = 0; body < in_scene_; ++body) {
    count.pairs += before++;
    if (ignored_.has_all(body)) continue;
    std::uint64_t& same = alike_before[(*this)[body].alike];
    alike(body) += same++;
    count.tested += heard++;
  }
  for (const auto& [a, b] : ignored_.pairs()) {
    if (ignored_.has_all(a) || ignored_.has_all(b)) continue;
    --count.tested;
    if ((*this)[a].alike == (*this)[b].alike) --alike(a);
  }
  count.ignored = count.pairs - count.tested;
  if (tests_alike_) count.at_rest = count.moving_alike = 0;
  count.layers = layered_ ? without_common_layer() : 0;
  count.tested -= count.at_rest + count.moving_alike + count.layers;
  return count;
}

/// Of pairs that are neither ignored nor left out because they move alike. A body has few kinds of layers: bodies are
/// taken together that have the same.
std::uint64_t VerifierScene::without_common_layer() const {
  std::map<int, std::vector<std::pair<double, double>>> layers;  // of each body of the scene
  for (const VerifierBody& body : bodies_) layers[body.in_scene].emplace_back(body.z.lo, body.z.hi);
  struct Kind {
    std::uint64_t bodies = 0;
    std::map<int, std::uint64_t> alike;
  };
  std::map<std::vector<std::pair<double, double>>, Kind> kinds;
  const auto apart = [](const auto& a, const auto& b) {
    for (const auto& [a_lo, a_hi] : a) {
      for (const auto& [b_lo, b_hi] : b) {
        if (std::max(a_lo, b_lo) < std::min(a_hi, b_hi)) return false;
      }
    }
    return true;
  };
  std::uint64_t count = 0;
  for (int body = 0; body < in_scene_; ++body) {
    if (ignored_.has_all(body)) continue;
    const int alike = (*this)[body].alike;
    for (const auto& [other, kind] : kinds) {
      if (!apart(layers[body], other)) continue;
      const auto same = kind.alike.find(alike);
      count += kind.bodies - (tests_alike_ || same == kind.alike.end() ? 0 : same->second);
    }
    Kind& own = kinds[layers[body]];
    ++own.bodies;
    ++own.alike[alike];
  }
  for (const auto& [a, b] : ignored_.pairs()) {
    if (ignored_.has_all(a) || ignored_.has_all(b) || !apart(layers[a], layers[b])) continue;
    if (tests_alike_ || (*this)[a].alike != (*this)[b].alike) --count;
  }
  return count;
}

BodyPair VerifierScene::pair(int a, int b) const {
  return pair_of((*this)[a].rings, (*this)[a].motions, (*this)[b].rings, (*this)[b].motions);
}

double VerifierScene::repeats_from(int a, int b) const {
  const BodyPair bodies = pair(a, b);
  return internal::repeats_from(bodies.motions[0], bodies.motions[1], start_, end_);
}

MotionSegments VerifierScene::segments(const BodyPair& pair) const { return segments_of(pair, start_, end_); }

}  // namespace taut::internal::proof
