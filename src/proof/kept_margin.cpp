#include "proof/kept_margin.hpp"

#include "certificate/margin_function.hpp"
#include "certificate/precise_root.hpp"

namespace taut::internal::proof {
namespace {

/// Is a function negative at all times of [from, to]? Throws PrecisionExhausted.
template <class Real, class Function>
bool stays_negative(const MotionSegment& segment, const Function& f, double from, double to, Stage stage) {
  const int sign = f.value(Ball<Real>::exact(from)).sign();
  if (sign == 0) throw PrecisionExhausted{};
  if (sign > 0 || !(from < to)) return sign < 0;
  return !first_change<Real>(segment, f, -1, PreciseTime::between(from, from), to, stage);
}

/// ask(zero, stage) as at_some_stage() has it, in doubles first, which nearly always decide. False if none does.
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
    const VertexMargin<Real> f(segment_, pair_.geometry, a, c, margin_, &models_);
    return stays_negative<Real>(segment_, f, from, to, stage);
  });
}

bool KeptMargin::separated(Lifetimes& lifetimes, const Incidence& incidence, SeparationReason why, double from,
                           double to) const {
  if (why > SeparationReason::behind_second) return false;
  if (why != SeparationReason::right)
    return stays_separated(pair_.geometry, lifetimes, incidence, why, from, Instant::exactly(to));
  return holds_at_some_stage([&](auto zero, Stage stage) {
    using Real = decltype(zero);
    const LineMargin<Real> f(segment_, pair_.geometry, incidence.line(pair_.geometry), margin_, &models_);
    return stays_negative<Real>(segment_, f, from, to, stage);
  });
}

bool closer_at(const PairGeometry& g, const MotionSegment& segment, double margin, const Incidence& pair, bool is_edge,
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
           if (!is_edge) return positive(VertexMargin<Real>(segment, g, pair.vertex, pair.edge, margin));
           const CertificateFunction line = pair.line(g);
           const LineMargin<Real> margin_function(segment, g, line, margin);
           return positive(margin_function) && margin_function.not_behind(t) &&
                  positive(PreciseFunction<Real>(segment, g, line.along())) &&
                  positive(PreciseFunction<Real>(segment, g, line.back()));
         })
      .value_or(false);
}

}  // namespace taut::internal::proof
