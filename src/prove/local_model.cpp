#include "prove/local_model.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "numeric/overloaded.hpp"

namespace taut::internal {

LocalModel operator+(const LocalModel& a, const LocalModel& b) {
  LocalModel sum;
  for (std::size_t k = 0; k < LocalModel::terms; ++k) sum.c[k] = a.c[k] + b.c[k];
  sum.slack = a.slack + b.slack;
  return sum;
}

LocalModel operator-(const LocalModel& a, const LocalModel& b) { return a + -1.0 * b; }

LocalModel operator*(double factor, const LocalModel& a) {
  LocalModel product;
  for (std::size_t k = 0; k < LocalModel::terms; ++k) product.c[k] = factor * a.c[k];
  product.slack = std::fabs(factor) * a.slack;
  return product;
}

double LocalModels::norm(const LocalModel& m) const {
  double sum = 0;
  for (std::size_t k = LocalModel::terms; k-- > 0;) sum = sum * radius_ + std::fabs(m.c[k]);
  return sum;
}

double LocalModels::lower(const LocalModel& m) const {
  // Even powers with positive coefficients take nothing away.
  double deficit = 0;
  for (std::size_t k = LocalModel::terms; k-- > 1;)
    deficit = deficit * radius_ + (k % 2 == 0 && m.c[k] >= 0 ? 0 : std::fabs(m.c[k]));
  // The checker's slack may be a little larger: it is rounded up, and terms are dropped in another order.
  return m.c[0] - deficit * radius_ - 1.02 * m.slack;
}

LocalModel LocalModels::product(const LocalModel& a, const LocalModel& b) const {
  LocalModel out;
  double beyond = 0;
  for (std::size_t i = 0; i < LocalModel::terms; ++i) {
    if (a.c[i] == 0) continue;
    for (std::size_t j = 0; j < LocalModel::terms; ++j) {
      const double term = a.c[i] * b.c[j];
      if (term == 0) continue;
      if (i + j < LocalModel::terms) {
        out.c[i + j] += term;
      } else {
        beyond += std::fabs(term) * std::pow(radius_, static_cast<double>(i + j));
      }
    }
  }
  out.slack = beyond;
  if (a.slack != 0) out.slack += a.slack * bound(b);
  if (b.slack != 0) out.slack += norm(a) * b.slack;
  return out;
}

LocalModel LocalModels::shifted(const Coefficients& polynomial, const RealMax& offset) const {
  std::vector<RealMax> q;
  for (std::size_t k = polynomial.size(); k-- > 0;) {
    q.emplace_back(0);
    for (std::size_t i = q.size(); i-- > 1;) q[i] = q[i] * offset + q[i - 1];
    q[0] = q[0] * offset + polynomial[k];
  }
  LocalModel out;
  for (std::size_t k = 0; k < q.size(); ++k) {
    const double c = RealTraits<RealMax>::to_double(q[k]);
    if (k < LocalModel::terms) {
      out.c[k] = c;
    } else {
      out.slack += std::fabs(c) * std::pow(radius_, static_cast<double>(k));
    }
  }
  return out;
}

LocalModel LocalModels::one_less(const LocalModel& square, double divisor, const LocalModel& rest) const {
  return LocalModel::constant(1) - product((1 / divisor) * square, rest);
}

std::optional<CosineAndSine> LocalModels::cos_sin(const LocalModel& angle) const {
  LocalModel d = angle;
  d.c[0] = 0;
  const double b = bound(d);
  // The checker's limit is 2.
  if (!(b < 1.999999)) return std::nullopt;
  const LocalModel square = product(d, d), one = LocalModel::constant(1);
  LocalModel sine = product(d, one_less(square, 6, one_less(square, 20, one)));
  LocalModel cosine = one_less(square, 2, one_less(square, 12, one_less(square, 30, one)));
  sine.slack += std::pow(b, 7) / 4096;
  cosine.slack += std::pow(b, 8) / 32768;
  const double c = std::cos(angle.c[0]), s = std::sin(angle.c[0]);
  return CosineAndSine{c * cosine - s * sine, s * cosine + c * sine};
}

LocalModel LocalModels::reciprocal(const LocalModel& m) const {
  LocalModel g = LocalModel::constant(1 / m.c[0]);
  for (int k = 0; k < 4; ++k) {
    g = product(g, LocalModel::constant(2) - product(m, g));
    g.slack = 0;
  }
  g.slack = bound(LocalModel::constant(1) - product(m, g));
  return g;
}

std::optional<LocalModel> LocalModels::reciprocal_root(const LocalModel& m) const {
  if (!(m.c[0] > 0)) return std::nullopt;
  LocalModel g = LocalModel::constant(1 / std::sqrt(m.c[0]));
  for (int k = 0; k < 4; ++k) {
    g = 0.5 * product(g, LocalModel::constant(3) - product(m, product(g, g)));
    g.slack = 0;
  }
  const double residue = bound(LocalModel::constant(1) - product(m, product(g, g)));
  if (!(residue <= 0.5 && lower(g) > 0)) return std::nullopt;
  g.slack = 2 * residue * norm(g);
  return g;
}

LocalModel LocalModels::root(const LocalModel& m) const {
  // Here rounding counts: the root of a small difference of numbers near 1 has few digits.
  const bool clear = m.c[0] > 0x1p-20;
  const auto inverse = clear ? reciprocal_root(m) : std::nullopt;
  if (inverse) return product(m, *inverse);
  const double s = std::sqrt(bound(m) + 0x1p-50);
  LocalModel out = LocalModel::constant(s / 2);
  out.slack = s / 2;
  return out;
}

LocalModel LocalModels::clamped(const LocalModel& m) const {
  if (lower(LocalModel::constant(1) - product(m, m)) > 0) return m;
  LocalModel out = m;
  out.slack += std::max(0.0, bound(m) - 1);
  return out;
}

std::optional<CosineAndSine> LocalModels::rotation(const Rotation& rotation, const RealMax& offset) const {
  using Both = std::optional<CosineAndSine>;
  const LocalModel one = LocalModel::constant(1);
  return std::visit(Overloaded{[&](const NoRotation&) {
                                 return Both({one, LocalModel{}});
                               },
                               [&](const AngleRotation& r) { return cos_sin(shifted(r.angle, offset)); },
                               [&](const DirectionRotation& r) {
                                 const LocalModel a = shifted(r.a, offset), b = shifted(r.b, offset);
                                 const auto inverse = reciprocal_root(product(a, a) + product(b, b));
                                 if (!inverse) return Both();
                                 return Both({product(a, *inverse), product(b, *inverse)});
                               },
                               [&](const HalfAngleRotation& r) {
                                 const LocalModel s = shifted(r.s, offset), square = product(s, s);
                                 const LocalModel inverse = reciprocal(one + square);
                                 return Both({product(one - square, inverse), product(2.0 * s, inverse)});
                               },
                               [&](const CosineRotation& r) {
                                 const LocalModel c = clamped(shifted(r.a, offset));
                                 return Both({c, root(one - product(c, c))});
                               },
                               // Other forms are not covered by exact logs.
                               [](const auto&) { return Both(); }},
                    rotation);
}

}  // namespace taut::internal
