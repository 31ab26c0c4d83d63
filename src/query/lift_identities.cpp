// What holds of lifts at all times: exactly, by the coefficients of the frame's functions.
#include <algorithm>
#include <cmath>

#include "motion/frame_model.hpp"
#include "motion/pieces.hpp"
#include "query/lift_functions.hpp"

namespace taut::internal {
namespace {

using LinearForm = std::array<Dyadic, 5>;

LinearForm operator-(const LinearForm& a, const LinearForm& b) {
  LinearForm c;
  for (std::size_t i = 0; i < c.size(); ++i) c[i] = a[i] - b[i];
  return c;
}
LinearForm scaled_by(const LinearForm& a, const Dyadic& by) {
  LinearForm c;
  for (std::size_t i = 0; i < c.size(); ++i) c[i] = a[i] * by;
  return c;
}

bool is_constant(const LinearForm& a) {
  return std::all_of(a.begin() + 1, a.end(), [](const Dyadic& x) { return x.is_zero(); });
}

/// A coefficient of D less the shift, in powers of the time since about(): of a translation.
Dyadic way_coefficient(const MotionSegment& segment, bool of_x, std::size_t k) {
  if (segment.far()) {
    const DyadicPolynomial& all = segment.way(of_x).exact();
    return k < all.size() ? all[k] : Dyadic();
  }
  if (k == 0) return {};
  const auto exact = [k](const Coefficients& c) { return k < c.size() ? Dyadic::exact(c[k]) : Dyadic(); };
  return exact(of_x ? segment.q.x : segment.q.y) - exact(of_x ? segment.p.x : segment.p.y);
}

/// May c be 1, and s be 0, in the middle of the segment?
bool may_be_aligned(const MotionSegment& segment) {
  const double middle = segment.start + (segment.end - segment.start) / 2;
  const auto& functions = frame(segment, Ball<double>::exact(middle)).for_pp;
  const auto holds = [](const Ball<double>& b, double value) { return std::fabs(b.mid - value) <= b.rad; };
  return holds(functions[3].v, 1) && holds(functions[4].v, 0);
}

bool same_offsets(const MotionSegment& a, const MotionSegment& b) {
  for (const bool of_p : {false, true}) {
    Dyadic x, y;
    add_offset(a, of_p, x, y);
    Dyadic other_x, other_y;
    add_offset(b, of_p, other_x, other_y);
    if (!(x == other_x && y == other_y)) return false;
  }
  return true;
}

}  // namespace

/// Do the bodies keep their orientation towards each other: are c and s 1 and 0? So slides carry the links of
/// mechanisms.
bool LiftIdentities::keeps_orientation(const MotionSegment& segment) {
  if (segment.translation || segment.aligned) return true;
  if (segment.bridge || !may_be_aligned(segment)) return false;
  const Dyadic one(1, 0), none;
  return vanishes(segment, {-one, none, none, one, none}) && vanishes(segment, {none, none, none, none, one});
}

void LiftIdentities::begin() {
  level_.clear();
  keeps_orientation_.clear();
  for (const LiftCouple& couple : couples_) keeps_orientation_.push_back(keeps_orientation(*couple.segment));
}

bool LiftIdentities::vanishes(const MotionSegment& segment, const Linear& c) {
  if (segment.bridge) return false;
  if (!segment.translation) return segment.identities().vanishes(true, c);
  const auto change = [&](std::size_t k) {
    return c[1] * way_coefficient(segment, true, k) + c[2] * way_coefficient(segment, false, k);
  };
  if (!(c[0] + c[3] + change(0)).is_zero()) return false;
  for (int k = 1; k <= segment.degree; ++k) {
    if (!change(static_cast<std::size_t>(k)).is_zero()) return false;
  }
  return true;
}

auto LiftIdentities::place(const LiftCouple& couple, bool of_follower, std::uint32_t vertex) const -> Place {
  const DisplacedPoint& point = (of_follower ? couple.follower : couple.cam).point(vertex);
  Dyadic x = Dyadic::exact(point.x), y = Dyadic::exact(point.y);
  add_offset(*couple.segment, of_follower, x, y);
  const Dyadic ux = Dyadic::exact(u_.x), uy = Dyadic::exact(u_.y), none;
  const Dyadic across = ux * y - uy * x, along = ux * x + uy * y;
  if (of_follower) return {{across, none, none, none, none}, {along, none, none, none, none}};
  if (keeps_orientation(couple)) return {{across, -uy, ux, none, none}, {along, ux, uy, none, none}};
  return {{none, -uy, ux, across, along}, {none, ux, uy, along, -across}};
}

bool LiftIdentities::level(const VertexCouple& at) {
  const auto [known, added] = level_.try_emplace(at, false);
  if (added) {
    const LiftCouple& couple = couples_[at.couple];
    known->second = vanishes(*couple.segment, place(couple, true, at.follower).w - place(couple, false, at.cam).w);
  }
  return known->second;
}

std::optional<int> LiftIdentities::side_of_neighbour(std::uint32_t number, bool of_follower, std::uint32_t vertex,
                                                     bool next) const {
  const LiftCouple& couple = couples_[number];
  const LiftCouple::Outline& outline = of_follower ? couple.follower : couple.cam;
  const std::uint32_t neighbour = next ? outline.next(vertex) : outline.previous(vertex);
  const Linear way = place(couple, of_follower, neighbour).w - place(couple, of_follower, vertex).w;
  return is_constant(way) ? std::optional(way[0].sign()) : std::nullopt;
}

/// Numerator and denominator are linear in the frame's functions only if the edge keeps its direction.
auto LiftIdentities::lift(const LiftPair& pair) const -> Quotient {
  const LiftCouple& couple = couples_[pair.couple];
  const LiftCouple::Outline& of_edge = pair.of_follower ? couple.cam : couple.follower;
  const Place p = place(couple, pair.of_follower, pair.vertex), a = place(couple, !pair.of_follower, pair.edge),
              b = place(couple, !pair.of_follower, of_edge.next(pair.edge));
  const Linear width = b.w - a.w, rise = b.h - a.h;
  const Linear above = pair.of_follower ? a.h - p.h : p.h - a.h;
  const Linear across = pair.of_follower ? p.w - a.w : a.w - p.w;
  Linear numerator = scaled_by(above, width[0]);
  const Linear part = scaled_by(across, rise[0]);
  for (std::size_t i = 0; i < numerator.size(); ++i) numerator[i] = numerator[i] + part[i];
  return {numerator, width};
}

bool LiftIdentities::same_line(const LiftPair& a, const LiftPair& b) const {
  const LiftCouple &first = couples_[a.couple], &second = couples_[b.couple];
  const auto point = [](const LiftCouple::Outline& outline, std::uint32_t k) {
    return std::array{Dyadic::exact(outline.point(k).x), Dyadic::exact(outline.point(k).y)};
  };
  const LiftCouple::Outline& p = a.of_follower ? first.follower : first.cam;
  const LiftCouple::Outline& q = b.of_follower ? second.follower : second.cam;
  if (point(p, a.vertex) != point(q, b.vertex)) return false;
  const LiftCouple::Outline& e = a.of_follower ? first.cam : first.follower;
  const LiftCouple::Outline& f = b.of_follower ? second.cam : second.follower;
  const auto from = point(e, a.edge), to = point(e, e.next(a.edge));
  const auto on_it = [&](std::uint32_t k) {
    const auto z = point(f, k);
    return ((to[0] - from[0]) * (z[1] - from[1]) - (to[1] - from[1]) * (z[0] - from[0])).is_zero();
  };
  return on_it(b.edge) && on_it(f.next(b.edge));
}

bool LiftIdentities::same(const LiftPair& a, const LiftPair& b) const {
  const LiftCouple &first = couples_[a.couple], &second = couples_[b.couple];
  if (a.couple != b.couple && !(first.group == second.group && same_offsets(*first.segment, *second.segment)))
    return false;
  if (a.of_follower == b.of_follower && same_line(a, b)) return true;
  const bool fixed_edges = !a.of_follower && !b.of_follower;
  if (!fixed_edges && !keeps_orientation(first)) return false;
  const Quotient x = lift(a), y = lift(b);
  if (!is_constant(x.denominator) || !is_constant(y.denominator)) return false;
  return vanishes(*first.segment, scaled_by(x.numerator, y.denominator[0]) - scaled_by(y.numerator, x.denominator[0]));
}

bool LiftIdentities::zero(const LiftPair& a) const {
  const LiftCouple& couple = couples_[a.couple];
  if (a.of_follower && !keeps_orientation(couple)) return false;
  const Quotient x = lift(a);
  return is_constant(x.denominator) && vanishes(*couple.segment, x.numerator);
}

}  // namespace taut::internal
