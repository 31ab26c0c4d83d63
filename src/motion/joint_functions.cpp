#include "motion/joint_functions.hpp"

#include <atomic>
#include <limits>

#include "motion/joint_value.hpp"
#include "motion/motion_segment.hpp"
#include "taut/envelope.hpp"

namespace taut::internal {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Real>
Ball<Real> anything() {
  return Ball<Real>(Real(0), infinity);
}

template <class J>
J unknown_series() {
  J s = J::constant(0.0);
  s.c.fill(anything<typename J::Number>());
  s.terms = static_cast<int>(s.c.size());
  return s;
}

/// Coefficients about a ball from those about its middle: c_k over it is the sum of binomial(j, k) c_j h^(j - k).
template <class Real, std::size_t Size, int N>
Series<Real, N> widened(const std::array<Ball<Real>, Size>& c, double radius) {
  auto out = Series<Real, N>::of_terms(N + 1);
  const Ball<Real> h(Real(0), radius);
  for (int k = 0; k <= N; ++k) {
    Ball<Real> sum = Ball<Real>::exact(0), power = Ball<Real>::exact(1);
    double binomial = 1;
    for (int j = k; j < static_cast<int>(Size); ++j) {
      sum = sum + c[static_cast<std::size_t>(j)] * power * binomial;
      power = power * h;
      binomial = binomial * (j + 1) / (j + 1 - k);
    }
    out.c[static_cast<std::size_t>(k)] = sum;
  }
  return out;
}

/// The polynomial of an unknown, at any precision: neighbouring doubles may be far apart as times, and as values.
template <class Real>
Ball<Real> polynomial_at(const LoopCell& cell, std::size_t unknown, const Real& t) {
  using B = Ball<Real>;
  const B place = (B(t, 0.0) - B::exact(cell.middle)) / B::exact(cell.radius);
  B sum = B::exact(0);
  for (std::size_t k = LoopCell::order + 1; k-- > 0;) sum = sum * place + B::exact(cell.c[unknown][k]);
  return sum;
}

template <int N>
Series<double, N> hull(const Series<double, N>& a, const Series<double, N>& b) {
  auto out = Series<double, N>::of_terms(N + 1);
  for (std::size_t k = 0; k < out.c.size(); ++k)
    out.c[k] =
        Ball<double>::between(std::min(a.c[k].lower(), b.c[k].lower()), std::max(a.c[k].upper(), b.c[k].upper()));
  return out;
}

}  // namespace

template <int N>
Series<double, N> LoopCell::about(std::size_t unknown, const Ball<double>& t) const {
  if (box) {
    auto out = unknown_series<Series<double, N>>();
    out.c[0] = box->range(unknown);
    return out;
  }
  using B = Ball<double>;
  const B scale = B::exact(radius), place = (B::exact(t.mid) - B::exact(middle)) / scale;
  const double half = t.rad == 0 ? 0 : (B::exact(t.rad) / scale).magnitude(), reach = place.magnitude() + half;
  if (!(reach < 1)) return unknown_series<Series<double, N>>();
  std::array<B, order + 1> at;
  for (std::size_t k = 0; k < at.size(); ++k) at[k] = B::exact(c[unknown][k]);
  // About the ball's middle first.
  const int last = half == 0 ? N : order;
  for (int k = 0; k <= last; ++k) {
    for (int i = order; i-- > k;)
      at[static_cast<std::size_t>(i)] = at[static_cast<std::size_t>(i)] + at[static_cast<std::size_t>(i) + 1] * place;
  }
  auto out = Series<double, N>::of_terms(N + 1);
  if (half != 0) {
    out = widened<double, order + 1, N>(at, half);
  } else {
    for (std::size_t k = 0; k < out.c.size(); ++k) out.c[k] = at[k];
  }
  // Coefficient k of the analytic rest is at most error / (1 - reach)^(k + 1), since binomial(j, k) reach^(j - k) is at
  // most the sum of these over all j.
  const B room = B::exact(1) / (B::exact(1) - B::exact(reach));
  B rest = B::exact(error[unknown]) * room, unit = B::exact(1);
  for (B& x : out.c) {
    x = x * unit;
    x.rad = detail::inflate(x.rad + rest.magnitude());
    rest = rest * room / scale;
    unit = unit / scale;
  }
  return out;
}
template Series<double, 0> LoopCell::about(std::size_t, const Ball<double>&) const;
template Series<double, 1> LoopCell::about(std::size_t, const Ball<double>&) const;

double LoopCell::approximate(std::size_t unknown, double t) const {
  double sum = 0;
  for (int k = order; k >= 0; --k) sum = sum * ((t - middle) / radius) + c[unknown][static_cast<std::size_t>(k)];
  return sum;
}

namespace {

/// 1 for degrees, and a share of the mechanism's extent for what slides follow.
std::vector<double> weights(const LoopEquations& equations, int count, std::vector<LinearForm::Term> LinearForm::*of) {
  std::vector<double> out(static_cast<std::size_t>(count), 1);
  double extent = 0;
  for (const auto& joint : equations.joints) extent = std::max(extent, joint.at.extent());
  for (const auto& closure : equations.closures) extent = std::max(extent, closure.at.extent());
  if (extent == 0) return out;
  const auto add_length = [&](const LinearForm& form) {
    for (const LinearForm::Term& term : form.*of) out[static_cast<std::size_t>(term.of)] = extent / 64;
  };
  for (const auto& joint : equations.joints) {
    if (joint.slide) add_length(joint.value);
  }
  for (const auto& closure : equations.closures) {
    if (closure.slide && closure.value) add_length(*closure.value);
  }
  return out;
}

}  // namespace

std::vector<double> weights_of(const LoopEquations& equations) {
  return weights(equations, equations.unknowns, &LinearForm::unknowns);
}

std::vector<double> weights_of_drives(const LoopEquations& equations) {
  return weights(equations, static_cast<int>(equations.drives.size()), &LinearForm::drives);
}

JointFunctions::JointFunctions(LoopEquations equations, std::vector<std::vector<LoopCell>> cells,
                               std::optional<double> drawn_at)
    : equations_(std::move(equations)), cells_(std::move(cells)), drawn_at_(drawn_at) {
  static std::atomic<std::uint64_t> next{1};
  id_ = next++;
}

const LoopCell& JointFunctions::cell_at(std::size_t piece, double t) const {
  const std::vector<LoopCell>& cells = cells_[piece];
  const auto found =
      std::upper_bound(cells.begin(), cells.end(), t, [](double time, const LoopCell& cell) { return time < cell.to; });
  return found == cells.end() ? cells.back() : *found;
}

template <int N>
std::vector<Series<double, N>> JointFunctions::enclosed(std::size_t piece, const Ball<double>& t) const {
  const std::vector<LoopCell>& cells = cells_[piece];
  const std::size_t n = static_cast<std::size_t>(equations_.unknowns);
  const double lo = t.lower(), hi = t.upper();
  std::vector<Series<double, N>> out;
  for (const LoopCell* cell = &cell_at(piece, lo); cell != cells.data() + cells.size(); ++cell) {
    if (!out.empty() && cell->from >= hi) break;
    const bool within = cell->from <= lo && hi <= cell->to;
    const Ball<double> part =
        within ? t : Ball<double>::between(std::clamp(lo, cell->from, cell->to), std::clamp(hi, cell->from, cell->to));
    for (std::size_t i = 0; i < n; ++i) {
      const Series<double, N> here = cell->template about<N>(i, part);
      if (out.size() < n) {
        out.push_back(here);
      } else {
        out[i] = hull(out[i], here);
      }
    }
    if (within) break;
  }
  return out;
}

template <class Real, int N>
std::optional<std::vector<Series<Real, N>>> JointFunctions::solved(std::size_t piece, const Real& t) const {
  const double near = RealTraits<Real>::to_double(t);
  const LoopCell& cell = cell_at(piece, near);
  if (cell.box) return std::nullopt;
  const LoopCurve curve{equations_, piece, equations_.unknowns};
  std::vector<double> about;
  for (std::size_t i = 0; i < curve.size(); ++i) about.push_back(cell.approximate(i, near));
  const auto inverse = newton(curve, about, near);
  if (!inverse) return std::nullopt;
  const std::vector<double> weights = weights_of(equations_);
  const auto values = solve_at<Real>(curve, about, t, *inverse, weights);
  if (!values) return std::nullopt;
  // The solution that was found is the one in the tube. The cell may end up to a rounding before t.
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const Ball<double> off = detail::in_doubles((*values)[i] - polynomial_at<Real>(cell, i, t));
    if (!(off.magnitude() < cell.tube[i])) return std::nullopt;
  }
  return series_of<Real, N>(curve, *values, Ball<Real>(t, 0.0), *inverse, weights);
}

/// In the drawn pose the unknowns are 0, exactly: what coincides there coincides.
template <class Real, int N>
std::optional<std::vector<Series<Real, N>>> JointFunctions::drawn(std::size_t piece, const Ball<Real>& t) const {
  if (piece != 0 || !drawn_at_ || t.rad != 0 || t.mid != Real(*drawn_at_)) return std::nullopt;
  const LoopCurve curve{equations_, piece, equations_.unknowns};
  std::vector<double> about(curve.size());
  const auto inverse = newton(curve, about, *drawn_at_);
  if (!inverse) return std::nullopt;
  return series_of<Real, N>(curve, Balls<Real>(curve.size(), Ball<Real>::exact(0)), t, *inverse,
                            weights_of(equations_));
}

template <class Real, int N>
std::vector<Series<Real, N>> JointFunctions::unknowns(std::size_t piece, const Ball<Real>& t) const {
  if (auto exactly = drawn<Real, N>(piece, t)) return std::move(*exactly);
  if constexpr (std::is_same_v<Real, double>) {
    return enclosed<N>(piece, t);
  } else {
    const std::vector<Series<double, N + 1>> over = enclosed<N + 1>(piece, detail::in_doubles(t));
    auto at_middle = solved<Real, N>(piece, t.mid);
    std::vector<Series<Real, N>> out;
    for (std::size_t i = 0; i < over.size(); ++i) {
      const auto as_real = [](const Ball<double>& x) { return Ball<Real>(Real(x.mid), x.rad); };
      if (!at_middle) {
        auto s = Series<Real, N>::of_terms(N + 1);
        for (std::size_t k = 0; k < s.c.size(); ++k) s.c[k] = as_real(over[i].c[k]);
        out.push_back(s);
      } else if (t.rad == 0) {
        out.push_back((*at_middle)[i]);
      } else {
        std::array<Ball<Real>, static_cast<std::size_t>(N) + 2> c;
        std::copy((*at_middle)[i].c.begin(), (*at_middle)[i].c.end(), c.begin());
        c.back() = as_real(over[i].c.back());
        out.push_back(widened<Real, static_cast<std::size_t>(N) + 2, N>(c, t.rad));
      }
    }
    return out;
  }
}

template <class Real, int N>
const std::vector<Series<Real, N>>& JointFunctions::all_values(std::size_t piece, const Ball<Real>& t) const {
  using J = Series<Real, N>;
  struct Known {
    std::uint64_t id = 0;
    std::size_t piece = 0;
    Ball<Real> t;
    std::vector<J> values;
  };
  // Each of a pair's chains asks for several joints at one time, and for two times in turn; over a cell of joint
  // values, all pairs ask for one time of each drive.
  thread_local std::array<Known, 2 * max_joints> known;
  thread_local std::size_t last = 0;
  for (Known& k : known) {
    if (k.id == id_ && k.piece == piece && k.t.mid == t.mid && k.t.rad == t.rad) return k.values;
  }
  last = (last + 1) % known.size();
  Known& entry = known[last];
  entry.id = 0;
  const std::vector<J> of_unknowns = equations_.unknowns > 0 ? unknowns<Real, N>(piece, t) : std::vector<J>{};
  const std::vector<J> drives = LoopCurve{equations_, piece, equations_.unknowns}.drives_at(J::variable(t));
  entry.values.clear();
  for (const LoopEquations::TreeJoint& joint : equations_.joints)
    entry.values.push_back(value_of(joint.value, of_unknowns, drives));
  entry.piece = piece;
  entry.t = t;
  entry.id = id_;
  return entry.values;
}

template <class Real, int N>
Series<Real, N> JointFunctions::value_of_joint(std::size_t joint, std::size_t piece, const Ball<Real>& t) const {
  const std::vector<Series<Real, N>>& values = all_values<Real, N>(piece, t);
  if (joint < values.size()) return values[joint];
  const LoopEquations::Closure& closure = equations_.closure(joint);
  // Angles are sums.
  if (!closure.slide) return closing_value(equations_, LinkPoses<Series<Real, N>>{values, {}}, closure);
  return closing_value(equations_, link_poses(equations_, values), closure);
}

template <class J>
J JointFunctions::value(std::size_t joint, std::size_t piece, const Ball<typename J::Number>& given) const {
  using Real = typename J::Number;
  Ball<Real> t = given;
  if (!(t.magnitude() < 0x1p400)) {
    if constexpr (requires(J j) { j.v; }) {
      return J{anything<Real>(), anything<Real>(), anything<Real>()};
    } else {
      return unknown_series<J>();
    }
  }
  const std::vector<LoopCell>& cells = cells_[piece];
  if (!cells.empty()) {
    const Real from(cells.front().from), to(cells.back().to), lo = t.lower(), hi = t.upper();
    if (t.rad == 0) {
      if (t.mid < from) t.mid = from;
      if (t.mid > to) t.mid = to;
    } else if (lo < from || hi > to) {
      t = Ball<Real>::between(std::clamp(lo, from, to), std::clamp(hi, from, to));
    }
  }
  if constexpr (requires(J j) { j.v; }) {
    const Series<Real, 2> s = value_of_joint<Real, 2>(joint, piece, t);
    const auto c = [&](int k) { return k < s.terms ? s.c[static_cast<std::size_t>(k)] : Ball<Real>::exact(0); };
    return J{c(0), c(1), c(2) * 2.0};
  } else {
    constexpr int n = static_cast<int>(std::tuple_size_v<decltype(J::c)>) - 1;
    return value_of_joint<Real, n>(joint, piece, t);
  }
}

template <class J, class Real>
J joint_value(const JointFunctions& functions, std::size_t joint, std::size_t piece, const Ball<Real>& t) {
  return functions.value<J>(joint, piece, t);
}
#define TAUT_INSTANTIATE(Real)                                                                              \
  template Jet<Real> joint_value(const JointFunctions&, std::size_t, std::size_t, const Ball<Real>&);       \
  template Series<Real, 0> joint_value(const JointFunctions&, std::size_t, std::size_t, const Ball<Real>&); \
  template Series<Real, model_degree> joint_value(const JointFunctions&, std::size_t, std::size_t, const Ball<Real>&);
TAUT_INSTANTIATE(double)
TAUT_FOR_EACH_PRECISION(TAUT_INSTANTIATE)
#undef TAUT_INSTANTIATE
template Series<double, 1> joint_value(const JointFunctions&, std::size_t, std::size_t, const Ball<double>&);
template Series<double, 3> joint_value(const JointFunctions&, std::size_t, std::size_t, const Ball<double>&);

}  // namespace taut::internal
