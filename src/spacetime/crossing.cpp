#include "spacetime/crossing.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/errors.hpp"
#include "numeric/root_isolation.hpp"
#include "pair/placement.hpp"

namespace taut::spacetime {
namespace {

constexpr int stages = static_cast<int>(std::size(precision_ladder));

/// A pair's three functions.
template <class Real>
struct Functions {
  PreciseFunction<Real> line, from_start, from_end;

  Functions(const Leg& leg, const PairGeometry& g, const VertexEdge& pair)
      : line(leg, g, pair.forwards(g)),
        from_start(leg, g, pair.forwards(g), Measure::projection),
        from_end(leg, g, pair.backwards(g), Measure::projection) {}

  Beside beside(const Ball<Real>& t) const {
    const int a = from_start(t).v.sign(), b = from_end(t).v.sign();
    if (a < 0 || b < 0) return Beside::no;
    return a > 0 && b > 0 ? Beside::yes : Beside::unknown;
  }
};

template <class Real>
void store(const RootEnclosure<Real>& root, int stage, Crossing& c) {
  c.exact_lo = RealMax(root.lo);
  c.exact_hi = RealMax(root.hi);
  c.stage = stage;
  c.lo = double_floor(c.exact_lo);
  c.hi = double_above(c.exact_hi);
}

/// Goes from root to root until one is a contact.
template <class Real>
std::optional<Crossing> first_at(const Leg& leg, const PairGeometry& g, const VertexEdge& pair, double from, double to,
                                 int stage) {
  const Functions<Real> f(leg, g, pair);
  Real at(from);
  int sign = f.line(Ball<Real>(at, 0.0)).v.sign();
  if (sign == 0) throw PrecisionExhausted{};
  for (;;) {
    auto root = first_sign_change<Real>(f.line, sign, at, Real(to));
    if (!root) return std::nullopt;
    taut::refine(f.line, sign, *root);
    const Beside beside = f.beside(Ball<Real>::between(root->lo, root->hi));
    if (beside == Beside::unknown) throw PrecisionExhausted{};
    if (beside == Beside::yes && sign < 0) {
      Crossing c;
      c.pair = pair;
      store(*root, stage, c);
      return c;
    }
    at = root->hi;
    sign = -sign;
  }
}

}  // namespace

std::optional<Crossing> PreciseCrossings::first(const VertexEdge& pair, double from, double to) {
  ++calls_;
  for (int stage = 0; stage < stages; ++stage) {
    try {
      return with_stage(stage,
                        [&](auto zero) { return first_at<decltype(zero)>(leg_, geometry_, pair, from, to, stage); });
    } catch (const PrecisionExhausted&) {
    }
  }
  throw Undecidable{"whether a vertex crosses an edge"};
}

/// What a stage cannot improve stays as it is.
void PreciseCrossings::refine(Crossing& c, int sign, int stage) {
  if (c.stage >= stage) return;
  ++calls_;
  if (c.stage < 0) {
    c.exact_lo = RealMax(c.lo);
    c.exact_hi = RealMax(c.hi);
  }
  with_stage(stage, [&](auto zero) {
    using Real = decltype(zero);
    const PreciseFunction<Real> f(leg_, geometry_, c.pair.forwards(geometry_));
    RootEnclosure<Real> root{Real(c.exact_lo), Real(c.exact_hi)};
    try {
      taut::refine(f, sign, root);
      store(root, stage, c);
    } catch (const PrecisionExhausted&) {
      c.stage = stage;
    }
  });
}

Beside PreciseCrossings::beside(Crossing& root, int sign) {
  for (int stage = 0; stage < stages; ++stage) {
    refine(root, sign, stage);
    const Beside answer = with_stage(stage, [&](auto zero) {
      using Real = decltype(zero);
      const Functions<Real> f(leg_, geometry_, root.pair);
      return f.beside(Ball<Real>::between(Real(root.exact_lo), Real(root.exact_hi)));
    });
    if (answer != Beside::unknown) return answer;
  }
  throw Undecidable{"whether a vertex meets an edge or passes its end"};
}

bool PreciseCrossings::before(Crossing& a, Crossing& b) {
  for (int stage = -1; stage < stages; ++stage) {
    if (stage >= 0) {
      refine(a, -1, stage);
      refine(b, -1, stage);
      if (a.exact_hi < b.exact_lo) return true;
      if (b.exact_hi < a.exact_lo) return false;
    }
    if (a.hi < b.lo) return true;
    if (b.hi < a.lo) return false;
  }
  throw Undecidable{"the order of two contacts"};
}

void PreciseCrossings::tighten(Crossing& c) {
  if (c.hi - c.lo > 0x1p-51 * std::fabs(c.hi)) refine(c, -1, 0);
}

}  // namespace taut::spacetime
