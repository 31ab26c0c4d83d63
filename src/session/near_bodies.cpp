#include "session/near_bodies.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <iterator>

#include "certificate/root.hpp"
#include "geometry/displacement.hpp"
#include "motion/pose.hpp"
#include "numeric/budget.hpp"

namespace taut::internal {
namespace {

/// A box that meets another one may be so much longer than the body itself.
constexpr double longest_share = 1.5;

}  // namespace

/// Of all boxes. It computes areas: coordinates beyond 2^300 are moved there, after which no fewer boxes meet.
class NearBodies::Tree {
 public:
  void insert(int body, const AxisBox& box) { tree_.insert({bounded(box), body}); }
  void remove(int body, const AxisBox& box) { tree_.remove({bounded(box), body}); }
  std::vector<int> find(const AxisBox& box) const {
    std::vector<int> found;
    for (auto it = tree_.qbegin(boost::geometry::index::intersects(bounded(box))); it != tree_.qend(); ++it)
      found.push_back(it->second);
    std::sort(found.begin(), found.end());
    return found;
  }
  /// Does the box meet one that is wanted?
  template <class Wanted>
  bool find_one(const AxisBox& box, const Wanted& wanted) const {
    for (auto it = tree_.qbegin(boost::geometry::index::intersects(bounded(box))); it != tree_.qend(); ++it) {
      if (wanted(it->second)) return true;
    }
    return false;
  }

 private:
  using Corner = boost::geometry::model::d2::point_xy<double>;
  using Rectangle = boost::geometry::model::box<Corner>;

  static Rectangle bounded(const AxisBox& box) {
    const auto near = [](double x) { return std::clamp(x, -0x1p300, 0x1p300); };
    return {{near(box.lo_x), near(box.lo_y)}, {near(box.hi_x), near(box.hi_y)}};
  }

  boost::geometry::index::rtree<std::pair<Rectangle, int>, boost::geometry::index::quadratic<16>> tree_;
};

/// Around the middle of the bounds, with room for the displacement.
NearBodies::Disc NearBodies::disc_around(const RingSet& rings) {
  const AxisBox& bounds = rings.bounds();
  Disc disc{{(bounds.lo_x + bounds.hi_x) / 2, (bounds.lo_y + bounds.hi_y) / 2}, 0};
  for (std::size_t k = 0; k < rings.rings().size(); ++k) {
    for (const Point& p : rings.points(k))
      disc.radius = std::max(disc.radius, length(p.x - disc.centre.x, p.y - disc.centre.y));
  }
  const double rounding = 0x1p-50 * (std::fabs(disc.centre.x) + std::fabs(disc.centre.y));
  disc.radius = disc.radius * (1 + 0x1p-40) + rounding + displacement_room;
  return disc;
}

NearBodies::NearBodies(const Instance& instance)
    : instance_(instance),
      single_(instance.is_single_pair()),
      near_(instance.bodies().size()),
      latest_(instance.start()),
      tree_(std::make_unique<Tree>()) {
  if (single_) {
    if (instance.excluded(0, 1)) return;
    near_[0] = {1};
    near_[1] = {0};
    return;
  }
  boxes_.resize(near_.size());
  for (const InstanceBody& body : instance.bodies()) discs_.push_back(disc_around(*body.rings));
  for (std::size_t k = 0; k < boxes_.size(); ++k) {
    const int body = static_cast<int>(k);
    boxes_[k].length = instance.end() - instance.start();
    place(body, box_of(body, instance.start(), false));
  }
  for (std::size_t k = 0; k < boxes_.size(); ++k) {
    const int body = static_cast<int>(k);
    if (!(boxes_[k].to < instance.end())) continue;
    lift(body);
    place(body, box_of(body, instance.start(), true));
  }
  Changes ignored;
  for (std::size_t k = 0; k < boxes_.size(); ++k) find_near(static_cast<int>(k), ignored);
}

NearBodies::~NearBodies() = default;

std::vector<NearBodies::Pair> NearBodies::pairs() const {
  std::vector<Pair> all;
  for (std::size_t a = 0; a < near_.size(); ++a) {
    for (const int b : near_[a]) {
      if (static_cast<int>(a) < b) all.emplace_back(static_cast<int>(a), b);
    }
  }
  return all;
}

double NearBodies::until() const { return ends_.empty() ? never : ends_.begin()->first; }

bool NearBodies::may_meet(int a, int b) const {
  if (a == b || instance_.excluded(a, b)) return false;
  const std::vector<InstanceBody>& bodies = instance_.bodies();
  return bodies[static_cast<std::size_t>(a)].group != bodies[static_cast<std::size_t>(b)].group;
}

bool NearBodies::meets_any(int body, const AxisBox& box) const {
  return tree_->find_one(box, [&](int other) { return may_meet(body, other); });
}

std::vector<int> NearBodies::met_by(int body, const AxisBox& box) const {
  std::vector<int> met = tree_->find(box);
  std::erase_if(met, [&](int other) { return !may_meet(body, other); });
  return met;
}

bool NearBodies::is_short(int body, const AxisBox& box) const {
  return box.longest() <= longest_share * instance_.bodies()[static_cast<std::size_t>(body)].rings->diagonal();
}

double NearBodies::shortest_time() const {
  return std::ldexp(instance_.end() - instance_.start(), -most_window_halvings);
}

NearBodies::Box NearBodies::box_until(int body, double from, double to) const {
  checkpoint();
  const InstanceBody& moving = instance_.bodies()[static_cast<std::size_t>(body)];
  return {swept_box(moving, std::max(from, moving.born), to), from, to, Way(),
          boxes_[static_cast<std::size_t>(body)].length};
}

/// If it may be `alone`, a box that meets no other one may be long, even until the end. Otherwise twice the time of the
/// last short box is halved until the box is short.
NearBodies::Box NearBodies::box_of(int body, double from, bool alone) const {
  const auto will_do = [&](const Box& box) { return is_short(body, box.box) || (alone && !meets_any(body, box.box)); };
  const double end = instance_.end(), shortest = shortest_time();
  if (alone) {
    const Box whole = box_until(body, from, end);
    if (will_do(whole)) return whole;
  }
  double length = std::min(2 * boxes_[static_cast<std::size_t>(body)].length, end - from);
  for (;; length /= 2) {
    Box box = box_until(body, from, std::min(end, std::max(from + length, std::nextafter(from, never))));
    box.length = length;
    if (length <= shortest || will_do(box)) return box;
  }
}

/// From its middle, with a bound of how much the second derivative makes of it. Only while the body and its parents
/// follow one piece each, and no joint comes at the end. A change of motion begins a box one ulp before: that is the
/// jump which apart_until() asks for.
NearBodies::Way NearBodies::way_of(int body, double from, double to) const {
  const InstanceBody& moving = instance_.bodies()[static_cast<std::size_t>(body)];
  from = std::max(from, moving.born);
  const double next = std::nextafter(from, never);
  PieceChain chain;
  bool joins = false;
  for (const PieceList& motion : moving.motions) {
    if (motion.at(from).until == next) from = next;
  }
  for (const PieceList& motion : moving.motions) {
    chain.push_back(motion.at(from));
    joins = joins || chain.back().until <= to;
  }
  if (chain.empty()) chain.emplace_back();
  Way way;
  way.error = never;
  if (joins) return way;
  const auto [at, over, half_time] = poses_over(chain, discs_[static_cast<std::size_t>(body)].centre, from, to);
  const double half = half_time;
  const auto error = [half](const Jet<double>& middle, const Jet<double>& range) {
    return middle.v.rad + middle.d.rad * half + range.dd.magnitude() * half * half;
  };
  way = {from + (to - from) / 2, at.ox.v.mid, at.oy.v.mid, at.ox.d.mid, at.oy.d.mid, 0};
  way.error = error(at.ox, over.ox) + error(at.oy, over.oy);
  if (!std::isfinite(way.error) || !std::isfinite(way.x + way.y + way.vx + way.vy)) way.error = never;
  return way;
}

/// Solves |p + v t| = r for the distance p of the centres: where rounding might matter, r has room for it.
double NearBodies::apart_until(int a, int b, double from, double jump) const {
  if (single_) return from;
  const Box &first = boxes_[static_cast<std::size_t>(a)], &second = boxes_[static_cast<std::size_t>(b)];
  const Way &p = first.way, &q = second.way;
  const double to = std::min(first.to, second.to);
  const double sp = from - p.about, sq = from - q.about;
  const double x = (p.x + p.vx * sp) - (q.x + q.vx * sq), y = (p.y + p.vy * sp) - (q.y + q.vy * sq);
  const double vx = p.vx - q.vx, vy = p.vy - q.vy;
  const double magnitude = std::fabs(p.x) + std::fabs(p.y) + std::fabs(q.x) + std::fabs(q.y) +
                           (std::fabs(p.vx) + std::fabs(p.vy)) * std::fabs(sp) +
                           (std::fabs(q.vx) + std::fabs(q.vy)) * std::fabs(sq) +
                           (std::fabs(vx) + std::fabs(vy)) * (to - from);
  const double r = discs_[static_cast<std::size_t>(a)].radius + discs_[static_cast<std::size_t>(b)].radius + p.error +
                   q.error + 2 * jump + 0x1p-40 * magnitude;
  const double gap = x * x + y * y - r * r, closing = -(x * vx + y * vy), square = vx * vx + vy * vy;
  if (!(to > from) || !(gap > 0x1p-20 * (x * x + y * y))) return from;
  if (closing <= 0) return to;
  const double root = closing * closing - square * gap;
  if (root < 0) return to;
  return std::min(to, from + gap / (closing + std::sqrt(root)) * (1 - 0x1p-30));
}

void NearBodies::place(int body, Box box) {
  box.way = way_of(body, box.from, box.to);
  boxes_[static_cast<std::size_t>(body)] = box;
  tree_->insert(body, box.box);
  if (box.to < instance_.end()) ends_.insert({box.to, body});
}

void NearBodies::lift(int body) {
  const Box& box = boxes_[static_cast<std::size_t>(body)];
  tree_->remove(body, box.box);
  ends_.erase({box.to, body});
}

void NearBodies::renew(const std::vector<int>& bodies, double from, Changes& changes) {
  for (const int body : bodies) lift(body);
  box_anew(bodies, from, changes);
}

/// Of bodies without boxes. All boxes are made before any pair is looked for. What is in the way of a long box shortens
/// it.
void NearBodies::box_anew(const std::vector<int>& bodies, double from, Changes& changes) {
  latest_ = std::max(latest_, from);
  std::vector<int> renewed = bodies;
  for (const int body : bodies) place(body, box_of(body, from, true));
  for (std::size_t k = 0; k < renewed.size(); ++k) {
    for (const int other : met_by(renewed[k], boxes_[static_cast<std::size_t>(renewed[k])].box)) {
      const Box& box = boxes_[static_cast<std::size_t>(other)];
      if (is_short(other, box.box) || box.to - box.from <= shortest_time()) continue;
      lift(other);
      place(other, box_of(other, from, false));
      renewed.push_back(other);
    }
  }
  for (const int body : renewed) find_near(body, changes);
  changes.renewed = std::move(renewed);
}

void NearBodies::find_near(int body, Changes& changes) {
  const std::vector<int> met = met_by(body, boxes_[static_cast<std::size_t>(body)].box);
  std::vector<int>& near = near_[static_cast<std::size_t>(body)];
  std::vector<int> come, gone;
  std::set_difference(met.begin(), met.end(), near.begin(), near.end(), std::back_inserter(come));
  std::set_difference(near.begin(), near.end(), met.begin(), met.end(), std::back_inserter(gone));
  const auto pair = [body](int other) { return Pair(std::min(body, other), std::max(body, other)); };
  for (const int other : come) {
    bring(other, body);
    changes.come.push_back(pair(other));
  }
  for (const int other : gone) {
    std::erase(near_[static_cast<std::size_t>(other)], body);
    changes.gone.push_back(pair(other));
  }
  near = met;
}

void NearBodies::bring(int body, int other) {
  std::vector<int>& near = near_[static_cast<std::size_t>(body)];
  near.insert(std::lower_bound(near.begin(), near.end(), other), other);
}

NearBodies::Changes NearBodies::renew() {
  const double from = until();
  std::vector<int> ended;
  for (auto it = ends_.begin(); it != ends_.end() && it->first == from; ++it) ended.push_back(it->second);
  Changes changes;
  renew(ended, from, changes);
  return changes;
}

NearBodies::Changes NearBodies::change(const std::vector<int>& changed, double from) {
  Changes changes;
  if (single_) return changes;
  std::vector<int> renewed = changed;
  for (std::size_t k = 0; latest_ > from && k < boxes_.size(); ++k) {
    if (boxes_[k].from > from) renewed.push_back(static_cast<int>(k));
  }
  std::sort(renewed.begin(), renewed.end());
  renewed.erase(std::unique(renewed.begin(), renewed.end()), renewed.end());
  latest_ = from;
  renew(renewed, from, changes);
  return changes;
}

NearBodies::Changes NearBodies::add(double from) {
  const int body = static_cast<int>(near_.size());
  near_.emplace_back();
  discs_.push_back(disc_around(*instance_.bodies().back().rings));
  boxes_.emplace_back();
  boxes_.back().length = instance_.end() - from;
  Changes changes;
  box_anew({body}, from, changes);
  return changes;
}

NearBodies::Changes NearBodies::remove(int body) {
  Changes changes;
  lift(body);
  boxes_[static_cast<std::size_t>(body)].from = -never;
  for (const int other : near_[static_cast<std::size_t>(body)]) {
    std::erase(near_[static_cast<std::size_t>(other)], body);
    changes.gone.emplace_back(std::min(body, other), std::max(body, other));
  }
  near_[static_cast<std::size_t>(body)].clear();
  return changes;
}

void NearBodies::remove_last() {
  remove(static_cast<int>(near_.size()) - 1);
  near_.pop_back();
  discs_.pop_back();
  boxes_.pop_back();
}

void NearBodies::part(int a, int b) {
  std::erase(near_[static_cast<std::size_t>(a)], b);
  std::erase(near_[static_cast<std::size_t>(b)], a);
}

std::vector<int> NearBodies::alike_at(int body, double t) const {
  const std::vector<InstanceBody>& bodies = instance_.bodies();
  const InstanceBody& one = bodies[static_cast<std::size_t>(body)];
  std::vector<int> alike = tree_->find(swept_box(one, t, t));
  std::erase_if(alike, [&](int other) {
    return other == body || bodies[static_cast<std::size_t>(other)].group != one.group ||
           instance_.excluded(body, other);
  });
  return alike;
}

}  // namespace taut::internal
