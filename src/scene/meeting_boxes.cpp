#include "scene/meeting_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_set>
#include <utility>

#include "geometry/box_tree.hpp"
#include "numeric/budget.hpp"

namespace taut::internal {

bool is_long(const Instance& instance, int a, const AxisBox& box_a, int b, const AxisBox& box_b) {
  const auto size = [&](int k) { return instance.bodies()[static_cast<std::size_t>(k)].rings->diagonal(); };
  return is_long(box_a, box_b, size(a) + size(b));
}

MeetingBoxes::MeetingBoxes(const Instance& instance, const std::vector<int>& bodies, double from, double to)
    : instance_(instance), bodies_(bodies) {
  boxes_.reserve(bodies.size());
  for (const int b : bodies) {
    checkpoint();
    boxes_.push_back(swept_box(instance.bodies()[static_cast<std::size_t>(b)], from, to));
  }
}

void MeetingBoxes::each(const std::function<void(int, int, bool)>& visit) const {
  each(instance_.tests_groups() ? std::vector<int>{} : groups(), visit);
}

void MeetingBoxes::each_moving(const std::function<void(int, int, bool)>& visit) const { each(groups(), visit); }

std::vector<int> MeetingBoxes::groups() const {
  std::vector<int> groups;
  groups.reserve(bodies_.size());
  for (const int b : bodies_) groups.push_back(instance_.bodies()[static_cast<std::size_t>(b)].group);
  return groups;
}

void MeetingBoxes::each(const std::vector<int>& groups, const std::function<void(int, int, bool)>& visit) const {
  BoxTree(boxes_, groups).each_two([&](int i, int j) {
    const auto [first, last] = std::minmax(i, j);
    const int a = bodies_[static_cast<std::size_t>(first)], b = bodies_[static_cast<std::size_t>(last)];
    if (!instance_.asked(a, b)) return;
    visit(a, b,
          is_long(instance_, a, boxes_[static_cast<std::size_t>(first)], b, boxes_[static_cast<std::size_t>(last)]));
  });
}

namespace {

/// Each stretch has a beginning of its own, which costs as much as some time on the way.
constexpr int halvings_of_coarse_windows = 6;

}  // namespace

NearStretches::NearStretches(const Instance& instance) : instance_(instance) {
  std::vector<int> bodies(instance.bodies().size());
  std::iota(bodies.begin(), bodies.end(), 0);
  for (int k = 0; k < coarse_windows; ++k)
    cover(bodies, coarse_boundary(instance, k), coarse_boundary(instance, k + 1), 0);
}

void NearStretches::cover(const std::vector<int>& bodies, double from, double to, int depth) {
  const double middle = from + (to - from) / 2;
  const bool divisible = from < middle && middle < to && depth < halvings_of_coarse_windows;
  std::unordered_set<int> again;
  MeetingBoxes(instance_, bodies, from, to).each([&](int a, int b, bool longer) {
    std::vector<TimeInterval>& own = stretches_[{a, b}];
    // The window around this one was short enough for them.
    if (!own.empty() && own.back().hi >= to) return;
    if (divisible && longer) {
      again.insert({a, b});
    } else if (!own.empty() && own.back().hi == from) {
      own.back().hi = to;
    } else {
      own.push_back({from, to});
    }
  });
  if (again.empty()) return;
  std::vector<int> rest(again.begin(), again.end());
  std::sort(rest.begin(), rest.end());
  cover(rest, from, middle, depth + 1);
  cover(rest, middle, to, depth + 1);
}

namespace {

/// A lower bound of the distance of two boxes.
double distance_of(const AxisBox& a, const AxisBox& b) { return a.distance_to(b) * (1 - 0x1p-45); }

bool all_rest(const Instance& instance) {
  return std::all_of(instance.bodies().begin(), instance.bodies().end(),
                     [](const InstanceBody& body) { return body.motions.empty(); });
}

}  // namespace

CoarseBoxes::CoarseBoxes(const Instance& instance)
    : instance_(instance), windows_(all_rest(instance) ? 1 : coarse_windows) {
  for (std::size_t k = 0; k < windows_.size(); ++k) {
    const int window = static_cast<int>(k);
    for (const InstanceBody& body : instance.bodies()) {
      checkpoint();
      windows_[k].push_back(swept_box(body, coarse_boundary(instance, window), coarse_boundary(instance, window + 1)));
    }
  }
}

std::vector<std::pair<int, int>> CoarseBoxes::pairs_within(double reach) const {
  return pairs_within(std::vector<double>(instance_.bodies().size(), reach / 2));
}

std::vector<std::pair<int, int>> CoarseBoxes::pairs_within(const std::vector<double>& shares) const {
  std::vector<int> groups;
  if (!instance_.tests_groups()) {
    for (const InstanceBody& body : instance_.bodies()) groups.push_back(body.group);
  }
  std::vector<std::pair<int, int>> pairs;
  for (const std::vector<AxisBox>& boxes : windows_) {
    std::vector<AxisBox> in_reach;
    for (std::size_t k = 0; k < boxes.size(); ++k) in_reach.push_back(grown(boxes[k], shares[k]));
    BoxTree(in_reach, groups).each_two([&](int i, int j) {
      if (instance_.asked(i, j)) pairs.emplace_back(std::minmax(i, j));
    });
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

double CoarseBoxes::distance(int a, int b) const {
  double least = INFINITY;
  for (const std::vector<AxisBox>& boxes : windows_)
    least = std::min(least, distance_of(boxes[static_cast<std::size_t>(a)], boxes[static_cast<std::size_t>(b)]));
  return least;
}

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr AxisBox everywhere{-unbounded, -unbounded, unbounded, unbounded};

/// A point's coordinate over the window: the mean value theorem about the middle, or the range itself if that is less.
Ball<double> range_of(const Jet<double>& middle, const Jet<double>& over, double half) {
  const Ball<double> by_slope = middle.v + over.d * Ball<double>(0, half);
  return by_slope.rad <= over.v.rad ? by_slope : over.v;
}

/// While every motion of the chain follows one piece.
AxisBox box_of_pieces(const PieceChain& chain, const AxisBox& bounds, double from, double to) {
  const Point c{(bounds.lo_x + bounds.hi_x) / 2, (bounds.lo_y + bounds.hi_y) / 2};
  const auto [at, range, half] = poses_over(chain, c, from, to);
  const Ball<double> x = range_of(at.ox, range.ox, half), y = range_of(at.oy, range.oy, half);
  double wide = (bounds.hi_x - bounds.lo_x) / 2, high = (bounds.hi_y - bounds.lo_y) / 2;
  if (turns(chain)) wide = high = length(wide, high);
  const double slack = 0x1p-45 * (x.magnitude() + y.magnitude() + wide + high) + displacement_room;
  wide += x.rad + slack;
  high += y.rad + slack;
  if (!(std::isfinite(wide) && std::isfinite(high) && std::isfinite(x.mid) && std::isfinite(y.mid))) return everywhere;
  return {x.mid - wide, y.mid - high, x.mid + wide, y.mid + high};
}

}  // namespace

AxisBox swept_box(const InstanceBody& body, double from, double to) {
  const AxisBox& bounds = body.rings->bounds();
  if (body.motions.empty()) return box_of_pieces({MotionPiece{}}, bounds, from, to);
  AxisBox whole;
  // From joint to joint of any of the motions. Bridges lie between the two boxes that they join.
  for (double t = from;;) {
    PieceChain chain;
    double until = unbounded;
    for (const PieceList& motion : body.motions) {
      chain.push_back(motion.at(t));
      until = std::min(until, chain.back().until);
    }
    whole.include(box_of_pieces(chain, bounds, t, std::min(until, to)));
    // A joint at the very end belongs to this window, bridge and all.
    if (until > to || t >= to) break;
    t = until;
  }
  return whole;
}

double coarse_boundary(const Instance& instance, int k) {
  const double length = instance.end() - instance.start();
  return k == coarse_windows ? instance.end()
                             : std::min(instance.end(), instance.start() + length * k / coarse_windows);
}

ChangingBoxes::ChangingBoxes(std::vector<int> bodies, std::vector<AxisBox> boxes)
    : bodies_(std::move(bodies)), boxes_(std::move(boxes)) {}

std::size_t ChangingBoxes::place(int body) const {
  return static_cast<std::size_t>(std::lower_bound(bodies_.begin(), bodies_.end(), body) - bodies_.begin());
}

bool ChangingBoxes::has(int body) const {
  const std::size_t k = place(body);
  return k < bodies_.size() && bodies_[k] == body;
}

void ChangingBoxes::set(int body, const AxisBox& box) { since_[body] = box; }

void ChangingBoxes::remove(int body) {
  if (has(body)) {
    since_[body] = std::nullopt;
  } else {
    since_.erase(body);
  }
}

const AxisBox& ChangingBoxes::box(int body) const {
  const auto changed = since_.find(body);
  return changed == since_.end() ? boxes_[place(body)] : *changed->second;
}

std::vector<int> ChangingBoxes::find(const AxisBox& box) {
  // Looking through what has changed, and making a tree once in so many changes, then cost about the same.
  if (!tree_ || since_.size() * since_.size() > 64 * (bodies_.size() + 64)) make_tree();
  std::vector<int> found;
  tree_->find(box, found);
  for (int& k : found) k = bodies_[static_cast<std::size_t>(k)];
  if (since_.empty()) return found;
  std::erase_if(found, [&](int body) { return since_.count(body) > 0; });
  for (const auto& [body, changed] : since_) {
    if (changed && changed->meets(box)) found.push_back(body);
  }
  std::sort(found.begin(), found.end());
  return found;
}

void ChangingBoxes::make_tree() {
  std::vector<std::pair<int, AxisBox>> now;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    if (since_.count(bodies_[k]) == 0) now.emplace_back(bodies_[k], boxes_[k]);
  }
  for (const auto& [body, changed] : since_) {
    if (changed) now.emplace_back(body, *changed);
  }
  std::sort(now.begin(), now.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  bodies_.clear();
  boxes_.clear();
  for (const auto& [body, box] : now) {
    bodies_.push_back(body);
    boxes_.push_back(box);
  }
  since_.clear();
  tree_.emplace(boxes_);
}

}  // namespace taut::internal
