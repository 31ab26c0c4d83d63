#include "spacetime/crossing.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "numeric/root_isolation.hpp"
#include "pair/placement.hpp"

namespace taut::spacetime {
namespace {

/// A pair's three functions.
template <class Real>
struct Functions {
  PreciseFunction<Real> line, from_start, from_end;

  Functions(const Leg& leg, const PairGeometry& g, const VertexEdge& pair)
      : line(leg, g, pair.line(g)), from_start(leg, g, pair.from_start(g)), from_end(leg, g, pair.from_end(g)) {}

  Beside beside(const Ball<Real>& t) const {
    const int a = from_start(t).v.sign(), b = from_end(t).v.sign();
    if (a < 0 || b < 0) return Beside::no;
    return a > 0 && b > 0 ? Beside::yes : Beside::unknown;
  }
};

void store(const PreciseTime& t, Crossing& c) {
  c.precise = t;
  c.lo = t.floor();
  c.hi = t.ceiling();
}

/// Goes from root to root until one is a contact.
template <class Real>
std::optional<Crossing> first_at(const Leg& leg, const PairGeometry& g, const VertexEdge& pair, Ways ways, double from,
                                 double to, int stage) {
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
    if (beside == Beside::yes && (sign < 0 || ways == Ways::both)) {
      Crossing c;
      c.pair = pair;
      c.out = sign > 0;
      store({RealMax(root->lo), RealMax(root->hi), stage}, c);
      return c;
    }
    at = root->hi;
    sign = -sign;
  }
}

}  // namespace

std::optional<Crossing> PreciseCrossings::first(const VertexEdge& pair, double from, double to) {
  ++calls_;
  for (int stage = 0; stage < precise_stages; ++stage) {
    try {
      return with_stage(
          stage, [&](auto zero) { return first_at<decltype(zero)>(leg_, geometry_, pair, ways_, from, to, stage); });
    } catch (const PrecisionExhausted&) {
    }
  }
  throw Undecidable{"whether a vertex crosses an edge"};
}

/// What a stage cannot improve stays as it is.
void PreciseCrossings::refine(Crossing& c, int sign, int stage) {
  PreciseTime t = c.precise.stage < 0 ? PreciseTime::between(c.lo, c.hi) : c.precise;
  if (t.stage >= stage) return;
  ++calls_;
  if (!PreciseTriple(leg_, geometry_, c.pair.line(geometry_)).refine(sign, t, stage)) t.stage = stage;
  store(t, c);
}

Beside PreciseCrossings::beside(Crossing& root, int sign) {
  const PreciseTriple from_start(leg_, geometry_, root.pair.from_start(geometry_));
  const PreciseTriple from_end(leg_, geometry_, root.pair.from_end(geometry_));
  for (int stage = 0; stage < precise_stages; ++stage) {
    refine(root, sign, stage);
    const int a = from_start.sign_at(root.precise, stage), b = from_end.sign_at(root.precise, stage);
    if (a < 0 || b < 0) return Beside::no;
    if (a > 0 && b > 0) return Beside::yes;
  }
  throw Undecidable{"whether a vertex meets an edge or passes its end"};
}

bool PreciseCrossings::before(Crossing& a, Crossing& b) {
  for (int stage = -1; stage < precise_stages; ++stage) {
    if (stage >= 0) {
      refine(a, -1, stage);
      refine(b, -1, stage);
      if (a.precise.certainly_before(b.precise)) return true;
      if (b.precise.certainly_before(a.precise)) return false;
    }
    if (a.hi < b.lo) return true;
    if (b.hi < a.lo) return false;
  }
  throw Undecidable{"the order of two contacts"};
}

void PreciseCrossings::tighten(Crossing& c) {
  if (c.hi - c.lo > 0x1p-51 * std::fabs(c.hi)) refine(c, c.out ? 1 : -1, 0);
}

}  // namespace taut::spacetime
