#include "comparison/kinetic_tiling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "comparison/pointed_tiling.hpp"
#include "taut/error.hpp"

namespace taut::paper {

KineticTiling::KineticTiling(const MovingBodies& bodies, double start, double end)
    : bodies_(bodies),
      time_(start),
      end_(end),
      map_(bodies, pointed_tiling(bodies, bodies.positions(start))),
      corners_(static_cast<std::size_t>(map_.size())) {
  for (int h = 0; h < map_.size(); ++h) renew(h);
}

Triple KineticTiling::triple(int h) const { return {map_.origin(map_.previous(h)), map_.origin(h), map_.target(h)}; }

bool KineticTiling::is_mixed(int u, int v, int w) const {
  const int a = bodies_.body_of(u), b = bodies_.body_of(v), c = bodies_.body_of(w);
  return !bodies_.rigid(a, b) || !bodies_.rigid(b, c);
}

bool KineticTiling::is_active(int h) const {
  return !map_.is_inside(h) && is_mixed(map_.origin(map_.previous(h)), map_.origin(h), map_.target(h));
}

void KineticTiling::renew(int h) {
  Corner& corner = corners_[static_cast<std::size_t>(h)];
  ++corner.version;
  active_ -= corner.sign != 0;
  corner.sign = 0;
  if (!is_active(h)) return;
  corner.sign = static_cast<std::int8_t>(triple(h).sign(bodies_, time_));
  if (corner.sign == 0) throw StructureError("three vertices in line at the time of an event");
  ++active_;
  active_max_ = std::max(active_max_, active_);
  schedule(h);
}

void KineticTiling::schedule(int h) {
  const Corner& corner = corners_[static_cast<std::size_t>(h)];
  const Triple three = triple(h);
  double until = end_;
  for (const int v : three.vertices()) until = std::min(until, bodies_.piece_end(bodies_.body_of(v), time_));
  ++failure_times_;
  const double failure = failure_time(bodies_, three.cross(), three.parity() * corner.sign, time_, until, &steps_);
  late_ += failure == time_;
  if (std::isfinite(failure)) {
    queue_.push({failure, h, corner.version, true});
  } else if (until < end_) {
    queue_.push({until, h, corner.version, false});
  }
}

void KineticTiling::drop_stale() {
  while (!queue_.empty() && queue_.top().version != corners_[static_cast<std::size_t>(queue_.top().half_edge)].version)
    queue_.pop();
}

double KineticTiling::next_time() {
  drop_stale();
  return queue_.empty() ? std::numeric_limits<double>::infinity() : queue_.top().time;
}

bool KineticTiling::step() {
  drop_stale();
  if (queue_.empty()) return false;
  const Entry entry = queue_.top();
  queue_.pop();
  time_ = std::max(time_, entry.time);
  if (entry.failure) {
    ++events_;
    repair(entry.half_edge);
  } else {
    schedule(entry.half_edge);
  }
  return true;
}

void KineticTiling::repair(int h) {
  const int p = map_.previous(h);
  const std::array<Point, 3> at = {bodies_.at(map_.origin(p), time_).position,
                                   bodies_.at(map_.origin(h), time_).position,
                                   bodies_.at(map_.target(h), time_).position};
  // Which of the three is between the others.
  const auto is_middle = [&](std::size_t m) {
    const Point &a = at[(m + 1) % 3], &b = at[(m + 2) % 3];
    return (a.x - at[m].x) * (b.x - at[m].x) + (a.y - at[m].y) * (b.y - at[m].y) < 0;
  };
  const bool convex = corners_[static_cast<std::size_t>(h)].sign > 0;
  if (map_.next(map_.next(h)) == p || convex == is_middle(1))
    throw StructureError(fmt::format("a corner of a pseudo-triangle fails as none can, at {}", time_));
  const bool previous = convex ? is_middle(2) : prefers_previous(h);
  if (map_.is_side(previous ? p : h)) throw StructureError(fmt::format("a vertex reaches a side at {}", time_));
  slide(h, previous);
}

/// Of a reflex corner that straightens: which of its edges goes. The one after which fewer certificates are active, or
/// else the longer one.
bool KineticTiling::prefers_previous(int h) const {
  const int p = map_.previous(h);
  if (map_.is_side(p)) return false;
  if (map_.is_side(h)) return true;
  const int one = mixed_after(h, true), other = mixed_after(h, false);
  if (one != other) return one < other;
  const auto length = [this](int g) {
    const Point a = bodies_.at(map_.origin(g), time_).position, b = bodies_.at(map_.target(g), time_).position;
    return std::hypot(a.x - b.x, a.y - b.y);
  };
  return length(p) >= length(h);
}

/// How many of the corners that a slide changes are mixed after it, less those that are before.
int KineticTiling::mixed_after(int h, bool previous) const {
  const int p = map_.previous(h), u = map_.origin(p), v = map_.origin(h), w = map_.target(h);
  const int back = HalfEdges::twin(previous ? p : h);
  const int before_u = map_.origin(map_.previous(p)), after_w = map_.target(map_.next(h));
  const int x = map_.origin(map_.previous(back)), y = map_.target(map_.next(back));
  // In the face that loses v, before and after.
  int change = is_mixed(before_u, u, w) + is_mixed(u, w, after_w) - is_mixed(before_u, u, v) - is_mixed(u, v, w) -
               is_mixed(v, w, after_w);
  // In the face beyond: x, v, u, y becomes x, v, w, u, y; or x, w, v, y becomes x, w, u, v, y.
  if (previous) {
    change += is_mixed(x, v, w) + is_mixed(v, w, u) + is_mixed(w, u, y) - is_mixed(x, v, u) - is_mixed(v, u, y);
  } else {
    change += is_mixed(x, w, u) + is_mixed(w, u, v) + is_mixed(u, v, y) - is_mixed(x, w, v) - is_mixed(w, v, y);
  }
  return change;
}

void KineticTiling::slide(int h, bool previous) {
  const int p = map_.previous(h);
  if (previous) {
    map_.slide_previous(h);
    const int back = HalfEdges::twin(p);
    for (const int corner : {p, map_.next(p), h, back, map_.next(back)}) renew(corner);
  } else {
    map_.slide_this(h);
    const int back = HalfEdges::twin(h);
    for (const int corner : {h, map_.next(h), back, p, map_.next(p)}) renew(corner);
  }
}

std::uint64_t KineticTiling::mixed_edges() const {
  std::uint64_t count = 0;
  for (int h = 0; h < map_.size(); h += 2)
    count += !bodies_.rigid(bodies_.body_of(map_.origin(h)), bodies_.body_of(map_.target(h)));
  return count;
}

std::size_t KineticTiling::bytes() const {
  return map_.bytes() + corners_.capacity() * sizeof(Corner) + queue_.size() * sizeof(Entry);
}

bool KineticTiling::holds(double t) const {
  for (int h = 0; h < map_.size(); ++h) {
    const Corner& corner = corners_[static_cast<std::size_t>(h)];
    if (corner.sign != 0 && triple(h).sign(bodies_, t) != corner.sign) return false;
  }
  return true;
}

}  // namespace taut::paper
