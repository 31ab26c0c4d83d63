// Functions that vanish at all times through identities between the motions.
#include <gtest/gtest.h>

#include "certificate/certificate_function.hpp"
#include "certificate/precise_function.hpp"
#include "motion/frame_model.hpp"
#include "support/effort.hpp"
#include "support/rng.hpp"

namespace taut::testing {
using namespace internal;
namespace {

Coefficients small_coefficients(Rng& rng, int n) {
  Coefficients c;
  for (int i = 0; i < n; ++i) c.push_back(rng.between(-3, 3));
  return c;
}

/// Small whole numbers, so that identities come about by chance.
MotionPiece lattice_piece(Rng& rng) {
  MotionPiece piece;
  piece.x = small_coefficients(rng, rng.between(0, 2));
  piece.y = small_coefficients(rng, rng.between(0, 2));
  switch (rng.below(6)) {
    case 0:
      break;
    case 1:
      piece.rotation = AngleRotation{small_coefficients(rng, 2)};
      break;
    case 2:
      piece.rotation = DirectionRotation{{static_cast<double>(rng.between(1, 2))}, small_coefficients(rng, 2)};
      break;
    case 3:
      piece.rotation = HalfAngleRotation{small_coefficients(rng, 2)};
      break;
    case 4:
      piece.rotation = CosineRotation{{rng.between(-2, 2) * 0.25, rng.between(-1, 1) * 0.5}};
      break;
    default:
      piece.rotation = DirectionRotation{{1, 0, -1}, {0, 2}};
  }
  if (rng.chance(0.3)) piece.pivot = {static_cast<double>(rng.between(-2, 2)), static_cast<double>(rng.between(-2, 2))};
  return piece;
}

/// A triangle of each body, without displacement: all that the function is made of vanishes, or nothing does.
PairGeometry lattice_triangles(Rng& rng) {
  std::vector<DisplacedPoint> p, q;
  for (int i = 0; i < 3; ++i) {
    p.push_back({rng.between(-2, 2) * 0.25, rng.between(-2, 2) * 0.25, 0, 0});
    q.push_back({rng.between(-2, 2) * 0.25, rng.between(-2, 2) * 0.25, 0, 0});
  }
  return {p, q};
}

using WideBall = Ball<Real960>;

struct WorldPlace {
  WideBall x, y;
};

/// Where a point is in the world, from the pose itself.
WorldPlace world_place(const MotionPiece& piece, const DisplacedPoint& v, const WideBall& t) {
  const Pose<Real960> at = pose(piece, t);
  const WideBall x = WideBall::exact(v.x), y = WideBall::exact(v.y);
  return {at.ox.v + at.xx.v * x - at.xy.v * y, at.oy.v + at.xy.v * x + at.xx.v * y};
}

/// Zero at a few instants, to nearly all bits.
bool seems_to_vanish(const MotionSegment& segment, const PairGeometry& g, const CertificateFunction& triple) {
  for (const double t : {0.1, 0.37, 0.61, 0.83}) {
    const auto at = [&](VertexId v) {
      return world_place(g.in_p(v) ? segment.p : segment.q, g.point(v), WideBall::exact(t));
    };
    const WorldPlace a = at(triple.a), b = at(triple.b), c = at(triple.c);
    if (!(((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)).magnitude() < 0x1p-800)) return false;
  }
  return true;
}

/// What was found to vanish, and what was not though it does.
struct Vanishing {
  int found = 0, missed = 0;

  /// Of one triple of the triangles.
  void look(const MotionPiece& p, const MotionPiece& q, Rng& rng) {
    const PairGeometry g = lattice_triangles(rng);
    const MotionSegment segment = MotionSegment::motion(p, q, 0, 1);
    if (segment.translation) return;
    const int a = rng.below(3), b = (a + 1) % 3, other = rng.below(3);
    const bool pp = rng.chance(0.5);
    const CertificateFunction triple =
        pp ? CertificateFunction{VertexId(a), VertexId(b), VertexId(3 + other), true}
           : CertificateFunction{VertexId(3 + a), VertexId(3 + b), VertexId(other), false};
    const bool seems = seems_to_vanish(segment, g, triple), does = vanishes_before_displacement(segment, g, triple);
    ASSERT_FALSE(does && !seems);
    found += does;
    missed += seems && !does;
  }
};

TEST(FrameIdentities, AreFoundIfAndOnlyIfTheFunctionVanishes) {
  Rng rng(11);
  Vanishing seen;
  for (std::uint64_t i = 0; i < effort(8000); ++i) {
    MotionPiece p = lattice_piece(rng), q = rng.chance(0.2) ? p : lattice_piece(rng);
    if (rng.chance(0.3)) q.x = p.x, q.y = p.y;
    ASSERT_NO_FATAL_FAILURE(seen.look(p, q, rng)) << i;
  }
  EXPECT_GT(seen.found, static_cast<int>(enough(400)));
  EXPECT_EQ(seen.missed, 0);
}

/// Sines that are zero at the ends of the segment, where the squares of their roots are no longer positive.
TEST(FrameIdentities, OfCosinesThatBeginOrEndAtOne) {
  const std::vector<Coefficients> cosines{{0, 1}, {0, -1}, {1, -1}, {-1, 1}, {-1, 2}, {1, -2}, {1, 0, -1}, {0.5, 0.5}};
  Rng rng(12);
  Vanishing seen;
  for (std::uint64_t i = 0; i < effort(8000); ++i) {
    MotionPiece p, q;
    p.rotation = CosineRotation{cosines[static_cast<std::size_t>(rng.below(8))]};
    q.rotation = CosineRotation{cosines[static_cast<std::size_t>(rng.below(8))]};
    q.x = small_coefficients(rng, rng.between(0, 2));
    ASSERT_NO_FATAL_FAILURE(seen.look(p, q, rng)) << i;
  }
  EXPECT_GT(seen.found, static_cast<int>(enough(300)));
  EXPECT_EQ(seen.missed, 0);
}

/// The functions of an identity are not zero by themselves.
TEST(FrameIdentities, OfTwoFormsOfOneTurn) {
  MotionPiece p, q;
  p.rotation = HalfAngleRotation{{0, 1}};
  q.rotation = DirectionRotation{{1, 0, -1}, {0, 2}};
  const MotionSegment segment = MotionSegment::motion(p, q, 0, 1);
  const FrameIdentities& identities = segment.identities();
  const auto exact = [](double x) { return Dyadic::exact(x); };
  for (const bool pp : {true, false}) {
    // c = 1 and s = 0, and D = 0.
    EXPECT_TRUE(identities.vanishes(pp, {exact(-1), exact(5), exact(7), exact(1), exact(3)}));
    EXPECT_FALSE(identities.vanishes(pp, {exact(1), exact(0), exact(0), exact(1), exact(0)}));
    EXPECT_FALSE(identities.vanishes(pp, {exact(1), exact(0), exact(0), exact(-1 + 0x1p-53), exact(0)}));
  }
}

TEST(Dyadic, SquareRootsOfPolynomials) {
  Rng rng(3);
  for (int i = 0; i < 300; ++i) {
    DyadicPolynomial p;
    for (int k = rng.between(1, 5); k > 0; --k) p.push_back(Dyadic::exact(rng.between(-9, 9) * 0x1p-3));
    trim(p);
    const DyadicPolynomial square = p * p;
    const auto root = square_root(square);
    ASSERT_TRUE(root);
    EXPECT_TRUE(*root == p || *root == -p);
    if (p.empty()) continue;
    EXPECT_FALSE(square_root(square + DyadicPolynomial{Dyadic::exact(0x1p-80)}) && p.size() > 1);
    EXPECT_FALSE(square_root(-square));
  }
}

TEST(Dyadic, RootsAreDividedOutOfPolynomials) {
  Rng rng(4);
  for (int i = 0; i < 300; ++i) {
    DyadicPolynomial p;
    for (int k = rng.between(1, 5); k > 0; --k) p.push_back(Dyadic::exact(rng.between(-9, 9) * 0x1p-3));
    trim(p);
    const Dyadic root = Dyadic::exact(rng.between(-20, 20) * 0x1p-4);
    const DyadicPolynomial product = p * DyadicPolynomial{-root, Dyadic::exact(1)};
    const auto rest = without_root(product, root);
    ASSERT_EQ(rest.has_value(), !p.empty());
    if (p.empty()) continue;
    EXPECT_TRUE(*rest == p);
    EXPECT_FALSE(without_root(product + DyadicPolynomial{Dyadic::exact(0x1p-80)}, root));
  }
}

}  // namespace
}  // namespace taut::testing
