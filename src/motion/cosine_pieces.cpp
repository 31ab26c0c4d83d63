#include "motion/cosine_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/dyadic.hpp"

namespace taut {
namespace {

double value(const Coefficients& c, double t) {
  double v = 0;
  for (std::size_t k = c.size(); k-- > 0;) v = v * t + c[k];
  return v;
}

/// |a| - 1, exactly.
Dyadic excess(const Coefficients& a, double t) {
  Dyadic v;
  const Dyadic at = Dyadic::exact(t), one = Dyadic::exact(1);
  for (std::size_t k = a.size(); k-- > 0;) v = v * at + Dyadic::exact(a[k]);
  return v.sign() < 0 ? -v - one : v - one;
}

/// Is |a| 1 at a double, or beyond, or so close to 1 that it must touch it beside the double?
bool touches(const Coefficients& a, double t) { return (excess(a, t) + Dyadic(1, -90)).sign() > 0; }

Coefficients derivative(const Coefficients& c) {
  Coefficients d;
  for (std::size_t k = 1; k < c.size(); ++k) d.push_back(c[k] * static_cast<double>(k));
  return d;
}

/// About where the polynomial is zero in [from, to], between the places where its derivative is. Only guesses: they are
/// looked at exactly.
std::vector<double> guess_roots(const Coefficients& c, const std::vector<double>& stationary, double from, double to) {
  std::vector<double> ends{from};
  ends.insert(ends.end(), stationary.begin(), stationary.end());
  ends.push_back(to);
  std::vector<double> roots;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    double lo = ends[i], hi = ends[i + 1];
    const bool rises = value(c, lo) < 0;
    if (rises == (value(c, hi) < 0)) continue;
    for (;;) {
      const double middle = lo + (hi - lo) / 2;
      if (!(lo < middle && middle < hi)) break;
      ((value(c, middle) < 0) == rises ? lo : hi) = middle;
    }
    roots.push_back(hi);
  }
  return roots;
}

/// Where |a| may reach 1: where it crosses 1, and where a derivative vanishes, as all up to some order do where it only
/// touches. The roots of high derivatives are known best.
std::vector<double> guesses(const Coefficients& a, double from, double to) {
  std::vector<Coefficients> derivatives{a};
  while (derivatives.back().size() > 2) derivatives.push_back(derivative(derivatives.back()));
  std::vector<double> all, stationary;
  for (std::size_t k = derivatives.size(); k-- > 1;) {
    stationary = guess_roots(derivatives[k], stationary, from, to);
    all.insert(all.end(), stationary.begin(), stationary.end());
  }
  for (const double e : {1.0, -1.0}) {
    Coefficients shifted = a;
    shifted[0] -= e;
    const std::vector<double> crossings = guess_roots(shifted, stationary, from, to);
    all.insert(all.end(), crossings.begin(), crossings.end());
  }
  return all;
}

/// The doubles strictly between the ends at which |a| is 1, or next to which it crosses 1, or between which it touches
/// 1; in order.
std::vector<double> extremes(const Coefficients& a, double from, double to) {
  std::vector<double> found{from, to};
  const auto note = [&](double t) {
    if (from < t && t < to && std::find(found.begin(), found.end(), t) == found.end()) found.push_back(t);
  };
  const std::vector<double> all = guesses(a, from, to);
  for (const double guess : all) {
    const double ends[] = {std::nextafter(guess, -INFINITY), guess, std::nextafter(guess, INFINITY)};
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
  // Beside an end of the piece, or an instant that is known, that is what touches.
  const double beside = 0x1p-10 * (to - from);
  for (const double guess : all) {
    const bool known = std::any_of(found.begin(), found.end(), [&](double t) { return std::fabs(t - guess) < beside; });
    if (known || !touches(a, guess)) continue;
    note(std::nextafter(guess, -INFINITY));
    note(std::nextafter(guess, INFINITY));
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
  const Coefficients& a = cosine->a;
  std::vector<double> cuts = extremes(a, from, to);
  cuts.push_back(piece.until);
  std::vector<MotionPiece> pieces;
  double start = from;
  for (const double until : cuts) {
    MotionPiece part = piece;
    part.until = until;
    const double end = std::min(until, to), middle = start + (end - start) / 2;
    if (touches(a, start) && touches(a, middle) && touches(a, end)) part.rotation = at_rest(value(a, middle));
    pieces.push_back(part);
    start = until;
  }
  return pieces;
}

}  // namespace taut
