#include "motion/pose.hpp"

#include "numeric/dyadic.hpp"

namespace taut {

bool same_rotation(const Rotation& a, const Rotation& b) {
  if (a.index() != b.index()) return false;
  return std::visit(Overloaded{[](const NoRotation&) { return true; },
                               [&](const AngleRotation& r) { return r.angle == std::get<AngleRotation>(b).angle; },
                               [&](const DirectionRotation& r) {
                                 const auto& other = std::get<DirectionRotation>(b);
                                 return r.a == other.a && r.b == other.b;
                               },
                               [&](const HalfAngleRotation& r) { return r.s == std::get<HalfAngleRotation>(b).s; },
                               [&](const CosineRotation& r) { return r.a == std::get<CosineRotation>(b).a; }},
                    a);
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
