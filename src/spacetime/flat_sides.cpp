#include "spacetime/flat_sides.hpp"

#include <cmath>

#include "numeric/budget.hpp"
#include "numeric/exact_number.hpp"

namespace taut::internal::spacetime {
namespace {

/// If boxes overlap by more than this, so do their vertices. Coordinates are at most 1, and boxes are padded by 2^-47
/// of them.
constexpr double hair = 0x1p-40;
/// Bodies with fewer vertices have few pairs of edges, which cost less than the search for a direction between them.
constexpr std::uint32_t worth_it = 48;

double reach_along(Vector n, const Box& box) {
  return std::fabs(dot(n, box.along)) * box.half_length + std::fabs(dot(n, turned(box.along))) * box.half_width;
}

}  // namespace

FlatSides::FlatSides(const PairGeometry& geometry, const TreePair& trees, const MotionSegment& segment)
    : geometry_(geometry), trees_(trees), segment_(segment) {
  if (!segment.translation || segment.degree != 1 || geometry.size() < worth_it) return;
  const ExactNumber x = segment.way_coefficient<ExactNumber>(true, 1);
  const ExactNumber y = segment.way_coefficient<ExactNumber>(false, 1);
  n_ = {-y.sum().approximate(), x.sum().approximate()};
  const double length = std::sqrt(n_.x * n_.x + n_.y * n_.y);
  if (x.sum().size() > 1 || y.sum().size() > 1 || !(length > 0x1p-300 && length < 0x1p300)) return;
  usable_ = true;
  unit_ = {n_.x / length, n_.y / length};
  const ExactVector &p = segment.offset(true), &q = segment.offset(false);
  offset_ = {q.x - p.x, q.y - p.y};
}

bool FlatSides::apart(const BoxNode& p, const BoxNode& q) {
  if (!usable_) return false;
  const double relative = dot(unit_, q.box.centre - p.box.centre + offset_);
  if (std::fabs(relative) + hair * (1 + l1_norm(offset_)) < reach_along(unit_, p.box) + reach_along(unit_, q.box))
    return false;
  const Extremes of_p = extremes(true, static_cast<std::uint32_t>(&p - &trees_.p.node(0)));
  const Extremes of_q = extremes(false, static_cast<std::uint32_t>(&q - &trees_.q.node(0)));
  if (!exact_) return usable_ = false;
  return relative > 0 ? clear(of_q.low, of_p.high) : clear(of_p.low, of_q.high);
}

/// Is vertex a above vertex b along n? Both belong to one body.
bool FlatSides::above(VertexId a, VertexId b) {
  const DisplacedPoint &v = geometry_.point(a), &w = geometry_.point(b);
  const double difference = n_.x * (v.x - w.x) + n_.y * (v.y - w.y);
  const double room = (std::fabs(n_.x) + std::fabs(n_.y)) * (0x1p-48 + displacement_room);
  if (std::fabs(difference) > room) return difference > 0;
  ExactSum<16> sum;
  bool exact = true;
  for (const auto& [n, to, from] : {std::array{n_.x, v.x, w.x}, std::array{n_.y, v.y, w.y},
                                    std::array{n_.x, v.dx, w.dx}, std::array{n_.y, v.dy, w.dy}})
    exact = add_exact_product(sum, n, to) && add_exact_product(sum, -n, from) && exact;
  if (!exact) exact_ = false;
  return sum.sign() > 0;
}

FlatSides::Extremes& FlatSides::Known::of(std::uint32_t node, std::size_t all) {
  if (blocks.empty()) blocks.resize(all / size + 1);
  auto& block = blocks[node / size];
  if (!block) block = std::make_unique<std::array<Extremes, size>>();
  return (*block)[node % size];
}

/// The extremes of a box, computed from those of its halves, so that each vertex is evaluated once for each edge.
FlatSides::Extremes FlatSides::extremes(bool of_p, std::uint32_t node) {
  const Hierarchy& tree = of_p ? trees_.p : trees_.q;
  Extremes& known = (of_p ? of_p_ : of_q_).of(node, tree.size());
  if (known.known) return known;
  checkpoint();
  const BoxNode& box = tree.node(node);
  Extremes a, b;
  if (box.count == 1) {
    a.low = a.high = VertexId(box.first + (of_p ? 0 : geometry_.np));
    b.low = b.high = geometry_.next(a.low);
  } else {
    a = extremes(of_p, box.left);
    b = extremes(of_p, box.right);
  }
  return known = {above(a.low, b.low) ? b.low : a.low, above(b.high, a.high) ? b.high : a.high, true};
}

/// Is `low`, of one body, above `high`, of the other one?
bool FlatSides::clear(VertexId low, VertexId high) {
  using N = ExactNumber;
  const auto seen = [this](VertexId v, N& x, N& y) {
    const DisplacedPoint& point = geometry_.point(v);
    x = N::exact(point.x) + N::exact(point.dx);
    y = N::exact(point.y) + N::exact(point.dy);
    const bool of_p = geometry_.in_p(v);
    add_offset(segment_, of_p, x, y);
    if (of_p || !segment_.far()) return;
    x = x + segment_.way_coefficient<N>(true, 0);
    y = y + segment_.way_coefficient<N>(false, 0);
  };
  N ax, ay, bx, by;
  seen(low, ax, ay);
  seen(high, bx, by);
  const N gap = dot(N::exact(n_.x), N::exact(n_.y), ax - bx, ay - by);
  if (!gap.is_exact() || gap.sum().sign() <= 0) return false;
  if (gap.sum().approximate() < displacement_room * l1_norm(n_)) stages_.add(Stage::exact);
  return true;
}

}  // namespace taut::internal::spacetime
