#include "motion/cosine_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/dyadic.hpp"

namespace taut::internal {
namespace {

/// A polynomial with its exact coefficients. Near its roots doubles show nothing of its sign, and the less the higher
/// its degree: there it is evaluated exactly.
class ExactPolynomial {
 public:
  ExactPolynomial(const Coefficients& c, double origin) : near_(c), origin_(origin) {
    for (const double x : c) exact_.push_back(Dyadic::exact(x));
  }

  std::size_t degree() const { return exact_.size() - 1; }
  ExactPolynomial derivative() const {
    ExactPolynomial d({}, origin_);
    for (std::size_t k = 1; k < exact_.size(); ++k) {
      d.exact_.push_back(exact_[k] * Dyadic(static_cast<std::int64_t>(k), 0));
      d.near_.push_back(near_[k] * static_cast<double>(k));
    }
    return d;
  }
  ExactPolynomial minus(double constant) const {
    ExactPolynomial shifted = *this;
    shifted.exact_[0] = exact_[0] - Dyadic::exact(constant);
    shifted.near_[0] -= constant;
    return shifted;
  }

  double near(double t) const {
    double v = 0;
    const double since = t - origin_;
    for (std::size_t k = near_.size(); k-- > 0;) v = v * since + near_[k];
    return v;
  }
  Dyadic operator()(double t) const {
    Dyadic v;
    const Dyadic at = Dyadic::exact(t) - Dyadic::exact(origin_);
    for (std::size_t k = exact_.size(); k-- > 0;) v = v * at + exact_[k];
    return v;
  }
  bool negative(double t) const {
    double size = 0;
    for (std::size_t k = near_.size(); k-- > 0;) size = size * std::fabs(t - origin_) + std::fabs(near_[k]);
    // Each coefficient was rounded for each derivative, the time once, and each step twice.
    const double roundings = 4.0 * (static_cast<double>(near_.size()) + max_degree);
    const double error = roundings * 0x1p-53 * size + 0x1p-1000, v = near(t);
    return std::fabs(v) > error ? v < 0 : (*this)(t).sign() < 0;
  }

 private:
  std::vector<Dyadic> exact_;
  Coefficients near_;
  double origin_;
};

/// The first doubles from which on the polynomial has another sign, in [from, to], between the places where its
/// derivative does.
std::vector<double> roots(const ExactPolynomial& c, const std::vector<double>& stationary, double from, double to) {
  std::vector<double> ends{from};
  ends.insert(ends.end(), stationary.begin(), stationary.end());
  ends.push_back(to);
  std::vector<double> found;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    double lo = ends[i], hi = ends[i + 1];
    const bool rises = c.negative(lo);
    if (rises == c.negative(hi)) continue;
    for (;;) {
      const double middle = lo + (hi - lo) / 2;
      if (!(lo < middle && middle < hi)) break;
      (c.negative(middle) == rises ? lo : hi) = middle;
    }
    found.push_back(hi);
  }
  return found;
}

/// Where |a| may reach 1: where it crosses 1, and where a derivative vanishes, as all up to some order do where it only
/// touches.
std::vector<double> candidates(const ExactPolynomial& a, double from, double to) {
  std::vector<ExactPolynomial> derivatives{a};
  while (derivatives.back().degree() > 1) derivatives.push_back(derivatives.back().derivative());
  std::vector<double> all, stationary;
  for (std::size_t k = derivatives.size(); k-- > 1;) {
    stationary = roots(derivatives[k], stationary, from, to);
    all.insert(all.end(), stationary.begin(), stationary.end());
  }
  for (const double e : {1.0, -1.0}) {
    const std::vector<double> crossings = roots(a.minus(e), stationary, from, to);
    all.insert(all.end(), crossings.begin(), crossings.end());
  }
  return all;
}

double before(double t) { return std::nextafter(t, -INFINITY); }
double after(double t) { return std::nextafter(t, INFINITY); }

/// |a| - 1, exactly.
Dyadic excess(const ExactPolynomial& a, double t) {
  const Dyadic v = a(t), one = Dyadic::exact(1);
  return v.sign() < 0 ? -v - one : v - one;
}

/// Is |a| 1 at a double, or beyond, or so close to 1 that it must touch it next to the double? That is, by no more than
/// it bends from double to double.
bool touches(const ExactPolynomial& a, double t) {
  const Dyadic x = excess(a, t);
  if ((x + Dyadic(1, -90)).sign() > 0) return true;
  const Dyadic second = excess(a, before(t)) + excess(a, after(t)) - x - x;
  return second.sign() < 0 && (x - second * Dyadic(4, 0)).sign() >= 0;
}

/// The doubles strictly between the ends at which |a| is 1, or next to which it crosses 1, or between which it touches
/// 1; in order.
std::vector<double> extremes(const ExactPolynomial& a, double from, double to) {
  std::vector<double> found{from, to};
  const auto note = [&](double t) {
    if (from < t && t < to && std::find(found.begin(), found.end(), t) == found.end()) found.push_back(t);
  };
  const std::vector<double> all = candidates(a, from, to);
  for (const double t : all) {
    const double ends[] = {before(t), t, after(t)};
    int sign[3];
    for (int i = 0; i < 3; ++i) {
      sign[i] = excess(a, ends[i]).sign();
      if (sign[i] == 0) note(ends[i]);
    }
    // Of two neighbours on both sides of 1, the one within.
    for (int i = 0; i < 2; ++i) {
      if (sign[i] * sign[i + 1] < 0) note(sign[i] < 0 ? ends[i] : ends[i + 1]);
    }
  }
  // Near an end of the piece, or an instant that is known, that is what touches.
  const double nearby = 0x1p-10 * (to - from);
  for (const double t : all) {
    const bool known = std::any_of(found.begin(), found.end(), [&](double x) { return std::fabs(x - t) < nearby; });
    if (known || !touches(a, t)) continue;
    note(before(t));
    note(after(t));
  }
  std::sort(found.begin(), found.end());
  return {found.begin() + 1, found.end() - 1};
}

/// Not turned, or by half a turn: what the cosine says that is 1 or -1, or beyond.
Rotation at_rest(double cosine) { return DirectionRotation{{cosine > 0 ? 1.0 : -1.0}, {0.0}}; }

}  // namespace

std::vector<MotionPiece> cut_at_extremes(const MotionPiece& piece, double from, double to) {
  const auto* cosine = std::get_if<CosineRotation>(&piece.rotation);
  if (!cosine || cosine->a.empty() || !(from <= to)) return {piece};
  const ExactPolynomial a(cosine->a, piece.origin);
  std::vector<double> cuts = extremes(a, from, to);
  cuts.push_back(piece.until);
  std::vector<MotionPiece> pieces;
  double start = from;
  for (const double until : cuts) {
    MotionPiece part = piece;
    part.until = until;
    const double end = std::min(until, to), middle = start + (end - start) / 2;
    // Beyond 1 in the middle, it is so up to the doubles next to both ends.
    const bool rests = excess(a, middle).sign() > 0 || (touches(a, start) && touches(a, middle) && touches(a, end));
    if (rests) part.rotation = at_rest(a.near(middle));
    pieces.push_back(part);
    start = until;
  }
  return pieces;
}

}  // namespace taut::internal
