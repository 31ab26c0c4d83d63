#include "support/closed_linkage.hpp"

#include <cmath>

namespace taut::testing {
namespace {

LongPoint operator+(const LongPoint& a, const LongPoint& b) { return {a.x + b.x, a.y + b.y}; }
LongPoint operator-(const LongPoint& a, const LongPoint& b) { return {a.x - b.x, a.y - b.y}; }
LongPoint operator*(const Long& s, const LongPoint& a) { return {s * a.x, s * a.y}; }
LongPoint product(const LongPoint& a, const LongPoint& b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }
LongPoint quotient(const LongPoint& a, const LongPoint& b) {
  const Long square = b.x * b.x + b.y * b.y;
  return {(a.x * b.x + a.y * b.y) / square, (a.y * b.x - a.x * b.y) / square};
}
Long dot(const LongPoint& a, const LongPoint& b) { return a.x * b.x + a.y * b.y; }
Long cross(const LongPoint& a, const LongPoint& b) { return a.x * b.y - a.y * b.x; }
LongPoint of(const Point& p) { return {Long(p.x), Long(p.y)}; }

}  // namespace

int ClosedLinkage::add_body(const std::string& name, const Point& at) {
  Body body;
  body.name = name;
  body.polygon = {at, {at.x + 1, at.y}, {at.x, at.y + 1}};
  scene_.bodies.push_back(std::move(body));
  return static_cast<int>(scene_.bodies.size()) - 1;
}

ClosedLinkage::ClosedLinkage(Rng& rng, int dyads) : speed_(rng.sign() * rng.real(20, 360)) {
  scene_.end = 1;
  const int ground = add_body("ground", {-1, -1});
  const int crank = add_body("crank", {1, 1});
  Mechanism mechanism;
  mechanism.ground = "ground";
  MechanismJoint joint;
  joint.name = "drive";
  joint.first = "ground";
  joint.second = "crank";
  joint.at = {rng.real(-2, 2), rng.real(-2, 2)};
  mechanism.joints.push_back(joint);
  mechanism.drives.push_back({"drive", {{INFINITY, std::array<double, 4>{0, 0, 1, speed_}, {}}}});
  scene_.mechanism = mechanism;
  markers_.push_back({ground, joint.at});
  markers_.push_back({crank, {joint.at.x + rng.real(2, 6), joint.at.y + rng.real(-6, 6)}});
  markers_.push_back({ground, {rng.real(10, 30), rng.real(-10, 10)}});
  markers_.push_back({ground, {rng.real(-30, -10), rng.real(-10, 10)}});
  for (int k = 0; k < dyads; ++k) add_dyad(rng, k);
}

/// Hangs on a moving marker and one of another body.
void ClosedLinkage::add_dyad(Rng& rng, int number) {
  Dyad dyad{};
  do {
    dyad.p = 1 + static_cast<int>(rng.below(static_cast<int>(markers_.size()) - 1));
    dyad.q = static_cast<int>(rng.below(static_cast<int>(markers_.size())));
  } while (markers_[static_cast<std::size_t>(dyad.p)].body == 0 ||
           markers_[static_cast<std::size_t>(dyad.p)].body == markers_[static_cast<std::size_t>(dyad.q)].body);
  dyad.slides = rng.chance(0.3);
  const Marker p = markers_[static_cast<std::size_t>(dyad.p)], q = markers_[static_cast<std::size_t>(dyad.q)];
  const Point inner{(p.at.x + q.at.x) / 2 + rng.real(-15, 15), (p.at.y + q.at.y) / 2 + rng.real(-15, 15)};
  const std::string id = std::to_string(number);
  const int a = add_body("a" + id, inner), b = add_body("b" + id, inner);
  dyad.direction = {rng.real(-1, 1), rng.real(-1, 1)};
  dyad.r = static_cast<int>(markers_.size());
  markers_.push_back({b, inner});
  markers_.push_back({a, {inner.x + rng.real(-5, 5), inner.y + rng.real(-5, 5)}});
  const auto name = [&](int body) { return scene_.bodies[static_cast<std::size_t>(body)].name; };
  std::vector<MechanismJoint>& joints = scene_.mechanism->joints;
  using Kind = MechanismJoint::Kind;
  const auto add = [&](const char* what, Kind kind, int first, int second, const Point& at) {
    MechanismJoint joint;
    joint.name = what + id;
    joint.kind = kind;
    joint.first = name(first);
    joint.second = name(second);
    if (rng.chance(0.3) && kind == Kind::revolute) std::swap(joint.first, joint.second);
    (kind == Kind::slide ? joint.direction : joint.at) = at;
    joints.push_back(joint);
  };
  add("p", Kind::revolute, p.body, a, p.at);
  add("r", Kind::revolute, a, b, inner);
  if (dyad.slides) {
    add("s", Kind::slide, q.body, b, dyad.direction);
  } else {
    add("q", Kind::revolute, b, q.body, q.at);
  }
  dyads_.push_back(dyad);
}

Long ClosedLinkage::place(double t, std::vector<LongPoint>& points) const {
  static const Long degree = boost::multiprecision::acos(Long(-1)) / 180;
  std::vector<Frame> frames(scene_.bodies.size(), Frame{{0, 0}, {1, 0}});
  const auto placed = [&](int body, const Point& at) {
    const Frame& f = frames[static_cast<std::size_t>(body)];
    return f.at + product(f.axis, of(at));
  };
  /// The frame with this axis that puts a point there.
  const auto frame = [](const LongPoint& axis, const Point& at, const LongPoint& there) {
    return Frame{there - product(axis, of(at)), axis};
  };
  Long room = 1;
  const Point& pivot = scene_.mechanism->joints[0].at;
  const Long angle = Long(speed_) * Long(t) * degree;
  frames[1] = frame({boost::multiprecision::cos(angle), boost::multiprecision::sin(angle)}, pivot, of(pivot));
  for (const Dyad& dyad : dyads_) {
    const Marker &mp = markers_[static_cast<std::size_t>(dyad.p)], &mq = markers_[static_cast<std::size_t>(dyad.q)];
    const Marker& mr = markers_[static_cast<std::size_t>(dyad.r)];
    const LongPoint p = placed(mp.body, mp.at), drawn = of(mr.at) - of(mp.at);
    const Long length = dot(drawn, drawn);
    LongPoint r;
    LongPoint axis_b;
    if (dyad.slides) {
      // r = start + s d with |r - p|^2 = length; the branch is the side of p's foot that r is on when drawn.
      const LongPoint start = placed(mq.body, mr.at),
                      d = product(frames[static_cast<std::size_t>(mq.body)].axis, of(dyad.direction));
      const Long dd = dot(d, d), foot = dot(p - start, d) / dd;
      const LongPoint nearest = start + foot * d;
      const Long under = (length - dot(p - nearest, p - nearest)) / dd;
      if (under < room) room = under;
      if (under <= 0) return under;
      const int side = dot(drawn, of(dyad.direction)) > 0 ? 1 : -1;
      r = nearest + (side * boost::multiprecision::sqrt(under)) * d;
      axis_b = frames[static_cast<std::size_t>(mq.body)].axis;
    } else {
      const LongPoint q = placed(mq.body, mq.at), w = q - p, drawn_q = of(mr.at) - of(mq.at);
      const Long ww = dot(w, w), other = dot(drawn_q, drawn_q);
      const Long along = (ww + length - other) / (2 * ww), under = length / ww - along * along;
      if (under < room) room = under;
      if (under <= 0) return under;
      const int side = cross(of(mq.at) - of(mp.at), drawn) > 0 ? 1 : -1;
      r = p + product({along, side * boost::multiprecision::sqrt(under)}, w);
      axis_b = quotient(r - q, drawn_q);
    }
    // a carries p and r, b carries r.
    const int a = markers_[static_cast<std::size_t>(dyad.r) + 1].body, b = mr.body;
    frames[static_cast<std::size_t>(a)] = frame(quotient(r - p, drawn), mp.at, p);
    frames[static_cast<std::size_t>(b)] = frame(axis_b, mr.at, r);
  }
  points.clear();
  for (const Marker& marker : markers_) points.push_back(placed(marker.body, marker.at));
  return room;
}

}  // namespace taut::testing
