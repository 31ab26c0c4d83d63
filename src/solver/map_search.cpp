#include "solver/map_search.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "motion/motion_segments.hpp"
#include "numeric/budget.hpp"
#include "scene/meeting_boxes.hpp"
#include "scene/overlap_witness.hpp"

namespace taut::internal {
namespace {

/// A window is short enough if the mover's box over it is at most this many times longer than at rest.
constexpr double longest_way = 3;
constexpr int deepest_halving = 30;

}  // namespace

MapSearch::MapSearch(const MapBodies& bodies, InstanceBody mover, double start, double end, Offset offset)
    : bodies_(bodies),
      mover_(std::move(mover)),
      start_(start),
      end_(end),
      offset_(offset),
      size_(diagonal(mover_.rings->bounds())),
      stop_(end),
      proved_(start) {}

const SharedSegments& MapSearch::segments(const BodyPair& bodies) {
  SharedSegments& known = segments_[bodies.rings[1] == mover_.rings ? 1 : 0];
  if (!known) known = std::make_shared<const MotionSegments>(segments_of(bodies, start_, end_));
  return known;
}

SpacetimeSolver& MapSearch::pair(int body) {
  std::unique_ptr<SpacetimeSolver>& place = pairs_[body];
  if (!place) {
    BodyPair roles = bodies_with(body);
    const SharedSegments& all = segments(roles);
    place = std::make_unique<SpacetimeSolver>(PairInstance(std::move(roles), all, offset_), offset_, start_, end_);
  }
  return *place;
}

BodyPair MapSearch::bodies_with(int body) const {
  return pair_of(bodies_.rings[static_cast<std::size_t>(body)], {}, mover_.rings, mover_.motions);
}

std::optional<Point> MapSearch::common_point(int body) const {
  for (const auto& [section, pair] : pairs_) {
    if (bodies_.rings[static_cast<std::size_t>(section)]->body() != body) continue;
    if (const auto point = internal::common_point(bodies_with(section), start_)) return point;
  }
  return std::nullopt;
}

std::uint64_t MapSearch::tested() const {
  std::set<int> bodies;
  for (const auto& [section, pair] : pairs_) bodies.insert(bodies_.rings[static_cast<std::size_t>(section)]->body());
  return bodies.size();
}

/// Those that may meet the mover in the box.
std::vector<int> MapSearch::near(const AxisBox& box) const {
  std::vector<int> found;
  bodies_.boxes.find(box, found);
  std::erase_if(found, [this](int k) { return !bodies_.z[static_cast<std::size_t>(k)].meet(mover_.z); });
  return found;
}

bool MapSearch::start() {
  for (const int body : near(swept_box(mover_, start_, start_))) {
    SpacetimeSolver& met = pair(body);
    met.ask_start();
    if (!met.open()) stop_ = start_;
  }
  return stop_ > start_ || start_ == end_;
}

void MapSearch::cover(double from, double to, int depth) {
  checkpoint();
  if (from > stop_) return;
  proved_ = std::max(proved_, from);
  const AxisBox box = swept_box(mover_, from, to);
  if (!bodies_.boxes.any(box)) return;
  const double middle = from + (to - from) / 2;
  if (box.longest() > longest_way * size_ && depth < deepest_halving && from < middle && middle < to) {
    cover(from, middle, depth + 1);
    cover(middle, to, depth + 1);
    return;
  }
  for (const int body : near(box)) {
    if (from > stop_) return;
    SpacetimeSolver& met = pair(body);
    met.ask(from, std::min(to, stop_));
    if (met.result().contact) stop_ = std::min(stop_, met.result().contact->time.hi);
  }
}

}  // namespace taut::internal
