#include "motion/pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "motion/cosine_pieces.hpp"
#include "motion/polynomial_search.hpp"
#include "motion/pose.hpp"
#include "numeric/budget.hpp"
#include "taut/error.hpp"

namespace taut::internal {
namespace {

void drop_last_zeros(Coefficients& c) {
  while (!c.empty() && c.back() == 0) c.pop_back();
}

/// The same piece without zeros at the end of polynomials, and without an origin of constants, so that equal motions
/// look alike.
MotionPiece without_last_zeros(MotionPiece piece) {
  drop_last_zeros(piece.x);
  drop_last_zeros(piece.y);
  drop_last_zeros(piece.orbit.angle);
  for_each_polynomial(piece.rotation, drop_last_zeros);
  if (!varies(piece)) piece.origin = 0;
  return piece;
}

}  // namespace

namespace {

template <class Visit>
void for_each_given_between(const Motion& motion, double start, double end, const Visit& visit) {
  if (motion.pieces.empty()) return visit(MotionPiece{});
  for (const MotionPiece& given : motion.pieces) {
    const bool last = &given == &motion.pieces.back();
    if (given.until <= start && !last) continue;
    MotionPiece piece = without_last_zeros(given);
    const bool ends = last || given.until >= end;
    if (ends) piece.until = std::numeric_limits<double>::infinity();
    visit(std::move(piece));
    if (ends) break;
  }
}

}  // namespace

std::vector<MotionPiece> given_pieces_between(const Motion& motion, double start, double end) {
  std::vector<MotionPiece> out;
  for_each_given_between(motion, start, end, [&](MotionPiece&& piece) { out.push_back(std::move(piece)); });
  return out;
}

void for_each_piece_between(const Motion& motion, double start, double end,
                            const std::function<void(MotionPiece&&)>& visit) {
  double from = start;
  for_each_given_between(motion, start, end, [&](MotionPiece&& piece) {
    const double until = piece.until;
    if (std::holds_alternative<CosineRotation>(piece.rotation)) {
      for (MotionPiece& part : cut_at_extremes(piece, from, std::min(until, end))) visit(std::move(part));
    } else {
      visit(std::move(piece));
    }
    from = until;
  });
}

std::vector<MotionPiece> pieces_between(const Motion& motion, double start, double end) {
  std::vector<MotionPiece> out;
  for_each_piece_between(motion, start, end, [&](MotionPiece&& piece) { out.push_back(std::move(piece)); });
  return out;
}

const MotionPiece& piece_at(const std::vector<MotionPiece>& pieces, double t) {
  for (const MotionPiece& piece : pieces) {
    if (t < piece.until) return piece;
  }
  return pieces.back();
}

bool varies(const MotionPiece& piece) {
  return piece.x.size() > 1 || piece.y.size() > 1 || piece.orbit.angle.size() > 1 || varies(piece.rotation);
}

MotionPiece scaled(MotionPiece piece, int exponent) {
  for (double& c : piece.x) c = std::ldexp(c, exponent);
  for (double& c : piece.y) c = std::ldexp(c, exponent);
  for (Point* p : {&piece.pivot, &piece.orbit.centre}) *p = {std::ldexp(p->x, exponent), std::ldexp(p->y, exponent)};
  if (auto* follower = std::get_if<JointFollower>(&piece.rotation)) follower->exponent += exponent;
  return piece;
}

bool same_motion(const MotionPiece& a, const MotionPiece& b) {
  return a.x == b.x && a.y == b.y && (a.origin == b.origin || !varies(a)) && same_rotation(a.rotation, b.rotation) &&
         pivot_of(a) == pivot_of(b) && a.orbit.angle == b.orbit.angle &&
         (!orbits(a) || a.orbit.centre == b.orbit.centre);
}

double joint_gap(const MotionPiece& before, const MotionPiece& after, const AxisBox& polygon, double t) {
  const Pose<double> a = sharp_pose(before, t), b = sharp_pose(after, t);
  const double ox = b.ox.v.mid - a.ox.v.mid, oy = b.oy.v.mid - a.oy.v.mid;
  const double xx = b.xx.v.mid - a.xx.v.mid, xy = b.xy.v.mid - a.xy.v.mid;
  double gap = 0;
  for (const double x : {polygon.lo_x, polygon.hi_x}) {
    for (const double y : {polygon.lo_y, polygon.hi_y})
      gap = std::max(gap, length(ox + xx * x - xy * y, oy + xy * x + xx * y));
  }
  return gap;
}

namespace {

/// The sum of the terms' magnitudes: by so many units in the last place does rounding them change the value, at most.
double magnitude_of(const Coefficients& c, double t) {
  double sum = 0;
  for (std::size_t k = c.size(); k-- > 0;) sum = sum * std::fabs(t) + std::fabs(c[k]);
  return sum;
}

/// Of all that is added up to where a piece puts a corner of the polygon's bounds.
double magnitude_of(const MotionPiece& piece, const AxisBox& polygon, double t) {
  const Point c = pivot_of(piece);
  const double turned = std::max(std::fabs(polygon.lo_x), std::fabs(polygon.hi_x)) +
                        std::max(std::fabs(polygon.lo_y), std::fabs(polygon.hi_y)) + std::fabs(c.x) + std::fabs(c.y);
  t -= piece.origin;
  const auto* angle = std::get_if<AngleRotation>(&piece.rotation);
  const double turn = angle ? magnitude_of(angle->angle, t) : 0;
  const double moved = magnitude_of(piece.x, t) + magnitude_of(piece.y, t);
  if (!orbits(piece)) return moved + turned * (1 + turn);
  const Point& centre = piece.orbit.centre;
  const double radius = moved + turned + std::fabs(centre.x) + std::fabs(centre.y);
  return turned * (1 + turn) + radius * (2 + magnitude_of(piece.orbit.angle, t));
}

}  // namespace

double joint_room(const MotionPiece& before, const MotionPiece& after, const AxisBox& polygon, double t,
                  double extent) {
  return joint_tolerance * extent +
         joint_rounding * (magnitude_of(before, polygon, t) + magnitude_of(after, polygon, t));
}

namespace {

std::string number(double x) { return fmt::format("{:.17g}", x); }

class PieceCheck {
 public:
  /// Without times of a piece that is past: what a rotation is then does not matter.
  PieceCheck(const MotionPiece& piece, std::string place, std::optional<std::pair<double, double>> times = {})
      : piece_(piece), place_(std::move(place)), times_(times) {}

  void run() const {
    coefficients("x", piece_.x);
    coefficients("y", piece_.y);
    usable(piece_.origin, [] { return std::string("origin"); });
    coefficients("pivot", std::array{piece_.pivot.x, piece_.pivot.y});
    coefficients("orbit.angle", piece_.orbit.angle);
    coefficients("orbit.centre", std::array{piece_.orbit.centre.x, piece_.orbit.centre.y});
    std::visit([this](const auto& form) { rotation(form); }, piece_.rotation);
  }

 private:
  template <class Name>
  void usable(double x, const Name& name) const {
    if (x == 0 || (std::fabs(x) <= 0x1p400 && std::fabs(x) >= 0x1p-400)) return;
    if (!std::isfinite(x)) throw InputError(place_, name() + " is not a finite number", "write finite numbers");
    throw InputError(
        place_,
        name() + " = " + number(x) + " is outside the range of magnitudes that taut computes with, 2^-400 to 2^400",
        "choose other units");
  }

  void coefficients(const std::string& what, std::span<const double> c) const {
    for (std::size_t i = 0; i < c.size(); ++i) usable(c[i], [&] { return what + "[" + std::to_string(i) + "]"; });
    if (c.size() > max_degree + 1)
      throw InputError(place_, what + " has degree " + std::to_string(c.size() - 1),
                       "the highest degree supported is " + std::to_string(max_degree));
  }

  template <class Form>
  void rotation(const Form& form) const {
    const auto& polynomials = FormOf<Form>::polynomials;
    for (const auto& polynomial : polynomials) {
      const std::string key = std::string("rotation.") + FormOf<Form>::key;
      coefficients(polynomials.size() == 1 ? key : key + "." + polynomial.name, form.*polynomial.coefficients);
    }
    if (!times_) return;
    // A search that did not come to an end has shown nothing, and nothing is accepted on its account.
    std::optional<RotationFault> fault;
    try {
      fault = FormOf<Form>::fault(form, piece_.origin, times_->first, times_->second);
    } catch (const SearchExhausted&) {
      throw InputError(place_, "the rotation is too intricate to decide whether it is well defined",
                       "divide the motion into pieces, or lower the degree");
    }
    if (fault) throw InputError(place_, fault->problem, fault->remedy);
  }

  const MotionPiece& piece_;
  std::string place_;
  std::optional<std::pair<double, double>> times_;
};

}  // namespace

void validate_motion(const Motion& motion, const std::string& body, const AxisBox& polygon, double start, double end,
                     double extent) {
  const std::size_t n = motion.pieces.size();
  const auto place = [&](std::size_t i) {
    return body + ": motion" + (n > 1 ? " piece " + std::to_string(i) : std::string());
  };
  double from = start;
  for (std::size_t i = 0; i < n; ++i) {
    checkpoint();
    const MotionPiece& piece = motion.pieces[i];
    if (std::isnan(piece.until)) throw InputError(place(i), "`until` is not a number");
    if (i > 0 && piece.until <= motion.pieces[i - 1].until)
      throw InputError(place(i),
                       "`until` " + number(piece.until) + " does not come after that of the piece before, " +
                           number(motion.pieces[i - 1].until),
                       "pieces are in order of time");
    const bool last = i + 1 == n;
    if (last && piece.until < end)
      throw InputError(place(i),
                       "the motion ends at " + number(piece.until) + ", before the scene does, at " + number(end),
                       "leave out `until` in the last piece, or add a piece");
    if (piece.until <= start && !last) {
      PieceCheck(piece, place(i)).run();
      continue;
    }
    // What comes after the scene's end does not matter; a piece that begins there does.
    if (i > 0 && motion.pieces[i - 1].until > end) break;
    const double to = std::min(piece.until, end);
    PieceCheck(piece, place(i), std::pair{from, to}).run();
    if (!last && piece.until < end) {
      const double gap = joint_gap(piece, motion.pieces[i + 1], polygon, piece.until);
      const double room = joint_room(piece, motion.pieces[i + 1], polygon, piece.until, extent);
      if (!(gap <= room))
        throw InputError(
            place(i),
            "the motion jumps by " + number(gap) + " at t = " + number(piece.until) +
                ", where the next piece takes over",
            "pieces must join up to rounding (" + number(room) +
                " here): coefficients are in powers of t, or of t - origin where the piece has an \"origin\"");
    }
    from = to;
  }
}

}  // namespace taut::internal
