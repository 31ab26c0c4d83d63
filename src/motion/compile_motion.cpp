#include "taut/motions.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "motion/pieces.hpp"
#include "numeric/ball.hpp"
#include "numeric/real.hpp"
#include "numeric/trig.hpp"
#include "taut/error.hpp"

namespace taut {
using namespace internal;
namespace {

/// Sums of products of two doubles are exact in it, unless their magnitudes differ by more than 2^800.
using Wide = RealMax;

double rounded(const Wide& x) {
  const double nearest = RealTraits<Wide>::to_double(x);
  if (std::isfinite(nearest)) return nearest;
  throw InputError("", "the motion needs a coefficient that is too large for a double",
                   "choose other units, or times that are farther apart");
}

Wide radians_per_degree() { return pi<Wide>() / 180; }

void require_finite(std::initializer_list<double> numbers, const std::string& place) {
  if (!std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); }))
    throw InputError(place, "a number is not finite", "write finite numbers");
}

/// The line through (t0, a) and (t1, b), t0 < t1, times a factor, in powers of the time since t0. In powers of the time
/// itself, the pose at t0 would be the difference of two rounded numbers, which late in time are far larger than it.
Coefficients line(double t0, double a, double t1, double b, const Wide& factor = 1) {
  if (a == b) return a == 0 ? Coefficients{} : Coefficients{rounded(a * factor)};
  return {rounded(a * factor), rounded((Wide(b) - Wide(a)) / (Wide(t1) - Wide(t0)) * factor)};
}

Coefficients constant(double value) { return value == 0 ? Coefficients{} : Coefficients{value}; }

/// Quarter turns have exact directions; other angles are rounded to radians.
Rotation held(double degrees) {
  const double rest = std::fmod(degrees, 360);
  if (rest == 0) return NoRotation{};
  if (std::fmod(rest, 90) != 0) return AngleRotation{{radians(degrees)}};
  const int quarters = (static_cast<int>(rest / 90) + 4) % 4;
  constexpr double cosines[] = {1, 0, -1, 0}, sines[] = {0, 1, 0, -1};
  return DirectionRotation{{cosines[quarters]}, {sines[quarters]}};
}

MotionPiece rest_at(const Keyframe& k, const Point& pivot) {
  MotionPiece piece;
  piece.x = constant(k.x);
  piece.y = constant(k.y);
  piece.rotation = held(k.angle_deg);
  piece.pivot = pivot;
  return piece;
}

/// Around the keyframe's centre, evenly.
MotionPiece around(const Keyframe& a, const Keyframe& b, const Point& pivot) {
  MotionPiece piece = rest_at(a, pivot);
  piece.origin = a.t;
  piece.orbit = {b.centre, line(a.t, 0, b.t, b.by_deg, radians_per_degree())};
  if (b.way == Way::turn && a.angle_deg != b.angle_deg)
    piece.rotation = AngleRotation{line(a.t, a.angle_deg, b.t, b.angle_deg, radians_per_degree())};
  piece.until = b.t;
  return piece;
}

MotionPiece between(const Keyframe& a, const Keyframe& b, const Point& pivot) {
  if (b.way != Way::straight && b.by_deg != 0) return around(a, b, pivot);
  MotionPiece piece;
  piece.x = line(a.t, a.x, b.t, b.x);
  piece.y = line(a.t, a.y, b.t, b.y);
  piece.rotation = a.angle_deg == b.angle_deg
                       ? held(a.angle_deg)
                       : Rotation(AngleRotation{line(a.t, a.angle_deg, b.t, b.angle_deg, radians_per_degree())});
  piece.until = b.t;
  piece.pivot = pivot;
  if (varies(piece)) piece.origin = a.t;
  return piece;
}

/// Sine and cosine of an angle in degrees; exact at quarter turns.
std::pair<Wide, Wide> sine_and_cosine(double degrees) {
  const double rest = std::fmod(degrees, 360);
  if (std::fmod(rest, 90) == 0) {
    constexpr double cosines[] = {1, 0, -1, 0}, sines[] = {0, 1, 0, -1};
    const int quarters = (static_cast<int>(rest / 90) + 4) % 4;
    return {sines[quarters], cosines[quarters]};
  }
  const SinCos<Wide> both = sin_cos(Ball<Wide>(rest * radians_per_degree(), 0.0));
  return {both.sin.mid, both.cos.mid};
}

/// Where the way around a centre leads to.
void take_the_way(const Keyframe& before, Keyframe& k, const Point& pivot) {
  if (k.way == Way::straight) return;
  const auto [sine, cosine] = sine_and_cosine(k.by_deg);
  const Wide x = Wide(pivot.x) + before.x - k.centre.x, y = Wide(pivot.y) + before.y - k.centre.y;
  // The cosine of 60 degrees is exact, and so may a sum be zero: of that, rounding leaves some 2^-960.
  const Wide noise =
      (abs(x) + abs(y) + abs(Wide(k.centre.x)) + abs(Wide(k.centre.y)) + abs(Wide(pivot.x)) + abs(Wide(pivot.y))) *
      0x1p-900;
  const auto coordinate = [&](const Wide& sum) { return abs(sum) < noise ? 0 : rounded(sum); };
  k.x = coordinate(cosine * x - sine * y + k.centre.x - pivot.x);
  k.y = coordinate(sine * x + cosine * y + k.centre.y - pivot.y);
  k.angle_deg = k.way == Way::turn ? before.angle_deg + k.by_deg : before.angle_deg;
}

void require_keyframes(const std::vector<Keyframe>& keyframes) {
  if (keyframes.empty()) throw InputError("keyframes", "there are none", "write at least one keyframe");
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    const Keyframe& k = keyframes[i];
    const std::string place = "keyframe " + std::to_string(i);
    require_finite({k.t, k.x, k.y, k.angle_deg, k.centre.x, k.centre.y, k.by_deg}, place);
    if (i == 0 && k.way != Way::straight)
      throw InputError(place, "it goes around a centre, and there is no keyframe before", "begin with x, y and angle");
    if (i > 0 && !(keyframes[i - 1].t < k.t))
      throw InputError(place, "its time does not come after that of the keyframe before", "order keyframes by time");
  }
}

}  // namespace

double radians(double degrees) { return rounded(degrees * radians_per_degree()); }

Motion from_keyframes(const std::vector<Keyframe>& given, const Point& pivot) {
  require_keyframes(given);
  require_finite({pivot.x, pivot.y}, "pivot");
  std::vector<Keyframe> keyframes = given;
  for (std::size_t i = 1; i < keyframes.size(); ++i) take_the_way(keyframes[i - 1], keyframes[i], pivot);
  Motion motion;
  motion.pieces.reserve(keyframes.size() + 1);
  motion.pieces.push_back(rest_at(keyframes.front(), pivot));
  for (std::size_t i = 0; i + 1 < keyframes.size(); ++i) {
    if (i == 0) motion.pieces[0].until = keyframes[0].t;
    motion.pieces.push_back(between(keyframes[i], keyframes[i + 1], pivot));
  }
  if (keyframes.size() > 1) motion.pieces.push_back(rest_at(keyframes.back(), pivot));
  return motion;
}

Motion from_velocity(const Point& velocity, double spin_deg, const Point& pivot) {
  require_finite({velocity.x, velocity.y, spin_deg, pivot.x, pivot.y}, "velocity");
  MotionPiece piece;
  if (velocity.x != 0) piece.x = {0, velocity.x};
  if (velocity.y != 0) piece.y = {0, velocity.y};
  if (spin_deg != 0) piece.rotation = AngleRotation{{0, radians(spin_deg)}};
  piece.pivot = pivot;
  return {{std::move(piece)}};
}

Motion from_sweep(const Point& pivot, double from_deg, double to_deg, double start, double end) {
  require_finite({pivot.x, pivot.y, from_deg, to_deg, start, end}, "sweep");
  if (!(start < end))
    throw InputError("sweep", "the time interval has no length", "give the sweep a time interval with start < end");
  MotionPiece piece;
  piece.pivot = pivot;
  piece.origin = start;
  piece.rotation = AngleRotation{line(start, from_deg, end, to_deg, radians_per_degree())};
  return {{std::move(piece)}, true};
}

std::optional<AngleInterval> angle_at(const Motion& motion, const TimeInterval& time) {
  if (!motion.sweep || motion.pieces.size() != 1) return std::nullopt;
  const auto* rotation = std::get_if<AngleRotation>(&motion.pieces[0].rotation);
  if (!rotation || rotation->angle.size() > 2) return std::nullopt;
  const Wide origin = motion.pieces[0].origin;
  const auto degrees = [&](double t) {
    const Wide since = t - origin;
    Wide angle = 0;
    for (std::size_t k = rotation->angle.size(); k-- > 0;) angle = angle * since + rotation->angle[k];
    return Wide(angle / radians_per_degree());
  };
  const Wide a = degrees(time.lo), b = degrees(time.hi);
  const Wide &low = std::min(a, b), &high = std::max(a, b);
  return AngleInterval{low.is_zero() ? 0 : double_below(low), high.is_zero() ? 0 : double_above(high)};
}

std::optional<AngleInterval> contact_angle(const Scene& scene, const Contact& contact) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (static_cast<BodyId>(i) != contact.vertex.body && static_cast<BodyId>(i) != contact.edge.body) continue;
    if (const auto angle = angle_at(body.motion, contact.time)) return angle;
  }
  return std::nullopt;
}

}  // namespace taut
