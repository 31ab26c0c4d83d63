#include "support/two_drives.hpp"

#include <cmath>
#include <numbers>

namespace taut::testing {
namespace {

using Far = long double;
struct Spot {
  Far x, y;
};

Spot spot(const Point& p) { return {p.x, p.y}; }
Spot operator-(const Spot& a, const Spot& b) { return {a.x - b.x, a.y - b.y}; }
Far cross_of(const Spot& a, const Spot& b) { return a.x * b.y - a.y * b.x; }
Far dot_of(const Spot& a, const Spot& b) { return a.x * b.x + a.y * b.y; }

/// The body that has p at p1 and looks from p to q as from p1 to q1.
TwoDrives::Place place_by(const Spot& p, const Spot& q, const Spot& p1, const Spot& q1) {
  const Spot from = q - p, to = q1 - p1;
  const Far n = std::sqrt(dot_of(from, from) * dot_of(to, to));
  const Far c = dot_of(from, to) / n, s = cross_of(from, to) / n;
  return {p1.x - c * p.x + s * p.y, p1.y - s * p.x - c * p.y, c, s};
}

Spot placed(const TwoDrives::Place& place, const Point& p) {
  const auto [x, y] = place.of(p);
  return {x, y};
}

/// The third corner of a triangle with the sides of the drawn one, on the same side of its base; and the sine at it.
std::pair<Spot, Far> third_corner(const Point& p, const Point& q, const Point& r, const Spot& p1, const Spot& q1) {
  const Spot pr = spot(r) - spot(p), qr = spot(r) - spot(q), base = q1 - p1;
  const Far pr2 = dot_of(pr, pr), qr2 = dot_of(qr, qr), base2 = dot_of(base, base);
  const Far along = (pr2 - qr2 + base2) / (2 * base2);
  const Far height2 = pr2 / base2 - along * along;
  const Far up = std::copysign(std::sqrt(std::max<Far>(height2, 0)), cross_of(spot(q) - spot(p), pr));
  const Far sine = base2 * std::sqrt(std::max<Far>(height2, 0)) / std::sqrt(pr2 * qr2);
  return {{p1.x + along * base.x - up * base.y, p1.y + along * base.y + up * base.x}, height2 > 0 ? sine : -1};
}

}  // namespace

TwoDrives::TwoDrives(Rng& rng, Kind kind) : kind_(kind) {
  const auto near = [&](double x, double y) { return Point{x + rng.real(-8, 8), y + rng.real(-8, 8)}; };
  a_ = {0, 0};
  e_ = near(40, 0);
  b_ = near(-8, 22);
  d_ = near(48, 22);
  c_ = near(20, rng.chance(0.5) ? 45 : -5);
  add_polygon("base", {{-60, -70}, {-50, -72}, {-55, 70}});
  add_body(rng, "a", a_, b_);
  add_body(rng, "b", b_, kind == Kind::slide ? near(10, 30) : c_);
  add_body(rng, "c", kind == Kind::slide ? near(30, 30) : c_, d_);
  add_body(rng, "d", d_, e_);
  const Point middle = near(20, 65);
  add_polygon("block", {middle, {middle.x + rng.real(3, 20), middle.y}, {middle.x, middle.y + rng.real(3, 20)}});
  scene_.mechanism.emplace();
  scene_.mechanism->ground = "base";
  add_pin("A", "base", "a", a_);
  add_pin("B", "a", "b", b_);
  if (kind == Kind::slide) {
    along_ = {rng.real(0.5, 2), rng.real(-1, 1)};
    MechanismJoint slide{"C", MechanismJoint::Kind::slide, "b", "c"};
    slide.direction = along_;
    scene_.mechanism->joints.push_back(slide);
    scene_.ignore.push_back({"b", "c"});
  } else {
    add_pin("C", "b", "c", c_);
  }
  add_pin("D", "c", "d", d_);
  add_pin("E", "base", "d", e_);
  if (kind != Kind::two_loops) return;
  p_ = near(8, 40);
  g_ = near(-40, 20);
  q_ = near(-25, 55);
  add_body(rng, "f", p_, q_);
  add_body(rng, "g", q_, g_);
  add_pin("P", "b", "f", p_);
  add_pin("Q", "f", "g", q_);
  add_pin("G", "base", "g", g_);
}

/// A quadrangle around a bar.
void TwoDrives::add_body(Rng& rng, const std::string& name, const Point& p, const Point& q) {
  const double x = q.x - p.x, y = q.y - p.y, wide = rng.real(0.02, 0.1), long_by = rng.real(0, 0.1);
  const auto corner = [&](const Point& at, double along, double across) {
    return Point{at.x + along * x - across * y, at.y + along * y + across * x};
  };
  add_polygon(name, {corner(p, -long_by, -wide), corner(q, long_by, -wide), corner(q, long_by, wide / 2),
                     corner(p, -long_by, wide)});
}

void TwoDrives::add_polygon(const std::string& name, Polygon polygon) {
  Body body;
  body.name = name;
  body.polygon = std::move(polygon);
  scene_.bodies.push_back(std::move(body));
}

void TwoDrives::add_pin(const std::string& name, const std::string& first, const std::string& second, const Point& at) {
  MechanismJoint pin{name, MechanismJoint::Kind::revolute, first, second};
  pin.at = at;
  scene_.mechanism->joints.push_back(pin);
  scene_.ignore.push_back({first, second});
}

TwoDrives::Solved TwoDrives::solve(long double a, long double e) const {
  const auto turned = [](const Point& p, const Point& about, Far degrees) {
    const Far angle = degrees * std::numbers::pi_v<Far> / 180, c = std::cos(angle), s = std::sin(angle);
    const Far x = Far{p.x} - about.x, y = Far{p.y} - about.y;
    return Spot{about.x + c * x - s * y, about.y + s * x + c * y};
  };
  const Spot b = turned(b_, a_, a), d = turned(d_, e_, e);
  Solved out{{{0, 0, 1, 0}}, 0};
  out.places.push_back(place_by(spot(a_), spot(b_), spot(a_), b));
  if (kind_ == Kind::slide) {
    // The slider's frame sees D at a constant distance from the line through B.
    const Spot u = spot(along_), drawn = spot(d_) - spot(b_), now = d - b;
    const Far length = std::sqrt(dot_of(u, u)), across = cross_of(u, drawn) / length;
    const Far square = dot_of(now, now) - across * across;
    const Far way = std::copysign(std::sqrt(std::max<Far>(square, 0)), dot_of(u, drawn));
    // Where the pins are near each other, the bars turn fast.
    out.margin = square > 0 ? std::min(std::sqrt(square / dot_of(now, now)), std::sqrt(square) / 20) : -1;
    const Spot seen{way * u.x / length - across * u.y / length, way * u.y / length + across * u.x / length};
    out.places.push_back(place_by(spot(b_), {b_.x + seen.x, b_.y + seen.y}, b, d));
    const Place& turn = out.places.back();
    out.places.push_back({d.x - turn.c * d_.x + turn.s * d_.y, d.y - turn.s * d_.x - turn.c * d_.y, turn.c, turn.s});
  } else {
    const auto [c, sine] = third_corner(b_, d_, c_, b, d);
    out.margin = sine;
    out.places.push_back(place_by(spot(b_), spot(c_), b, c));
    out.places.push_back(place_by(spot(c_), spot(d_), c, d));
  }
  out.places.push_back(place_by(spot(d_), spot(e_), d, spot(e_)));
  out.places.push_back({0, 0, 1, 0});
  if (kind_ != Kind::two_loops) return out;
  const Spot p = placed(out.places[2], p_);
  const auto [q, sine] = third_corner(p_, g_, q_, p, spot(g_));
  out.margin = std::min(out.margin, sine);
  out.places.push_back(place_by(spot(p_), spot(q_), p, q));
  out.places.push_back(place_by(spot(q_), spot(g_), q, spot(g_)));
  return out;
}

std::optional<std::vector<TwoDrives::Place>> TwoDrives::places(long double a, long double e) const {
  Solved solved = solve(a, e);
  if (!(solved.margin > 0)) return std::nullopt;
  return std::move(solved.places);
}

long double TwoDrives::margin(long double a, long double e) const { return solve(a, e).margin; }

}  // namespace taut::testing
