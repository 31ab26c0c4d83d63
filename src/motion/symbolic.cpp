#include "motion/symbolic.hpp"

#include <algorithm>
#include <utility>

#include "numeric/jet.hpp"
#include "numeric/real.hpp"

namespace taut::internal {
namespace {

template <class Items, class Same>
std::size_t place_of(const Items& items, const Same& same) {
  return static_cast<std::size_t>(std::find_if(items.begin(), items.end(), same) - items.begin());
}

const DyadicPolynomial& zero() {
  static const DyadicPolynomial none;
  return none;
}

}  // namespace

int SymbolicSegment::root_of(const DyadicPolynomial& square, bool clamped) {
  const std::size_t i = place_of(roots_, [&](const Root& r) { return r.square == square; });
  if (i == roots_.size()) roots_.push_back({square, clamped});
  return static_cast<int>(i);
}

int SymbolicSegment::angle_of(const DyadicPolynomial& angle) {
  const std::size_t i = place_of(angles_, [&](const DyadicPolynomial& a) { return a == angle; });
  if (i == angles_.size()) angles_.push_back(angle);
  return static_cast<int>(i);
}

std::size_t SymbolicSegment::factor_of(const DyadicPolynomial& factor) {
  const std::size_t i = place_of(factors_, [&](const DyadicPolynomial& f) { return f == factor; });
  if (i == factors_.size() && i < most_factors) factors_.push_back(factor);
  return i;
}

/// If a cosine c is 1 at the start or end, 1 - c^2 is zero there. Such zeros are divided out.
int SymbolicSegment::sign_over(const DyadicPolynomial& p) const {
  DyadicPolynomial within = p;
  int sign = 1;
  while (auto rest = without_root(within, Dyadic::exact(start_))) within = std::move(*rest);
  while (auto rest = without_root(within, Dyadic::exact(end_))) {
    within = std::move(*rest);
    sign = -sign;
  }
  return sign * sign_with_ends(within);
}

int SymbolicSegment::sign_with_ends(const DyadicPolynomial& p) const {
  BallPolynomial<Real320> balls;
  if (p.size() > balls.capacity) return 0;
  for (const Dyadic& c : p) balls.push_back(ball_of<Real320>(c));
  constexpr int parts = 64;
  int sign = 0;
  for (int i = 0; i < parts; ++i) {
    const double width = end_ - start_, lo = start_ + width * i / parts, hi = start_ + width * (i + 1) / parts;
    const int here = polynomial_range(balls, Ball<Real320>::between(Real320(lo), Real320(hi))).v.sign();
    if (here == 0 || (i > 0 && here != sign)) return 0;
    sign = here;
  }
  return sign;
}

Symbolic Symbolic::constant(double c) { return of(nullptr, {}, {Dyadic::exact(c)}); }

Symbolic Symbolic::of(SymbolicSegment* segment, const Key& key, DyadicPolynomial p) {
  Symbolic s;
  s.segment_ = segment;
  s.add(key, std::move(p));
  return s;
}

Symbolic Symbolic::unknown(SymbolicSegment* segment) {
  Symbolic s;
  s.segment_ = segment;
  s.known_ = false;
  return s;
}

void Symbolic::add(const Key& key, DyadicPolynomial p) {
  trim(p);
  if (p.empty()) return;
  const auto same = std::find_if(terms_.begin(), terms_.end(), [&](const Term& t) { return t.key == key; });
  if (same == terms_.end()) {
    terms_.push_back({key, std::move(p)});
  } else {
    same->polynomial = same->polynomial + p;
    if (same->polynomial.empty()) terms_.erase(same);
  }
}

const DyadicPolynomial* Symbolic::as_polynomial() const {
  if (!known_ || denominator_ != Exponents{}) return nullptr;
  if (terms_.empty()) return &zero();
  return terms_.size() == 1 && terms_[0].key == Key{} ? &terms_[0].polynomial : nullptr;
}

Symbolic Symbolic::over(const Exponents& denominator, const SymbolicSegment& segment) const {
  Symbolic s = *this;
  for (std::size_t i = 0; i < denominator.size(); ++i) {
    for (; s.denominator_[i] < denominator[i]; ++s.denominator_[i]) {
      for (Term& t : s.terms_) t.polynomial = t.polynomial * segment.factor(i);
    }
  }
  return s;
}

Symbolic operator-(const Symbolic& a) {
  Symbolic s = a;
  for (Symbolic::Term& t : s.terms_) t.polynomial = -t.polynomial;
  return s;
}

Symbolic operator+(const Symbolic& a, const Symbolic& b) {
  SymbolicSegment* const segment = a.segment_ ? a.segment_ : b.segment_;
  if (!a.known_ || !b.known_) return Symbolic::unknown(segment);
  Symbolic::Exponents most{};
  for (std::size_t i = 0; i < most.size(); ++i) most[i] = std::max(a.denominator_[i], b.denominator_[i]);
  if (!segment) {
    Symbolic sum = a;
    for (const Symbolic::Term& t : b.terms_) sum.add(t.key, t.polynomial);
    return sum;
  }
  Symbolic sum = a.over(most, *segment);
  sum.segment_ = segment;
  const Symbolic other = b.over(most, *segment);
  for (const Symbolic::Term& t : other.terms_) sum.add(t.key, t.polynomial);
  return sum;
}

/// Replaces products of sin and cos of two angles by those of their difference and their sum.
void Symbolic::add_product(const Term& a, const Term& b) {
  DyadicPolynomial p = a.polynomial * b.polynomial;
  const std::uint8_t both = a.key.roots & b.key.roots;
  for (int i = 0; i < 8; ++i) {
    if ((both >> i & 1) == 0) continue;
    const SymbolicSegment::Root& root = segment_->root(i);
    if (root.clamped) known_ = false;
    p = p * root.square;
  }
  Key key{a.key.angle ? a.key.angle : b.key.angle, a.key.angle ? a.key.sine : b.key.sine,
          static_cast<std::uint8_t>(a.key.roots ^ b.key.roots)};
  if (a.key.angle == 0 || b.key.angle == 0) return add(key, std::move(p));
  // These are copies, because a new angle may move those stored in the segment.
  const DyadicPolynomial x = segment_->angle(a.key.angle), y = segment_->angle(b.key.angle);
  p = halved(p);
  const auto add_of = [&](const DyadicPolynomial& angle, double sign) {
    Symbolic sine, cosine;
    sin_cos(of(segment_, {}, angle), sine, cosine);
    const bool sine_wanted = a.key.sine != b.key.sine;
    for (const Term& t : (sine_wanted ? sine : cosine).terms_) {
      const DyadicPolynomial q = p * t.polynomial;
      add({t.key.angle, t.key.sine, key.roots}, sign < 0 ? -q : q);
    }
  };
  // cos cos: (d) + (s); sin sin: (d) - (s); sin cos: sin (s) + sin (d); cos sin: sin (s) - sin (d).
  add_of(x + -y, !a.key.sine && b.key.sine ? -1 : 1);
  add_of(x + y, a.key.sine && b.key.sine ? -1 : 1);
}

Symbolic operator*(const Symbolic& a, const Symbolic& b) {
  Symbolic product;
  product.segment_ = a.segment_ ? a.segment_ : b.segment_;
  product.known_ = a.known_ && b.known_;
  if (!product.known_) return product;
  for (std::size_t i = 0; i < product.denominator_.size(); ++i) {
    product.denominator_[i] = static_cast<std::uint8_t>(a.denominator_[i] + b.denominator_[i]);
  }
  for (const Symbolic::Term& x : a.terms_) {
    for (const Symbolic::Term& y : b.terms_) product.add_product(x, y);
  }
  return product;
}

Symbolic operator/(const Symbolic& a, const Symbolic& b) {
  SymbolicSegment* const segment = a.segment_ ? a.segment_ : b.segment_;
  if (!segment || !b.known_ || b.terms_.size() != 1) return Symbolic::unknown(segment);
  const Symbolic::Term& by = b.terms_[0];
  if (by.key.angle != 0) return Symbolic::unknown(segment);
  // 1 / (p r), where r is a product of roots, is r / (p r^2).
  DyadicPolynomial factor = by.polynomial;
  for (int i = 0; i < 8; ++i) {
    if (by.key.roots >> i & 1) factor = factor * segment->root(i).square;
  }
  Symbolic quotient = a * Symbolic::of(segment, {0, false, by.key.roots}, {Dyadic::exact(1)});
  const std::size_t place = segment->factor_of(factor);
  if (place >= SymbolicSegment::most_factors) return Symbolic::unknown(segment);
  ++quotient.denominator_[place];
  for (std::size_t i = 0; i < b.denominator_.size(); ++i) {
    for (int k = 0; k < b.denominator_[i]; ++k) quotient = quotient * Symbolic::of(segment, {}, segment->factor(i));
  }
  return quotient;
}

Symbolic sqrt(const Symbolic& a) {
  const DyadicPolynomial* const p = a.as_polynomial();
  if (!p) return Symbolic::unknown(a.segment_);
  const auto absolute = [&](const DyadicPolynomial& s) -> std::optional<DyadicPolynomial> {
    const int sign = s.empty() ? 1 : a.segment_->sign_over(s);
    if (sign == 0) return std::nullopt;
    return sign > 0 ? s : -s;
  };
  if (const auto s = square_root(*p)) {
    if (const auto root = absolute(*s)) return Symbolic::of(a.segment_, {}, *root);
  }
  // Test whether the product with a known root is a square: sqrt(p) = |s| / sqrt(q) = |s| sqrt(q) / q.
  for (int i = 0; i < a.segment_->roots(); ++i) {
    const DyadicPolynomial q = a.segment_->root(i).square;
    if (q == *p || a.segment_->root(i).clamped) continue;
    const auto s = square_root(*p * q);
    const auto root = s ? absolute(*s) : std::nullopt;
    if (root) {
      return Symbolic::of(a.segment_, {}, *root) /
             Symbolic::of(a.segment_, {0, false, static_cast<std::uint8_t>(1u << i)}, {Dyadic::exact(1)});
    }
  }
  const int i = a.segment_->root_of(*p, a.segment_->sign_over(*p) <= 0);
  if (i >= 8) return Symbolic::unknown(a.segment_);
  return Symbolic::of(a.segment_, {0, false, static_cast<std::uint8_t>(1u << i)}, {Dyadic::exact(1)});
}

void sin_cos(const Symbolic& a, Symbolic& sine, Symbolic& cosine) {
  const DyadicPolynomial* const p = a.as_polynomial();
  if (!p) {
    sine = cosine = Symbolic::unknown(a.segment_);
  } else if (p->empty()) {
    sine = Symbolic();
    cosine = Symbolic::constant(1);
    sine.segment_ = cosine.segment_ = a.segment_;
  } else {
    const bool flipped = p->back().sign() < 0;
    const int angle = a.segment_->angle_of(flipped ? -*p : *p);
    sine = Symbolic::of(a.segment_, {angle, true, 0}, {Dyadic::exact(flipped ? -1 : 1)});
    cosine = Symbolic::of(a.segment_, {angle, false, 0}, {Dyadic::exact(1)});
  }
}

}  // namespace taut::internal
