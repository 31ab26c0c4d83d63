#include "support/exact_motion.hpp"

namespace taut::testing::exact {
namespace {

Poly one() { return {Rational(1)}; }

Complex constant(const Point& p) { return {trimmed({Rational(p.x)}), trimmed({Rational(p.y)})}; }

/// A polynomial of the piece as one of the time itself.
Poly in_time(const MotionPiece& piece, const Coefficients& c) {
  return piece.origin == 0 ? poly(c) : composed(poly(c), Poly{Rational(-Rational(piece.origin)), Rational(1)});
}

/// 1 - a^2 of a cosine, or nothing.
Poly radicand_of(const MotionPiece& piece) {
  const auto* r = std::get_if<CosineRotation>(&piece.rotation);
  if (!r) return {};
  const Poly a = in_time(piece, r->a);
  return one() - a * a;
}

/// How often (t - root) divides p, which is divided by it.
int take_out(Poly& p, const Rational& root) {
  int m = 0;
  while (!p.empty() && value(p, root) == 0) {
    p = divided(p, root);
    ++m;
  }
  return m;
}

/// Nothing if p > 0 is proved on [from, to]; else about where it is not.
std::optional<Rational> doubtful(const Poly& p, const Rational& from, const Rational& to, int depth) {
  std::vector<Wide> c;
  for (const Rational& x : p) c.push_back(Wide::of(x));
  const Wide low = Wide::of(from), high = Wide::of(to), t = Wide::hull(low, high), m = t.middle();
  const Series<Wide, 4> at = polynomial<Wide, 4>(c, m), over = polynomial<Wide, 4>(c, t);
  const Wide h = t - m;
  if ((at.c[0] + h * (at.c[1] + h * (at.c[2] + h * (at.c[3] + h * over.c[4])))).positive()) return std::nullopt;
  const Rational middle = (from + to) / 2;
  if (depth == 0) return middle;
  auto found = doubtful(p, from, middle, depth - 1);
  return found ? found : doubtful(p, middle, to, depth - 1);
}

/// The multiple of 2^-20 next to it.
Rational rounded(const Rational& x) {
  const Rational shifted = x * 1048576 + Rational(1, 2);
  mpz_class q;
  mpz_fdiv_q(q.get_mpz_t(), shifted.get_num_mpz_t(), shifted.get_den_mpz_t());
  return Rational(q) / 1048576;
}

}  // namespace

std::optional<std::vector<Rational>> cuts(const MotionPiece& piece, const Rational& from, const Rational& to) {
  std::vector<Rational> zeros;
  Poly p = radicand_of(piece);
  if (p.empty()) return zeros;
  take_out(p, from);
  if (take_out(p, to) % 2 == 1) p = Rational(-1) * p;
  while (const auto place = doubtful(p, from, to, 40)) {
    const Rational zero = rounded(*place);
    const int m = take_out(p, zero);
    if (m == 0) return doubtful(p, from, to, 90) ? std::nullopt : std::optional(zeros);
    if (m % 2 == 1) return std::nullopt;
    zeros.push_back(zero);
  }
  return zeros;
}

bool infinite_speed(const MotionPiece& piece, const Rational& end) {
  Poly p = radicand_of(piece);
  return take_out(p, end) % 2 == 1;
}

struct BodyMotion::Ends {
  BodyMotion before, after;
  Rational u;
};

std::optional<BodyMotion> BodyMotion::of(const MotionPiece& piece, const Poly& time, const Rational& from,
                                         const Rational& to) {
  BodyMotion b;
  b.below_ = b.square_ = Curve(one());
  if (!b.set_rotation(piece, time, from, to)) return std::nullopt;
  b.set_origin(piece, time);
  b.prepare();
  return b;
}

void BodyMotion::set_origin(const MotionPiece& piece, const Poly& time) {
  const bool turns = !std::holds_alternative<NoRotation>(piece.rotation);
  if (turns) pivot_point_ = piece.pivot;
  pivot_ = constant(pivot_point_);
  origin_ = Complex{composed(in_time(piece, piece.x), time), composed(in_time(piece, piece.y), time)} + pivot_;
}

bool BodyMotion::set_rotation(const MotionPiece& piece, const Poly& time, const Rational& from, const Rational& to) {
  plain_ = {one(), {}};
  if (const auto* r = std::get_if<AngleRotation>(&piece.rotation)) angle_ = composed(in_time(piece, r->angle), time);
  if (const auto* r = std::get_if<HalfAngleRotation>(&piece.rotation)) {
    const Poly s = composed(in_time(piece, r->s), time);
    plain_ = Complex{one(), s} * Complex{one(), s};
    below_ = square_ = Curve(one() + s * s);
  }
  if (const auto* r = std::get_if<DirectionRotation>(&piece.rotation)) {
    Rational u = (from + to) / 2;
    if (time.size() > 2) u = time[2] > 0 ? Rational(1, 1024) : Rational(-1, 1024);
    set_direction(composed(in_time(piece, r->a), time), composed(in_time(piece, r->b), time), u);
  }
  if (const auto* r = std::get_if<CosineRotation>(&piece.rotation))
    return set_cosine(in_time(piece, r->a), time, from, to);
  return true;
}

void BodyMotion::set_direction(const Poly& a, const Poly& b, const Rational& inside) {
  const Poly size = a * a + b * b;
  Rational root;
  if (a.empty() || b.empty()) {
    const Rational sign = sgn(value(a.empty() ? b : a, inside));
    plain_ = a.empty() ? Complex{{}, {sign}} : Complex{{sign}, {}};
  } else if (size.size() == 1 && is_square(size[0], root)) {
    plain_ = {Rational(1 / root) * a, Rational(1 / root) * b};
  } else {
    plain_ = {};
    rooted_ = {a, b};
    radicand_ = size;
    below_ = square_ = Curve(size);
  }
}

bool BodyMotion::set_cosine(const Poly& a, const Poly& time, const Rational& from, const Rational& to) {
  plain_ = {composed(a, time), {}};
  Poly rest = one() - a * a;
  if (rest.empty()) return true;
  const int before = take_out(rest, from), after = take_out(rest, to);
  // 1 - a^2 = (t - from)^before (to - t)^after rest.
  if (after % 2 == 1) rest = Rational(-1) * rest;
  const Poly up = time - trimmed({from}), down = trimmed({to}) - time;
  const Poly u = {Rational(0), Rational(1)}, minus_u = {Rational(0), Rational(-1)};
  Poly factor = one();
  const Poly square = {Rational(0), Rational(0), Rational(1)};
  for (int k = 0; k < before; ++k) {
    if (before % 2 == 1 && up != square) return false;
    if (before % 2 == 1 || k % 2 == 0) factor = factor * (before % 2 == 1 ? u : up);
  }
  for (int k = 0; k < after; ++k) {
    if (after % 2 == 1 && down != square) return false;
    if (after % 2 == 1 || k % 2 == 0) factor = factor * (after % 2 == 1 ? minus_u : down);
  }
  radicand_ = composed(rest, time);
  rooted_ = {{}, factor};
  return true;
}

void BodyMotion::prepare() {
  ox_ = origin_.re;
  oy_ = origin_.im;
  plain_x_ = plain_.re;
  plain_y_ = plain_.im;
  rooted_x_ = rooted_.re;
  rooted_y_ = rooted_.im;
}

BodyMotion BodyMotion::bridge(const MotionPiece& before, const MotionPiece& after, double joint) {
  const Poly time = {Rational(0), Rational(1)};
  const Rational t(joint);
  BodyMotion b;
  b.below_ = b.square_ = Curve(one());
  // Of a stretch around the joint at whose ends no cosine is 1: nothing is taken out of the radicand.
  const Rational some(1, 7919);
  const auto first = of(before, time, t - some, t + some), second = of(after, time, t - some, t + some);
  Complex o0, o1, x0, x1;
  if (first && second && first->rational_pose(t, o0, x0) && second->rational_pose(t, o1, x1)) {
    const Complex u{{Rational(0), Rational(1)}, {}};
    b.origin_ = o0 + u * (o1 - o0);
    b.plain_ = x0 + u * (x1 - x0);
    b.square_ = Curve(b.plain_.re * b.plain_.re + b.plain_.im * b.plain_.im);
    b.prepare();
    return b;
  }
  if (first && second) b.ends_ = std::make_shared<const Ends>(Ends{*first, *second, t});
  return b;
}

bool BodyMotion::rational_pose(const Rational& u, Complex& origin, Complex& x) const {
  Rational root = 0;
  if (!is_square(value(radicand_.exact, u), root) || value(angle_.exact, u) != 0) return false;
  const Rational below = value(below_.exact, u);
  const auto part = [&](const Poly& p, const Poly& q) {
    return trimmed({Rational((value(p, u) + value(q, u) * root) / below)});
  };
  x = {part(plain_.re, rooted_.re), part(plain_.im, rooted_.im)};
  origin = Complex{trimmed({value(origin_.re, u)}), trimmed({value(origin_.im, u)})} - x * pivot_;
  return true;
}

Formal BodyMotion::formal(int which) const {
  return Formal::term(false, which, angle_.exact, plain_) + Formal::term(true, which, angle_.exact, rooted_);
}

template <class I, int N>
Series<I, N> Curve::series(const I& u) const {
  if constexpr (std::is_same_v<I, Narrow>) {
    return polynomial<Narrow, N>(narrow, u);
  } else {
    std::vector<Wide> c;
    for (const Rational& x : exact) c.push_back(Wide::of(x));
    return polynomial<Wide, N>(c, u);
  }
}

template <class I, int N>
Pose<I, N> BodyMotion::pose(const I& u) const {
  using S = Series<I, N>;
  Pose<I, N> p;
  if (ends_) {
    const auto straight = [&](const I& from, const I& to) {
      S s(from + u * (to - from));
      s.c[1] = to - from;
      return s;
    };
    const I t = I::of(ends_->u);
    const Pose<I, N> a = ends_->before.template pose<I, N>(t), b = ends_->after.template pose<I, N>(t);
    const auto part = [](const I& x, const Pose<I, N>& q) { return x / q.below.c[0]; };
    const I ax = part(a.x.c[0], a), ay = part(a.y.c[0], a), bx = part(b.x.c[0], b), by = part(b.y.c[0], b);
    const auto origin = [](const BodyMotion& m, const Pose<I, N>& q, const I& x, const I& y, I& ox, I& oy) {
      const I cx = I::of(value(m.pivot_.re, 0)), cy = I::of(value(m.pivot_.im, 0));
      ox = q.ox.c[0] - (x * cx - y * cy);
      oy = q.oy.c[0] - (x * cy + y * cx);
    };
    I aox, aoy, box, boy;
    origin(ends_->before, a, ax, ay, aox, aoy);
    origin(ends_->after, b, bx, by, box, boy);
    p.ox = straight(aox, box);
    p.oy = straight(aoy, boy);
    p.x = straight(ax, bx);
    p.y = straight(ay, by);
    p.below = S(I(1.0));
    p.square = p.x * p.x + p.y * p.y;
    return p;
  }
  p.ox = ox_.series<I, N>(u);
  p.oy = oy_.series<I, N>(u);
  p.below = below_.series<I, N>(u);
  p.square = square_.series<I, N>(u);
  p.x = plain_x_.series<I, N>(u);
  p.y = plain_y_.series<I, N>(u);
  if (!radicand_.exact.empty()) {
    const S g = sqrt(radicand_.series<I, N>(u));
    p.x = p.x + rooted_x_.series<I, N>(u) * g;
    p.y = p.y + rooted_y_.series<I, N>(u) * g;
  }
  if (!angle_.exact.empty()) {
    S s, c;
    sin_cos(angle_.series<I, N>(u), s, c);
    const S x = p.x * c - p.y * s;
    p.y = p.x * s + p.y * c;
    p.x = x;
  }
  return p;
}

template Pose<Narrow, 4> BodyMotion::pose(const Narrow&) const;
template Pose<Wide, 2> BodyMotion::pose(const Wide&) const;
template Pose<Wide, 8> BodyMotion::pose(const Wide&) const;
template Series<Wide, 8> Curve::series(const Wide&) const;

}  // namespace taut::testing::exact
