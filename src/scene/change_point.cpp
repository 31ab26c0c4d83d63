// Change points of parallelograms: four bars, opposite ones equal and drawn parallel, stay parallel until all are in
// line.
//
// There the motion could go on with crossed bars as well, and no bound in numbers can show that: it is known from the
// bars' vectors, which are compared exactly.
#include <algorithm>
#include <cmath>

#include "numeric/exact_sum.hpp"
#include "scene/mechanism.hpp"

namespace taut::internal {
namespace {

/// Is a - b the same vector as d - c, exactly?
bool are_parallel(const LocalPoint& a, const LocalPoint& b, const LocalPoint& c, const LocalPoint& d) {
  const auto same = [&](TwoDoubles LocalPoint::*of) {
    ExactSum<8> sum;
    for (const LocalPoint* p : {&a, &c}) {
      sum.add((p->*of).hi);
      sum.add((p->*of).lo);
    }
    for (const LocalPoint* p : {&b, &d}) {
      sum.add(-(p->*of).hi);
      sum.add(-(p->*of).lo);
    }
    return sum.sign() == 0;
  };
  return same(&LocalPoint::x) && same(&LocalPoint::y);
}

/// A loop of four pins in order, and which of them is driven.
struct FourBar {
  std::array<LocalPoint, 4> pins;
  int driven = -1;
  const LoopEquations::TreeJoint* joint = nullptr;
  bool carries_next = false;  ///< the joint carries the bar to the next pin
};

std::optional<FourBar> four_bar_of(const LoopEquations& equations) {
  if (equations.closures.size() != 1 || equations.closures[0].slide) return std::nullopt;
  const LoopEquations::Closure& closure = equations.closures[0];
  std::vector<int> first, second;
  for_each_joint_on_path(equations, closure.first, [&](int k) { first.push_back(k); });
  for_each_joint_on_path(equations, closure.second, [&](int k) { second.push_back(k); });
  while (!first.empty() && !second.empty() && first.back() == second.back()) {
    first.pop_back();
    second.pop_back();
  }
  if (first.size() + second.size() != 3) return std::nullopt;
  FourBar bars;
  bars.pins[0] = closure.at;
  int pin = 0;
  const auto add = [&](int k, bool carries_next) {
    const LoopEquations::TreeJoint& joint = equations.joints[static_cast<std::size_t>(k)];
    bars.pins[static_cast<std::size_t>(++pin)] = joint.at;
    if (joint.value.unknowns.empty()) {
      bars.driven = pin;
      bars.joint = &joint;
      bars.carries_next = carries_next;
    }
    return !joint.slide;
  };
  bool pinned = true;
  // From the closing joint down to the common link, and up again.
  for (const int k : first) pinned = add(k, false) && pinned;
  for (std::size_t i = second.size(); i-- > 0;) pinned = add(second[i], true) && pinned;
  return pinned && bars.driven > 0 ? std::optional(bars) : std::nullopt;
}

using Moving = Series<double, 1>;

class ChangePointSearch {
 public:
  ChangePointSearch(const LoopEquations& equations, std::size_t piece, const FourBar& bars)
      : curve_{equations, piece, equations.unknowns}, bars_(bars) {}

  /// The instant after `from`, at the latest at `end`, at which the bars are in line.
  std::optional<std::array<double, 2>> find(double from, double end) const {
    const int before = cross(Ball<double>::exact(from)).c[0].sign();
    if (before == 0) return std::nullopt;
    double lo = from, hi = from, step = (end - from) * 0x1p-50;
    for (; cross(Ball<double>::exact(hi)).c[0].sign() != -before; step *= 2) {
      if (hi >= end) return std::nullopt;
      hi = std::min(end, hi + step);
    }
    for (int k = 0; k < 100; ++k) {
      const double middle = lo + (hi - lo) / 2;
      if (!(lo < middle && middle < hi)) break;
      const int sign = cross(Ball<double>::exact(middle)).c[0].sign();
      if (sign == 0) return closed_in(lo, middle, hi, from, before);
      (sign == before ? lo : hi) = middle;
    }
    return only_root(from, lo, hi);
  }

 private:
  /// Of the two bars at the driven pin.
  Moving cross(const Ball<double>& t) const {
    const auto at = [&](int k) { return bars_.pins[static_cast<std::size_t>(k & 3)]; };
    const LocalPoint pin = at(bars_.driven), next = at(bars_.driven + 1), last = at(bars_.driven + 3);
    const LocalPoint &turning = bars_.carries_next ? next : last, &other = bars_.carries_next ? last : next;
    const auto vector = [&](const LocalPoint& p) {
      const auto to = p.as<double>(), from = pin.as<double>();
      return std::array{Moving::constant(to[0] - from[0]), Moving::constant(to[1] - from[1])};
    };
    const Moving value = value_of(bars_.joint->value, {}, curve_.drives_at(Moving::variable(t)));
    Moving s, c;
    sin_cos_degrees(bars_.joint->sign < 0 ? -value : value, s, c);
    const auto a = vector(turning), b = vector(other);
    return (c * a[0] - s * a[1]) * b[1] - (s * a[0] + c * a[1]) * b[0];
  }

  /// Between lo and hi signs are certain but for a neighbourhood of the middle.
  std::optional<std::array<double, 2>> closed_in(double lo, double middle, double hi, double from, int before) const {
    for (double left = lo, right = middle; left < right;) {
      const double between = left + (right - left) / 2;
      if (!(left < between && between < right)) break;
      (cross(Ball<double>::exact(between)).c[0].sign() == before ? left : right) = between;
      lo = left;
    }
    for (double left = middle, right = hi; left < right;) {
      const double between = left + (right - left) / 2;
      if (!(left < between && between < right)) break;
      (cross(Ball<double>::exact(between)).c[0].sign() == -before ? right : left) = between;
      hi = right;
    }
    return only_root(from, lo, hi);
  }

  std::optional<std::array<double, 2>> only_root(double from, double lo, double hi) const {
    const Moving over = cross(Ball<double>::between(from, hi));
    if (over.terms < 2 || over.c[1].sign() == 0) return std::nullopt;
    return std::array{lo, hi};
  }

  LoopCurve curve_;
  const FourBar& bars_;
};

}  // namespace

std::optional<std::array<double, 2>> change_point_after(const LoopEquations& equations, std::size_t piece, double from,
                                                        double end) {
  const auto bars = four_bar_of(equations);
  if (!bars) return std::nullopt;
  const auto& p = bars->pins;
  if (!are_parallel(p[0], p[1], p[2], p[3])) return std::nullopt;
  const auto found = ChangePointSearch(equations, piece, *bars).find(from, end);
  // Where following has ended long before, it was for another reason.
  return found && (*found)[0] - from <= 0x1p-16 * (end - from) + 0x1p-40 * std::fabs(end) ? found : std::nullopt;
}

}  // namespace taut::internal
