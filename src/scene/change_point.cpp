// Change points of parallelograms and of symmetric slider-cranks.
//
// Four bars, opposite ones equal and drawn parallel, stay parallel until all
// are in line. A slider-crank whose two bars are equal, and whose slide passes
// the crank's pivot, has its other pin there where the crank is square to the
// slide (Scott-Russell). There the motion could go on in another way as well,
// and no bound in numbers can show that: it is known from the bars' vectors,
// which are compared exactly.
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

/// A coordinate, exactly.
Dyadic exactly(const TwoDoubles& sum) { return Dyadic::exact(sum.hi) + Dyadic::exact(sum.lo); }

/// Are two bars equally long, exactly?
bool are_equally_long(const LocalPoint& a, const LocalPoint& pin, const LocalPoint& b) {
  const auto square = [&](const LocalPoint& p) {
    const Dyadic x = exactly(p.x) - exactly(pin.x), y = exactly(p.y) - exactly(pin.y);
    return x * x + y * y;
  };
  return (square(a) - square(b)).is_zero();
}

/// Does the line through a point in a direction pass the other point, exactly?
bool is_on_line(const LocalPoint& p, const Point& direction, const LocalPoint& q) {
  const Dyadic x = exactly(q.x) - exactly(p.x), y = exactly(q.y) - exactly(p.y);
  return (x * Dyadic::exact(direction.y) - y * Dyadic::exact(direction.x)).is_zero();
}

/// A loop of four joints in order, and which of them is driven.
struct FourJoints {
  struct One {
    LocalPoint at;
    bool slide = false;
    Point direction;
  };
  std::array<One, 4> joints;
  int driven = -1;
  const LoopEquations::TreeJoint* joint = nullptr;
  bool carries_next = false;  ///< the joint carries the bar to the next pin

  const One& at(int k) const { return joints[static_cast<std::size_t>(k & 3)]; }
};

std::optional<FourJoints> four_joints_of(const LoopEquations& equations) {
  if (equations.closures.size() != 1) return std::nullopt;
  const LoopEquations::Closure& closure = equations.closures[0];
  std::vector<int> first, second;
  for_each_joint_on_path(equations, closure.first, [&](int k) { first.push_back(k); });
  for_each_joint_on_path(equations, closure.second, [&](int k) { second.push_back(k); });
  while (!first.empty() && !second.empty() && first.back() == second.back()) {
    first.pop_back();
    second.pop_back();
  }
  if (first.size() + second.size() != 3) return std::nullopt;
  FourJoints loop;
  loop.joints[0] = {closure.at, closure.slide, closure.direction};
  int place = 0;
  const auto add = [&](int k, bool carries_next) {
    const LoopEquations::TreeJoint& joint = equations.joints[static_cast<std::size_t>(k)];
    loop.joints[static_cast<std::size_t>(++place)] = {joint.at, joint.slide, joint.direction};
    if (joint.value.unknowns.empty()) {
      loop.driven = place;
      loop.joint = &joint;
      loop.carries_next = carries_next;
    }
  };
  // From the closing joint down to the common link, and up again.
  for (const int k : first) add(k, false);
  for (std::size_t i = second.size(); i-- > 0;) add(second[i], true);
  return loop.driven > 0 && !loop.joint->slide ? std::optional(loop) : std::nullopt;
}

using Vector2 = std::array<Ball<double>, 2>;

/// Two vectors at the driven pin, one of which turns with it: where they are in
/// line, the motion could go on in more than one way.
struct TurningVectors {
  Vector2 turning, other;
  const LoopEquations::TreeJoint* joint;
};

Vector2 between(const LocalPoint& from, const LocalPoint& to) {
  const auto a = from.as<double>(), b = to.as<double>();
  return {b[0] - a[0], b[1] - a[1]};
}

std::optional<TurningVectors> of_parallelogram(const FourJoints& loop) {
  const auto at = [&](int k) { return loop.at(k).at; };
  for (int k = 0; k < 4; ++k) {
    if (loop.at(k).slide) return std::nullopt;
  }
  if (!are_parallel(at(0), at(1), at(2), at(3))) return std::nullopt;
  const int k = loop.driven, turning = loop.carries_next ? k + 1 : k + 3;
  return TurningVectors{between(at(k), at(turning)), between(at(k), at(turning + 2)), loop.joint};
}

std::optional<TurningVectors> of_slider_crank(const FourJoints& loop) {
  const int k = loop.driven, crank = loop.carries_next ? k + 1 : k + 3;
  const FourJoints::One &pivot = loop.at(k), &pin = loop.at(crank), &end = loop.at(k + 2), &slide = loop.at(crank + 2);
  if (!slide.slide || pin.slide || end.slide || !are_equally_long(pivot.at, pin.at, end.at) ||
      !is_on_line(pivot.at, slide.direction, end.at))
    return std::nullopt;
  using B = Ball<double>;
  return TurningVectors{
      between(pivot.at, pin.at), {B::exact(-slide.direction.y), B::exact(slide.direction.x)}, loop.joint};
}

using Moving = Series<double, 1>;

class ChangePointSearch {
 public:
  ChangePointSearch(const LoopEquations& equations, std::size_t piece, const TurningVectors& vectors)
      : curve_{equations, piece, equations.unknowns}, vectors_(vectors) {}

  /// The instant after `from`, at the latest at `end`, at which the vectors are in line.
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
  Moving cross(const Ball<double>& t) const {
    const Moving value = value_of(vectors_.joint->value, {}, curve_.drives_at(Moving::variable(t)));
    Moving s, c;
    sin_cos_degrees(vectors_.joint->sign < 0 ? -value : value, s, c);
    const auto& [a, b] = std::pair(vectors_.turning, vectors_.other);
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
  const TurningVectors& vectors_;
};

}  // namespace

std::optional<std::array<double, 2>> change_point_after(const LoopEquations& equations, std::size_t piece, double from,
                                                        double end) {
  const auto loop = four_joints_of(equations);
  if (!loop) return std::nullopt;
  const auto parallelogram = of_parallelogram(*loop), slider_crank = of_slider_crank(*loop);
  if (!parallelogram && !slider_crank) return std::nullopt;
  const auto found =
      ChangePointSearch(equations, piece, parallelogram ? *parallelogram : *slider_crank).find(from, end);
  // Where following has ended long before, it was for another reason.
  return found && (*found)[0] - from <= 0x1p-16 * (end - from) + 0x1p-40 * std::fabs(end) ? found : std::nullopt;
}

}  // namespace taut::internal
