// Every form of rotation, each described in one place: RotationForm<...>. Readers, writers, checks and engines go by
// these descriptions, so that a new form in Rotation needs one here, and nothing else in the library.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "motion/joint_value.hpp"
#include "motion/local_time.hpp"
#include "motion/symbolic.hpp"
#include "numeric/jet.hpp"
#include "taut/motion.hpp"

namespace taut::internal {

/// A polynomial's coefficients with 0 for the constant.
struct VaryingPart {
  const Coefficients& whole;
  std::size_t size() const { return whole.size(); }
  bool empty() const { return whole.empty(); }
  double operator[](std::size_t k) const { return k == 0 ? 0.0 : whole[k]; }
};

/// A polynomial over a stretch of time, about its middle. Near 1 a cosine's range decides how long stretches can be,
/// and in powers of the time since somewhere else it would be as wide as if the cosine were steep there.
template <class J, class Real>
J about_middle(BallCoefficients<Real> c, const Ball<Real>& t) {
  if (t.rad == 0 || c.p.size == 0) return J::polynomial(c, t);
  c.p = expanded(c.p, t.mid);
  return J::polynomial(c, Ball<Real>(Real(0), t.rad));
}

/// What a cosine adds to its constant part.
template <class J, class Real>
J change_of_cosine(const Coefficients& a, const Ball<Real>& t) {
  BallCoefficients<Real> change;
  for (std::size_t k = 0; k < a.size(); ++k) change.p.push_back(as_ball<Real>(VaryingPart{a}[k]));
  return about_middle<J>(change, t);
}
template <class J, class Time>
J change_of_cosine(const Coefficients& a, const Time& t) {
  return J::polynomial(VaryingPart{a}, t);
}

/// The value of the joint that a body follows, in degrees or lengths.
template <class J, class Time>
J value_of_joint(const JointFollower& follower, const Time& t) {
  return joint_value<J>(*follower.functions, static_cast<std::size_t>(follower.joint),
                        static_cast<std::size_t>(follower.piece), absolute(t)) *
         Ball<typename J::Number>::exact(follower.sign);
}
/// As expressions in the joint's value: identities in it hold at all times.
template <class J>
J value_of_joint(const JointFollower&, const SymbolicTime& t) {
  return J::polynomial(Coefficients{0, 1}, SymbolicTime{t.segment});
}

/// One of the polynomials by which a form is given; its name in scene files and messages.
template <class Form>
struct FormPolynomial {
  const char* name;
  Coefficients Form::*coefficients;
};

/// Why a rotation is not well defined, and what to do.
struct RotationFault {
  std::string problem, remedy;
};

/// What forms need not define themselves.
template <class Form>
struct AnyRotationForm {
  /// Its name in scene files, where it is {"key": [...]}, or {"key": {"a": [...], "b": [...]}} with more polynomials
  /// than one. Empty: it is not written.
  static constexpr const char* key = "";
  static constexpr std::array<FormPolynomial<Form>, 0> polynomials{};
  /// What a model of it over a stretch of time costs, in units of checkpoint(). Measured.
  static constexpr int work = 0;
  /// What keeps it from being a rotation at all times of [start, end]; its polynomials are in powers of t - origin.
  /// Throws SearchExhausted (polynomial_search.hpp) if that is not decided.
  static std::optional<RotationFault> fault(const Form&, double /*origin*/, double /*start*/, double /*end*/) {
    return std::nullopt;
  }
};

/// Defines axis(form, t, xx, xy), the unit vector that the x axis is turned to, too; see rotation_jet(). There is no
/// general one: a form without a description does not compile.
template <class Form>
struct RotationForm;

template <>
struct RotationForm<NoRotation> : AnyRotationForm<NoRotation> {
  template <class J, class Time>
  static void axis(const NoRotation&, const Time&, J& xx, J& xy) {
    xx = J::constant(1.0);
    xy = J::constant(0.0);
  }
};

template <>
struct RotationForm<AngleRotation> : AnyRotationForm<AngleRotation> {
  static constexpr const char* key = "angle";
  static constexpr std::array polynomials{FormPolynomial<AngleRotation>{"angle", &AngleRotation::angle}};
  static constexpr int work = 14;
  template <class J, class Time>
  static void axis(const AngleRotation& r, const Time& t, J& xx, J& xy) {
    sin_cos(angle_at<J>(r.angle, t), xy, xx);
  }
};

template <>
struct RotationForm<DirectionRotation> : AnyRotationForm<DirectionRotation> {
  static constexpr const char* key = "direction";
  static constexpr std::array polynomials{FormPolynomial<DirectionRotation>{"a", &DirectionRotation::a},
                                          FormPolynomial<DirectionRotation>{"b", &DirectionRotation::b}};
  static constexpr int work = 39;
  template <class J, class Time>
  static void axis(const DirectionRotation& r, const Time& t, J& xx, J& xy) {
    const J a = J::polynomial(r.a, t), b = J::polynomial(r.b, t);
    const J length = sqrt(a * a + b * b);
    xx = a / length;
    xy = b / length;
  }
  static std::optional<RotationFault> fault(const DirectionRotation& r, double origin, double start, double end);
};

template <>
struct RotationForm<HalfAngleRotation> : AnyRotationForm<HalfAngleRotation> {
  static constexpr const char* key = "half_angle_tangent";
  static constexpr std::array polynomials{FormPolynomial<HalfAngleRotation>{"s", &HalfAngleRotation::s}};
  static constexpr int work = 16;
  template <class J, class Time>
  static void axis(const HalfAngleRotation& r, const Time& t, J& xx, J& xy) {
    const J s = J::polynomial(r.s, t), square = s * s, one = J::constant(1.0);
    const J below = one + square;
    xx = (one - square) / below;
    xy = (s + s) / below;
  }
};

template <>
struct RotationForm<CosineRotation> : AnyRotationForm<CosineRotation> {
  static constexpr const char* key = "cosine";
  static constexpr std::array polynomials{FormPolynomial<CosineRotation>{"a", &CosineRotation::a}};
  static constexpr int work = 26;
  /// 1 - c^2 as (1 - c)(1 + c), with the constant parts added first: exact where c starts or ends at 1 or -1.
  template <class J, class Time>
  static void axis(const CosineRotation& r, const Time& t, J& xx, J& xy) {
    const J change = change_of_cosine<J>(r.a, absolute(t));
    const J one = J::constant(1.0), start = J::constant(r.a.empty() ? 0.0 : r.a[0]);
    xx = start + change;
    xy = sqrt(((one - start) - change) * ((one + start) + change));
  }
  static std::optional<RotationFault> fault(const CosineRotation& r, double origin, double start, double end);
};

template <>
struct RotationForm<JointFollower> : AnyRotationForm<JointFollower> {
  static constexpr int work = 40;
  template <class J, class Time>
  static void axis(const JointFollower& r, const Time& t, J& xx, J& xy) {
    xx = J::constant(1.0);
    xy = J::constant(0.0);
    if (r.slides) return;
    const J value = value_of_joint<J>(r, t);
    if constexpr (std::is_same_v<J, Symbolic>) {
      sin_cos(value, xy, xx);
    } else {
      sin_cos_degrees(value, xy, xx);
    }
  }
};

/// The description of the form that a value has.
template <class Form>
using FormOf = RotationForm<std::decay_t<Form>>;

/// Calls visit(form) with an empty rotation of each form.
template <class Visit>
void for_each_form(const Visit& visit) {
  [&]<std::size_t... I>(std::index_sequence<I...>) { (visit(std::variant_alternative_t<I, Rotation>{}), ...); }
  (std::make_index_sequence<std::variant_size_v<Rotation>>{});
}

/// Calls visit(coefficients) for each polynomial of a rotation.
template <class Visit>
void for_each_polynomial(const Rotation& rotation, const Visit& visit) {
  std::visit(
      [&](const auto& form) {
        for (const auto& polynomial : FormOf<decltype(form)>::polynomials) visit(form.*polynomial.coefficients);
      },
      rotation);
}
template <class Visit>
void for_each_polynomial(Rotation& rotation, const Visit& visit) {
  for_each_polynomial(std::as_const(rotation), [&](const Coefficients& c) { visit(const_cast<Coefficients&>(c)); });
}

/// x(t) of a rotation; J is Jet<Real>, Series<Real, N> or Symbolic, and the time LocalTime, TimeFromEnd or
/// SymbolicTime, since the rotation's origin.
template <class J, class Time>
void rotation_jet(const Rotation& rotation, const Time& t, J& xx, J& xy) {
  std::visit([&](const auto& form) { FormOf<decltype(form)>::axis(form, t, xx, xy); }, rotation);
}

/// The index of a form in the variant.
template <class Form>
inline constexpr std::size_t form_index = [] {
  std::size_t index = 0;
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    ((std::is_same_v<Form, std::variant_alternative_t<I, Rotation>> ? void(index = I) : void()), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Rotation>>{});
  return index;
}();

/// An empty rotation of the form with this index.
Rotation rotation_of_form(std::size_t index);

/// The joint that the piece's body follows; null if it follows none.
inline const JointFollower* followed_joint(const MotionPiece& piece) {
  return std::get_if<JointFollower>(&piece.rotation);
}

/// Does it change with time, as far as its polynomials show?
bool varies(const Rotation& rotation);

/// Are the two given by the very same coefficients?
bool same_rotation(const Rotation& a, const Rotation& b);

}  // namespace taut::internal
