#include "proof/kept_margin.hpp"

#include "sign/closeness.hpp"
#include "sign/precise_root.hpp"

namespace taut::proof {
namespace {

/// Is a function negative at all times of [from, to]? Throws PrecisionExhausted.
template <class Real, class Function>
bool stays_negative(const Leg& leg, const Function& f, double from, double to, Stage stage) {
  const int sign = f.value(Ball<Real>::exact(from)).sign();
  if (sign == 0) throw PrecisionExhausted{};
  if (sign > 0 || !(from < to)) return sign < 0;
  return !first_change<Real>(leg, f, -1, PreciseTime::between(from, from), to, stage);
}

/// ask(zero, stage) as at_some_stage() has it, in doubles first, which nearly always tell. False if none does.
template <class Ask>
bool holds_at_some_stage(const Ask& ask) {
  try {
    return ask(double{}, Stage::doubles);
  } catch (const PrecisionExhausted&) {
    return at_some_stage(ask).value_or(false);
  }
}

}  // namespace

bool KeptMargin::vertices(const RangePair& edges, double from, double to) const {
  const VertexId a = pair_.onto_q(edges).vertex, c = pair_.onto_p(edges).vertex;
  return holds_at_some_stage([&](auto zero, Stage stage) {
    using Real = decltype(zero);
    const VertexCloseness<Real> f(leg_, pair_.geometry, a, c, margin_, &models_);
    return stays_negative<Real>(leg_, f, from, to, stage);
  });
}

bool KeptMargin::aside(Lifetimes& lifetimes, const Incidence& incidence, Aside why, double from, double to) const {
  if (why > Aside::behind_second) return false;
  if (why != Aside::right) return stays_aside(pair_.geometry, lifetimes, incidence, why, from, Instant::exactly(to));
  return holds_at_some_stage([&](auto zero, Stage stage) {
    using Real = decltype(zero);
    const LineCloseness<Real> f(leg_, pair_.geometry, incidence.line(pair_.geometry), margin_, &models_);
    return stays_negative<Real>(leg_, f, from, to, stage);
  });
}

bool closer_at(const PairGeometry& g, const Leg& leg, double margin, const Incidence& pair, bool is_edge,
               const FineInstant& at) {
  return at_some_stage([&](auto zero, Stage) {
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
           return positive(closeness) && closeness.not_behind(t) &&
                  positive(PreciseFunction<Real>(leg, g, line.along())) &&
                  positive(PreciseFunction<Real>(leg, g, line.back()));
         })
      .value_or(false);
}

}  // namespace taut::proof
