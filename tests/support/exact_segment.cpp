#include "support/exact_segment.hpp"

#include <cmath>

namespace taut::testing::exact {
namespace {

bool is_imaginary(What what) { return what == What::height || what == What::turn || what == What::ray; }

/// The direction of rays: one in which nothing else lies.
constexpr double ray_x = 0.7390851332151607, ray_y = 0.6736120291832148;

}  // namespace

MotionSegment::MotionSegment(const Scene& scene, std::array<BodyMotion, 2> bodies, Poly time, Rational from,
                             Rational to)
    : bodies_(std::move(bodies)), time_(std::move(time)), from_(std::move(from)), to_(std::move(to)) {
  has_formal_ = bodies_[0].has_formal() && bodies_[1].has_formal();
  for (std::size_t b = 0; b < 2; ++b) {
    radicands_[b] = bodies_[b].radicand();
    polygons_[b] = scene.bodies[b].polygon;
    for (int i = 0; i < size(static_cast<int>(b)); ++i) {
      const std::array<Rational, 2> v = local<Rational>(static_cast<int>(b), i);
      narrow_[b].push_back({Narrow::of(v[0]), Narrow::of(v[1])});
    }
  }
}

template <class I>
std::array<I, 2> MotionSegment::local(int body, int vertex) const {
  const auto b = static_cast<std::size_t>(body), i = static_cast<std::size_t>(vertex);
  if constexpr (std::is_same_v<I, Narrow>) {
    return narrow_[b][i];
  } else {
    const Point &v = polygons_[b][i], &c = bodies_[b].pivot_point();
    if (c == Point{}) return {I(v.x), I(v.y)};
    return {I(I(v.x) - I(c.x)), I(I(v.y) - I(c.y))};
  }
}

template <class I, int N>
FrameOf<I, N> MotionSegment::make_frame(int side, const I& u) const {
  using S = Series<I, N>;
  const Pose<I, N> own = bodies_[static_cast<std::size_t>(side)].pose<I, N>(u);
  const Pose<I, N> other = bodies_[static_cast<std::size_t>(1 - side)].pose<I, N>(u);
  FrameOf<I, N> f;
  const S dx = (other.ox - own.ox) * other.below, dy = (other.oy - own.oy) * other.below;
  f.lx = own.x * dx + own.y * dy;
  f.ly = own.x * dy - own.y * dx;
  f.kx = own.x * other.x + own.y * other.y;
  f.ky = own.x * other.y - own.y * other.x;
  f.r = own.square * other.below;
  return f;
}

FrameOf<Narrow, 4> MotionSegment::frame(int side, const Narrow& u) const { return make_frame<Narrow, 4>(side, u); }

template <class I>
MotionSegment::TermsOf<I> MotionSegment::terms(const Function& f) const {
  const int own = f.pair.side, other = 1 - own, i = f.pair.edge, j = f.pair.vertex;
  using Vector = std::array<I, 2>;
  const auto next = [&](int body, int k) { return local<I>(body, k + 1 == size(body) ? 0 : k + 1); };
  const Vector a = local<I>(own, i), v = local<I>(other, j);
  const bool imaginary = is_imaginary(f.what);
  if (f.what == What::ray) return {I(ray_x), I(ray_y), v[0], v[1], a[0], a[1], true, imaginary};
  const Vector b = next(own, i);
  const I ex = b[0] - a[0], ey = b[1] - a[1];
  if (f.what == What::turn || f.what == What::along) {
    const Vector n = next(other, j);
    return {ex, ey, I(n[0] - v[0]), I(n[1] - v[1]), I(0.0), I(0.0), false, imaginary};
  }
  const Vector& s = f.what == What::past_b ? b : a;
  return {ex, ey, v[0], v[1], s[0], s[1], true, imaginary};
}

template <int N>
const FrameOf<Wide, N>& MotionSegment::wide_frame(Cache<N>& cache, int side, const Wide& u) const {
  const std::size_t hash = u.hash();
  const auto [first, last] = cache.equal_range(hash);
  for (auto at = first; at != last; ++at) {
    const Cached<N>& c = at->second;
    if (c.side == side && c.bits == Wide::bits() && c.u.same(u)) return c.frame;
  }
  if (++work_ > 20000) throw Beyond{"too much work"};
  if (cache.size() >= most_cached) cache.clear();
  return cache.emplace(hash, Cached<N>{side, Wide::bits(), u, make_frame<Wide, N>(side, u)})->second.frame;
}

namespace {

/// Adds up the k-th coefficients.
template <class I, int N, class Terms>
I combined(const Terms& t, const FrameOf<I, N>& at, std::size_t k) {
  I zx = t.wx * at.kx.c[k] - t.wy * at.ky.c[k], zy = t.wx * at.ky.c[k] + t.wy * at.kx.c[k];
  if (t.whole) {
    zx = zx + at.lx.c[k] - t.sx * at.r.c[k];
    zy = zy + at.ly.c[k] - t.sy * at.r.c[k];
  }
  return t.imaginary ? t.ex * zy - t.ey * zx : t.ex * zx + t.ey * zy;
}

}  // namespace

Wide MotionSegment::coefficient(const Function& f, const Wide& u, int k) const {
  const auto t = terms<Wide>(f);
  const auto i = static_cast<std::size_t>(k);
  if (k <= 2) return combined(t, wide_frame(short_frames_, f.pair.side, u), i);
  return combined(t, wide_frame(long_frames_, f.pair.side, u), i);
}

MotionSegment::WideSeries MotionSegment::series(const Function& f, const Wide& u) const {
  const FrameOf<Wide, 8>& at = wide_frame(long_frames_, f.pair.side, u);
  const auto t = terms<Wide>(f);
  WideSeries r;
  for (std::size_t k = 0; k < r.c.size(); ++k) r.c[k] = combined(t, at, k);
  return r;
}

MotionSegment::NarrowSeries MotionSegment::series(const Function& f, const FrameOf<Narrow, 4>& at) const {
  const auto t = terms<Narrow>(f);
  NarrowSeries r;
  for (std::size_t k = 0; k < r.c.size(); ++k) r.c[k] = combined(t, at, k);
  return r;
}

Narrow MotionSegment::coefficient(const Function& f, const FrameOf<Narrow, 4>& at, int k) const {
  return combined(terms<Narrow>(f), at, static_cast<std::size_t>(k));
}

const MotionSegment::FormalFrame& MotionSegment::formal_frame(int side) const {
  auto& known = formal_frames_[static_cast<std::size_t>(side)];
  if (known) return *known;
  const BodyMotion &own = bodies_[static_cast<std::size_t>(side)], &other = bodies_[static_cast<std::size_t>(1 - side)];
  // Equal radicands are one root.
  const int other_root = radicands_[0] == radicands_[1] ? side : 1 - side;
  const Formal x = conj(own.formal(side)), y = other.formal(other_root);
  const Complex below{other.below(), {}};
  FormalFrame f;
  f.l = ((other.origin() - own.origin()) * below) * x;
  f.k = Formal::product(x, y, radicands_);
  f.r = Formal(Complex{own.square(), {}} * below);
  known = std::move(f);
  return *known;
}

Formal MotionSegment::formal(const Function& f) const {
  const FormalFrame& frame = formal_frame(f.pair.side);
  const auto t = terms<Rational>(f);
  const auto complex = [](const Rational& x, const Rational& y) { return Complex{trimmed({x}), trimmed({y})}; };
  const Complex e = complex(t.ex, Rational(-t.ey));
  const Formal turned = (e * complex(t.wx, t.wy)) * frame.k;
  return t.whole ? turned + e * frame.l - (e * complex(t.sx, t.sy)) * frame.r : turned;
}

Formal MotionSegment::formal_part(const Function& f) const {
  const Formal z = formal(f);
  return is_imaginary(f.what) ? z - conj(z) : z + conj(z);
}

bool MotionSegment::identically_zero(const Function& f, bool& assumed) const {
  const int before = Wide::bits();
  bool zero = true;
  for (const int bits : {192, 1000, 4000}) {
    Wide::bits() = bits;
    // An instant at which nothing else happens.
    const Wide u = Wide::of(from_ + (to_ - from_) * Rational(483647, 1000003));
    zero = coefficient(f, u, 0).sign() == 0;
    if (!zero) break;
    if (has_formal_ && formal_part(f).zero()) {
      Wide::bits() = before;
      return true;
    }
  }
  Wide::bits() = before;
  assumed |= zero;
  return zero;
}

bool MotionSegment::zero_at(const Function& f, const Rational& u) const {
  return formal_part(f).at(u, radicands_).zero();
}

const std::optional<Curve>& MotionSegment::norm(const Function& f) const {
  const std::array<int, 4> key{f.pair.side, f.pair.vertex, f.pair.edge, static_cast<int>(f.what)};
  const auto [place, fresh] = norms_.try_emplace(key);
  if (fresh && has_formal_) place->second = formal(f).norm(is_imaginary(f.what), radicands_);
  return place->second;
}

bool MotionSegment::polynomial_of(const Function& f, Poly& p) const {
  if (!has_formal_) return false;
  const Formal z = formal(f);
  const Complex* c = z.as_polynomial();
  if (!c) return false;
  p = is_imaginary(f.what) ? c->im : c->re;
  return true;
}

double MotionSegment::length(int side, int edge) const {
  const auto& own = narrow_[static_cast<std::size_t>(side)];
  const auto &a = own[static_cast<std::size_t>(edge)], &b = own[static_cast<std::size_t>(edge + 1) % own.size()];
  return std::hypot(b[0].lo() - a[0].lo(), b[1].lo() - a[1].lo());
}

}  // namespace taut::testing::exact
