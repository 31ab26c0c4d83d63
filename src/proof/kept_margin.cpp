#include "proof/kept_margin.hpp"

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

}  // namespace

bool KeptMargin::vertices(const RangePair& edges, double from, double to) const {
  const VertexId a = pair_.onto_q(edges).vertex, c = pair_.onto_p(edges).vertex;
  return at_some_stage([&](auto zero, Stage) {
           using Real = decltype(zero);
           return stays_negative<Real>(VertexCloseness<Real>(leg_, pair_.geometry, a, c, margin_), from, to);
         })
      .value_or(false);
}

bool KeptMargin::aside(Lifetimes& lifetimes, const Incidence& incidence, Aside why, double from, double to) const {
  if (why > Aside::behind_second) return false;
  if (why != Aside::right) return stays_aside(pair_.geometry, lifetimes, incidence, why, from, Instant::exactly(to));
  return at_some_stage([&](auto zero, Stage) {
           using Real = decltype(zero);
           const LineCloseness<Real> line(leg_, pair_.geometry, incidence.line(pair_.geometry), margin_);
           return stays_negative<Real>(line, from, to);
         })
      .value_or(false);
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
