// The law of BoxModel, at random values of the parameters, in long doubles.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "motion/box_model.hpp"
#include "support/rng.hpp"

namespace taut::testing {
namespace {

using internal::Ball;
using internal::BoxModel;

struct ModelledNumber {
  BoxModel model;
  long double exact;  ///< at the parameters' values
};

TEST(BoxModel, ContainsWhatItIsMadeOf) {
  Rng rng(8);
  double widest = 0;
  for (int n = 0; n < 2000; ++n) {
    std::array<long double, BoxModel::parameters> h{};
    for (long double& x : h) x = rng.chance(0.3) ? rng.sign() : rng.real(-1, 1);
    std::vector<ModelledNumber> known;
    for (int i = 0; i < 4; ++i) {
      BoxModel m = BoxModel::constant(rng.real(-3, 3));
      long double exact = m.value;
      for (std::size_t k = 0; k < h.size(); ++k) {
        m.rate[k] = rng.real(-1, 1) * std::exp2(rng.between(-20, 0));
        exact += m.rate[k] * h[k];
      }
      m.error = std::exp2(rng.between(-50, -3));
      known.push_back({m, exact + m.error * rng.real(-1, 1) * (1 - 0x1p-40)});
    }
    for (int step = 0; step < 6; ++step) {
      const ModelledNumber a = rng.pick(known), b = rng.pick(known);
      BoxModel sine, cosine;
      sin_cos(a.model, sine, cosine);
      const double factor = rng.real(-2, 2);
      known.push_back(rng.pick(std::vector<ModelledNumber>{
          {a.model + b.model, a.exact + b.exact},
          {a.model - b.model, a.exact - b.exact},
          {a.model * b.model, a.exact * b.exact},
          {-a.model, -a.exact},
          {a.model * Ball<double>::exact(factor), a.exact * factor},
          {sine, std::sin(a.exact)},
          {cosine, std::cos(a.exact)},
      }));
      const auto& [model, exact] = known.back();
      long double linear = model.value;
      for (std::size_t k = 0; k < h.size(); ++k) linear += model.rate[k] * h[k];
      const long double off = std::fabs(exact - linear);
      ASSERT_LE(off, model.error);
      ASSERT_LE(std::fabs(exact), model.magnitude());
      if (model.error > 1e-9) widest = std::max(widest, static_cast<double>(off / model.error));
    }
  }
  // The bound is not idle.
  EXPECT_GT(widest, 0.5);
}

/// What of two angles cancels costs nothing.
TEST(BoxModel, LinearPartsCancel) {
  BoxModel turn = BoxModel::constant(1);
  turn.rate[2] = 0.25;
  EXPECT_LT((turn - turn).magnitude(), 1e-12);
  EXPECT_LT((turn + -turn).magnitude(), 1e-12);
}

}  // namespace
}  // namespace taut::testing
