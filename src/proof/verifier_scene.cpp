#include "proof/verifier_scene.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>

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
  for (const Body& body : scene.bodies) {
    const int index = size();
    bodies_.push_back({std::make_shared<const RingSet>(body, index, exponent_), {}, index});
  }
  add_motions(scene);
  find_alike();
  std::set<int> motions;
  for (int i = 0; i < size(); ++i) {
    if (!ignored_.has_all(i)) motions.insert((*this)[i].alike);
  }
  tests_alike_ = motions.size() <= 1 || scene.at_rest == AtRest::test;
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
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    MotionChain& chain = bodies_[i].motions;
    for (int k = static_cast<int>(i); k >= 0; k = parent[static_cast<std::size_t>(k)]) {
      if (!own[static_cast<std::size_t>(k)].rests()) chain.push_back(own[static_cast<std::size_t>(k)]);
    }
    std::reverse(chain.begin(), chain.end());
  }
}

bool VerifierScene::asked(int a, int b) const {
  return ((*this)[a].alike != (*this)[b].alike || tests_alike_) && !ignored_.has(a, b);
}

Coverage VerifierScene::coverage() const {
  Coverage count;
  // Of each body, how many before it are not ignored by all; of these, how many move alike.
  std::uint64_t heard = 0, before = 0;
  std::map<int, std::uint64_t> alike_before;
  const auto alike = [&](int body) -> std::uint64_t& {
    return (*this)[body].rests() ? count.at_rest : count.moving_alike;
  };
  for (int body = 0; body < size(); ++body) {
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
  count.tested -= count.at_rest + count.moving_alike;
  return count;
}

BodyPair VerifierScene::pair(int a, int b) const {
  return pair_of((*this)[a].rings, (*this)[a].motions, (*this)[b].rings, (*this)[b].motions);
}

MotionSegments VerifierScene::segments(const BodyPair& pair) const { return segments_of(pair, start_, end_); }

}  // namespace taut::internal::proof
