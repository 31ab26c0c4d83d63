#include "spacetime/any_rotation.hpp"

#include <algorithm>
#include <cmath>

namespace taut::internal::spacetime {
namespace {

/// Covers the rounding of the operations below, which are fewer than 40, relative to the largest length in them, and
/// what the boxes' own numbers are rounded by.
constexpr double rounding = 0x1p-44;

double length(double x, double y) { return std::sqrt(x * x + y * y); }

/// How far the points of a box are from a point.
struct Radii {
  double least, most;
};
Radii radii_about(Vector point, const Box& box) {
  const Vector relative = box.centre - point;
  const double u = std::fabs(dot(relative, box.along)), w = std::fabs(dot(relative, turned(box.along)));
  return {length(std::max(u - box.half_length, 0.0), std::max(w - box.half_width, 0.0)),
          length(u + box.half_length, w + box.half_width)};
}

}  // namespace

AnyRotation::AnyRotation(const MotionSegment& segment, double start, double end) {
  // Where sine and cosine are all but unknown, so are the products with them; the translation as seen from a body that
  // does not rotate is none of these.
  const Frame<double> f = frame(segment, Ball<double>::between(start, end));
  const auto side = [&](const FrameSample& sample, bool in_p) {
    const Vector fixed{segment.offset(in_p).x, segment.offset(in_p).y};
    const double sign = in_p ? 1 : -1;
    Side out;
    out.about = {sign * sample.f[1] - fixed.x, sign * sample.f[2] - fixed.y};
    out.moving = {segment.offset(!in_p).x, segment.offset(!in_p).y};
    const double reach = l1_norm(fixed) + l1_norm(out.moving) + l1_norm(out.about) + sample.error_a + 10;
    out.error = (sample.error_a + rounding * reach) * (1 + 0x1p-40) + underflow_slack;
    return out;
  };
  in_p_ = side(sample_of(f.for_pp), true);
  in_q_ = side(sample_of(f.for_qq), false);
  if (segment.composed) return;
  const auto relative = way_series<double>(segment, Ball<double>::between(start, end));
  const Ball<double>&x = relative[0].c[0], &y = relative[1].c[0];
  const double distance = length(x.mid, y.mid), spread = x.rad + y.rad + rounding * distance;
  least_ = distance - spread;
  most_ = distance + spread;
}

bool AnyRotation::Side::farther(const Box& fixed, const Box& moved, double margin) const {
  const Radii outside = radii_about(about, fixed), inside = radii_about({-this->moving.x, -this->moving.y}, moved);
  const double room = error + margin + rounding * (outside.most + inside.most + margin);
  return outside.least - inside.most > room || inside.least - outside.most > room;
}

/// Three lengths make a triangle: if one is longer than the others together, what is left is a distance.
bool AnyRotation::farther(const Box& p, const Box& q, double margin) const {
  if (in_p_.farther(p, q, margin) || in_q_.farther(q, p, margin)) return true;
  if (!(least_ <= most_)) return false;
  const Radii of_p = radii_about({-in_q_.moving.x, -in_q_.moving.y}, p),
              of_q = radii_about({-in_p_.moving.x, -in_p_.moving.y}, q);
  const double longest = most_ + of_p.most + of_q.most, room = margin + rounding * (longest + margin + 1);
  return least_ - of_p.most - of_q.most > room || of_p.least - most_ - of_q.most > room ||
         of_q.least - most_ - of_p.most > room;
}

/// Is the moved disc in the fixed one, and that by more than the margin?
bool AnyRotation::Side::holds(const Disc& fixed, const Disc& moved, double margin) const {
  const Vector a = about - fixed.centre, b = moved.centre + moving;
  const double reach = length(a.x, a.y) + length(b.x, b.y) + moved.radius;
  return reach + error + margin + rounding * (reach + fixed.radius + margin) < fixed.radius;
}

bool AnyRotation::nested(const TreePair& trees, const BoxNode& p, const BoxNode& q, double margin) const {
  const Disc* of_p = trees.p.hollow(p);
  if (of_p && in_p_.holds(*of_p, trees.q.around(), margin)) return true;
  const Disc* of_q = trees.q.hollow(q);
  return of_q && in_q_.holds(*of_q, trees.p.around(), margin);
}

}  // namespace taut::internal::spacetime
