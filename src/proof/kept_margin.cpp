#include "proof/kept_margin.hpp"

#include "numeric/root_isolation.hpp"
#include "sign/closeness.hpp"
#include "sign/precise_time.hpp"

namespace taut::proof {
namespace {

/// Is a function negative at all times of [from, to]?
template <class Real, class Function>
bool stays_negative(const Function& f, double from, double to) {
  const int sign = f.value(Ball<Real>::exact(from)).sign();
  if (sign == 0) throw PrecisionExhausted{};
  return sign < 0 && (!(from < to) || !first_sign_change<Real>(f, -1, Real(from), Real(to)));
}

/// `ask(zero)` at one precision after the other, until one can tell; false if none can.
template <class Ask>
bool shown_at_some_stage(const Ask& ask) {
  for (int stage = 0; stage < precise_stages; ++stage) {
    try {
      return with_stage(stage, ask);
    } catch (const PrecisionExhausted&) {
    }
  }
  return false;
}

}  // namespace

bool KeptMargin::vertices(const RangePair& edges, double from, double to) const {
  const VertexId a = pair_.onto_q(edges).vertex, c = pair_.onto_p(edges).vertex;
  return shown_at_some_stage([&](auto zero) {
    using Real = decltype(zero);
    return stays_negative<Real>(VertexCloseness<Real>(leg_, pair_.geometry, a, c, margin_), from, to);
  });
}

bool KeptMargin::aside(Lifetimes& lifetimes, const Incidence& incidence, Aside why, double from, double to) const {
  if (why > Aside::behind_second) return false;
  if (why != Aside::right) return stays_aside(pair_.geometry, lifetimes, incidence, why, from, Instant::exactly(to));
  return shown_at_some_stage([&](auto zero) {
    using Real = decltype(zero);
    const LineCloseness<Real> line(leg_, pair_.geometry, incidence.line(pair_.geometry), margin_);
    return stays_negative<Real>(line, from, to);
  });
}

bool closer_at(const PairGeometry& g, const Leg& leg, double margin, const Incidence& pair, bool is_edge,
               const FineInstant& at) {
  return shown_at_some_stage([&](auto zero) {
    using Real = decltype(zero);
    using B = Ball<Real>;
    const B t = B::exact(at[0]) + B::exact(at[1]) + B::exact(at[2]);
    const auto positive = [&](const auto& f) {
      const int sign = f.value(t).sign();
      if (sign == 0) throw PrecisionExhausted{};
      return sign > 0;
    };
    if (!is_edge) return positive(VertexCloseness<Real>(leg, g, pair.vertex, pair.edge, margin));
    const Form line = pair.line(g);
    const LineCloseness<Real> closeness(leg, g, line, margin);
    return positive(closeness) && closeness.not_behind(t) && positive(PreciseFunction<Real>(leg, g, line.along())) &&
           positive(PreciseFunction<Real>(leg, g, line.back()));
  });
}

}  // namespace taut::proof
