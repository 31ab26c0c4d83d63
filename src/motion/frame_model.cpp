#include "motion/frame_model.hpp"

#include <algorithm>
#include <cmath>

#include "motion/pieces.hpp"
#include "motion/symbolic.hpp"
#include "motion/uniform_rotation.hpp"
#include "numeric/budget.hpp"

namespace taut::internal {
namespace {

/// A quantity that matters to no query, because the displacement is far larger. In a relative motion that is exactly
/// zero, slack for underflow accumulates, multiplied by powers of the radius, and becomes large in some units of time.
constexpr double negligible = 0x1p-400;

/// In units of checkpoint().
constexpr std::uint64_t work_of_uniform_rotation = 6;

std::uint64_t work_of_turn(const MotionPiece& piece) {
  return std::visit([](const auto& form) { return std::uint64_t{FormOf<decltype(form)>::work}; }, piece.rotation);
}
/// Fitted to the times of many thousand queries.
std::uint64_t work_of_model(const MotionSegment& segment) {
  if (segment.translation) return 9;
  if (segment.composed) return 150;
  const std::uint64_t turns = work_of_turn(segment.p) + work_of_turn(segment.q);
  if (!internal::turns(segment.p) || !internal::turns(segment.q)) return turns;
  return turns + (segment.p.rotation.index() == segment.q.rotation.index() ? 25 : 50);
}

double known_or_infinite(double bound) { return bound >= 0 ? bound : INFINITY; }

}  // namespace

/// f = sum c_k h^k (k < n) + c_n(intermediate point) h^n, and the corresponding formula for derivatives.
void take_series(FrameModel& m, int i, const ModelSeries<double>& at_middle, const ModelSeries<double>& over) {
  constexpr int n = model_degree;
  double noise = 0, size = 0, size_d = 0, size_dd = 0, size_ddd = 0;
  double vague = 0, vague_d = 0, vague_dd = 0, vague_ddd = 0;
  double power[4] = {1, 0, 0, 0};  // r^k, k r^(k-1), k (k-1) r^(k-2) and so on
  for (int k = 0; k < n; ++k) m.c[k][i] = at_middle.c[k].mid;
  m.remainder[i] = 0;
  const int last = std::max(at_middle.terms, over.terms) - 1;  // later terms are zero
  for (int k = 0; k <= last; ++k) {
    const double known = k < n ? std::fabs(at_middle.c[k].mid) : 0;
    const double open = k < n ? at_middle.c[k].rad : over.c[n].magnitude();
    if (k < n && at_middle.c[k].mid != 0) m.terms = std::max(m.terms, k + 1);
    if (k < n) noise += open * power[0];
    size += known * power[0];
    size_d += known * power[1];
    vague += open * power[0];
    vague_d += open * power[1];
    vague_dd += open * power[2];
    size_ddd += known * power[3];
    vague_ddd += open * power[3];
    if (k != 2) size_dd += known * power[2];
    if (k == n) m.remainder[i] = known_or_infinite(open * power[0]);
    for (int order = 3; order > 0; --order) power[order] = (k + 1) * power[order - 1];
    power[0] *= m.radius;
  }
  m.size[i] = size;
  m.noise[i] = known_or_infinite(noise);
  m.second[i] = std::isfinite(m.c[2][i]) ? 2 * m.c[2][i] : 0;
  // h = t - middle is rounded once, relative to itself. Horner's rule rounds twice for each coefficient.
  const double error = (vague + (2 * n + 8) * 0x1p-53 * (size + m.radius * size_d)) * (1 + 0x1p-40);
  const double error_d = vague_d + (3 * n + 8) * 0x1p-53 * (size_d + m.radius * (size_dd + std::fabs(m.second[i])));
  const double error_dd = vague_dd + (4 * n + 8) * 0x1p-53 * (size_dd + std::fabs(m.second[i]) + m.radius * size_ddd);
  m.error[i] = known_or_infinite(error + underflow_slack);
  m.error_d[i] = known_or_infinite(error_d * (1 + 0x1p-40) + underflow_slack);
  m.error_dd[i] = known_or_infinite(error_dd * (1 + 0x1p-40) + underflow_slack);
  m.vague_second[i] = known_or_infinite(vague_dd);
  m.vague_third[i] = known_or_infinite(vague_ddd);
  m.second_rad[i] = INFINITY;
  // For long intervals, the bound from the series over the interval is far better than that from the coefficients.
  m.third[i] = known_or_infinite((over.terms > 3 ? 6 * over.c[3].magnitude() : 0) * (1 + 0x1p-40));
  m.bound_by_coefficients(i);
  if (!std::isfinite(m.c[2][i])) m.second_rad[i] = m.error_dd[i] = m.third[i] = INFINITY;
}

void FrameModel::bound_by_coefficients(int i) {
  double second_moves = 0, third_is = 0, power = 1;
  for (int k = 3; k < model_degree; ++k) {
    const double falling = k * (k - 1) * std::fabs(c[k][i]) * power;  // times r^(k - 3)
    third_is += falling * (k - 2);
    second_moves += falling * radius;
    power *= radius;
  }
  const auto least = [](double kept, double vague, double known) {
    const double bound = (vague + known) * (1 + 0x1p-40) + underflow_slack;
    return bound < kept ? bound : kept;
  };
  second_rad[i] = least(second_rad[i], vague_second[i], second_moves);
  third[i] = least(third[i], vague_third[i], third_is);
}

FrameModel FrameModel::over(const MotionSegment& segment, double start, double end) {
  if (const auto& even = segment.uniform_rotation()) {
    count_work(work_of_uniform_rotation);
    if (const auto m = even->model(segment, start, end)) return *m;
  }
  FrameModel m;
  count_work(work_of_model(segment));
  const Ball<double> whole = Ball<double>::between(start, end);
  m.start = start;
  m.end = end;
  m.middle = whole.mid;
  m.radius = whole.rad;
  m.terms = 1;
  const FrameOf<ModelSeries<double>> point = frame_series(segment, Ball<double>::exact(m.middle));
  const FrameOf<ModelSeries<double>> range = frame_series(segment, whole);
  take_series(m, 0, point.for_pp[1], range.for_pp[1]);
  take_series(m, 1, point.for_pp[2], range.for_pp[2]);
  take_series(m, 2, point.for_qq[1], range.for_qq[1]);
  take_series(m, 3, point.for_qq[2], range.for_qq[2]);
  take_series(m, 4, point.for_pp[3], range.for_pp[3]);
  take_series(m, 5, point.for_pp[4], range.for_pp[4]);
  return m;
}

bool FrameModel::finite() const {
  for (int i = 0; i < functions; ++i) {
    if (!(error[i] < INFINITY && error_d[i] < INFINITY && second_rad[i] < INFINITY && third[i] < INFINITY))
      return false;
  }
  return true;
}

double FrameModel::leave(int i) const { return std::max(0x1p-47 * scale(i), noise[i]) + negligible; }

bool FrameModel::sharp() const {
  for (int i = 0; i < functions; ++i) {
    if (!(remainder[i] <= leave(i))) return false;
  }
  return finite();
}

bool FrameModel::barely_sharp() const {
  // 2^9, with room for functions that are several times as large over the longer interval.
  constexpr double growth = 0x1p6;
  for (int i = 0; i < functions; ++i) {
    if (growth * remainder[i] > leave(i)) return true;
  }
  return false;
}

bool FrameModel::hopeless() const {
  for (const double bound : noise) {
    if (!(bound < INFINITY)) return true;
  }
  return false;
}

double FrameModel::straightness(int i, double slack) const {
  const double share = 0x1p-4 * slack, least = 0x1p-10 * slack;
  // Noise of size e in the terms up to h^9 contributes at most 72 e to h^2 times the second derivative.
  return share * std::fabs(c[1][i]) * radius + least * scale(i) + 72 * noise[i] + negligible;
}

bool FrameModel::straight(double slack) const {
  for (int i = 0; i < functions; ++i) {
    if (!(second_rad[i] * radius * radius <= straightness(i, slack))) return false;
  }
  return true;
}

/// The remainder grows with the ninth power of the length. Once it is small, the change of the second derivative
/// relative to the displacement grows with the second or the third power. Roots are computed by square roots alone,
/// which are the same on all platforms.
double FrameModel::fitting_share(double slack) const {
  constexpr double nothing = 0x1p-500;
  double rest = nothing, turn = nothing;
  for (int i = 0; i < functions; ++i) {
    rest = std::max(rest, remainder[i] / leave(i));
    turn = std::max(turn, second_rad[i] * radius * radius / straightness(i, slack));
  }
  if (!(rest < INFINITY && turn < INFINITY)) return 0.5;
  const double eighth = std::sqrt(std::sqrt(std::sqrt(rest))), of_64 = std::sqrt(std::sqrt(std::sqrt(eighth)));
  const double by_rest = of_64 / eighth;
  return rest > 1 ? by_rest : std::min(by_rest, 1 / std::sqrt(turn));
}

namespace {

using Condition = std::array<Dyadic, 5>;

/// Independent conditions in a row echelon form without divisions: each lacks the leading entries of those before it.
class Echelon {
 public:
  /// Adds the condition. Returns true if it is independent of those before.
  bool add(Condition c) {
    for (const auto& [lead, row] : rows_) {
      if (c[lead].is_zero()) continue;
      const Dyadic factor = c[lead], pivot = row[lead];
      for (std::size_t i = 0; i < c.size(); ++i) c[i] = c[i] * pivot - row[i] * factor;
    }
    for (std::size_t i = 0; i < c.size(); ++i) {
      if (c[i].is_zero()) continue;
      rows_.emplace_back(i, std::move(c));
      return true;
    }
    return false;
  }
  bool full() const { return rows_.size() == 5; }

 private:
  std::vector<std::pair<std::size_t, Condition>> rows_;
};

}  // namespace

FrameIdentities::Side FrameIdentities::conditions_of(const std::array<Symbolic, 5>& functions,
                                                     const SymbolicSegment& segment) {
  Side side;
  side.known = std::all_of(functions.begin(), functions.end(), [](const Symbolic& f) { return f.known(); });
  if (!side.known) return side;
  Symbolic::Exponents denominator{};
  for (const Symbolic& f : functions) {
    for (std::size_t i = 0; i < denominator.size(); ++i) {
      denominator[i] = std::max(denominator[i], f.denominator()[i]);
    }
  }
  struct Terms {
    Symbolic::Key key;
    std::vector<Condition> by_power;
  };
  std::vector<Terms> all;
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const Symbolic function = functions[i].over(denominator, segment);
    for (const Symbolic::Term& t : function.terms()) {
      auto found = std::find_if(all.begin(), all.end(), [&](const Terms& x) { return x.key == t.key; });
      if (found == all.end()) found = all.insert(all.end(), {t.key, {}});
      if (found->by_power.size() < t.polynomial.size()) found->by_power.resize(t.polynomial.size());
      for (std::size_t k = 0; k < t.polynomial.size(); ++k) found->by_power[k][i] = t.polynomial[k];
    }
  }
  Echelon echelon;
  for (const Terms& terms : all) {
    for (const Condition& c : terms.by_power) {
      if (!echelon.full() && echelon.add(c)) side.conditions.push_back(c);
    }
  }
  return side;
}

namespace {

/// Symbolic expressions are in powers of the time, or of one joint's value, if nothing else moves.
bool has_symbols(const MotionSegment& segment) {
  int joints = 0, others = 0;
  for (const PieceChain* chain : {&segment.p_chain, &segment.q_chain}) {
    for (const MotionPiece& piece : *chain) {
      if (varies(piece)) ++(followed_joint(piece) ? joints : others);
    }
  }
  return joints == 0 || (joints == 1 && others == 0);
}

}  // namespace

FrameIdentities::FrameIdentities(const MotionSegment& segment) {
  if (!has_symbols(segment)) return;
  SymbolicSegment symbols(segment.start, segment.end);
  const FrameOf<Symbolic> f = symbolic_frame(segment, symbols);
  pp_ = conditions_of(f.for_pp, symbols);
  qq_ = conditions_of(f.for_qq, symbols);
}

bool FrameIdentities::vanishes(bool pp, const std::array<Dyadic, 5>& c) const {
  const Side& side = pp ? pp_ : qq_;
  return side.known && std::all_of(side.conditions.begin(), side.conditions.end(), [&](const Condition& condition) {
           Dyadic sum;
           for (std::size_t i = 0; i < c.size(); ++i) sum = sum + c[i] * condition[i];
           return sum.is_zero();
         });
}

}  // namespace taut::internal
