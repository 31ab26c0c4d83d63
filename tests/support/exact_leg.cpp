#include "support/exact_leg.hpp"

#include <cmath>

namespace taut::testing::exact {
namespace {

Complex constant(const Rational& x, const Rational& y) { return {trimmed({x}), trimmed({y})}; }
Rational real(const Complex& c) { return c.re.empty() ? Rational(0) : c.re[0]; }
bool is_imaginary(What what) { return what == What::height || what == What::turn || what == What::ray; }
Rational imaginary(const Complex& c) { return c.im.empty() ? Rational(0) : c.im[0]; }

/// The direction of rays: one in which nothing else lies.
constexpr double ray_x = 0.7390851332151607, ray_y = 0.6736120291832148;

}  // namespace

Leg::Leg(const Scene& scene, std::array<BodyMotion, 2> bodies, Poly time, Rational from, Rational to)
    : bodies_(std::move(bodies)), time_(std::move(time)), from_(std::move(from)), to_(std::move(to)) {
  has_formal_ = bodies_[0].has_formal() && bodies_[1].has_formal();
  for (std::size_t b = 0; b < 2; ++b) {
    radicands_[b] = bodies_[b].radicand();
    for (const Point& p : scene.bodies[b].polygon) {
      local_[b].push_back(constant(Rational(p.x), Rational(p.y)) - bodies_[b].pivot());
      narrow_[b].push_back({Narrow::of(real(local_[b].back())), Narrow::of(imaginary(local_[b].back()))});
    }
  }
}

template <class I, int N>
FrameOf<I, N> Leg::make_frame(int side, const I& u) const {
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

FrameOf<Narrow, 4> Leg::frame(int side, const Narrow& u) const { return make_frame<Narrow, 4>(side, u); }

Leg::Terms Leg::terms(const Function& f) const {
  const auto side = static_cast<std::size_t>(f.pair.side), i = static_cast<std::size_t>(f.pair.edge),
             j = static_cast<std::size_t>(f.pair.vertex);
  const std::vector<Complex>&own = local_[side], &other = local_[1 - side];
  const Complex &a = own[i], &b = own[(i + 1) % own.size()], &v = other[j];
  switch (f.what) {
    case What::turn:
    case What::along:
      return {b - a, other[(j + 1) % other.size()] - v, {}, false, is_imaginary(f.what)};
    case What::ray:
      return {constant(Rational(ray_x), Rational(ray_y)), v, a, true, true};
    default:
      return {b - a, v, f.what == What::past_b ? b : a, true, is_imaginary(f.what)};
  }
}

Leg::WideSeries Leg::series(const Function& f, const Wide& u) const {
  const Cached* found = nullptr;
  for (const Cached& c : cache_) {
    if (c.side == f.pair.side && c.bits == Wide::bits() && c.u.same(u)) found = &c;
  }
  if (!found) {
    if (++work_ > 20000) throw Beyond{"too much work"};
    cache_.push_front({f.pair.side, Wide::bits(), u, make_frame<Wide, 8>(f.pair.side, u)});
    if (cache_.size() > 12) cache_.pop_back();
    found = &cache_.front();
  }
  const Terms terms = this->terms(f);
  const FrameOf<Wide, 8>& at = found->frame;
  const Complex e = conj(terms.e), w = e * terms.w, s = e * terms.s;
  const bool im = terms.imaginary;
  // Im (p + i q) (X + i Y) = p Y + q X, Re = p X - q Y.
  WideSeries r(Wide(0.0));
  const auto add = [&](const Rational& weight, const WideSeries& x) {
    if (weight != 0) r = r + Wide::of(weight) * x;
  };
  add(real(w), im ? at.ky : at.kx);
  add(im ? imaginary(w) : Rational(-imaginary(w)), im ? at.kx : at.ky);
  if (!terms.whole) return r;
  add(real(e), im ? at.ly : at.lx);
  add(im ? imaginary(e) : Rational(-imaginary(e)), im ? at.lx : at.ly);
  add(Rational(-(im ? imaginary(s) : real(s))), at.r);
  return r;
}

Leg::NarrowSeries Leg::series(const Function& f, const FrameOf<Narrow, 4>& at) const {
  using Vector = std::array<Narrow, 2>;
  const auto side = static_cast<std::size_t>(f.pair.side), i = static_cast<std::size_t>(f.pair.edge),
             j = static_cast<std::size_t>(f.pair.vertex);
  const std::vector<Vector>&own = narrow_[side], &other = narrow_[1 - side];
  const Vector &a = own[i], &b = own[(i + 1) % own.size()], &v = other[j], &n = other[(j + 1) % other.size()];
  const bool whole = f.what != What::turn && f.what != What::along;
  const Vector e = f.what == What::ray ? Vector{ray_x, ray_y} : Vector{b[0] - a[0], b[1] - a[1]};
  const Vector w = whole ? v : Vector{n[0] - v[0], n[1] - v[1]};
  NarrowSeries zx = w[0] * at.kx - w[1] * at.ky, zy = w[0] * at.ky + w[1] * at.kx;
  if (whole) {
    const Vector& s = f.what == What::past_b ? b : a;
    zx = zx + at.lx - s[0] * at.r;
    zy = zy + at.ly - s[1] * at.r;
  }
  return is_imaginary(f.what) ? e[0] * zy - e[1] * zx : e[0] * zx + e[1] * zy;
}

const Leg::FormalFrame& Leg::formal_frame(int side) const {
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

Formal Leg::formal(const Function& f) const {
  const FormalFrame& frame = formal_frame(f.pair.side);
  const Terms t = terms(f);
  const Complex e = conj(t.e);
  const Formal turned = (e * t.w) * frame.k;
  return t.whole ? turned + e * frame.l - (e * t.s) * frame.r : turned;
}

Formal Leg::formal_part(const Function& f) const {
  const Formal z = formal(f);
  return is_imaginary(f.what) ? z - conj(z) : z + conj(z);
}

bool Leg::identically_zero(const Function& f, bool& assumed) const {
  const int before = Wide::bits();
  bool zero = true;
  for (const int bits : {192, 1000, 4000}) {
    Wide::bits() = bits;
    // An instant at which nothing else happens.
    const Wide u = Wide::of(from_ + (to_ - from_) * Rational(483647, 1000003));
    zero = series(f, u).c[0].sign() == 0;
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

bool Leg::zero_at(const Function& f, const Rational& u) const { return formal_part(f).at(u, radicands_).zero(); }

bool Leg::polynomial_of(const Function& f, Poly& p) const {
  if (!has_formal_) return false;
  const Formal z = formal(f);
  const Complex* c = z.as_polynomial();
  if (!c) return false;
  p = is_imaginary(f.what) ? c->im : c->re;
  return true;
}

double Leg::length(int side, int edge) const {
  const auto& own = narrow_[static_cast<std::size_t>(side)];
  const auto &a = own[static_cast<std::size_t>(edge)], &b = own[static_cast<std::size_t>(edge + 1) % own.size()];
  return std::hypot(b[0].lo() - a[0].lo(), b[1].lo() - a[1].lo());
}

}  // namespace taut::testing::exact
