// The laws of geometry/predicates.hpp, on random and on degenerate input, against rational arithmetic.
#include "geometry/predicates.hpp"
#include "support/effort.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace taut {
using namespace internal;
namespace {

using Rational = boost::multiprecision::cpp_rational;

int sign_of(const Rational& r) { return r < 0 ? -1 : (r > 0 ? 1 : 0); }

int reference(const Point& a, const Point& b, const Point& c) {
  return sign_of((Rational(a.x) - Rational(c.x)) * (Rational(b.y) - Rational(c.y)) -
                 (Rational(a.y) - Rational(c.y)) * (Rational(b.x) - Rational(c.x)));
}

/// Displaced points have an orientation of their own.
int orientation_of(const Point& a, const Point& b, const Point& c) { return orientation(a, b, c); }

/// Triples of every kind that makes floating-point predicates fail.
class Triples {
 public:
  explicit Triples(unsigned seed) : engine_(seed) {}

  struct Triple {
    Point a, b, c;
  };

  Triple next() {
    switch (below(6)) {
      case 0:
        return {uniform(), uniform(), uniform()};
      case 1:
        return {grid(), grid(), grid()};
      case 2:
        return nudged(collinear());
      case 3:
        return collinear();
      case 4:
        return {log_uniform(), log_uniform(), log_uniform()};
      default:
        return nudged(offset());
    }
  }

  int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }

 private:
  double real() { return static_cast<double>(engine_()) * 0x1p-32 * 2 - 1; }
  Point uniform() { return {real(), real()}; }
  Point grid() { return {double(below(9) - 4), double(below(9) - 4)}; }
  double log_uniform_number() { return (below(2) ? 1 : -1) * std::pow(10.0, real() * 12); }
  Point log_uniform() { return {log_uniform_number(), log_uniform_number()}; }

  /// p + k d for small integers: exactly collinear, at a random scale.
  Triple collinear() {
    const Point p = grid(), d = grid();
    const double s = std::ldexp(1 + below(1000), below(80) - 40);
    const auto at = [&](int k) { return Point{s * (p.x + k * d.x), s * (p.y + k * d.y)}; };
    return {at(below(9)), at(below(9)), at(below(9))};
  }
  /// Small shapes far from the origin.
  Triple offset() {
    const double far = std::pow(10.0, 6 + below(4)), step = std::ldexp(1.0, -below(20));
    const auto at = [&] { return Point{far + step * (below(9) - 4), -far + step * (below(9) - 4)}; };
    return {at(), at(), at()};
  }
  double nudge(double x) {
    for (int k = below(3); k > 0; --k)
      x = std::nextafter(x, below(2) ? std::numeric_limits<double>::infinity() : -1e300);
    return std::fabs(x) < 1e-100 ? 0 : x;
  }
  Triple nudged(Triple t) {
    for (Point* p : {&t.a, &t.b, &t.c}) *p = {nudge(p->x), nudge(p->y)};
    return t;
  }

  std::mt19937 engine_;
};

TEST(Orientation, IsTheExactSign) {
  Triples triples(1);
  int zeros = 0, exact = 0;
  for (std::uint64_t i = 0; i < testing::effort(20000); ++i) {
    const auto [a, b, c] = triples.next();
    const int want = reference(a, b, c);
    const StagedSign got = orientation_staged(a, b, c);
    ASSERT_EQ(got.sign, want) << i;
    ASSERT_EQ(orientation_exact(a, b, c), want) << i;
    zeros += want == 0;
    exact += got.stage == Stage::exact;
  }
  EXPECT_GT(zeros, static_cast<int>(testing::enough(2000)));  // the generator does reach the hard cases
  EXPECT_GT(exact, static_cast<int>(testing::enough(1000)));
}

TEST(Orientation, LawsO1AndO2PermutationsChangeTheSignAsTheyMust) {
  Triples triples(2);
  for (std::uint64_t i = 0; i < testing::effort(20000); ++i) {
    const auto [a, b, c] = triples.next();
    const int s = orientation(a, b, c);
    ASSERT_EQ(orientation(b, c, a), s);
    ASSERT_EQ(orientation(c, a, b), s);
    ASSERT_EQ(orientation(b, a, c), -s);
    ASSERT_EQ(orientation(a, c, b), -s);
    ASSERT_EQ(orientation(c, b, a), -s);
  }
}

TEST(Orientation, LawO3ZeroExactlyForCollinearPoints) {
  EXPECT_EQ(orientation_of({0, 0}, {1, 1}, {3, 3}), 0);
  EXPECT_EQ(orientation_of({0.1, 0.1}, {0.2, 0.2}, {0.7, 0.7}), 0);
  EXPECT_EQ(orientation_of({5, 7}, {5, 7}, {1, 2}), 0);
  // Kettner et al. 2008, Fig. 2: in plain doubles this neighbourhood is a patchwork of wrong signs.
  const Point q{12, 12}, r{24, 24};
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 64; ++j) {
      const Point p{0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53};
      ASSERT_EQ(orientation(p, q, r), (i < j) - (i > j) == 0 ? 0 : reference(p, q, r)) << i << ' ' << j;
    }
}

TEST(Orientation, LawO4TranslationByRepresentableVectors) {
  Triples triples(3);
  int tried = 0;
  for (std::uint64_t i = 0; i < testing::effort(20000); ++i) {
    const auto [a, b, c] = triples.next();
    const Point v{std::ldexp(triples.below(2000) - 1000, triples.below(40) - 20), double(triples.below(64))};
    const Point moved[3] = {{a.x + v.x, a.y + v.y}, {b.x + v.x, b.y + v.y}, {c.x + v.x, c.y + v.y}};
    const Point* before[3] = {&a, &b, &c};
    bool exact = true;
    for (int k = 0; k < 3; ++k)
      exact = exact && Rational(moved[k].x) == Rational(before[k]->x) + Rational(v.x) &&
              Rational(moved[k].y) == Rational(before[k]->y) + Rational(v.y);
    if (!exact) continue;
    ++tried;
    ASSERT_EQ(orientation(moved[0], moved[1], moved[2]), orientation(a, b, c));
  }
  EXPECT_GT(tried, static_cast<int>(testing::enough(1000)));
}

TEST(Orientation, LawO5ScalingByPowersOfTwoUpToTheEndsOfTheRange) {
  Triples triples(4);
  for (std::uint64_t i = 0; i < testing::effort(20000); ++i) {
    const auto [a, b, c] = triples.next();
    double least = max_coordinate, largest = min_coordinate;
    for (const double x : {a.x, a.y, b.x, b.y, c.x, c.y})
      if (x != 0) least = std::min(least, std::fabs(x)), largest = std::max(largest, std::fabs(x));
    for (const double s : {std::ldexp(1.0, -399 - std::ilogb(least)), std::ldexp(1.0, 399 - std::ilogb(largest))}) {
      const auto scaled = [&](const Point& p) { return Point{s * p.x, s * p.y}; };
      ASSERT_EQ(orientation(scaled(a), scaled(b), scaled(c)), orientation(a, b, c)) << s;
    }
  }
}

TEST(Orientation, LawO6CounterclockwiseIsPositive) { EXPECT_EQ(orientation_of({0, 0}, {1, 0}, {0, 1}), 1); }

TEST(Orientation, TheRangeMayBeUsedToItsEnds) {
  const double m = max_coordinate, e = min_coordinate;
  EXPECT_EQ(orientation_of({-m, -m}, {m, m}, {0, 0}), 0);
  EXPECT_EQ(orientation_of({-m, -m}, {m, m}, {0, e}), 1);
  EXPECT_EQ(orientation_of({-m, -m}, {m, m}, {e, 0}), -1);
  EXPECT_EQ(orientation_of({e, e}, {std::nextafter(e, 1.0), e}, {e, std::nextafter(e, 1.0)}), 1);
  EXPECT_EQ(orientation_of({e, 2 * e}, {2 * e, 4 * e}, {3 * e, 6 * e}), 0);
  EXPECT_EQ(orientation_of({e, 2 * e}, {2 * e, 4 * e}, {3 * e, std::nextafter(6 * e, 1.0)}), 1);
}

Stage stage_of(const Point& a, const Point& b, const Point& c) { return orientation_staged(a, b, c).stage; }

TEST(Orientation, TellsWhichStageAnswered) {
  EXPECT_EQ(stage_of({0, 0}, {1, 0}, {0, 1}), Stage::doubles);
  // Axis-aligned collinear points are everyday input and need no exact arithmetic.
  EXPECT_EQ(stage_of({0, 3}, {1, 3}, {7, 3}), Stage::doubles);
  EXPECT_EQ(stage_of({0.1, 0}, {0.1, 0.3}, {0.1, 17}), Stage::doubles);
  EXPECT_EQ(stage_of({0, 0}, {1, 1}, {3, 3}), Stage::exact);
  EXPECT_EQ(stage_of({0.5, 0.5}, {12, 12}, {24, std::nextafter(24, 25)}), Stage::exact);

  std::mt19937 engine(5);  // on random input the filter must almost always do
  int exact = 0;
  for (int i = 0; i < 100000; ++i) {
    const auto real = [&] { return static_cast<double>(engine()) * 0x1p-32; };
    const Point a{real(), real()}, b{real(), real()}, c{real(), real()};
    exact += stage_of(a, b, c) == Stage::exact;
  }
  EXPECT_LE(exact, 1);
}

TEST(CrossSign, IsTheExactSign) {
  Triples triples(6);
  for (int i = 0; i < 10000; ++i) {
    const auto [a, b, c] = triples.next();
    const auto [d, e, f] = triples.next();
    const Point other = i % 2 ? d : c;
    const int want = sign_of((Rational(b.x) - Rational(a.x)) * (Rational(other.y) - Rational(c.y)) -
                             (Rational(b.y) - Rational(a.y)) * (Rational(other.x) - Rational(c.x)));
    ASSERT_EQ(cross_sign(a, b, c, other), want);
    ASSERT_EQ(cross_sign_exact(a, b, c, other), want);
    ASSERT_EQ(cross_sign(a, b, a, c), orientation(a, b, c));
  }
  EXPECT_EQ(cross_sign({0, 0}, {0.1, 0.3}, {7, 7}, {7.1, 7.3}),
            sign_of(Rational(0.1) * (Rational(7.3) - 7) - Rational(0.3) * (Rational(7.1) - 7)));
}

TEST(LexicographicOrder, ComparesXThenY) {
  EXPECT_TRUE(lexicographically_less({0, 5}, {1, 0}));
  EXPECT_TRUE(lexicographically_less({1, 0}, {1, 2}));
  EXPECT_FALSE(lexicographically_less({1, 2}, {1, 2}));
  EXPECT_FALSE(lexicographically_less({-0.0, 1}, {0.0, 1}));
}

}  // namespace
}  // namespace taut
