#include "motion/uniform_rotation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <tuple>
#include <utility>

#include "motion/pose.hpp"
#include "numeric/ball.hpp"
#include "numeric/trig.hpp"

namespace taut::internal {
namespace {

/// The least number with this many binary digits that is not less than x >= 0. Bounds are computed for such numbers, so
/// that many models share them, and no model depends on those computed before it.
double first_digits_above(double x, int digits) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  const std::uint64_t rest = (std::uint64_t{1} << (53 - digits)) - 1;
  bits = (bits + rest) & ~rest;
  std::memcpy(&x, &bits, sizeof bits);
  return x;
}
constexpr int digits_of_size = 3, digits_of_error = 2, digits_of_radius = 32;

/// A quick test, because many segments do not rotate.
bool rotates(const MotionSegment& segment) {
  double fastest = 0;
  const auto look = [&](const Coefficients& angle) { fastest = std::max(fastest, std::fabs(coefficient(angle, 1))); };
  for (const MotionPiece* piece : {&segment.p, &segment.q}) {
    if (const auto* given = std::get_if<AngleRotation>(&piece->rotation)) look(given->angle);
  }
  return fastest > 0 && fastest < 0x1p100;
}

/// A bound of the length of a vector from bounds of x and y.
double length_of(double x, double y) {
  const double square = x * x + y * y, sum = std::fabs(x) + std::fabs(y);
  const bool in_range = square > 0x1p-900 && square < 0x1p900;
  return in_range ? std::min(sum, std::sqrt(square) * (1 + 0x1p-50)) : sum;
}

/// Bounds the coefficients of D over a range, from those about its middle.
template <class Sizes>
double size_over(const Sizes& size, int terms, int j, double radius) {
  double sum = 0, power = 1, binomial = 1;
  for (int l = j; l < terms; ++l, power *= radius) {
    sum += binomial * size[static_cast<std::size_t>(l)] * power;
    binomial = binomial * (l + 1) / (l + 1 - j);
  }
  return sum;
}

}  // namespace

/// The relative displacement of a rotation alone.
const UniformRotation::Way& UniformRotation::one_way() {
  static const Way one = [] {
    Way way;
    way.x[0] = way.size[0] = 1;
    return way;
  }();
  return one;
}

bool UniformRotation::Angle::at(double m, double& re, double& im) const {
  if (!(std::fabs(c1 * (m - origin)) < 0x1p39 && std::fabs(c0) < 0x1p39)) return false;
  const TwoDoubles since = two_sum(m, -origin);
  const TwoDoubles way = two_product(c1, since.hi), sum = two_sum(way.hi, c0);
  // Five numbers, each less than 2^-13.
  const double low = (sum.lo + way.lo) + (c0_low + c1_low * since.hi) + c1 * since.lo;
  const SinCos<double> both = sin_cos_of_sum(sum.hi, low);
  re = both.cos.mid;
  im = sign * both.sin.mid;
  return true;
}

void UniformRotation::Angle::at(double m, FixedBall& re, FixedBall& im) const {
  using B = Ball<Real320>;
  const B angle =
      (B::exact(c0) + B::exact(c0_low)) + (B::exact(c1) + B::exact(c1_low)) * time_since(B::exact(m), origin);
  const SinCos<Real320> both = sin_cos(angle);
  re = FixedBall::of(both.cos);
  im = FixedBall::of(sign < 0 ? -both.sin : both.sin);
}

/// Each step rounds twice, and the difference between the rate and its double counts as another rounding.
void UniformRotation::Spin::set(const Angle& a) {
  angle = a;
  for (int k = 0; k < last; ++k) u[k + 1] = u[k] * (a.sign * a.c1) / (k + 1);
}

UniformRotation::Powers<FixedBall> UniformRotation::Spin::precise_powers(int exponent) const {
  Powers<FixedBall> powers;
  powers[0] = FixedBall::exact(1);
  if (!angle) return powers;
  const double unit = angle->sign * power_of_two(exponent);
  const FixedBall rate = FixedBall::exact(unit * angle->c1) + FixedBall::exact(unit * angle->c1_low);
  // The cost of a product is proportional to the number of words of its first factor.
  for (int k = 0; k < last; ++k) powers[k + 1] = rate * powers[k] * FixedBall::of(reciprocal<Real320>(k + 1));
  return powers;
}

std::shared_ptr<const UniformRotation> UniformRotation::of(const MotionSegment& segment) {
  if (segment.bridge || segment.composed || segment.translation || !rotates(segment)) return nullptr;
  if (segment.degree > last) return nullptr;  // a series does not contain all of D
  const auto even = std::make_shared<UniformRotation>();
  return even->take(segment) ? even : nullptr;
}

/// On a far segment the angle at the instant of the expansion is rounded to two doubles, which is far less than what
/// Angle::at() rounds.
UniformRotation::Angle UniformRotation::difference_of_angles(const MotionSegment& segment) {
  if (!segment.far()) {
    return {1,
            coefficient(segment.turn, 0),
            coefficient(segment.turn_low, 0),
            coefficient(segment.turn, 1),
            coefficient(segment.turn_low, 1),
            segment.origin};
  }
  const auto rate = [](const MotionPiece& piece) {
    return coefficient(std::get<AngleRotation>(piece.rotation).angle, 1);
  };
  const TwoDoubles change = two_sum(rate(segment.q), -rate(segment.p));
  const DyadicPolynomial& turn = segment.far_turn().exact();
  const Dyadic start = turn.empty() ? Dyadic() : turn[0];
  const double high = nearest_double(start);
  return {1, high, nearest_double(start - Dyadic::exact(high)), change.hi, change.lo, segment.about()};
}

/// False if the rotation of a body is not uniform.
bool UniformRotation::take(const MotionSegment& segment) {
  const auto take_angle = [](const MotionPiece& piece, std::optional<Angle>& angle) {
    if (std::holds_alternative<NoRotation>(piece.rotation)) return true;
    const auto* given = std::get_if<AngleRotation>(&piece.rotation);
    if (!given || given->angle.size() > 2) return false;
    angle = Angle{-1, coefficient(given->angle, 0), 0, coefficient(given->angle, 1), 0, piece.origin};
    return true;
  };
  std::optional<Angle> p, q, both;
  if (!take_angle(segment.p, p) || !take_angle(segment.q, q)) return false;
  aligned_ = segment.aligned;
  if (p && q) {
    both = difference_of_angles(segment);
  } else {
    both = p ? *p : *q;
    both->sign = p ? -1 : 1;
  }
  if (p) to_p_.set(*p);
  if (q) to_q_.set(*q);
  if (!aligned_) relative_.set(*both);
  const Way way = way_about(segment, segment.start);
  if (way.terms == 1) constant_way_ = way;
  return true;
}

UniformRotation::Way UniformRotation::way_about(const MotionSegment& segment, double m) const {
  if (constant_way_) return *constant_way_;
  const std::array<ModelSeries<double>, 2> d = way_series(segment, Ball<double>::exact(m));
  Way way;
  way.terms = std::max(d[0].terms, d[1].terms);
  for (int k = 0; k < way.terms; ++k) {
    way.x[k] = d[0].c[k].mid;
    way.y[k] = d[1].c[k].mid;
    way.size[k] = length_of(way.x[k], way.y[k]);
    way.error[k] = length_of(d[0].c[k].rad, d[1].c[k].rad);
  }
  return way;
}

/// Bounds of D's coefficients about any instant within this radius of the middle.
UniformRotation::Powers<double> UniformRotation::sizes_within(const Way& way, double radius) {
  Powers<double> sizes{};
  for (int j = 0; j < way.terms; ++j) {
    sizes[j] = size_over(way.size, way.terms, j, radius) + size_over(way.error, way.terms, j, radius);
  }
  return sizes;
}

/// A bound of coefficient k of a function, from bounds of D's coefficients.
double UniformRotation::size_of(const Spin& spin, const Powers<double>& sizes, int terms, int k) {
  double sum = 0;
  for (int j = 0; j < terms && j <= k; ++j) sum += std::fabs(spin.u[k - j]) * sizes[j];
  return sum * (1 + 0x1p-44);
}

/// Sets the bounds of functions i and i + 1, whose coefficients about any instant are no larger than these.
void UniformRotation::bound(const Spin& spin, const Way& way, int i, FrameModel& model) const {
  ModelSeries<double> point, range;
  for (int k = 0; k <= last; ++k) {
    // Sine and cosine have an error of 2^-50 each. The roundings are: 3 k of the powers, 3 of a complex product, 2 of
    // each term and sum.
    const double size = size_of(spin, way.size, way.terms, k), share = 0x1p-49 + (3 * k + 4 + 2 * way.terms) * 0x1p-53;
    point.c[k] = Ball<double>(size, size * share + size_of(spin, way.error, way.terms, k) + underflow_slack);
  }
  const Powers<double> over = sizes_within(way, model.radius);
  range.c[3] = Ball<double>(0, size_of(spin, over, way.terms, 3));
  range.c[last] = Ball<double>(0, size_of(spin, over, way.terms, last));
  for (int part = 0; part < 2; ++part) take_series(model, i + part, point, range);
}

/// The coefficients of two functions about an instant at which a body is rotated by (re, im).
template <class N, class Take>
void UniformRotation::turned(const Powers<N>& u, const RelativeDisplacement<N>& way, const N& re, const N& im,
                             const Take& take) {
  N turned_x[last + 1], turned_y[last + 1];
  for (int j = 0; j < way.terms; ++j) {
    turned_x[j] = re * way.x[j] - im * way.y[j];
    turned_y[j] = re * way.y[j] + im * way.x[j];
  }
  for (int k = 0; k < model_degree; ++k) {
    N x{}, y{};
    for (int j = 0; j < way.terms && j <= k; ++j) {
      N a = u[k - j] * turned_x[j], b = u[k - j] * turned_y[j];
      // Multiply by a power of i.
      if ((k - j) & 1) std::tie(a, b) = std::pair(-b, a);
      if ((k - j) & 2) a = -a, b = -b;
      x = x + a;
      y = y + b;
    }
    take(k, x, y);
  }
}

bool UniformRotation::turn(const Spin& spin, const Way& way, double m, int i, FrameModel& out) {
  double re = 1, im = 0;
  if (spin.angle && !spin.angle->at(m, re, im)) return false;
  turned<double>(spin.u, way, re, im, [&](int k, double x, double y) {
    out.c[k][i] = x;
    out.c[k][i + 1] = y;
  });
  for (int part = i; part < i + 2; ++part) {
    out.second[part] = 2 * out.c[2][part];
    out.bound_by_coefficients(part);
  }
  return true;
}

const UniformRotation::Bounds& UniformRotation::bounds_for(double radius, Way way) const {
  radius = first_digits_above(radius, digits_of_radius);
  for (int k = 0; k < way.terms && !constant_way_; ++k) {
    way.size[k] = first_digits_above(way.size[k], digits_of_size);
    way.error[k] = first_digits_above(way.error[k], digits_of_error);
  }
  if (!kept_) {
    kept_ = ThreadLocalPool<Kept>::take();
    for (Bounds& b : kept_->bounds) b.radius = -1;  // those of another rotation
  }
  for (const Bounds& b : kept_->bounds) {
    if (b.radius == radius && b.way.terms == way.terms && b.way.size == way.size && b.way.error == way.error) return b;
  }
  Bounds& fresh = kept_->bounds[kept_->next++ % kept_->bounds.size()];
  fresh.way = way;
  fresh.radius = radius;
  FrameModel& model = fresh.model;
  model = {};
  model.radius = fresh.radius;
  model.terms = 1;
  for (int pair = 0; pair < pairs; ++pair) bound(spin(pair), pair < 2 ? fresh.way : one_way(), 2 * pair, model);
  return fresh;
}

std::optional<FrameModel> UniformRotation::model(const MotionSegment& segment, double start, double end) const {
  const Ball<double> times = Ball<double>::between(start, end);
  const Way way = way_about(segment, times.mid);
  std::optional<FrameModel> m = bounds_for(times.rad, way).model;
  m->start = start;
  m->end = end;
  m->middle = times.mid;
  m->radius = times.rad;
  for (int pair = 0; pair < pairs; ++pair) {
    if (!turn(spin(pair), pair < 2 ? way : one_way(), times.mid, 2 * pair, *m)) return std::nullopt;
  }
  return m;
}

FrameThird UniformRotation::third(const MotionSegment& segment, bool pp, double start, double end) const {
  const Ball<double> times = Ball<double>::between(start, end);
  const Way way = way_about(segment, times.mid);
  const Spin& spin = this->spin(pp ? 0 : 1);
  const double of_way = 6 * size_of(spin, sizes_within(way, times.rad), way.terms, 3) * (1 + 0x1p-40);
  const double of_turn = 6 * std::fabs(relative_.u[3]) * (1 + 0x1p-40);
  return {{of_way, of_way, of_turn, of_turn}};
}

RelativeDisplacement<FixedBall> UniformRotation::precise_way(const MotionSegment& segment, double m, int exponent) {
  const std::array<ModelSeries<Real320>, 2> d = way_series(segment, Ball<Real320>::exact(m));
  RelativeDisplacement<FixedBall> way;
  way.terms = std::max(d[0].terms, d[1].terms);
  for (int k = 0; k < way.terms; ++k) {
    way.x[k] = FixedBall::of(scaled(d[0].c[k], k * exponent));
    way.y[k] = FixedBall::of(scaled(d[1].c[k], k * exponent));
  }
  return way;
}

const UniformRotation::Precise& UniformRotation::precise(const MotionSegment& segment, int exponent) const {
  if (precise_ && precise_->exponent == exponent) return *precise_;
  if (!precise_) precise_ = std::make_unique<Precise>();
  precise_->exponent = exponent;
  for (int pair = 0; pair < pairs; ++pair) precise_->u[pair] = spin(pair).precise_powers(exponent);
  if (constant_way_) precise_->constant_way = precise_way(segment, segment.start, exponent);
  return *precise_;
}

double UniformRotation::rest_within(const MotionSegment& segment, double m, int exponent) const {
  const double radius = power_of_two(exponent);
  const Way way = way_about(segment, m);
  const Powers<double> over = sizes_within(way, radius);
  double most = std::fabs(relative_.u[last]);
  for (int pair = 0; pair < 2; ++pair) most = std::max(most, size_of(spin(pair), over, way.terms, last));
  for (int k = 0; k < last; ++k) most *= radius;
  return most * (1 + 0x1p-44);
}

UniformRotation::Expansion UniformRotation::expansion(const MotionSegment& segment, double m, int exponent) const {
  const Precise& given = precise(segment, exponent);
  const RelativeDisplacement<FixedBall> way =
      given.constant_way ? *given.constant_way : precise_way(segment, m, exponent);
  RelativeDisplacement<FixedBall> one;
  one.x[0] = FixedBall::exact(1);
  // Bounds of the coefficients in t - m about any instant within the radius.
  const double radius = power_of_two(exponent);
  const Way about = way_about(segment, m);
  const Powers<double> over = sizes_within(about, radius);
  // The relative rotation is the composition of the two rotations.
  FixedBall p_re = FixedBall::exact(1), q_re = p_re, p_im, q_im;
  if (to_p_.angle) to_p_.angle->at(m, p_re, p_im);
  if (to_q_.angle) to_q_.angle->at(m, q_re, q_im);
  Expansion made;
  for (int pair = 0; pair < pairs; ++pair) {
    const Spin& s = spin(pair);
    const int i = 2 * pair;
    const bool of_q = pair == 1 && !aligned_, both = pair == 2 && !aligned_;
    const FixedBall re = both ? p_re * q_re + p_im * q_im : pair == 2 ? FixedBall::exact(1) : of_q ? q_re : p_re;
    const FixedBall im = both ? p_im * q_re - p_re * q_im : pair == 2 ? FixedBall() : of_q ? q_im : p_im;
    turned<FixedBall>(given.u[pair], pair < 2 ? way : one, re, im, [&](int k, const FixedBall& x, const FixedBall& y) {
      made.c[i][k] = x;
      made.c[i + 1][k] = y;
    });
    const Powers<double>& sizes = pair < 2 ? over : one_way().size;
    const int terms = pair < 2 ? about.terms : 1;
    double rest = size_of(s, sizes, terms, last);
    for (int k = 0; k < last; ++k) rest *= radius;
    for (int part = i; part < i + 2; ++part) {
      const auto& c = made.c[part];
      const double value = c[0].about(), slope = c[1].about();
      made.rest[part] = rest * (1 + 0x1p-44);
      made.over[part] = {
          {value, detail::inflate(c[0].error_of(value) + size_of(s, sizes, terms, 1) * radius)},
          {slope / radius, detail::inflate(c[1].error_of(slope) / radius + 2 * size_of(s, sizes, terms, 2) * radius)},
          Ball<double>::exact(0)};
    }
  }
  return made;
}

}  // namespace taut::internal
