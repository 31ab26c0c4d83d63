// The equations that close the loops of a mechanism, for any kind of numbers.
//
// A tree of joints leads from the ground to every link. The pose of a link is the product of the motions of the joints
// on its path; joint values are degrees or lengths, and 0 in the drawn pose. Each joint that is not in the tree closes
// a loop, and gives the equations F(u, t) = 0 for the unknown values u.
#pragma once

#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "motion/degrees.hpp"
#include "motion/pose.hpp"
#include "numeric/dyadic.hpp"
#include "numeric/exact_sum.hpp"
#include "numeric/series.hpp"
#include "taut/mechanism.hpp"

namespace taut::internal {

/// A sum of multiples of unknowns and of drives, with exact factors.
class LinearForm {
 public:
  struct Term {
    int of;  ///< the number of the unknown or of the drive
    Dyadic factor;
    Ball<double> near;
    template <class Real>
    Ball<Real> as() const {
      if constexpr (std::is_same_v<Real, double>) {
        return near;
      } else {
        return ball_of<Real>(factor);
      }
    }
  };
  static LinearForm unknown(int k) { return single(&LinearForm::unknowns, k); }
  static LinearForm drive(int k) { return single(&LinearForm::drives, k); }
  LinearForm times(const Dyadic& factor) const;

  std::vector<Term> unknowns, drives;

 private:
  static LinearForm single(std::vector<Term> LinearForm::*terms, int k) {
    LinearForm form;
    (form.*terms).push_back({k, Dyadic::exact(1), Ball<double>::exact(1)});
    return form;
  }
};

/// A point of the drawing as seen from the equations' origin: a difference of doubles, exactly.
struct LocalPoint {
  TwoDoubles x{0, 0}, y{0, 0};

  LocalPoint() = default;
  LocalPoint(const Point& at, const Point& origin) : x(two_sum(at.x, -origin.x)), y(two_sum(at.y, -origin.y)) {}
  template <class Real>
  std::array<Ball<Real>, 2> as() const {
    const auto exactly = [](const TwoDoubles& sum) {
      if constexpr (std::is_same_v<Real, double>) {
        return Ball<double>(sum.hi, std::fabs(sum.lo));
      } else {
        return Ball<Real>(Real(sum.hi) + Real(sum.lo), 0.0);
      }
    };
    return {exactly(x), exactly(y)};
  }
  /// How far it is from the origin, about.
  double extent() const { return std::max(std::fabs(x.hi), std::fabs(y.hi)); }
  friend bool operator==(const LocalPoint& a, const LocalPoint& b) {
    return a.x.hi == b.x.hi && a.x.lo == b.x.lo && a.y.hi == b.y.hi && a.y.lo == b.y.lo;
  }
};

/// Everything is seen from an origin at one of the joints, as a drawing may be far from 0.
struct LoopEquations {
  /// A joint of the tree, and the link that it carries.
  struct TreeJoint {
    int parent = -1;  ///< the joint that carries the other body; -1: the ground does
    bool slide = false;
    LocalPoint at;  ///< of a slide, any point
    Point direction;
    double sign = 1;  ///< -1: the link is the joint's first body
    LinearForm value;
  };
  /// A joint that closes a loop, between the links that two joints of the tree carry; -1 stands for the ground.
  struct Closure {
    int first = -1, second = -1;
    bool slide = false;
    LocalPoint at;
    Point pivot, direction;           ///< as drawn
    std::optional<LinearForm> value;  ///< given if the joint is driven or coupled
    int equations() const { return value ? 3 : 2; }
  };
  std::vector<TreeJoint> joints;  ///< parents first
  std::vector<Closure> closures;
  /// Joints that follow from others: of links on one pin.
  std::vector<Closure> implied;
  std::vector<Drive> drives;
  int unknowns = 0;

  /// A joint by its number: first those of the tree, then the closures, then implied ones.
  const Closure& closure(std::size_t joint) const {
    const std::size_t k = joint - joints.size();
    return k < closures.size() ? closures[k] : implied[k - closures.size()];
  }
  /// As many as unknowns in a mechanism that moves as its drives say.
  int equations() const;
};

/// Where all links are, as seen from the origin of the equations, for some values of the unknowns.
template <class J>
struct LinkPoses {
  std::vector<J> values;      ///< of the joints of the tree
  std::vector<PoseOf<J>> of;  ///< of the links, as seen from the ground; in the drawn pose they are identities
};

/// The motion of a joint with this value.
template <class J>
PoseOf<J> joint_pose(bool slide, const LocalPoint& at, const Point& direction, const J& value) {
  using Real = typename J::Number;
  if (slide) {
    const J way = value * (Ball<Real>::exact(1) / length_of_direction<Real>(direction));
    return {way * Ball<Real>::exact(direction.x), way * Ball<Real>::exact(direction.y), J::constant(1.0),
            J::constant(0.0)};
  }
  PoseOf<J> p;
  sin_cos_degrees(value, p.xy, p.xx);
  const J versine = J::constant(1.0) - p.xx;
  const auto [x, y] = at.template as<Real>();
  p.ox = versine * x + p.xy * y;
  p.oy = versine * y - p.xy * x;
  return p;
}

template <class J>
PoseOf<J> resting_pose_of() {
  return {J::constant(0.0), J::constant(0.0), J::constant(1.0), J::constant(0.0)};
}

/// Where a pose puts a point.
template <class J>
std::array<J, 2> placed_point(const PoseOf<J>& p, const LocalPoint& at) {
  const auto [x, y] = at.template as<typename J::Number>();
  return {p.ox + (p.xx * x - p.xy * y), p.oy + (p.xy * x + p.xx * y)};
}

template <class J>
J value_of(const LinearForm& form, const std::vector<J>& unknowns, const std::vector<J>& drives) {
  using Real = typename J::Number;
  J sum = J::constant(0.0);
  const auto add = [&sum](const LinearForm::Term& term, const std::vector<J>& from) {
    const Ball<Real> factor = term.as<Real>();
    const J& x = from[static_cast<std::size_t>(term.of)];
    const bool one = factor.rad == 0 && factor.mid == Real(1);
    sum = sum + (one ? x : x * factor);
  };
  for (const auto& term : form.unknowns) add(term, unknowns);
  for (const auto& term : form.drives) add(term, drives);
  return sum;
}

/// The value that a piece of a drive says, where J is the time as a function of whatever the numbers are functions of.
template <class J>
J drive_value(const Drive::Piece& piece, const J& t) {
  using Real = typename J::Number;
  if (!piece.line) {
    J sum = J::constant(0.0);
    for (std::size_t k = piece.polynomial.size(); k-- > 0;) sum = sum * t + J::constant(piece.polynomial[k]);
    return sum;
  }
  const auto& [t0, v0, t1, v1] = *piece.line;
  using B = Ball<Real>;
  if (t0 == t1 || v0 == v1) return J::constant(v0);
  const B slope = (B::exact(v1) - B::exact(v0)) / (B::exact(t1) - B::exact(t0));
  return J::constant(v0) + (t - J::constant(t0)) * slope;
}

/// Its derivative by the time.
template <class J>
J drive_rate(const Drive::Piece& piece, const J& t) {
  using B = Ball<typename J::Number>;
  if (!piece.line) {
    J sum = J::constant(0.0);
    for (std::size_t k = piece.polynomial.size(); k-- > 1;)
      sum = sum * t + J::constant(B::exact(piece.polynomial[k]) * static_cast<double>(k));
    return sum;
  }
  const auto& [t0, v0, t1, v1] = *piece.line;
  if (t0 == t1 || v0 == v1) return J::constant(0.0);
  return J::constant((B::exact(v1) - B::exact(v0)) / (B::exact(t1) - B::exact(t0)));
}

template <class J>
LinkPoses<J> link_poses(const LoopEquations& equations, std::vector<J> values) {
  LinkPoses<J> links{std::move(values), {}};
  links.of.reserve(equations.joints.size());
  for (std::size_t k = 0; k < equations.joints.size(); ++k) {
    const LoopEquations::TreeJoint& joint = equations.joints[k];
    const J& value = links.values[k];
    const PoseOf<J> own = joint_pose(joint.slide, joint.at, joint.direction, joint.sign < 0 ? -value : value);
    links.of.push_back(joint.parent < 0 ? own : compose(links.of[static_cast<std::size_t>(joint.parent)], own));
  }
  return links;
}

template <class J>
LinkPoses<J> link_poses(const LoopEquations& equations, const std::vector<J>& unknowns, const std::vector<J>& drives) {
  std::vector<J> values;
  values.reserve(equations.joints.size());
  for (const LoopEquations::TreeJoint& joint : equations.joints)
    values.push_back(value_of(joint.value, unknowns, drives));
  return link_poses(equations, std::move(values));
}

/// Calls visit(joint) for each joint between a link and the ground.
template <class Visit>
void for_each_joint_on_path(const LoopEquations& equations, int link, const Visit& visit) {
  for (; link >= 0; link = equations.joints[static_cast<std::size_t>(link)].parent) visit(link);
}

/// By how much a link has turned, in degrees.
template <class J>
J angle_of(const LoopEquations& equations, const LinkPoses<J>& links, int link) {
  J sum = J::constant(0.0);
  for_each_joint_on_path(equations, link, [&](int k) {
    const LoopEquations::TreeJoint& joint = equations.joints[static_cast<std::size_t>(k)];
    if (joint.slide) return;
    const J& value = links.values[static_cast<std::size_t>(k)];
    sum = joint.sign < 0 ? sum - value : sum + value;
  });
  return sum;
}

template <class J>
PoseOf<J> pose_of_link(const LinkPoses<J>& links, int link) {
  return link < 0 ? resting_pose_of<J>() : links.of[static_cast<std::size_t>(link)];
}

/// In which frame the gap of a pin that closes a loop is seen. Where a loop turns as a whole, its equations stay as
/// they are in a frame that turns with it; where it does not, such a frame may turn faster than most of the loop.
enum class GapFrame : unsigned char { ground, turning };

/// A joint that closes a loop: how far its point on the second body is from that on the first one. Of a slide, the
/// first coordinate is along its direction, which turns with the first body.
template <class J>
struct ClosingGap {
  PoseOf<J> first, second;
  std::array<J, 2> p, q;  ///< the point on either body
  bool slide;
  int turns_with;  ///< the link with which the frame turns; -1: the ground
  J ex, ey;        ///< its first axis
  J along, across;

  ClosingGap(const LinkPoses<J>& links, const LoopEquations::Closure& closure, GapFrame seen = GapFrame::ground)
      : first(pose_of_link(links, closure.first)),
        second(pose_of_link(links, closure.second)),
        p(placed_point(first, closure.at)),
        q(placed_point(second, closure.at)),
        slide(closure.slide),
        turns_with(closure.slide              ? closure.first
                   : seen == GapFrame::ground ? -1
                                              : std::max(closure.first, closure.second)) {
    const J x = q[0] - p[0], y = q[1] - p[1];
    if (closure.slide) {
      using Real = typename J::Number;
      const Ball<Real> dx = Ball<Real>::exact(closure.direction.x), dy = Ball<Real>::exact(closure.direction.y);
      ex = first.xx * dx - first.xy * dy;
      ey = first.xy * dx + first.xx * dy;
    } else if (turns_with >= 0) {
      const PoseOf<J> frame = pose_of_link(links, turns_with);
      ex = frame.xx;
      ey = frame.xy;
    }
    std::tie(along, across) = seen_as(x, y);
  }
  /// The coordinates of a vector in the frame.
  std::pair<J, J> seen_as(const J& x, const J& y) const {
    if (!slide && turns_with < 0) return {x, y};
    return {ex * x + ey * y, ex * y - ey * x};
  }
};

/// The value of a joint that is not in the tree.
template <class J>
J closing_value(const LoopEquations& equations, const LinkPoses<J>& links, const LoopEquations::Closure& closure) {
  using Real = typename J::Number;
  if (!closure.slide) return angle_of(equations, links, closure.second) - angle_of(equations, links, closure.first);
  return ClosingGap<J>(links, closure).along * (Ball<Real>::exact(1) / length_of_direction<Real>(closure.direction));
}

/// F: zero where the loops are closed.
template <class J>
std::vector<J> residuals(const LoopEquations& equations, const LinkPoses<J>& links, const std::vector<J>& unknowns,
                         const std::vector<J>& drives, GapFrame seen) {
  using Real = typename J::Number;
  std::vector<J> out;
  for (const LoopEquations::Closure& closure : equations.closures) {
    const ClosingGap<J> gap(links, closure, seen);
    const auto turned = [&] {
      return angle_of(equations, links, closure.second) - angle_of(equations, links, closure.first);
    };
    if (!closure.slide) {
      out.push_back(gap.along);
      out.push_back(gap.across);
      if (closure.value) out.push_back(turned() - value_of(*closure.value, unknowns, drives));
      continue;
    }
    // The second body is on the line, and turned as the first.
    out.push_back(gap.across);
    out.push_back(turned());
    if (closure.value)
      out.push_back(gap.along -
                    value_of(*closure.value, unknowns, drives) * length_of_direction<Real>(closure.direction));
  }
  return out;
}

/// The derivatives of F by the values of the tree's joints, in rows; of joints between neither body and the ground they
/// are 0 and left empty.
template <class J>
std::vector<std::vector<std::optional<J>>> derivatives(const LoopEquations& equations, const LinkPoses<J>& links,
                                                       GapFrame seen) {
  using Real = typename J::Number;
  using Placed = std::array<J, 2>;
  std::vector<std::vector<std::optional<J>>> rows;
  for (const LoopEquations::Closure& closure : equations.closures) {
    const std::size_t first_row = rows.size();
    rows.resize(first_row + static_cast<std::size_t>(closure.equations()),
                std::vector<std::optional<J>>(equations.joints.size()));
    const ClosingGap<J> gap(links, closure, seen);
    for (const bool of_second : {false, true}) {
      const double side = of_second ? 1 : -1;
      const Placed& point = of_second ? gap.q : gap.p;
      for_each_joint_on_path(equations, of_second ? closure.second : closure.first, [&](int k) {
        const LoopEquations::TreeJoint& joint = equations.joints[static_cast<std::size_t>(k)];
        const PoseOf<J> parent = pose_of_link(links, joint.parent);
        const auto add = [&](std::size_t row, const J& term) {
          std::optional<J>& entry = rows[first_row + row][static_cast<std::size_t>(k)];
          entry = entry ? *entry + term : term;
        };
        // How the point moves, and by how much the body turns.
        Placed way;
        const Ball<Real> turn = one_degree<Real>() * (joint.slide ? 0.0 : side * joint.sign);
        if (joint.slide) {
          const Ball<Real> unit = Ball<Real>::exact(side * joint.sign) / length_of_direction<Real>(joint.direction);
          const Ball<Real> u = Ball<Real>::exact(joint.direction.x) * unit,
                           v = Ball<Real>::exact(joint.direction.y) * unit;
          way = {parent.xx * u - parent.xy * v, parent.xy * u + parent.xx * v};
        } else {
          const Placed pivot = placed_point(parent, joint.at);
          way = {(pivot[1] - point[1]) * turn, (point[0] - pivot[0]) * turn};
        }
        const J turned = J::constant(joint.slide ? 0.0 : side * joint.sign);
        auto [along, across] = gap.seen_as(way[0], way[1]);
        if (gap.turns_with >= 0 && gap.turns_with == (of_second ? closure.second : closure.first)) {
          // The frame turns, too: against the sign of `turn` where that is the first body's.
          const Ball<Real> by = of_second ? turn : -turn;
          along = along + gap.across * by;
          across = across - gap.along * by;
        }
        add(0, closure.slide ? across : along);
        add(1, closure.slide ? turned : across);
        if (closure.value) add(2, closure.slide ? along : turned);
      });
    }
  }
  return rows;
}

/// One column of F': how F changes while the joints' values change at these rates, and the closures' given values at
/// theirs.
template <class J, class RateOf>
std::vector<J> change_of(const LoopEquations& equations, const std::vector<std::vector<std::optional<J>>>& by_joint,
                         const RateOf& rate_of) {
  using Real = typename J::Number;
  std::vector<J> column(by_joint.size(), J::constant(0.0));
  for (std::size_t k = 0; k < equations.joints.size(); ++k) {
    const std::optional<J> rate = rate_of(equations.joints[k].value);
    if (!rate) continue;
    for (std::size_t i = 0; i < column.size(); ++i) {
      if (by_joint[i][k]) column[i] = column[i] + *by_joint[i][k] * *rate;
    }
  }
  std::size_t row = 0;
  for (const LoopEquations::Closure& closure : equations.closures) {
    row += static_cast<std::size_t>(closure.equations());
    const std::optional<J> rate = closure.value ? rate_of(*closure.value) : std::nullopt;
    if (!rate) continue;
    J& last = column[row - 1];
    last = last - (closure.slide ? *rate * length_of_direction<Real>(closure.direction) : *rate);
  }
  return column;
}

}  // namespace taut::internal
