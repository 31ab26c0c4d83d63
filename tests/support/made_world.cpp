#include "support/made_world.hpp"

#include <algorithm>

namespace taut::testing {

MadeBody transformed(MadeBody body, Transform change, bool mirrors, const Point& by) {
  const auto place = [&](Point& p) {
    p = change(p);
    p.x += by.x;
    p.y += by.y;
  };
  place(body.pivot);
  for (Part& part : body.parts) {
    std::for_each(part.outline.begin(), part.outline.end(), place);
    for (Polygon& hole : part.holes) std::for_each(hole.begin(), hole.end(), place);
  }
  for (Keyframe& k : body.keyframes) {
    place(k.centre);
    const Point way = change({k.x, k.y});
    k.x = way.x;
    k.y = way.y;
    if (mirrors) {
      k.angle_deg = -k.angle_deg;
      k.by_deg = -k.by_deg;
    }
  }
  return body;
}

Scene scene_of(const MadeWorld& world) {
  Scene scene;
  scene.end = world.end;
  for (const MadeBody& made : world.bodies) {
    Body body;
    body.name = made.name;
    body.z = made.z;
    if (made.parts.size() == 1 && made.parts[0].holes.empty() && !made.parts[0].z)
      body.polygon = made.parts[0].outline;
    else
      body.parts = made.parts;
    if (!made.keyframes.empty()) body.motion = from_keyframes(made.keyframes, made.pivot);
    if (made.parent >= 0) body.relative_to = world.bodies[static_cast<std::size_t>(made.parent)].name;
    scene.bodies.push_back(body);
  }
  const auto name = [&](int i) { return i < 0 ? std::string("*") : world.bodies[static_cast<std::size_t>(i)].name; };
  for (const auto& pair : world.ignore) {
    if (pair[0] != pair[1]) scene.ignore.push_back({name(pair[0]), name(pair[1])});
  }
  return scene;
}

namespace {

/// Where the pivot is, and by how many degrees the body is turned.
struct PivotPlace {
  Complex at;
  double deg = 0;
};

Complex unit(double deg) { return std::polar(1.0, deg * std::acos(-1.0) / 180); }

/// From `from`, a share of the way to the keyframe.
PivotPlace on_the_way(const PivotPlace& from, const Keyframe& to, double share, const Complex& pivot) {
  if (to.way == Way::straight) {
    const Complex end = pivot + Complex(to.x, to.y);
    return {from.at + share * (end - from.at), from.deg + share * (to.angle_deg - from.deg)};
  }
  const Complex centre(to.centre.x, to.centre.y);
  return {centre + unit(share * to.by_deg) * (from.at - centre),
          from.deg + (to.way == Way::turn ? share * to.by_deg : 0)};
}

MadePose own_pose(const MadeBody& body, double t) {
  if (body.keyframes.empty()) return {};
  const Complex pivot(body.pivot.x, body.pivot.y);
  PivotPlace place = on_the_way({pivot, 0}, body.keyframes[0], 1, pivot);
  for (std::size_t k = 1; k < body.keyframes.size() && t > body.keyframes[k - 1].t; ++k) {
    const double from = body.keyframes[k - 1].t, to = body.keyframes[k].t;
    place = on_the_way(place, body.keyframes[k], std::min(1.0, (t - from) / (to - from)), pivot);
  }
  const Complex x = unit(place.deg);
  return {place.at - x * pivot, x};
}

}  // namespace

MadePose pose_of(const MadeWorld& world, int body, double t) {
  const MadeBody& made = world.bodies[static_cast<std::size_t>(body)];
  const MadePose own = own_pose(made, t);
  if (made.parent < 0) return own;
  const MadePose frame = pose_of(world, made.parent, t);
  return {frame.o + frame.x * own.o, frame.x * own.x};
}

BodyAtPose posed(const MadeWorld& world, int body, double t) {
  const MadePose pose = pose_of(world, body, t);
  const auto ring = [&](const Polygon& polygon) {
    RingAtPose points;
    for (const Point& p : polygon) points.push_back(pose.at(p));
    return points;
  };
  BodyAtPose result;
  const MadeBody& made = world.bodies[static_cast<std::size_t>(body)];
  for (const Part& part : made.parts) {
    PartAtPose at_pose{{ring(part.outline)}, part.z.value_or(made.z)};
    for (const Polygon& hole : part.holes) at_pose.rings.push_back(ring(hole));
    result.push_back(at_pose);
  }
  return result;
}

namespace {

double cross_of(const Complex& a, const Complex& b) { return (std::conj(a) * b).imag(); }

/// How far c lies to the left of the line from a to b.
double left_of(const Complex& a, const Complex& b, const Complex& c) {
  return cross_of(b - a, c - a) / std::abs(b - a);
}

}  // namespace

double to_segment(const Complex& p, const Complex& a, const Complex& b) {
  const Complex d = b - a;
  const double share = std::clamp((std::conj(d) * (p - a)).real() / std::norm(d), 0.0, 1.0);
  return std::abs(p - (a + share * d));
}

namespace {

template <class Visit>
void each_edge(const PartAtPose& part, Visit visit) {
  for (const RingAtPose& ring : part.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
  }
}

/// Do the two edges cross, each end farther than the margin from the other one's line?
bool cross_clearly(const Complex& a, const Complex& b, const Complex& c, const Complex& d, double margin) {
  const double l = left_of(a, b, c), m = left_of(a, b, d), n = left_of(c, d, a), o = left_of(c, d, b);
  return std::min(std::fabs(l), std::fabs(m)) > margin && std::min(std::fabs(n), std::fabs(o)) > margin &&
         (l > 0) != (m > 0) && (n > 0) != (o > 0);
}

/// Inside the part, and farther than the margin from its rings? Rings are counted by turns, in either orientation.
bool lies_clearly_inside(const PartAtPose& part, const Complex& p, double margin) {
  bool near = false;
  each_edge(part, [&](const Complex& a, const Complex& b) { near = near || to_segment(p, a, b) <= margin; });
  if (near) return false;
  const auto winds = [&](const RingAtPose& ring) {
    double turned = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) turned += std::arg((ring[(i + 1) % ring.size()] - p) / (ring[i] - p));
    return std::fabs(turned) > 3;
  };
  return winds(part.rings[0]) && std::none_of(part.rings.begin() + 1, part.rings.end(), winds);
}

/// Parts that have an edge crossed, or a vertex of the other one inside, overlap it.
bool parts_overlap_clearly(const PartAtPose& p, const PartAtPose& q, double margin) {
  bool crossing = false;
  each_edge(p, [&](const Complex& a, const Complex& b) {
    each_edge(q, [&](const Complex& c, const Complex& d) { crossing = crossing || cross_clearly(a, b, c, d, margin); });
  });
  if (crossing) return true;
  const auto has_vertex_of = [&](const PartAtPose& outer, const PartAtPose& inner) {
    return std::any_of(inner.rings[0].begin(), inner.rings[0].end(),
                       [&](const Complex& v) { return lies_clearly_inside(outer, v, margin); });
  };
  return has_vertex_of(p, q) || has_vertex_of(q, p);
}

}  // namespace

namespace {

/// By definition, of two intervals of heights.
bool share_layer(const PartAtPose& a, const PartAtPose& b) { return a.z.lo < b.z.hi && b.z.lo < a.z.hi; }

}  // namespace

bool overlap_clearly(const BodyAtPose& p, const BodyAtPose& q, double margin) {
  for (const PartAtPose& a : p) {
    for (const PartAtPose& b : q) {
      if (share_layer(a, b) && parts_overlap_clearly(a, b, margin)) return true;
    }
  }
  return false;
}

double between_rings(const BodyAtPose& p, const BodyAtPose& q) {
  double least = INFINITY;
  const auto from_vertices = [&](const BodyAtPose& vertices, const BodyAtPose& edges) {
    for (const PartAtPose& part : vertices) {
      for (const PartAtPose& other : edges) {
        if (!share_layer(part, other)) continue;
        each_edge(part, [&](const Complex& v, const Complex&) {
          each_edge(other, [&](const Complex& a, const Complex& b) { least = std::min(least, to_segment(v, a, b)); });
        });
      }
    }
  };
  from_vertices(p, q);
  from_vertices(q, p);
  return least;
}

double sixteenths(Rng& rng, double lo, double hi) {
  return rng.between(static_cast<int>(lo * 16), static_cast<int>(hi * 16)) / 16.0;
}

namespace {

/// Directions in order around, no gap of half a turn.
std::vector<Complex> star_directions(Rng& rng, int n) {
  std::vector<Complex> directions;
  const double begin = rng.real(0, 360);
  for (int i = 0; i < n; ++i) directions.push_back(unit(begin + 360 * (i + rng.real(0, 0.4)) / n));
  return directions;
}

Polygon star_ring(const std::vector<Complex>& directions, const std::vector<double>& radii, const Point& centre) {
  Polygon ring;
  for (std::size_t i = 0; i < directions.size(); ++i)
    ring.push_back({centre.x + radii[i] * directions[i].real(), centre.y + radii[i] * directions[i].imag()});
  return ring;
}

std::vector<double> random_radii(Rng& rng, std::size_t n, double lo, double hi) {
  std::vector<double> radii;
  for (std::size_t i = 0; i < n; ++i) radii.push_back(rng.real(lo, hi));
  return radii;
}

}  // namespace

Part star_part(Rng& rng, const Point& centre, double radius, double hole) {
  const auto directions = star_directions(rng, rng.between(hole > 0 ? 5 : 3, 7));
  const auto radii = random_radii(rng, directions.size(), hole > 0 ? 0.85 * radius : 0.5 * radius, radius);
  Part part{star_ring(directions, radii, centre), {}};
  if (hole > 0) {
    auto inner = radii;
    for (double& r : inner) r *= hole;
    part.holes.push_back(star_ring(directions, inner, centre));
    if (rng.chance(0.5)) std::reverse(part.holes[0].begin(), part.holes[0].end());
  }
  if (rng.chance(0.3)) std::reverse(part.outline.begin(), part.outline.end());
  return part;
}

std::vector<Keyframe> random_keyframes(Rng& rng, double end, double reach, const Point& at) {
  Keyframe last;
  if (rng.chance(0.1)) last = {0, sixteenths(rng, -3, 3), sixteenths(rng, -3, 3), 0};
  std::vector<Keyframe> keyframes{last};
  const int segments = rng.between(1, 3);
  for (int i = 1; i <= segments; ++i) {
    Keyframe k;
    k.t = end * i / segments;
    k.way = rng.pick(std::vector<Way>{Way::straight, Way::straight, Way::turn, Way::arc});
    // A straight segment after one around a centre has no jump: its place is that of its end.
    k.x = sixteenths(rng, -reach, reach);
    k.y = sixteenths(rng, -reach, reach);
    k.angle_deg = rng.chance(0.5) ? last.angle_deg : rng.between(-120, 120);
    k.centre = {at.x + sixteenths(rng, -reach, reach), at.y + sixteenths(rng, -reach, reach)};
    k.by_deg = rng.between(-150, 150);
    if (k.way != Way::straight) k.x = k.y = k.angle_deg = 0;
    keyframes.push_back(last = k);
  }
  return keyframes;
}

namespace {

MadeBody random_body(Rng& rng, const Point& at, const std::string& name, double hole) {
  MadeBody body;
  body.name = name;
  const double radius = rng.real(0.6, 1.6);
  if (hole > 0) {
    body.parts = {star_part(rng, at, 1.9, hole)};
  } else {
    const int parts = rng.chance(0.25) ? rng.between(2, 3) : 1;
    for (int i = 0; i < parts; ++i) {
      const Point off = i == 0 ? at : Point{at.x + rng.real(-1, 1), at.y + rng.real(-1, 1)};
      body.parts.push_back(star_part(rng, off, i == 0 ? radius : 0.7, 0));
    }
  }
  body.pivot = rng.chance(0.7) ? at : Point{};
  return body;
}

}  // namespace

MadeWorld random_way(Rng& rng) {
  MadeWorld world;
  world.end = 2;
  const int links = rng.between(1, 2);
  for (int k = 0; k < links; ++k) {
    MadeBody body;
    body.name = "link" + std::to_string(k);
    body.parts = {star_part(rng, {rng.real(-0.3, 0.3), 0}, rng.real(0.2, 1), rng.chance(0.3) ? 0.6 : 0)};
    if (rng.chance(0.3)) body.parts.push_back(star_part(rng, {1.5, 0.5}, 0.4, 0));
    body.keyframes = random_keyframes(rng, 2, 3, {});
    body.parent = k - 1;
    world.bodies.push_back(body);
  }
  return world;
}

MadeWorld random_world(std::uint64_t seed) {
  Rng rng(seed);
  MadeWorld world;
  const int n = rng.between(2, 12);
  const double moving = rng.real(0.3, 0.9), reach = rng.real(1, 6);
  for (int cell = 0; static_cast<int>(world.bodies.size()) < n; ++cell) {
    const Point at{-6.0 + 4 * (cell % 4), -4.0 + 4 * (cell / 4)};
    const bool ring = rng.chance(0.25);
    const auto add = [&](MadeBody body) {
      const int index = static_cast<int>(world.bodies.size());
      if (rng.chance(moving)) body.keyframes = random_keyframes(rng, world.end, reach, at);
      if (index > 0 && rng.chance(0.3)) body.parent = rng.below(index);
      world.bodies.push_back(body);
    };
    add(random_body(rng, at, "b" + std::to_string(world.bodies.size()), ring ? 0.75 : 0));
    if (ring && rng.chance(0.6)) {
      MadeBody inner;
      inner.name = "in" + std::to_string(world.bodies.size());
      inner.parts = {star_part(rng, at, 0.4, 0)};
      inner.pivot = at;
      add(inner);
      // It stays in the ring, and is now and then carried by it.
      if (rng.chance(0.5)) {
        const MadeBody& host = world.bodies[world.bodies.size() - 2];
        world.bodies.back().parent = rng.chance(0.5) ? static_cast<int>(world.bodies.size()) - 2 : host.parent;
        world.bodies.back().keyframes = rng.chance(0.5) ? host.keyframes : std::vector<Keyframe>{};
      }
    }
  }
  if (rng.chance(0.4)) {
    const int count = static_cast<int>(world.bodies.size());
    world.ignore.push_back({rng.below(count), rng.chance(0.2) ? -1 : rng.below(count)});
  }
  return world;
}

}  // namespace taut::testing
