// Functions of time near the middle of a window: a polynomial, and how far from it the function may be. The checker
// that is proved has the same in exact numbers (formal/Models.v); here, in doubles, they foretell what it accepts.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "numeric/real.hpp"
#include "taut/motion.hpp"

namespace taut::internal {

/// Of h, the time since the window's middle, for |h| up to the radius of a LocalModels.
struct LocalModel {
  static constexpr std::size_t terms = 8;
  std::array<double, terms> c{};  ///< in ascending powers
  double slack = 0;               ///< not negative

  static LocalModel constant(double value) {
    LocalModel m;
    m.c[0] = value;
    return m;
  }
};

LocalModel operator+(const LocalModel& a, const LocalModel& b);
LocalModel operator-(const LocalModel& a, const LocalModel& b);
LocalModel operator*(double factor, const LocalModel& a);

struct CosineAndSine {
  LocalModel cosine, sine;
};

/// What can be done with models in a window of this radius. Bounds are those of the checker, which are not the
/// tightest ones; rounding is not accounted for.
class LocalModels {
 public:
  explicit LocalModels(double radius) : radius_(radius) {}

  double radius() const { return radius_; }
  /// A bound of the polynomial's magnitude, and one of the function's.
  double norm(const LocalModel& m) const;
  double bound(const LocalModel& m) const { return norm(m) + m.slack; }
  /// A lower bound of the function.
  double lower(const LocalModel& m) const;
  LocalModel product(const LocalModel& a, const LocalModel& b) const;
  /// Of a polynomial in (offset + h). Late in time, its terms are far larger than their sum.
  LocalModel shifted(const Coefficients& polynomial, const RealMax& offset) const;
  /// Nothing where the window is too long for a model.
  std::optional<CosineAndSine> cos_sin(const LocalModel& angle) const;
  /// Of (cos, sin) as a rotation says, whose polynomials are in (offset + h).
  std::optional<CosineAndSine> rotation(const Rotation& rotation, const RealMax& offset) const;

 private:
  LocalModel one_less(const LocalModel& square, double divisor, const LocalModel& rest) const;
  /// Of functions that are at least 1.
  LocalModel reciprocal(const LocalModel& m) const;
  std::optional<LocalModel> reciprocal_root(const LocalModel& m) const;
  /// Of functions that are not negative.
  LocalModel root(const LocalModel& m) const;
  LocalModel clamped(const LocalModel& m) const;

  double radius_;
};

}  // namespace taut::internal
