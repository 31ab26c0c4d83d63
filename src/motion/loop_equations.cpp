#include "motion/loop_equations.hpp"

namespace taut::internal {

LinearForm LinearForm::times(const Dyadic& factor) const {
  LinearForm product;
  const auto scale = [&factor](const std::vector<Term>& from, std::vector<Term>& to) {
    for (const Term& term : from) {
      const Dyadic exact = term.factor * factor;
      if (!exact.is_zero()) to.push_back({term.of, exact, detail::in_doubles(ball_of<Real320>(exact))});
    }
  };
  scale(unknowns, product.unknowns);
  scale(drives, product.drives);
  return product;
}

int LoopEquations::equations() const {
  int sum = 0;
  for (const Closure& closure : closures) sum += closure.equations();
  return sum;
}

}  // namespace taut::internal
