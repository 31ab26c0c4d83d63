#include "support/exact_roots.hpp"

namespace taut::testing::exact {
namespace {

constexpr int first_bits = 192;

Poly nth_derivative(Poly p, int order) {
  for (int k = 0; k < order; ++k) p = derivative(p);
  return p;
}

/// Not the middle, where things may happen.
Rational inside(const Rational& lo, const Rational& hi) {
  Precision at(first_bits);
  const Wide a = Wide::of(lo), b = Wide::of(hi);
  const Wide m = (a + (b - a) * Wide(0.48710937523)).middle();
  const Rational q = m.exact_lo();
  return q > lo && q < hi ? q : Rational((lo + hi) / 2);
}

/// Taylor coefficients over an interval, from those in its middle and the last one over all of it: where large terms
/// cancel, they do so in the middle already.
MotionSegment::WideSeries centred(const MotionSegment& segment, const Function& f, const Wide& over) {
  constexpr int n = MotionSegment::WideSeries::order;
  const Wide m = over.middle(), h = over - m;
  MotionSegment::WideSeries s = segment.series(f, m);
  s.c[n] = segment.coefficient(f, over, n);
  // Horner's rule for all derivatives at once: a Taylor shift by h.
  for (int k = 0; k < n; ++k) {
    for (int j = n - 1; j >= k; --j)
      s.c[static_cast<std::size_t>(j)] = s.c[static_cast<std::size_t>(j)] + h * s.c[static_cast<std::size_t>(j + 1)];
  }
  return s;
}

/// The range of a polynomial over m + h, by its coefficients about m.
template <class I>
I range_about(std::vector<I> c, const I& m, const I& h) {
  for (std::size_t k = 0; k + 1 < c.size(); ++k) {
    for (std::size_t j = c.size() - 1; j-- > k;) c[j] = c[j] + m * c[j + 1];
  }
  I range = c.back();
  for (std::size_t k = c.size() - 1; k-- > 0;) range = c[k] + h * range;
  return range;
}

/// Has a polynomial no zero there? Doubles tell where it is not small.
bool vanishes_nowhere(const Curve& p, const Wide& over, const Rational& lo, const Rational& hi) {
  const Narrow from = Narrow::of(lo), to = Narrow::of(hi), middle((from.lo() + to.hi()) / 2);
  const Narrow rough = range_about(p.narrow, middle, Narrow(from.lo(), to.hi()) - middle);
  if (rough.positive() || rough.negative()) return true;
  std::vector<Wide> c;
  for (const Rational& x : p.exact) c.push_back(Wide::of(x));
  const Wide m = over.middle();
  return range_about(std::move(c), m, over - m).sign() != 0;
}

}  // namespace

std::vector<Root> RootFinder::zeros(const Function& f, const Rational& lo, const Rational& hi) {
  return search(f, lo, hi, 0);
}

std::vector<Root> RootFinder::search(const Function& f, const Rational& lo, const Rational& hi, int depth) {
  Precision at(first_bits + 2 * depth);
  const Wide over = Wide::hull(Wide::of(lo), Wide::of(hi));
  // A root whose square nearly vanishes hides the function's sign over all but the shortest intervals nearby.
  const std::optional<Curve>& norm = segment_.norm(f);
  if (norm && vanishes_nowhere(*norm, over, lo, hi)) return {};
  const MotionSegment::WideSeries s = centred(segment_, f, over);
  if (s.c[0].sign() != 0) return {};
  for (int j = 1; j <= 7; ++j) {
    if (s.c[static_cast<std::size_t>(j)].sign() != 0) return descend(f, 0, j, lo, hi);
  }
  if (depth > 400 || lo == hi) throw Beyond{"a zero of high multiplicity, or a singularity"};
  const Rational m = inside(lo, hi);
  std::vector<Root> roots = search(f, lo, m, depth + 1), rest = search(f, m, hi, depth + 1);
  for (Root& r : rest) {
    if (r.exact && !roots.empty() && roots.back().exact && *roots.back().exact == *r.exact) continue;
    roots.push_back(std::move(r));
  }
  return roots;
}

/// The `settled`-th derivative keeps its sign on [lo, hi].
std::vector<Root> RootFinder::descend(const Function& f, int order, int settled, const Rational& lo,
                                      const Rational& hi) {
  std::vector<Root> marks;
  const auto end = [&](const Rational& u) {
    Precision at(first_bits);
    marks.push_back({f, order, Wide::of(u), u});
  };
  end(lo);
  if (order + 1 < settled) {
    for (Root& r : descend(f, order + 1, settled, lo, hi)) {
      if (!r.exact || (*r.exact != lo && *r.exact != hi)) marks.push_back(std::move(r));
    }
  }
  if (lo != hi) end(hi);
  std::vector<Root> roots;
  int last = 0;
  for (std::size_t k = 0; k < marks.size(); ++k) {
    const int sign = sign_at(f, order, marks[k]);
    if (last * sign < 0) roots.push_back(crossing(f, order, marks[k - 1].at.at_hi(), marks[k].at.at_lo(), last));
    if (sign == 0) roots.push_back(marks[k]);
    last = sign;
  }
  return roots;
}

/// The only zero of that derivative between the two, and simple: halved until Newton's steps work.
Root RootFinder::crossing(const Function& f, int order, Wide lo, Wide hi, int sign_lo) {
  for (int bits = first_bits;; bits += 8) {
    Precision at(bits);
    const Wide over = Wide::hull(lo, hi);
    if (segment_.coefficient(f, over, order + 1).sign() != 0) return {f, order, over, std::nullopt};
    Wide m = over.middle();
    int sign = segment_.coefficient(f, m, order).sign();
    for (double share = 0.37; sign == 0; share *= 0.93) {
      // The middle may be the zero itself.
      m = (lo + (hi - lo) * Wide(share)).middle();
      sign = segment_.coefficient(f, m, order).sign();
      if (share < 0.01) throw Beyond{"a zero that cannot be isolated"};
    }
    (sign == sign_lo ? lo : hi) = m;
  }
}

void RootFinder::refine(Root& root, int bits) {
  if (root.exact) {
    Precision at(bits + 64);
    root.at = Wide::of(*root.exact);
    return;
  }
  for (int stuck = 0;;) {
    const long before = root.at.log_width(), size = std::max(root.at.log_size(), -64L);
    if (before <= -bits) return;
    // Newton's step doubles the digits. The middle must lie within the enclosure, and so needs its precision.
    Precision at(std::min(2 * std::max(size - before, 32L) + 128, size + bits + 192) + 64 * stuck);
    const Wide m = root.at.middle();
    const Wide slope =
        Wide(static_cast<double>(root.order + 1)) * segment_.coefficient(root.function, root.at, root.order + 1);
    if (slope.sign() != 0) {
      const Wide next = m - segment_.coefficient(root.function, m, root.order) / slope;
      if (!(next.before(root.at) || root.at.before(next))) root.at = Wide::meet(root.at, next);
    }
    if (root.at.log_width() > before - 2 && ++stuck > 60) throw Beyond{"a zero that cannot be refined"};
  }
}

long RootFinder::zero_bound(const Function& f, int order, const Root& root) const {
  Poly own, of_root;
  if (!segment_.polynomial_of(f, own) || !segment_.polynomial_of(root.function, of_root)) return -1;
  own = nth_derivative(own, order);
  of_root = nth_derivative(of_root, root.order);
  if (own.empty()) return 0;
  const long degree = static_cast<long>(own.size()) - 1, root_degree = static_cast<long>(of_root.size()) - 1;
  // The resultant is an integer; Landau bounds the zeros of the root's polynomial, and 64 the factorials.
  return degree * log_norm(of_root) + (root_degree - 1) * log_norm(own) + log_scale(own) + 64;
}

int RootFinder::sign_at(const Function& f, int order, Root& root) {
  if (root.exact) return sign_at(f, order, *root.exact);
  const bool same = f.pair == root.function.pair && f.what == root.function.what;
  if (same && order == root.order) return 0;
  long bound = -2;
  for (int bits = first_bits;; bits *= 2) {
    refine(root, bits);
    Precision at(bits + 64);
    const Wide v = segment_.coefficient(f, root.at, order);
    if (v.sign() != 0) return v.sign();
    if (bits == first_bits) continue;
    if (bound == -2) bound = zero_bound(f, order, root);
    const long size = v.log_size();
    if (bound >= 0 && size < -bound) return 0;
    if ((bound < 0 && bits > assumed_bits) || bits > most_bits) {
      assumed = true;
      return 0;
    }
  }
}

int RootFinder::sign_at(const Function& f, int order, const Rational& u) {
  for (int bits = first_bits;; bits *= 2) {
    Precision at(bits);
    const Wide v = segment_.coefficient(f, Wide::of(u), order);
    if (v.sign() != 0) return v.sign();
    if (bits == first_bits && order == 0 && segment_.has_formal() && segment_.zero_at(f, u)) return 0;
    if (bits == first_bits && order > 0) {
      if (Poly p; segment_.polynomial_of(f, p) && value(nth_derivative(p, order), u) == 0) return 0;
    }
    if (bits > assumed_bits) {
      assumed = true;
      return 0;
    }
  }
}

int RootFinder::multiplicity(Root& root) {
  if (!root.exact) return root.order + 1;
  int m = 1;
  while (m < 8 && sign_at(root.function, m, *root.exact) == 0) ++m;
  return m;
}

}  // namespace taut::testing::exact
