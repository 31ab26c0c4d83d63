#include "spacetime/first_contact.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "numeric/budget.hpp"
#include "spacetime/walk.hpp"

namespace taut::internal::spacetime {
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
