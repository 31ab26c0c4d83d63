#include "motion/pose.hpp"

#include "numeric/dyadic.hpp"

namespace taut {

bool same_rotation(const Rotation& a, const Rotation& b) {
  std::vector<const Coefficients*> of_a, of_b;
  for_each_polynomial(a, [&](const Coefficients& c) { of_a.push_back(&c); });
  for_each_polynomial(b, [&](const Coefficients& c) { of_b.push_back(&c); });
  return a.index() == b.index() && std::equal(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                                              [](const auto* x, const auto* y) { return *x == *y; });
}

std::optional<SingularCosine> singular_at(const CosineRotation& rotation, double end) {
  if (rotation.a.size() < 2) return std::nullopt;
  double about = 0;
  for (std::size_t k = rotation.a.size(); k-- > 0;) about = about * end + rotation.a[k];
  const double extreme = about > 0 ? 1 : -1;
  if (!(std::fabs(about - extreme) < 0x1p-10)) return std::nullopt;
  // The coefficients about the end, exactly.
  DyadicPolynomial c;
  const Dyadic at = Dyadic::exact(end);
  for (const double x : rotation.a) c.push_back(Dyadic::exact(x));
  for (std::size_t k = 0; k + 1 < c.size(); ++k) {
    for (std::size_t i = c.size() - 1; i-- > k;) c[i] = c[i] + c[i + 1] * at;
  }
  c[0] = c[0] - Dyadic::exact(extreme);
  SingularCosine cosine{end, extreme, 0, {}};
  while (cosine.order < c.size() && c[cosine.order].is_zero()) ++cosine.order;
  if (cosine.order == c.size()) return std::nullopt;
  for (std::size_t k = cosine.order; k < c.size(); ++k) cosine.rest.push_back(ball_of<RealMax>(c[k]));
  return cosine;
}

}  // namespace taut
