#include "relative/even_turn.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "motion/pose.hpp"
#include "numeric/trig.hpp"

namespace taut {
namespace {

/// The least number of so many binary digits that is no less than x >= 0. Bounds are made for such numbers, so that
/// many models have the same ones, and no model hangs on which was made before it.
double first_digits_above(double x, int digits) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  const std::uint64_t rest = (std::uint64_t{1} << (53 - digits)) - 1;
  bits = (bits + rest) & ~rest;
  std::memcpy(&x, &bits, sizeof bits);
  return x;
}
constexpr int digits_of_size = 3, digits_of_error = 2, digits_of_radius = 32;

/// Looked at first, as many legs do not.
bool turns(const Leg& leg) {
  double fastest = 0;
  const auto look = [&](const Coefficients& angle) { fastest = std::max(fastest, std::fabs(coefficient(angle, 1))); };
  for (const MotionPiece* piece : {&leg.p, &leg.q}) {
    if (const auto* given = std::get_if<AngleRotation>(&piece->rotation)) look(given->angle);
  }
  look(leg.turn);
  return fastest > 0 && fastest < 0x1p100;
}

/// A bound of how long a vector is that reaches so far in x and in y.
double length_of(double x, double y) {
  const double square = x * x + y * y, sum = std::fabs(x) + std::fabs(y);
  const bool in_range = square > 0x1p-900 && square < 0x1p900;
  return in_range ? std::min(sum, std::sqrt(square) * (1 + 0x1p-50)) : sum;
}

/// The coefficients of D over a range from those about its middle.
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

bool EvenTurn::Angle::at(double m, double& re, double& im) const {
  if (!(std::fabs(c1 * m) < 0x1p39 && std::fabs(c0) < 0x1p39)) return false;
  const TwoDoubles way = two_product(c1, m), sum = two_sum(way.hi, c0);
  // Four numbers, each less than 2^-13.
  const double low = (sum.lo + way.lo) + (c0_low + c1_low * m);
  const SinCos<double> both = sin_cos_of_sum(sum.hi, low);
  re = both.cos.mid;
  im = sign * both.sin.mid;
  return true;
}

/// Each step rounds twice, and the rate is no closer to its double than another rounding.
void EvenTurn::Spin::set(const Angle& a) {
  angle = a;
  for (int k = 0; k < last; ++k) u[k + 1] = u[k] * (a.sign * a.c1) / (k + 1);
}

std::shared_ptr<const EvenTurn> EvenTurn::of(const Leg& leg) {
  if (leg.bridge || leg.composed || leg.translation || !turns(leg)) return nullptr;
  if (leg.degree > last) return nullptr;  // a series does not have all of D
  const auto even = std::make_shared<EvenTurn>();
  return even->take(leg) ? even : nullptr;
}

/// False where a body turns in another way.
bool EvenTurn::take(const Leg& leg) {
  const auto take_angle = [](const Rotation& rotation, std::optional<Angle>& angle) {
    if (std::holds_alternative<NoRotation>(rotation)) return true;
    const auto* given = std::get_if<AngleRotation>(&rotation);
    if (!given || given->angle.size() > 2) return false;
    angle = Angle{-1, coefficient(given->angle, 0), 0, coefficient(given->angle, 1), 0};
    return true;
  };
  std::optional<Angle> p, q, both;
  if (!take_angle(leg.p.rotation, p) || !take_angle(leg.q.rotation, q)) return false;
  aligned_ = leg.aligned;
  if (p && q) {
    both = Angle{1, coefficient(leg.turn, 0), coefficient(leg.turn_low, 0), coefficient(leg.turn, 1),
                 coefficient(leg.turn_low, 1)};
  } else {
    both = p ? *p : *q;
    both->sign = p ? -1 : 1;
  }
  if (p) to_p_.set(*p);
  if (q) to_q_.set(*q);
  if (!aligned_) relative_.set(*both);
  const Way way = way_about(leg, leg.start);
  if (way.terms == 1) constant_way_ = way;
  return true;
}

EvenTurn::Way EvenTurn::way_about(const Leg& leg, double m) const {
  if (constant_way_) return *constant_way_;
  const std::array<ModelSeries<double>, 2> d = way_series(leg, Ball<double>::exact(m));
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

/// Of functions i and i + 1, whose coefficients about any instant are no larger than these.
void EvenTurn::bound(const Spin& spin, const Way& way, int i, FrameModel& model) const {
  ModelSeries<double> point, range;
  const auto product = [&](const auto& size, int k) {
    double sum = 0;
    for (int j = 0; j < way.terms && j <= k; ++j) sum += std::fabs(spin.u[k - j]) * size(j);
    return sum * (1 + 0x1p-44);
  };
  const auto at_middle = [&](int j) { return way.size[j]; };
  const auto missing = [&](int j) { return way.error[j]; };
  const auto over = [&](int j) {
    return size_over(way.size, way.terms, j, model.radius) + size_over(way.error, way.terms, j, model.radius);
  };
  for (int k = 0; k <= last; ++k) {
    // Sine and cosine to 2^-50 each; roundings: 3 k of the powers, 3 of a complex product, 2 of each term and sum.
    const double size = product(at_middle, k), share = 0x1p-49 + (3 * k + 4 + 2 * way.terms) * 0x1p-53;
    point.c[k] = Ball<double>(size, size * share + product(missing, k) + underflow_slack);
  }
  range.c[3] = Ball<double>(0, product(over, 3));
  range.c[last] = Ball<double>(0, product(over, last));
  for (int part = 0; part < 2; ++part) take_series(model, i + part, point, range);
}

/// Their coefficients.
bool EvenTurn::turn(const Spin& spin, const Way& way, double m, int i, FrameModel& out) {
  double re = 1, im = 0;
  if (spin.angle && !spin.angle->at(m, re, im)) return false;
  std::array<double, 2> turned[last + 1];
  for (int j = 0; j < way.terms; ++j) turned[j] = {re * way.x[j] - im * way.y[j], re * way.y[j] + im * way.x[j]};
  for (int k = 0; k < model_degree; ++k) {
    double x = 0, y = 0;
    for (int j = 0; j < way.terms && j <= k; ++j) {
      const double u = spin.u[k - j], a = u * turned[j][0], b = u * turned[j][1];
      // Times a power of i.
      switch ((k - j) & 3) {
        case 0:
          x += a, y += b;
          break;
        case 1:
          x -= b, y += a;
          break;
        case 2:
          x -= a, y -= b;
          break;
        default:
          x += b, y -= a;
      }
    }
    out.c[k][i] = x;
    out.c[k][i + 1] = y;
  }
  for (int part = i; part < i + 2; ++part) {
    out.bend[part] = 2 * out.c[2][part];
    out.bound_by_coefficients(part);
  }
  return true;
}

const EvenTurn::Bounds& EvenTurn::bounds_for(double radius, Way way) const {
  radius = first_digits_above(radius, digits_of_radius);
  for (int k = 0; k < way.terms && !constant_way_; ++k) {
    way.size[k] = first_digits_above(way.size[k], digits_of_size);
    way.error[k] = first_digits_above(way.error[k], digits_of_error);
  }
  for (const Bounds& b : kept_) {
    if (b.radius == radius && b.way.terms == way.terms && b.way.size == way.size && b.way.error == way.error) return b;
  }
  Bounds& fresh = kept_[next_++ % kept_.size()];
  fresh.way = way;
  fresh.radius = radius;
  FrameModel& model = fresh.model;
  model = {};
  model.radius = fresh.radius;
  model.terms = 1;
  bound(to_p_, fresh.way, 0, model);
  bound(aligned_ ? to_p_ : to_q_, fresh.way, 2, model);
  Way one;
  one.size[0] = 1;
  bound(relative_, one, 4, model);
  return fresh;
}

std::optional<FrameModel> EvenTurn::model(const Leg& leg, double start, double end) const {
  const Ball<double> times = Ball<double>::between(start, end);
  const Way way = way_about(leg, times.mid);
  std::optional<FrameModel> m = bounds_for(times.rad, way).model;
  m->start = start;
  m->end = end;
  m->middle = times.mid;
  m->radius = times.rad;
  Way one;
  one.x[0] = 1;
  const bool known = turn(to_p_, way, times.mid, 0, *m) && turn(aligned_ ? to_p_ : to_q_, way, times.mid, 2, *m) &&
                     turn(relative_, one, times.mid, 4, *m);
  if (!known) m.reset();
  return m;
}

FrameThird EvenTurn::third(const Leg& leg, bool pp, double start, double end) const {
  const Ball<double> times = Ball<double>::between(start, end);
  const Way way = way_about(leg, times.mid);
  const Spin& spin = pp || aligned_ ? to_p_ : to_q_;
  double of_way = 0;
  for (int j = 0; j < way.terms && j <= 3; ++j) {
    of_way += std::fabs(spin.u[3 - j]) *
              (size_over(way.size, way.terms, j, times.rad) + size_over(way.error, way.terms, j, times.rad));
  }
  of_way = 6 * of_way * (1 + 0x1p-40);
  const double of_turn = 6 * std::fabs(relative_.u[3]) * (1 + 0x1p-40);
  return {{of_way, of_way, of_turn, of_turn}};
}

}  // namespace taut
