#include "support/world_changes.hpp"

#include <algorithm>
#include <numeric>

namespace taut::testing {
namespace {

bool same_place(const Keyframe& a, const Keyframe& b) {
  return a.way == Way::straight && a.x == b.x && a.y == b.y && a.angle_deg == b.angle_deg;
}

double twice_area(const Polygon& p) {
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point &a = p[i], &b = p[(i + 1) % p.size()];
    twice += (a.x - p[0].x) * (b.y - p[0].y) - (a.y - p[0].y) * (b.x - p[0].x);
  }
  return twice;
}

/// Corner i of the hole is on the ray to corner i of the outline, once both go the same way round from there.
Polygon hole_along_outline(const Part& part) {
  Polygon hole = part.holes[0];
  if ((twice_area(hole) > 0) != (twice_area(part.outline) > 0)) std::reverse(hole.begin(), hole.end());
  const Point& first = part.outline[0];
  const auto distance = [&](const Point& p) { return std::hypot(p.x - first.x, p.y - first.y); };
  const auto nearest = std::min_element(hole.begin(), hole.end(),
                                        [&](const Point& p, const Point& q) { return distance(p) < distance(q); });
  std::rotate(hole.begin(), nearest, hole.end());
  return hole;
}

/// A ring in two arcs, a star around `centre` in two wedges, cut from corner 0 and from corner `at`.
std::vector<Part> cut_in_two(const Part& part, const Point& centre, std::size_t at) {
  const std::size_t n = part.outline.size();
  Polygon first, second;
  for (std::size_t i = 0; i <= at; ++i) first.push_back(part.outline[i]);
  for (std::size_t i = at; i <= n; ++i) second.push_back(part.outline[i % n]);
  if (part.holes.empty()) {
    first.push_back(centre);
    second.push_back(centre);
  } else {
    const Polygon hole = hole_along_outline(part);
    for (std::size_t i = at + 1; i-- > 0;) first.push_back(hole[i]);
    for (std::size_t i = n + 1; i-- > at;) second.push_back(hole[i % n]);
  }
  return {{first, {}, part.z}, {second, {}, part.z}};
}

/// Upright, as written by the worlds on a grid.
bool is_bar(const Polygon& p) {
  return p.size() == 4 && p[0].y == p[1].y && p[1].x == p[2].x && p[2].y == p[3].y && p[3].x == p[0].x;
}

std::vector<Part> halves(const Part& part) {
  const Polygon& p = part.outline;
  const double middle = p[0].x + (p[1].x - p[0].x) / 2;
  return {{{p[0], {middle, p[0].y}, {middle, p[2].y}, p[3]}, {}, part.z},
          {{{middle, p[0].y}, p[1], p[2], {middle, p[2].y}}, {}, part.z}};
}

}  // namespace

MadeWorld cut_at_seams(Rng& rng, const MadeWorld& world, int& count) {
  MadeWorld pieces = world;
  for (MadeBody& body : pieces.bodies) {
    const Part whole = body.parts[0];
    if (body.parts.size() > 1) continue;
    if (is_bar(whole.outline) && whole.holes.empty()) {
      body.parts = halves(whole);
    } else if (is_bar(whole.outline)) {
      // A frame: its hole goes round as its outline does.
      body.parts = cut_in_two(whole, {}, 2);
    } else {
      // The pivot, where it is not the origin, is the star's centre.
      if (whole.holes.empty() && (body.pivot == Point{} || whole.outline.size() < 4)) continue;
      if (body.pivot == whole.outline[0]) continue;
      const int n = static_cast<int>(whole.outline.size());
      body.parts = cut_in_two(whole, body.pivot, static_cast<std::size_t>(rng.between(1, n - 1)));
    }
    ++count;
  }
  return pieces;
}

MadeWorld carried_as_a_whole(Rng& rng, const MadeWorld& world) {
  MadeWorld carried = world;
  MadeBody carrier;
  carrier.name = "carrier";
  carrier.parts = {star_part(rng, {0, 0}, 1, 0)};
  carrier.keyframes = random_keyframes(rng, world.end, 5, {0, 0});
  const int index = static_cast<int>(carried.bodies.size());
  for (MadeBody& body : carried.bodies) {
    if (body.parent < 0) body.parent = index;
  }
  carried.bodies.push_back(carrier);
  carried.ignore.push_back({index, -1});
  return carried;
}

MadeWorld with_far_bodies(std::uint64_t seed, const MadeWorld& world) {
  MadeWorld larger = world;
  for (int i = 0; i < 3; ++i) {
    Rng rng(seed + static_cast<std::uint64_t>(i));
    const Point at{500.0 + 100 * i, -300};
    MadeBody far;
    far.name = "far" + std::to_string(i);
    far.parts = {star_part(rng, at, 2, 0.5)};
    far.pivot = at;
    if (i > 0) far.keyframes = random_keyframes(rng, world.end, 5, at);
    larger.bodies.push_back(far);
  }
  return larger;
}

MadeWorld in_another_order(Rng& rng, const MadeWorld& world) {
  const std::size_t n = world.bodies.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = n; i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(rng.below(static_cast<int>(i)))]);
  std::vector<int> place(n);
  for (std::size_t i = 0; i < n; ++i) place[order[i]] = static_cast<int>(i);
  const auto moved = [&](int old) { return old < 0 ? old : place[static_cast<std::size_t>(old)]; };
  MadeWorld other = world;
  for (std::size_t i = 0; i < n; ++i) {
    other.bodies[i] = world.bodies[order[i]];
    other.bodies[i].parent = moved(other.bodies[i].parent);
  }
  for (auto& pair : other.ignore) pair = {moved(pair[0]), moved(pair[1])};
  return other;
}

std::optional<MadeWorld> seen_from_a_moving_frame(Rng& rng, const MadeWorld& world) {
  const Point v{static_cast<double>(rng.between(-2, 2)), static_cast<double>(rng.between(-2, 2))};
  MadeWorld seen = world;
  for (MadeBody& body : seen.bodies) {
    if (body.parent >= 0) continue;
    // One that rests does so by two keyframes, whichever it had: bodies that rest move as one then, too, and are not
    // asked about.
    const auto rests = [&](const Keyframe& k) { return same_place(k, body.keyframes.front()); };
    if (std::all_of(body.keyframes.begin(), body.keyframes.end(), rests)) {
      body.keyframes.resize(2);
      body.keyframes[0].t = 0;
      body.keyframes[1] = body.keyframes[0];
      body.keyframes[1].t = world.end;
    }
    for (Keyframe& k : body.keyframes) {
      if (k.way != taut::Way::straight) return std::nullopt;
      k.x -= v.x * k.t;
      k.y -= v.y * k.t;
    }
  }
  return seen;
}

}  // namespace taut::testing
