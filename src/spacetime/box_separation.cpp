#include "spacetime/box_separation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "numeric/budget.hpp"
#include "numeric/exact_number.hpp"
#include "spacetime/first_contact.hpp"
#include "spacetime/walk.hpp"

namespace taut::internal::spacetime {
namespace {

/// Are the discs around the boxes disjoint?
bool discs_apart(double error, double r, const Path& relative, double radii) {
  Parabola gap = along({relative.x.a, relative.y.a}, relative);
  gap.a -= std::sqrt(gap.a) * (radii + error);
  return gap.a > 0 && gap.least(r) > 0;
}

/// Subtracts from the gap half a side of the moving box, whose component along the normal is `side`. The corner that is
/// nearest at the middle remains nearest unless the side rotates past the normal.
Parabola without_half(const Parabola& gap, const Parabola& side, double half, double swing) {
  if (std::fabs(side.a) > swing) return gap - (side.a > 0 ? half : -half) * side;
  return {gap.a - half * (std::fabs(side.a) + swing), gap.b, gap.c};
}

/// Does the direction n of the fixed box, which reaches `extent` from its centre, separate the two boxes?
bool separates(const RelativePose& relative_pose, double r, Vector n, double extent, const Box& moving,
               const Path& relative, const Path& side) {
  Parabola gap = along(n, relative);
  if (gap.a < 0) gap = -gap;
  gap.a -= extent + relative_pose.error;
  if (!(gap.a > 0)) return false;
  gap = without_half(gap, along(n, side), moving.half_length, relative_pose.swing);
  // n . turned(side) equals turned back(n) . side.
  gap = without_half(gap, along(-turned(n), side), moving.half_width, relative_pose.swing);
  return gap.a > 0 && gap.least(r) > 0;
}

bool separated(const RelativePose& relative_pose, double r, const Box& fixed, const Box& moving, const Path& relative) {
  const Path side = relative_pose.rotation * moving.along;
  return separates(relative_pose, r, turned(fixed.along), fixed.half_width, moving, relative, side) ||
         separates(relative_pose, r, fixed.along, fixed.half_length, moving, relative, side);
}

/// Nothing turns in the stretch: the boxes keep their directions, and one frame is enough for the sides of both.
bool apart_in_translation(const Stretch& s, const Box& p, const Box& q) {
  const Vector rotation{s.in_p.rotation.x.a, s.in_p.rotation.y.a}, side = rotation * q.along;
  const Vector offset = rotation * q.centre - p.centre;
  Path relative = s.in_p.shift;
  relative.x.a += offset.x;
  relative.y.a += offset.y;
  if (discs_apart(s.in_p.error, s.r, relative, p.radius + q.radius)) return true;
  const double c = std::fabs(dot(p.along, side)), d = std::fabs(dot(turned(p.along), side));
  const auto separates = [&](Vector n, double fixed, double moving) {
    Parabola gap = along(n, relative);
    if (gap.a < 0) gap = -gap;
    gap.a -= fixed + moving + s.in_p.error;
    return gap.a > 0 && gap.least(s.r) > 0;
  };
  return separates(turned(p.along), p.half_width, d * q.half_length + c * q.half_width) ||
         separates(p.along, p.half_length, c * q.half_length + d * q.half_width) ||
         separates(turned(side), q.half_width, d * p.half_length + c * p.half_width) ||
         separates(side, q.half_length, c * p.half_length + d * p.half_width);
}

}  // namespace

bool apart(const Stretch& s, const Box& p, const Box& q) {
  if (s.in_p.swing == 0) return apart_in_translation(s, p, q);
  const Path relative = s.in_p.place(q.centre, p.centre);
  return discs_apart(s.in_p.error, s.r, relative, p.radius + q.radius) || separated(s.in_p, s.r, p, q, relative) ||
         separated(s.in_q, s.r, q, p, s.in_q.place(p.centre, q.centre));
}

bool farther(const Stretch& s, const Box& p, const Box& q, Vector towards, double margin) {
  const Path relative = s.in_p.place(q.centre, p.centre);
  if (discs_apart(s.in_p.error + margin, s.r, relative, p.radius + q.radius)) return true;
  const double length = std::sqrt(dot(towards, towards));
  // The boxes' directions are unit vectors up to rounding, and so is this one: it must not be too long.
  constexpr double shorter = 1 - 0x1p-45;
  const double room = margin * (1 + 0x1p-44);
  if (length > 0) {
    const Vector n{towards.x / length * shorter, towards.y / length * shorter};
    const double extent =
        (std::fabs(dot(n, p.along)) * p.half_length + std::fabs(dot(n, turned(p.along))) * p.half_width) *
        (1 + 0x1p-45);
    if (separates(s.in_p, s.r, n, extent + room, q, relative, s.in_p.rotation * q.along)) return true;
  }
  const auto along_sides = [&](const RelativePose& relative_pose, const Box& fixed, const Box& moving,
                               const Path& path) {
    const Path side = relative_pose.rotation * moving.along;
    return separates(relative_pose, s.r, turned(fixed.along), fixed.half_width + room, moving, path, side) ||
           separates(relative_pose, s.r, fixed.along, fixed.half_length + room, moving, path, side);
  };
  return along_sides(s.in_p, p, q, relative) || along_sides(s.in_q, q, p, s.in_q.place(p.centre, q.centre));
}

namespace {

/// The part of a stretch around its middle. The omitted terms are third powers of time.
Stretch middle_part(const Stretch& s, double share) {
  Stretch part = s;
  part.r *= share;
  part.in_p.error -= s.rest * (1 - share * share * share);
  part.in_q.error -= s.rest * (1 - share * share * share);
  return part;
}

}  // namespace

bool apart_around_middle(const Stretch& s, double share, const Box& p, const Box& q) {
  return apart(middle_part(s, share), p, q);
}

bool farther_around_middle(const Stretch& s, double share, const Box& p, const Box& q, Vector towards, double margin) {
  return farther(middle_part(s, share), p, q, towards, margin);
}

double motion(const Stretch& s, const Box& p, const Box& q) {
  const Path relative = s.in_p.place(q.centre, p.centre);
  return relative.x.swing(s.r) + relative.y.swing(s.r) + s.in_p.swing * q.radius + s.rest;
}

bool misses(const Stretch& s, const RelativePose& relative_pose, Vector vertex, Vector from, Vector to, double margin) {
  const Vector edge = to - from;
  const Path relative = relative_pose.place(vertex, from);
  // The displacement contributes to the edge's direction, times the path, and to both points, along the edge, whose
  // coordinates are at most 1.
  const double error = relative_pose.error * l1_norm(edge) + displacement_room * (1 + relative_pose.reach);
  const double room = margin > 0 ? margin * l1_norm(edge) * (1 + 0x1p-45) : 0;
  const Parabola line = along(turned(edge), relative), ahead = along(edge, relative);
  const Parabola beyond{ahead.a - dot(edge, edge), ahead.b, ahead.c};
  return line.least(s.r) > error || (-line).least(s.r) > error + room || (-ahead).least(s.r) > error ||
         beyond.least(s.r) > error;
}

bool vertices_farther(const Stretch& s, Vector of_p, Vector of_q, double margin) {
  const Path relative = s.in_p.place(of_q, of_p);
  return discs_apart(s.in_p.error + margin, s.r, relative, 2 * displacement_room);
}

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

namespace {

/// The cost limit of a quick separation: about that of one model.
constexpr int most_looks = 96, most_stretches = 12;
/// The work counted for a stretch.
constexpr int work_of_stretch = 4;

std::span<const MotionPiece> pieces_of(const MotionSegment& segment, bool of_p) {
  if (segment.composed) return of_p ? segment.p_chain : segment.q_chain;
  return {of_p ? &segment.p : &segment.q, 1};
}

bool is_even(std::span<const MotionPiece> pieces) {
  return std::all_of(pieces.begin(), pieces.end(), UniformMotion::is_even);
}

class QuickSeparation {
 public:
  QuickSeparation(const TreePair& trees, const MotionSegment& segment)
      : trees_(trees), motion_(pieces_of(segment, true), pieces_of(segment, false), reach_of(trees.q)) {}

  /// Are these pairs of boxes disjoint throughout, as far as a few tests show?
  bool over(double start, double end, std::vector<BoxPair> todo) {
    if (++stretches_ > most_stretches) return false;
    UniformStretch stretch = motion_.stretch(start, end);
    std::vector<BoxPair> later;
    while (!todo.empty()) {
      if (++looks_ > most_looks) return false;
      const BoxPair pair = todo.back();
      todo.pop_back();
      evaluate(stretch, pair, todo, later);
    }
    if (later.empty()) return true;
    const double middle = start + (end - start) / 2;
    return start < middle && middle < end && over(start, middle, later) && over(middle, end, std::move(later));
  }
  std::uint64_t work() const { return static_cast<std::uint64_t>(looks_ + work_of_stretch * stretches_); }

 private:
  /// Drops the pair, divides the larger box, or defers the pair to shorter stretches.
  void evaluate(UniformStretch& stretch, const BoxPair& pair, std::vector<BoxPair>& todo,
                std::vector<BoxPair>& later) const {
    const BoxNode &p = trees_.p.node(pair.p), &q = trees_.q.node(pair.q);
    const Stretch& s = stretch.near(p.box);
    if (apart(s, p.box, q.box)) return;
    const bool leaf = p.count == 1 && q.count == 1;
    if (leaf || motion(s, p.box, q.box) > subdivision_threshold * (p.box.radius + q.box.radius)) {
      later.push_back(pair);
    } else if (divides_first(p, q)) {
      todo.insert(todo.end(), {{p.right, pair.q}, {p.left, pair.q}});
    } else {
      todo.insert(todo.end(), {{pair.p, q.right}, {pair.p, q.left}});
    }
  }

  const TreePair& trees_;
  UniformMotion motion_;
  int looks_ = 0, stretches_ = 0;
};

}  // namespace

bool quickly_apart(const TreePair& trees, const MotionSegment& segment, double from, double to) {
  if (segment.bridge || segment.translation || !(from < to)) return false;
  if (!is_even(pieces_of(segment, true)) || !is_even(pieces_of(segment, false))) return false;
  QuickSeparation quick_separation(trees, segment);
  if (!quick_separation.over(from, to, {{0, 0}})) return false;
  // A failed attempt is followed by far more work, which is counted.
  count_work(quick_separation.work());
  return true;
}

}  // namespace taut::internal::spacetime
