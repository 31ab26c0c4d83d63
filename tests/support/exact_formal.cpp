#include "support/exact_formal.hpp"

namespace taut::testing::exact {

void Formal::add(const Key& key, const Complex& c) {
  if (c.zero()) return;
  const auto [place, fresh] = terms_.emplace(key, c);
  if (fresh) return;
  place->second = place->second + c;
  if (place->second.zero()) terms_.erase(place);
}

Formal Formal::term(bool root, int which, const Poly& angle, const Complex& c) {
  Key key;
  key.roots[static_cast<std::size_t>(which)] = root;
  key.angle = angle;
  Formal f;
  f.add(key, c);
  return f;
}

Formal operator+(Formal a, const Formal& b) {
  for (const auto& [key, c] : b.terms_) a.add(key, c);
  return a;
}

Formal operator-(Formal a, const Formal& b) {
  for (const auto& [key, c] : b.terms_) a.add(key, Complex{} - c);
  return a;
}

Formal operator*(const Complex& x, const Formal& a) {
  Formal r;
  for (const auto& [key, c] : a.terms_) r.add(key, x * c);
  return r;
}

Formal conj(const Formal& a) {
  Formal r;
  for (const auto& [key, c] : a.terms_) r.add({key.roots, Rational(-1) * key.angle}, conj(c));
  return r;
}

Formal Formal::product(const Formal& a, const Formal& b, const Radicands& radicands) {
  Formal r;
  for (const auto& [ka, ca] : a.terms_) {
    for (const auto& [kb, cb] : b.terms_) {
      Key key{{}, ka.angle + kb.angle};
      Complex c = ca * cb;
      for (std::size_t k = 0; k < 2; ++k) {
        key.roots[k] = ka.roots[k] != kb.roots[k];
        if (ka.roots[k] && kb.roots[k]) c = c * Complex{radicands[k], {}};
      }
      r.add(key, c);
    }
  }
  return r;
}

Formal Formal::at(const Rational& t, const Radicands& radicands) const {
  const auto constant = [](const Rational& x) { return trimmed(Poly{x}); };
  const Rational first = value(radicands[0], t), second = value(radicands[1], t);
  Rational root[2], ratio;
  const bool square[2] = {is_square(first, root[0]), is_square(second, root[1])};
  const bool alike = !square[0] && !square[1] && is_square(second / first, ratio);
  Formal r;
  for (const auto& [key, c] : terms_) {
    Complex x{constant(value(c.re, t)), constant(value(c.im, t))};
    Key at{key.roots, constant(value(key.angle, t))};
    const auto times = [&](const Rational& q) { x = x * Complex{constant(q), {}}; };
    for (std::size_t k = 0; k < 2; ++k) {
      if (!at.roots[k] || !square[k]) continue;
      times(root[k]);
      at.roots[k] = false;
    }
    if (alike && at.roots[1]) {
      times(ratio);
      at.roots[1] = false;
      if (at.roots[0]) times(first);
      at.roots[0] = !at.roots[0];
    }
    r.add(at, x);
  }
  return r;
}

const Complex* Formal::as_polynomial() const {
  static const Complex nothing;
  if (terms_.empty()) return &nothing;
  const auto& [key, c] = *terms_.begin();
  const bool plain = terms_.size() == 1 && !key.roots[0] && !key.roots[1] && key.angle.empty();
  return plain ? &c : nullptr;
}

std::optional<Poly> Formal::norm(bool imaginary, const Radicands& radicands) const {
  Poly part[2][2];  // beside 1 and the roots, and beside their product
  for (const auto& [key, c] : terms_) {
    if (!key.angle.empty()) return std::nullopt;
    part[key.roots[0] ? 1 : 0][key.roots[1] ? 1 : 0] = imaginary ? c.im : c.re;
  }
  const auto square = [](const Poly& p) { return p * p; };
  const auto& [first, second] = radicands;
  // (a + b g_1)^2 - (c + d g_1)^2 g_0^2 is p + q g_1, and so on.
  const Poly p =
      square(part[0][0]) + square(part[0][1]) * second - (square(part[1][0]) + square(part[1][1]) * second) * first;
  const Poly q = Rational(2) * (part[0][0] * part[0][1] - part[1][0] * part[1][1] * first);
  Poly all = q.empty() ? p : square(p) - square(q) * second;
  if (all.empty()) return std::nullopt;
  return all;
}

}  // namespace taut::testing::exact
