// Models of the frame on legs on which bodies turn evenly, in closed form.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "relative/frame_model.hpp"
#include "relative/frame_sample.hpp"

namespace taut {

/// With frames as complex numbers the functions are e^(i a(t)), or that times D(t), where the angle a is linear in t.
/// About an instant m, e^(i a(m + h)) is e^(i a(m)) times the series of e^(i r h), r being the rate: which is the same
/// at all instants, up to a turn by a(m). So is what a polynomial in h leaves out. A model then takes one sine and one
/// cosine for each angle, while bounds are those of the last model of that length; nothing is composed. And the angle
/// is reduced as an exact sum, so that after 10^5 turns it is as good as in the first one, which an angle in a double
/// is not.
class EvenTurn {
 public:
  /// Null if the leg is another one.
  static std::shared_ptr<const EvenTurn> of(const Leg& leg);
  /// Of the part [start, end] of that leg. Nothing where an angle is too large.
  std::optional<FrameModel> model(const Leg& leg, double start, double end) const;
  /// Are bounds of the third derivatives the same over every part?
  bool is_steady() const { return constant_way_.has_value(); }
  /// Bounds of the third derivatives over a part.
  FrameThird third(const Leg& leg, bool pp, double start, double end) const;

 private:
  /// sign (c0 + c1 t), each coefficient a sum of two doubles.
  struct Angle {
    double sign = 1, c0 = 0, c0_low = 0, c1 = 0, c1_low = 0;
    /// Of e^(i a(m)): cosine and sine. False where the angle is too large.
    bool at(double m, double& re, double& im) const;
  };
  static constexpr int last = model_degree;  ///< the power that models leave out
  /// A turn, and (i r)^k / k! but for powers of i. That of a body which does not turn has no angle.
  struct Spin {
    std::optional<Angle> angle;
    std::array<double, last + 1> u{1};
    void set(const Angle& a);
  };
  /// D about an instant.
  struct Way {
    int terms = 1;
    std::array<double, last + 1> x{}, y{}, size{}, error{};  ///< bounds of |(x, y)|, and of what is missing
  };
  /// What is the same for all models of a radius and with ways of such sizes: all but the coefficients.
  struct Bounds {
    double radius = -1;
    Way way;
    FrameModel model;
  };

  bool take(const Leg& leg);
  Way way_about(const Leg& leg, double m) const;
  const Bounds& bounds_for(double radius, Way way) const;
  void bound(const Spin& spin, const Way& way, int i, FrameModel& model) const;
  static bool turn(const Spin& spin, const Way& way, double m, int i, FrameModel& out);

  Spin to_p_, to_q_, relative_;  ///< of conj(x_P) and conj(x_Q), and of conj(x_P) x_Q
  bool aligned_ = false;
  std::optional<Way> constant_way_;
  mutable std::array<Bounds, 6> kept_;  ///< those used last
  mutable std::size_t next_ = 0;
};

}  // namespace taut
