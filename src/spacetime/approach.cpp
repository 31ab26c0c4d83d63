#include "spacetime/approach.hpp"

#include <utility>

#include "base/errors.hpp"
#include "sign/closeness.hpp"

namespace taut::spacetime {
namespace {

/// A vertex and an edge: is the vertex beside it?
template <class Real>
class BesideEdge {
 public:
  BesideEdge(const Leg& leg, const PairGeometry& g, const VertexEdge& pair)
      : from_start_(leg, g, pair.from_start(g)), from_end_(leg, g, pair.from_end(g)) {}

  bool operator()(const Ball<Real>& t) const {
    const int a = from_start_.value(t).sign(), b = from_end_.value(t).sign();
    if (a < 0 || b < 0) return false;
    if (a > 0 && b > 0) return true;
    throw PrecisionExhausted{};
  }

 private:
  PreciseFunction<Real> from_start_, from_end_;
};

/// Calls `use` with the function of the pair and a test of its roots, at one precision.
template <class Real, class Use>
auto with_functions(const Leg& leg, const PairGeometry& g, const VertexPeer& pair, double margin, const Use& use) {
  if (!pair.is_edge) {
    return use(VertexCloseness<Real>(leg, g, pair.vertex, pair.peer, margin), [](const Ball<Real>&) { return true; });
  }
  const VertexEdge edge{pair.vertex, pair.peer};
  return use(LineCloseness<Real>(leg, g, edge.line(g), margin), BesideEdge<Real>(leg, g, edge));
}

/// Goes from root to root until one is an approach.
template <class Real, class Function, class Test>
std::optional<RootEnclosure<Real>> first_root(const Function& f, const Test& counts, double from, double to) {
  Real at(from);
  int sign = f.value(Ball<Real>(at, 0.0)).sign();
  if (sign == 0) throw PrecisionExhausted{};
  for (;;) {
    auto root = first_sign_change<Real>(f, sign, at, Real(to));
    if (!root) return std::nullopt;
    taut::refine(f, sign, *root);
    if (sign < 0 && counts(Ball<Real>::between(root->lo, root->hi))) return root;
    at = root->hi;
    sign = -sign;
  }
}

template <class Real>
bool is_close(const VertexCloseness<Real>& f, const Ball<Real>& t) {
  const int sign = f.value(t).sign();
  if (sign == 0) throw PrecisionExhausted{};
  return sign > 0;
}
template <class Real>
bool is_close(const LineCloseness<Real>& f, const Ball<Real>& t) {
  const int sign = f.value(t).sign();
  if (sign == 0) throw PrecisionExhausted{};
  // Behind the line by more than the margin, it is some other edge that is near.
  return sign > 0 && f.not_behind(t);
}

void store_approach(const PreciseTime& t, Approach& a) {
  a.precise = t;
  a.lo = t.floor();
  a.hi = t.ceiling();
}

/// The answer of the first stage that has one.
template <class Ask>
auto decided(const char* what, const Ask& ask) {
  auto found = at_some_stage(ask);
  if (!found) throw Undecidable{what};
  return std::move(*found);
}

}  // namespace

std::optional<Approach> PreciseApproaches::first(const VertexPeer& pair, double from, double to) const {
  return decided("whether two bodies come as close as the clearance", [&](auto zero, Stage stage) {
    using Real = decltype(zero);
    return with_functions<Real>(leg_, geometry_, pair, margin_, [&](const auto& f, const auto& counts) {
      std::optional<Approach> found;
      if (const auto root = first_root<Real>(f, counts, from, to)) {
        found.emplace();
        found->pair = pair;
        store_approach({RealMax(root->lo), RealMax(root->hi), stage}, *found);
      }
      return found;
    });
  });
}

bool PreciseApproaches::close_at(const VertexPeer& pair, double t) const {
  return decided("whether two bodies are closer than the clearance", [&](auto zero, Stage) {
    using Real = decltype(zero);
    return with_functions<Real>(leg_, geometry_, pair, margin_, [&](const auto& f, const auto& counts) {
      const Ball<Real> at = Ball<Real>::exact(t);
      return is_close(f, at) && counts(at);
    });
  });
}

int PreciseApproaches::side(const VertexPeer& pair, double t) const {
  return told_sign([&](auto zero) {
    using Real = decltype(zero);
    const auto value = [&](const auto& f, const auto&) { return f.value(Ball<Real>::exact(t)); };
    return with_functions<Real>(leg_, geometry_, pair, margin_, value);
  });
}

/// What a stage cannot improve stays as it is.
void PreciseApproaches::refine(Approach& a, Stage stage) const {
  if (a.precise.stage < Stage::precise || a.precise.stage >= stage) return;
  with_stage(stage, [&](auto zero) {
    using Real = decltype(zero);
    with_functions<Real>(leg_, geometry_, a.pair, margin_, [&](const auto& f, const auto&) {
      RootEnclosure<Real> root{Real(a.precise.lo()), Real(a.precise.hi())};
      try {
        taut::refine(f, -1, root);
      } catch (const PrecisionExhausted&) {
        return;
      }
      store_approach({RealMax(root.lo), RealMax(root.hi), stage}, a);
    });
  });
}

bool PreciseApproaches::before(Approach& a, Approach& b) const {
  const auto order = first_told([&](Stage stage) {
    refine(a, stage);
    refine(b, stage);
    return a.precise.is_first(b.precise);
  });
  // Where they cannot be told apart, which of them is named makes no difference to the time.
  return order.value_or(false);
}

}  // namespace taut::spacetime
