#include "query/lift_functions.hpp"

#include <algorithm>
#include <cmath>

namespace taut::internal {
namespace {

template <class Real>
LiftRange range_of(const Ball<Real>& b) {
  if (!std::isfinite(b.rad)) return {};
  const LiftRange range{double_below(b.lower()), double_above(b.upper())};
  return range.lo <= range.hi ? range : LiftRange{};
}

LiftRange both(const LiftRange& a, const LiftRange& b) { return {std::max(a.lo, b.lo), std::min(a.hi, b.hi)}; }

/// The ball of that radius about 0.
template <class Real>
Ball<Real> about_zero(double radius) {
  return Ball<Real>(RealTraits<Real>::from_double(0), radius);
}

template <class Real>
bool may_be_zero(const Ball<Real>& b) {
  return std::isfinite(b.rad) && RealTraits<Real>::magnitude(b.mid) <= 16 * b.rad;
}

/// The pair of this couple with the follower as P.
MotionSegments segments_from_follower(const Instance& instance, int follower, int cam) {
  const BodyPair pair = instance.pair(follower, cam);
  const MotionSegments all = instance.segments(pair);
  return pair.rings[0] == instance.bodies()[static_cast<std::size_t>(follower)].rings ? all : all.exchanged();
}

}  // namespace

template <class Real>
LiftRange WindowJet<Real>::range(double radius) const {
  const double half = radius * radius / 4 * (1 + 0x1p-40) + 0x1p-1000;
  const Ball<Real> square(RealTraits<Real>::from_double(half), half * 0x1p-30 + half);
  return both(range_of<Real>(middle.v + middle.d * about_zero<Real>(radius) + over.dd * square), range_of(over.v));
}
template <class Real>
LiftRange WindowJet<Real>::slopes(double radius) const {
  return both(range_of<Real>(middle.d + over.dd * about_zero<Real>(radius)), range_of(over.d));
}
template <class Real>
bool WindowJet<Real>::vanishes_in_middle() const {
  return may_be_zero(middle.v) && may_be_zero(middle.d) && may_be_zero(middle.dd);
}

std::uint32_t LiftCouple::Outline::next(std::uint32_t k) const {
  return shape->rings.empty() ? (k + 1) % size() : shape->next[k];
}
std::uint32_t LiftCouple::Outline::previous(std::uint32_t k) const {
  return shape->rings.empty() ? (k + size() - 1) % size() : shape->previous[k];
}

LiftCouple::LiftCouple(const Instance& instance, int follower_section, int cam_section, Offset offset)
    : group(instance.bodies()[static_cast<std::size_t>(cam_section)].group),
      segments(segments_from_follower(instance, follower_section, cam_section)) {
  follower.rings = instance.bodies()[static_cast<std::size_t>(follower_section)].rings;
  cam.rings = instance.bodies()[static_cast<std::size_t>(cam_section)].rings;
  follower.shape = follower.rings->displaced(offset);
  cam.shape = cam.rings->displaced(offset);
}

std::array<VertexCouple, 2> ends_of(const std::vector<LiftCouple>& couples, const LiftPair& pair) {
  const LiftCouple& couple = couples[pair.couple];
  if (pair.of_follower)
    return {VertexCouple{pair.couple, pair.vertex, pair.edge},
            VertexCouple{pair.couple, pair.vertex, couple.cam.next(pair.edge)}};
  return {VertexCouple{pair.couple, couple.follower.next(pair.edge), pair.vertex},
          VertexCouple{pair.couple, pair.edge, pair.vertex}};
}

template <class Real>
void LiftWindow<Real>::set(double lo, double hi) {
  time_ = Ball<double>::between(lo, hi);
  ++stamp_;
  frames_.resize(couples_.size());
  places_.resize(couples_.size());
  const Ball<Real> whole(RealTraits<Real>::from_double(time_.mid), time_.rad), middle(whole.mid, 0);
  for (std::size_t k = 0; k < couples_.size(); ++k) {
    const Frame<Real> at = frame(*couples_[k].segment, middle), over = frame(*couples_[k].segment, whole);
    for (std::size_t i = 0; i < 4; ++i) frames_[k][i] = {at.for_pp[i + 1], over.for_pp[i + 1]};
    places_[k][0].resize(couples_[k].cam.size());
    places_[k][1].resize(couples_[k].follower.size());
  }
}

template <class Real>
auto LiftWindow<Real>::made(const LiftCouple& couple, std::size_t number, bool of_follower, const DisplacedPoint& point)
    -> Place {
  using B = Ball<Real>;
  using F = WindowJet<Real>;
  B x = B::exact(point.x), y = B::exact(point.y);
  add_offset(*couple.segment, of_follower, x, y);
  const B ux = B::exact(u_.x), uy = B::exact(u_.y);
  const B across = ux * y - uy * x, along = ux * x + uy * y;
  if (of_follower) return {F::constant(across), F::constant(along), stamp_};
  const auto& [dx, dy, c, s] = frames_[number];
  const F fx = F::constant(ux), fy = F::constant(uy), fw = F::constant(across), fh = F::constant(along);
  return {fx * dy - fy * dx + c * fw + s * fh, fx * dx + fy * dy + c * fh - s * fw, stamp_};
}

template <class Real>
auto LiftWindow<Real>::place(std::uint32_t couple, bool of_follower, std::uint32_t vertex) -> const Place& {
  Place& kept = places_[couple][of_follower ? 1 : 0][vertex];
  if (kept.stamp != stamp_) {
    const LiftCouple& all = couples_[couple];
    kept = made(all, couple, of_follower, (of_follower ? all.follower : all.cam).point(vertex));
  }
  return kept;
}

template <class Real>
WindowJet<Real> LiftWindow<Real>::from_end(const LiftPair& pair, int end) {
  const VertexCouple at = ends_of(couples_, pair)[static_cast<std::size_t>(end)];
  const Place& of_vertex = place(pair.couple, pair.of_follower, pair.vertex);
  const Place& of_end = place(pair.couple, !pair.of_follower, pair.of_follower ? at.cam : at.follower);
  return end == 0 ? of_vertex.w - of_end.w : of_end.w - of_vertex.w;
}

template <class Real>
WindowJet<Real> LiftWindow<Real>::lift(const LiftPair& pair) {
  const LiftCouple& couple = couples_[pair.couple];
  const Place& p = place(pair.couple, pair.of_follower, pair.vertex);
  const Place& a = place(pair.couple, !pair.of_follower, pair.edge);
  const Place& b =
      place(pair.couple, !pair.of_follower, (pair.of_follower ? couple.cam : couple.follower).next(pair.edge));
  const WindowJet<Real> edge = a.h + (b.h - a.h) * ((p.w - a.w) / (b.w - a.w));
  return pair.of_follower ? edge - p.h : p.h - edge;
}

template <class Real>
LiftRange LiftWindow<Real>::lifts(const LiftPair& pair, const WindowJet<Real>& lift) {
  const LiftCouple& couple = couples_[pair.couple];
  const Place& p = place(pair.couple, pair.of_follower, pair.vertex);
  const Place& a = place(pair.couple, !pair.of_follower, pair.edge);
  const Place& b =
      place(pair.couple, !pair.of_follower, (pair.of_follower ? couple.cam : couple.follower).next(pair.edge));
  const LiftRange first = (pair.of_follower ? a.h - p.h : p.h - a.h).range(radius());
  const LiftRange second = (pair.of_follower ? b.h - p.h : p.h - b.h).range(radius());
  return both(lift.range(radius()), {std::min(first.lo, second.lo), std::max(first.hi, second.hi)});
}

template <class Real>
WindowJet<Real> LiftWindow<Real>::to_neighbour(std::uint32_t couple, bool of_follower, std::uint32_t vertex,
                                               bool next) {
  const LiftCouple::Outline& outline = of_follower ? couples_[couple].follower : couples_[couple].cam;
  const WindowJet<Real> own = place(couple, of_follower, vertex).w;
  return place(couple, of_follower, next ? outline.next(vertex) : outline.previous(vertex)).w - own;
}

template struct WindowJet<double>;
template class LiftWindow<double>;
#define TAUT_INSTANTIATE(Real)     \
  template struct WindowJet<Real>; \
  template class LiftWindow<Real>;
TAUT_FOR_EACH_PRECISION(TAUT_INSTANTIATE)
#undef TAUT_INSTANTIATE

}  // namespace taut::internal
