#include "proof/path_cell.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/joint_functions.hpp"
#include "motion/joint_value.hpp"
#include "motion/loop_region.hpp"
#include "numeric/trig.hpp"

namespace taut::internal::proof {
namespace {

/// More than a few roundings.
constexpr double up = 1 + 0x1p-45;

double farthest(const Enclosure& e) { return (std::fabs(e.mid) + e.rad) * up; }

CellFunction times(const CellFunction& a, const Enclosure& factor) {
  CellFunction product{a.middle * factor, a.range * factor, {}};
  for (std::size_t k = 0; k < product.slope.size(); ++k) product.slope[k] = a.slope[k] * factor;
  return product;
}

CellFunction negative(const CellFunction& a) { return CellFunction::constant(0) - a; }

}  // namespace

CellFunction operator+(const CellFunction& a, const CellFunction& b) {
  CellFunction sum{a.middle + b.middle, a.range + b.range, {}};
  for (std::size_t k = 0; k < sum.slope.size(); ++k) sum.slope[k] = a.slope[k] + b.slope[k];
  return sum;
}

CellFunction operator-(const CellFunction& a, const CellFunction& b) {
  CellFunction difference{a.middle - b.middle, a.range - b.range, {}};
  for (std::size_t k = 0; k < difference.slope.size(); ++k) difference.slope[k] = a.slope[k] - b.slope[k];
  return difference;
}

CellFunction operator*(const CellFunction& a, const CellFunction& b) {
  CellFunction product{a.middle * b.middle, a.range * b.range, {}};
  for (std::size_t k = 0; k < product.slope.size(); ++k) product.slope[k] = a.slope[k] * b.range + a.range * b.slope[k];
  return product;
}

CellPoint CellPose::place(const Point& p) const {
  const CellFunction u = CellFunction::constant(p.x), v = CellFunction::constant(p.y);
  return {x + c * u - s * v, y + s * u + c * v};
}

CellPose CellPose::of(const CellPose& inner) const {
  return {x + c * inner.x - s * inner.y, y + s * inner.x + c * inner.y, c * inner.c - s * inner.s,
          s * inner.c + c * inner.s};
}

CellPose CellPose::inverse() const { return {negative(c * x + s * y), s * x - c * y, c, negative(s)}; }

CellValues::CellValues(const PathProblem& problem, const PathCell& cell) {
  for (std::size_t k = 0; k < problem.linkage.joints.size(); ++k) {
    const Joint& joint = problem.linkage.joints[k];
    const auto at = [&](std::int64_t units) {
      return joint.lo + (joint.hi - joint.lo) * (static_cast<double>(units) / static_cast<double>(PathCell::whole));
    };
    const double rounding = 0x1p-49 * (std::fabs(joint.lo) + std::fabs(joint.hi));
    lo_[k] = at(cell.lo[k]) - rounding;
    hi_[k] = at(cell.lo[k] + cell.side[k]) + rounding;
    middle_[k] = lo_[k] + (hi_[k] - lo_[k]) / 2;
    half_[k] = std::max(hi_[k] - middle_[k], middle_[k] - lo_[k]) * up;
  }
}

double CellValues::variation(const CellFunction& f) const {
  double sum = 0;
  for (std::size_t k = 0; k < half_.size(); ++k) sum += farthest(f.slope[k]) * half_[k];
  return sum * up;
}

/// The better one of two bounds: by the mean value, and by the range.
double CellValues::least(const CellFunction& f) const {
  const double off = (variation(f) + f.middle.rad) * up;
  return std::max(f.middle.mid - off - 0x1p-50 * (std::fabs(f.middle.mid) + off), f.range.lower());
}

double CellValues::largest(const CellFunction& f) const {
  const double off = (variation(f) + f.middle.rad) * up;
  return std::min(f.middle.mid + off + 0x1p-50 * (std::fabs(f.middle.mid) + off), f.range.upper());
}

/// times * value + plus.
CellFunction CellValues::value(int joint, double times, double plus) const {
  const auto k = static_cast<std::size_t>(joint);
  const Enclosure factor = Enclosure::exact(times), offset = Enclosure::exact(plus);
  CellFunction f{factor * Enclosure::exact(middle_[k]) + offset, factor * Enclosure(middle_[k], half_[k]) + offset, {}};
  f.slope[k] = factor;
  return f;
}

bool CellValues::may_lock(const PathProblem& problem) const {
  const std::vector<DrivenLoops>& all = problem.linkage.loops;
  return std::any_of(all.begin(), all.end(), [&](const DrivenLoops& loops) {
    return loops.region && loops.region->share_of(middle_, half_) != LoopRegion::Share::all;
  });
}

/// Of a link that several joints move; not known where the mechanism may lock.
CellFunction CellValues::value_in_region(const LinkMotion& link) const {
  const auto over = link.region->value(static_cast<std::size_t>(link.follows.joint), middle_, half_);
  const Enclosure anything(0, INFINITY);
  if (!over) {
    CellFunction f{anything, anything, {}};
    f.slope.fill(anything);
    return f;
  }
  CellFunction f{over->middle * link.follows.sign, over->range * link.follows.sign, {}};
  for (std::size_t k = 0; k < f.slope.size(); ++k) f.slope[k] = over->slope[k] * link.follows.sign;
  return f;
}

/// Of a link's joint, in degrees or lengths: its value at the middle, and all values and derivatives.
CellFunction CellValues::value(const LinkMotion& link, int joint) const {
  if (link.region) return value_in_region(link);
  const auto k = static_cast<std::size_t>(joint);
  const auto series = [&](const Enclosure& at) {
    return joint_value<Series<double, 1>>(*link.follows.functions, static_cast<std::size_t>(link.follows.joint),
                                          static_cast<std::size_t>(link.follows.piece), at);
  };
  const auto coefficient = [&](const Series<double, 1>& s, int i) {
    return i < s.terms ? s.c[static_cast<std::size_t>(i)] * link.follows.sign : Enclosure::exact(0);
  };
  const auto over = series(Enclosure(middle_[k], half_[k]));
  CellFunction f{coefficient(series(Enclosure::exact(middle_[k])), 0), coefficient(over, 0), {}};
  f.slope[k] = coefficient(over, 1);
  return f;
}

namespace {

/// Of a sine or a cosine, which is never beyond 1.
Enclosure at_most_one(const Enclosure& e) { return farthest(e) > 1 && e.rad > 0.5 ? Enclosure(0, 1) : e; }

/// The turn by so many degrees, about the origin.
CellPose turn(const CellFunction& degrees) {
  // Around pi / 180, and what coefficients are rounded by that are made of it.
  constexpr double degree = std::numbers::pi / 180;
  const Enclosure unit(degree, degree * 0x1p-50);
  const SinCos<double> middle = sin_cos(degrees.middle * unit), range = sin_cos(degrees.range * unit);
  CellPose pose;
  pose.c.middle = middle.cos;
  pose.s.middle = middle.sin;
  pose.c.range = at_most_one(range.cos);
  pose.s.range = at_most_one(range.sin);
  for (std::size_t k = 0; k < degrees.slope.size(); ++k) {
    const Enclosure rate = degrees.slope[k] * unit;
    pose.c.slope[k] = Enclosure::exact(0) - pose.s.range * rate;
    pose.s.slope[k] = pose.c.range * rate;
  }
  return pose;
}

CellPose moved(const CellFunction& x, const CellFunction& y) {
  CellPose pose;
  pose.x = x;
  pose.y = y;
  return pose;
}

CellPose about(const Point& pivot, const CellPose& turn) {
  const CellPose to = moved(CellFunction::constant(pivot.x), CellFunction::constant(pivot.y));
  return to.of(turn).of(to.inverse());
}

}  // namespace

CellPose CellValues::pose(const JointMotion& motion) const {
  const CellFunction nothing = CellFunction::constant(0);
  if (const auto* revolute = std::get_if<Revolute>(&motion.kind))
    return about(revolute->pivot, turn(value(motion.joint, motion.times, motion.plus)));
  if (const auto* slide = std::get_if<Slide>(&motion.kind)) {
    const CellFunction way = value(motion.joint, motion.times, motion.plus);
    return moved(way * CellFunction::constant(slide->direction.x), way * CellFunction::constant(slide->direction.y));
  }
  if (const auto* link = std::get_if<LinkMotion>(&motion.kind)) {
    const CellFunction at = value(*link, motion.joint);
    if (!link->follows.slides) return about(link->pivot, turn(at));
    const Enclosure x = Enclosure::exact(link->follows.direction.x), y = Enclosure::exact(link->follows.direction.y);
    const Enclosure length = sqrt(x * x + y * y);
    return moved(times(at, x / length), times(at, y / length));
  }
  // A point p is at R (p - pivot) + pivot + (x, y).
  const auto& free = std::get<FreeMotion>(motion.kind);
  const CellPose shift = moved(free.x ? value(*free.x, 1, 0) : nothing, free.y ? value(*free.y, 1, 0) : nothing);
  return free.deg ? shift.of(about(free.pivot, turn(value(*free.deg, 1, 0)))) : shift;
}

}  // namespace taut::internal::proof
