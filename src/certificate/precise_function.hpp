// A certificate function as a function of the segment's parameter, at high precision.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "certificate/certificate_function.hpp"
#include "certificate/taylor_frames.hpp"
#include "motion/motion_segment.hpp"
#include "numeric/budget.hpp"

namespace taut::internal {

// A polynomial in the time that is added to a function of the segment's parameter, at one precision.

/// In powers of the time since the segment's `about()`. The segment is not a bridge.
template <class Real>
struct TimePolynomial {
  BallPolynomial<Real> c;
  double about = 0;

  Jet<Real> operator()(const Ball<Real>& t) const { return polynomial_range(c, time_since(t, about)); }
  Jet<Real> operator()(const TimeFromEnd<Real>& t) const {
    return Jet<Real>::polynomial(BallCoefficients<Real>{c}, TimeFromEnd<Real>{t.end, t.direction, t.s, about});
  }
  Ball<Real> value(const Ball<Real>& t) const { return polynomial_value(c, time_since(t, about)); }
  BallPolynomial<Real> expanded_about(double place) const {
    return expanded(c, time_since(Ball<Real>::exact(place), about));
  }

  /// As in PreciseFunction: of the polynomial in s about a singular end, all terms but the last,
  BallPolynomial<Real> terms_from_end(double end, double direction) const {
    const BallPolynomial<Real> in_time = expanded_about(end);
    BallPolynomial<Real> terms;
    for (std::size_t k = 0; k < last_from_end; ++k) {
      const std::size_t power = k / 2;
      const bool there = k % 2 == 0 && power < in_time.size;
      terms.push_back(there ? signed_power(in_time[power], direction, power) : Ball<Real>::exact(0));
    }
    return terms;
  }
  /// and the last one: the range of that coefficient of the expansions about all places up to `farthest`.
  Ball<Real> last_term_from_end(double end, double direction, double farthest) const {
    constexpr std::size_t first = last_from_end / 2;
    const BallPolynomial<Real> in_time = expanded_about(end);
    const Ball<Real> square = Ball<Real>::between(Real(0), Real(detail::inflate(farthest * farthest)));
    Ball<Real> sum = Ball<Real>::exact(0);
    for (std::size_t k = in_time.size; k-- > first;)
      sum = sum * square + signed_power(in_time[k], direction, k) * binomial_of_last(2 * k);
    return sum;
  }

 private:
  /// In how many ways to choose last_from_end of n: exact, as n is at most twice the largest degree.
  static double binomial_of_last(std::size_t n) {
    double product = 1;
    for (std::size_t i = 1; i + last_from_end <= n; ++i)
      product = product * static_cast<double>(last_from_end + i) / static_cast<double>(i);
    return product;
  }
  static Ball<Real> signed_power(const Ball<Real>& x, double direction, std::size_t power) {
    return direction < 0 && power % 2 == 1 ? -x : x;
  }
};

/// The function as five coefficients of the segment's frame functions, in multi-precision, including the displacement.
template <class Real>
class PreciseFunction {
  /// Costs in units of checkpoint(), fitted to instruction counts. A product of numbers three times as long costs less
  /// than three times as much, and sines cost nine times as much. A rotation needs a sine and a cosine, or a root and a
  /// quotient. A range of a polynomial requires its expansion about another place.
  static constexpr std::uint64_t bits = RealTraits<Real>::bits, square = bits * bits / 1024;
  static constexpr std::uint64_t work_of_function = 25, work_of_range = 5 + bits / 4,
                                 work_of_combination = 30 + square / 10;
  static constexpr std::uint64_t work_of_series = 230 + square * 4 / 5, work_of_doubles = 10;
  std::uint64_t work_of_value() const {
    if (std::is_same_v<Real, double>) return is_polynomial() ? 4 : 20;
    if (is_polynomial()) return 1 + degree() * (720 + square) / 540;
    return turns_by_angle() ? 30 + square * 2 / 5 : 40 + square / 9;
  }
  std::uint64_t work_of_jet() const {
    if (std::is_same_v<Real, double>) return is_polynomial() ? 10 : 45;
    return work_of_value() + (is_polynomial() ? degree() * degree() * (11 + square / 64) / 16 : 55 + square / 9);
  }
  std::uint64_t degree() const { return static_cast<std::uint64_t>(segment_.degree); }
  bool turns_by_angle() const {
    return std::holds_alternative<AngleRotation>(segment_.p.rotation) ||
           std::holds_alternative<AngleRotation>(segment_.q.rotation);
  }

 public:
  /// `models` are those of the segment, and must outlive this object. If null, the function has its own.
  PreciseFunction(const MotionSegment& segment, const PairGeometry& g, const CertificateFunction& function,
                  TaylorFrames* models = nullptr)
      : PreciseFunction(segment, g, function, Ball<Real>::exact(0), models) {}
  /// The certificate function plus a constant, and a polynomial in the time without a constant term, if there is one.
  PreciseFunction(const MotionSegment& segment, const PairGeometry& g, const CertificateFunction& function,
                  const Ball<Real>& constant, TaylorFrames* models,
                  std::optional<TimePolynomial<Real>> varying = std::nullopt)
      : segment_(segment), pp_(function.pp), varying_(std::move(varying)), shared_(models) {
    if (!std::is_same_v<Real, double>) count_work(work_of_function);
    const FunctionPoints<Ball<Real>> p = points_of<Ball<Real>>(segment, g, function, Shape::displaced);
    if (portion_of(segment, g, function) == Portion::displacement) {
      coefficients_ = displacement_part(g, function, p);
    } else {
      coefficients_ = coefficients_on(segment, function.pp, p, Ball<Real>::exact(0));
    }
    // The first of the frame's functions is 1. A sum is rounded, even if one summand is zero.
    if (constant.magnitude() > 0) coefficients_[0] = coefficients_[0] + constant;
    if (segment.translation) expand();
    if (segment.bridge) expand_bridge();
  }

  /// Value and derivatives over the ball t of the segment's parameter.
  Jet<Real> operator()(const Ball<Real>& t) const { return range<Sharpness::best>(t); }
  /// Like the call operator, or a wider range that decides the sign of the value or, over an interval, that of the
  /// slope.
  Jet<Real> decisive_range(const Ball<Real>& t) const { return range<Sharpness::decisive>(t); }
  /// Is the decisive range over that ball, which has been computed before, that of an expansion about its middle?
  bool is_expanded(const Ball<Real>& t) const {
    if constexpr (!std::is_same_v<Real, double>) {
      const TaylorFrame<Real>* const known = is_polynomial() ? nullptr : models().known(t);
      if (known && known->suits(t)) return true;
    }
    return is_polynomial();
  }
  /// The Taylor expansion about the middle of a ball, valid over the whole ball, if the decisive range there comes from
  /// such an expansion.
  std::optional<BallPolynomial<Real>> expansion(const Ball<Real>& t) const requires(!std::is_same_v<Real, double>) {
    count_work(2 * work_of_range);
    const Ball<Real> middle(t.mid, 0.0);
    if (is_polynomial()) return expanded(polynomial_, since_about(middle));
    const TaylorFrame<Real>* const known = models().known(t);
    if (!known) return std::nullopt;
    return expanded(about_middle(*known), since_middle(*known, middle));
  }
  /// The value and derivatives as a function of the square root of the distance from a singular end.
  Jet<Real> operator()(const TimeFromEnd<Real>& t) const {
    count_work(work_of_jet());
    return plus_varying(t, combined(frame(segment_, t)));
  }
  /// The terms of the Taylor expansion in s about a singular end, except for the last one,
  BallPolynomial<Real> terms_from_end(double end, double direction) const {
    const auto& f = models().template from_end<Real>().terms(segment_, end, direction);
    count_work(work_of_combination);
    BallPolynomial<Real> sum;
    for (std::size_t k = 0; k < last_from_end; ++k) sum.push_back(coefficient_of(f, k));
    if (varying_) add(varying_->terms_from_end(end, direction), sum);
    return sum;
  }
  /// and the last term, which makes the expansion valid for all s from the end to `farthest`.
  Ball<Real> last_term_from_end(double end, double direction, double farthest) const {
    const Ball<Real> last = combined(models().template from_end<Real>().last(segment_, end, direction, farthest));
    return varying_ ? last + varying_->last_term_from_end(end, direction, farthest) : last;
  }
  /// The value alone, at less than half the cost.
  Ball<Real> value(const Ball<Real>& t) const {
    count_work(work_of_value());
    if (is_polynomial()) return polynomial_value(polynomial_, since_about(t));
    const Ball<Real> sum = combined(frame_values(segment_, t));
    return varying_ ? sum + varying_->value(t) : sum;
  }
  /// The value, or one that is known to only a few digits.
  Ball<Real> telling_value(const Ball<Real>& t) const {
    if constexpr (!std::is_same_v<Real, double>) {
      if (const TaylorFrame<Real>* const known = is_polynomial() ? nullptr : models().known(t)) {
        const Ball<Real> value = value_of(*known, t);
        if (value.rad <= few_digits * RealTraits<Real>::magnitude(value.mid)) return value;
      }
    }
    return value(t);
  }
  /// The range over the ball s of a polynomial given by its terms from an end.
  Jet<Real> decisive_range(const BallPolynomial<Real>& from_end, const Ball<Real>& s) const {
    return range_of<Sharpness::decisive>(from_end, s, work_of_range);
  }

 private:
  enum class Sharpness { best, decisive };
  template <Sharpness sharpness>
  static Jet<Real> range_of(const BallPolynomial<Real>& p, const Ball<Real>& t, std::uint64_t work_of_best) {
    if constexpr (sharpness == Sharpness::decisive && !std::is_same_v<Real, double>) {
      count_work(work_of_doubles);
      if (const auto range = decisive_range_in_doubles(p, t)) return *range;
    }
    count_work(work_of_best);
    return polynomial_range(p, t);
  }
  template <Sharpness sharpness>
  Jet<Real> range(const Ball<Real>& t) const {
    if (is_polynomial()) return range_of<sharpness>(polynomial_, since_about(t), work_of_jet());
    if constexpr (!std::is_same_v<Real, double>) {
      // If a range did not decide, the range of a part of it hardly ever does, unless the model omitted much.
      if (const TaylorFrame<Real>* const known = models().known(t)) {
        const Jet<Real> range = range_by<sharpness>(*known, t);
        if constexpr (sharpness == Sharpness::decisive) {
          if (is_decisive(range, t)) return range;
          if (const TaylorFrame<Real>* const better = better_model(*known, range, t)) {
            return range_by<sharpness>(*better, t);
          }
        }
        if (known->suits(t)) return range;
      }
    }
    count_work(work_of_jet());
    const Jet<Real> range = plus_varying(t, combined(frame(segment_, t)));
    if constexpr (!std::is_same_v<Real, double>) {
      // Use the frame's polynomials about a place nearby (see TaylorFrames). Doubles do without.
      const TaylorFrame<Real>* const made = t.rad != 0 && !is_decisive(range, t) ? new_model(t) : nullptr;
      if (made) return range_by<sharpness>(*made, t);
    }
    return range;
  }
  Ball<Real> combined(const FrameValues<Real>& frame) const { return sum_of(pp_ ? frame.for_pp : frame.for_qq); }
  Jet<Real> combined(const Frame<Real>& frame) const { return combine(pp_ ? frame.for_pp : frame.for_qq); }
  template <class Time>
  Jet<Real> plus_varying(const Time& t, const Jet<Real>& sum) const {
    return varying_ ? sum + (*varying_)(t) : sum;
  }
  /// Adds a polynomial to another one, which may be shorter.
  static void add(const BallPolynomial<Real>& more, BallPolynomial<Real>& sum) {
    for (std::size_t k = 0; k < more.size; ++k) {
      if (k < sum.size) {
        sum[k] = sum[k] + more[k];
      } else {
        sum.push_back(more[k]);
      }
    }
  }
  Ball<Real> sum_of(const std::array<Ball<Real>, 5>& v) const {
    Ball<Real> sum = v[0] * coefficients_[0];
    for (std::size_t i = 1; i < 5; ++i) sum = sum + v[i] * coefficients_[i];
    return sum;
  }
  template <int N>
  Ball<Real> coefficient_of(const FrameOf<Series<Real, N>>& frame, std::size_t k) const {
    const std::array<Series<Real, N>, 5>& f = pp_ ? frame.for_pp : frame.for_qq;
    Ball<Real> c = f[0].c[k] * coefficients_[0];
    for (std::size_t i = 1; i < 5; ++i) c = c + f[i].c[k] * coefficients_[i];
    return c;
  }
  template <Sharpness sharpness>
  Jet<Real> range_by(const TaylorFrame<Real>& model, const Ball<Real>& t) const {
    return range_of<sharpness>(about_middle(model), since_middle(model, t), work_of_range);
  }
  Ball<Real> value_of(const TaylorFrame<Real>& model, const Ball<Real>& t) const {
    count_work(work_of_combination);
    return polynomial_value(about_middle(model), since_middle(model, t));
  }
  static Ball<Real> since_middle(const TaylorFrame<Real>& model, const Ball<Real>& t) {
    return t - Ball<Real>(model.middle, 0.0);
  }
  /// Null if there is no suitable model.
  const TaylorFrame<Real>* new_model(const Ball<Real>& t,
                                     TaylorFrames::Reach reach = TaylorFrames::Reach::several_times) const {
    const TaylorFrame<Real>* const made = models().make(segment_, t, reach);
    if (made) count_work(work_of_series);
    return made;
  }
  /// If the part that the model omits hides the sign: a model that omits less, if it is worth the cost.
  const TaylorFrame<Real>* better_model(const TaylorFrame<Real>& model, const Jet<Real>& range,
                                        const Ball<Real>& t) const {
    if (!model.is_loose_for(t) || !is_hidden_by_last(about_middle_, range.v, since_middle(model, t))) return nullptr;
    return new_model(t, TaylorFrames::Reach::once);
  }
  const BallPolynomial<Real>& about_middle(const TaylorFrame<Real>& model) const {
    if (combined_ != model.number) {
      count_work(work_of_combination);
      combined_ = model.number;
      about_middle_.size = 0;
      for (std::size_t k = 0; k <= model_degree; ++k) {
        about_middle_.push_back(coefficient_of(model.about_middle, k));
      }
      if (varying_)
        add(expanded(varying_->c, time_since(Ball<Real>(model.middle, 0.0), varying_->about)), about_middle_);
    }
    return about_middle_;
  }
  TaylorFrames& models() const { return shared_ ? *shared_ : own_; }

  /// On a translation the function is a polynomial. Its own coefficients show roots that those of x and y hide.
  void expand() {
    polynomial_.size = 0;
    const auto change = [this](int power) {
      const auto k = static_cast<std::size_t>(power);
      return coefficients_[1] * segment_.way_coefficient<Ball<Real>>(true, k) +
             coefficients_[2] * segment_.way_coefficient<Ball<Real>>(false, k);
    };
    polynomial_.push_back(segment_.far() ? coefficients_[0] + change(0) : coefficients_[0]);
    for (int k = 1; k <= segment_.degree; ++k) polynomial_.push_back(change(k));
    if (varying_) add(varying_->c, polynomial_);
  }
  /// The variable of that polynomial.
  Ball<Real> since_about(const Ball<Real>& t) const {
    return segment_.translation ? time_since(t, segment_.about()) : t;
  }
  void expand_bridge() {
    const FrameOf<ModelSeries<Real>> f = frame_series(segment_, Ball<Real>::exact(0));
    for (std::size_t k = 0; k <= 2; ++k) polynomial_.push_back(coefficient_of(f, k));
  }
  /// The relative error of a value at which Newton steps still gain several bits.
  static constexpr double few_digits = 0x1p-16;
  bool is_polynomial() const { return segment_.translation || segment_.bridge; }
  /// For a function that is zero at all times before the displacement: the remaining part, without cancellation. The
  /// product, linear in the edge e0 + e1 and in the points r0 + r1, without e0 r0, is e0 r1 + e1 (r0 + r1).
  std::array<Ball<Real>, 5> displacement_part(const PairGeometry& g, const CertificateFunction& function,
                                              const FunctionPoints<Ball<Real>>& whole) const {
    using B = Ball<Real>;
    const DisplacedPoint &a = g.point(function.a), &b = g.point(function.b), &c = g.point(function.c);
    FunctionPoints<B> edge = whole;
    edge.ex = B::exact(b.dx) - B::exact(a.dx);
    edge.ey = B::exact(b.dy) - B::exact(a.dy);
    edge.measure(function.measure);
    FunctionPoints<B> points{B::exact(b.x) - B::exact(a.x),
                             B::exact(b.y) - B::exact(a.y),
                             B::exact(a.dx),
                             B::exact(a.dy),
                             B::exact(c.dx),
                             B::exact(c.dy)};
    points.measure(function.measure);
    std::array<B, 5> sum = function_coefficients(function.pp, edge);
    const std::array<B, 5> more = function_coefficients(function.pp, points);
    // The motion's terms contain the edge alone, so they are in the first sum.
    for (const std::size_t i : {0, 3, 4}) sum[i] = sum[i] + more[i];
    return sum;
  }
  Jet<Real> combine(const std::array<Jet<Real>, 5>& f) const {
    Jet<Real> sum = f[0] * coefficients_[0];
    for (std::size_t i = 1; i < 5; ++i) sum = sum + f[i] * coefficients_[i];
    return sum;
  }

  const MotionSegment& segment_;
  bool pp_;
  std::array<Ball<Real>, 5> coefficients_;
  BallPolynomial<Real> polynomial_;              ///< for a translation, or a bridge
  std::optional<TimePolynomial<Real>> varying_;  ///< what is added to the certificate function besides a constant
  TaylorFrames* shared_;
  mutable TaylorFrames own_;
  mutable std::uint64_t combined_ = 0;  ///< the number of the model from which this was computed:
  mutable BallPolynomial<Real> about_middle_;
};

}  // namespace taut::internal
