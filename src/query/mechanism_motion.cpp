#include "taut/mechanism_motion.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "motion/degrees.hpp"
#include "motion/joint_value.hpp"
#include "numeric/budget.hpp"
#include "scene/mechanism.hpp"
#include "scene/mechanism_lock.hpp"
#include "taut/error.hpp"

namespace taut::internal {
namespace {

/// Values over a ball of times, with coefficients of their Taylor series.
using Rate = Series<double, 3>;

/// A bound, above or below, of the angle in degrees, from 0 to 90, with this sine.
double angle_of_sine(double sine, bool above) {
  if (above && sine >= 1) return 90;
  if (!above && sine <= 0) return 0;
  double lo = 0, hi = 90;
  for (int k = 0; k < 80; ++k) {
    const double middle = lo + (hi - lo) / 2;
    if (!(lo < middle && middle < hi)) break;
    Series<double, 0> s, c;
    sin_cos_degrees(Series<double, 0>::constant(middle), s, c);
    const int sign = (s.c[0] - Ball<double>::exact(sine)).sign();
    // What is not certain is not left out.
    (sign < 0 || (sign == 0 && above) ? lo : hi) = middle;
  }
  return above ? hi : lo;
}

/// A function of time on one piece of the drives.
using Function = std::function<Rate(std::size_t piece, const Ball<double>& t)>;

/// The least value of a function on the time of all pieces.
class LeastValue {
 public:
  LeastValue(Function function, const std::vector<double>& borders, double tolerance)
      : function_(std::move(function)), borders_(borders), tolerance_(tolerance) {}

  Extreme find() {
    for (std::size_t k = 0; k + 1 < borders_.size(); ++k) {
      sample(k, borders_[k]);
      sample(k, borders_[k + 1]);
    }
    for (std::size_t k = 0; k + 1 < borders_.size(); ++k) search(k, borders_[k], borders_[k + 1]);
    found_.lo = std::min(lowest_, found_.hi);
    return found_;
  }

 private:
  void sample(std::size_t piece, double t) {
    const Ball<double> value = function_(piece, Ball<double>::exact(t)).c[0];
    if (value.upper() < found_.hi) {
      found_.hi = value.upper();
      found_.t = t;
    }
    lowest_ = std::min(lowest_, value.lower());
  }

  /// Halves the time until the function rises or falls, or cannot be less by more than the tolerance.
  void search(std::size_t piece, double from, double to) {
    std::vector<std::array<double, 2>> open{{from, to}};
    while (!open.empty()) {
      checkpoint();
      const auto [a, b] = open.back();
      open.pop_back();
      const Rate over = function_(piece, Ball<double>::between(a, b));
      const double middle = a + (b - a) / 2;
      const Rate there = function_(piece, Ball<double>::exact(middle));
      // Where values are differences of others, as angles are, the bounds over all of the time are wide, and those at
      // an instant are not: so to third order.
      const auto of = [](const Rate& f, int k) {
        return k < f.terms ? f.c[static_cast<std::size_t>(k)] : Ball<double>::exact(0);
      };
      const Ball<double> h(0, detail::inflate(std::max(b - middle, middle - a))), last = of(over, 3);
      const Ball<double> slope = of(there, 1) + h * (of(there, 2) * 2.0 + h * last * 3.0);
      // The ends have been sampled.
      if (of(over, 1).sign() != 0 || slope.sign() != 0) continue;
      const Ball<double> value = there.c[0] + h * (of(there, 1) + h * (of(there, 2) + h * last));
      const double least = std::max(over.c[0].lower(), value.lower());
      // Shorter times do not make values more certain than those at an instant.
      const bool settled = least >= found_.hi - std::max(tolerance_, 8 * there.c[0].rad);
      if (settled || !(a < middle && middle < b)) {
        lowest_ = std::min(lowest_, least);
        continue;
      }
      sample(piece, middle);
      open.push_back({middle, b});
      open.push_back({a, middle});
    }
  }

  Function function_;
  const std::vector<double>& borders_;
  double tolerance_;
  double lowest_ = INFINITY;
  Extreme found_{0, INFINITY, 0};
};

class MotionOfJoints {
 public:
  explicit MotionOfJoints(const Scene& scene)
      : scene_(scene), assembly_(*scene.assembly), functions_(*assembly_.functions), borders_{scene.start} {
    for (std::size_t k = 0; k < functions_.pieces(); ++k) {
      const double until = drives().empty() ? scene.end : drives()[0].pieces[k].until;
      borders_.push_back(k + 1 < functions_.pieces() ? until : scene.end);
    }
  }

  MechanismMotion run(const MechanismOptions& options) const {
    MechanismMotion out;
    out.mobility = assembly_.mobility.mobility;
    out.loops = assembly_.mobility.loops;
    out.lock = scene_.lock;
    for (std::size_t j = 0; j < joints().size(); ++j) out.joints.push_back(range_of(j));
    for (std::size_t k = 0; k < equations().closures.size(); ++k) {
      if (auto angle = transmission_of(k)) out.transmission.push_back(std::move(*angle));
    }
    for (std::size_t i = 0; i < options.instants; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(options.instants - 1);
      const double t = i + 1 == options.instants ? scene_.end : scene_.start + (scene_.end - scene_.start) * share;
      out.instants.push_back(t);
      out.values.push_back(values_at(t));
    }
    return out;
  }

 private:
  const LoopEquations& equations() const { return functions_.equations(); }
  const std::vector<Drive>& drives() const { return equations().drives; }
  const std::vector<MechanismJoint>& joints() const { return scene_.mechanism->joints; }

  /// A joint of the mechanism, in the tree or not.
  Rate value(std::size_t joint, std::size_t piece, const Ball<double>& t) const {
    const auto& links = assembly_.tree.links;
    for (std::size_t k = 0; k < links.size(); ++k) {
      if (links[k].joint == static_cast<int>(joint)) return joint_value<Rate>(functions_, k, piece, t);
    }
    const auto& closing = assembly_.tree.closures;
    const auto found = std::find(closing.begin(), closing.end(), static_cast<int>(joint));
    return joint_value<Rate>(functions_, links.size() + static_cast<std::size_t>(found - closing.begin()), piece, t);
  }

  Extreme least(const Function& function, double size) const {
    return LeastValue(function, borders_, 1e-9 * size).find();
  }
  Extreme greatest(const Function& function, double size) const {
    const Extreme low = least([&](std::size_t piece, const Ball<double>& t) { return -function(piece, t); }, size);
    return {-low.hi, -low.lo, low.t};
  }

  JointRange range_of(std::size_t j) const {
    const MechanismJoint& joint = joints()[j];
    JointRange out{joint.name, joint.first, joint.second, joint.kind == MechanismJoint::Kind::slide, {}, {}};
    const Function function = [&](std::size_t piece, const Ball<double>& t) { return value(j, piece, t); };
    double size = out.slides ? 0 : 1;
    for (std::size_t k = 0; k + 1 < borders_.size(); ++k) {
      // Also between the ends, where a slide may be back at 0.
      for (int i = 0; i <= 8; ++i) {
        const double t = i == 8 ? borders_[k + 1] : borders_[k] + (borders_[k + 1] - borders_[k]) * i / 8;
        size = std::max(size, value(j, k, Ball<double>::exact(t)).c[0].magnitude());
      }
    }
    out.least = least(function, size);
    out.greatest = greatest(function, size);
    return out;
  }

  /// The pin next to a closing pin on one side of its loop.
  std::optional<LocalPoint> next_pin(int link, int other) const {
    std::vector<int> path, others;
    for_each_joint_on_path(equations(), link, [&](int k) { path.push_back(k); });
    for_each_joint_on_path(equations(), other, [&](int k) { others.push_back(k); });
    if (path.empty() || std::find(others.begin(), others.end(), path[0]) != others.end()) return std::nullopt;
    const LoopEquations::TreeJoint& joint = equations().joints[static_cast<std::size_t>(path[0])];
    return joint.slide ? std::nullopt : std::optional(joint.at);
  }

  struct Magnitudes {
    Extreme least, greatest;
  };

  /// Of a function of time that is at most 1.
  Magnitudes magnitudes(const Function& function) const {
    const Extreme low = least(function, 1), high = greatest(function, 1);
    const Extreme below{-low.hi, -low.lo, low.t};  // of the function's negative
    const Extreme& more = below.hi > high.hi ? below : high;
    Magnitudes out{{}, {std::max({below.lo, high.lo, 0.0}), more.hi, more.t}};
    if (low.lo > 0) {
      out.least = low;
    } else if (high.hi < 0) {
      out.least = {-high.hi, -high.lo, high.t};
    } else if (low.hi < 0 && high.lo > 0) {
      out.least = {0, 0, zero_between(function, low.t, high.t)};
    } else {
      const Extreme& nearest = low.hi >= 0 ? low : high;
      out.least = {0, std::max(std::fabs(nearest.lo), std::fabs(nearest.hi)), nearest.t};
    }
    return out;
  }

  /// An instant near which a function is 0 that is negative at one time and positive at another.
  double zero_between(const Function& function, double negative, double positive) const {
    for (int k = 0; k < 60; ++k) {
      const double middle = negative + (positive - negative) / 2;
      if (middle == negative || middle == positive) break;
      (function(piece_at(middle), Ball<double>::exact(middle)).c[0].mid < 0 ? negative : positive) = middle;
    }
    return positive;
  }

  /// Both the sine and the cosine of the angle between the two links are bounded: near 0, or 90 degrees, one of them
  /// says far more than the other.
  std::optional<TransmissionAngle> transmission_of(std::size_t k) const {
    const LoopEquations::Closure& closure = equations().closures[k];
    const auto p = next_pin(closure.first, closure.second), q = next_pin(closure.second, closure.first);
    if (closure.slide || !p || !q || *p == closure.at || *q == closure.at) return std::nullopt;
    // Links are rigid: the angle is that of the drawing and what they have turned since, as seen from each other.
    const auto axis = [&](const LocalPoint& pin) {
      const auto [x, y] = pin.as<double>();
      const auto [from_x, from_y] = closure.at.as<double>();
      return std::array{x - from_x, y - from_y};
    };
    const auto a = axis(*p), b = axis(*q);
    const Ball<double> lengths = sqrt((a[0] * a[0] + a[1] * a[1]) * (b[0] * b[0] + b[1] * b[1]));
    const Ball<double> cross = (a[0] * b[1] - a[1] * b[0]) / lengths, along = (a[0] * b[0] + a[1] * b[1]) / lengths;
    const auto turned = [&](std::size_t piece, const Ball<double>& t, const Ball<double>& by_sine,
                            const Ball<double>& by_cosine) {
      Rate s, c;
      sin_cos_degrees(joint_value<Rate>(functions_, equations().joints.size() + k, piece, t), s, c);
      return c * by_cosine + s * by_sine;
    };
    const Magnitudes sine =
        magnitudes([&](std::size_t piece, const Ball<double>& t) { return turned(piece, t, along, cross); });
    const Magnitudes cosine =
        magnitudes([&](std::size_t piece, const Ball<double>& t) { return turned(piece, t, -cross, along); });
    const auto in_degrees = [](const Extreme& of_sine, const Extreme& of_cosine) {
      const double down = std::nextafter(90 - angle_of_sine(of_cosine.hi, true), 0);
      const double up = std::min(90.0, std::nextafter(90 - angle_of_sine(of_cosine.lo, false), INFINITY));
      const double lo = std::max(angle_of_sine(of_sine.lo, false), down);
      const double hi = std::min(angle_of_sine(of_sine.hi, true), up);
      return Extreme{lo, hi, lo < 45 ? of_sine.t : of_cosine.t};
    };
    const MechanismJoint& joint = joints()[static_cast<std::size_t>(assembly_.tree.closures[k])];
    return TransmissionAngle{joint.name,
                             {joint.first, joint.second},
                             in_degrees(sine.least, cosine.greatest),
                             in_degrees(sine.greatest, cosine.least)};
  }

  std::size_t piece_at(double t) const {
    return static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(std::upper_bound(borders_.begin(), borders_.end(), t) - borders_.begin() - 1, 0,
                                   static_cast<std::ptrdiff_t>(functions_.pieces()) - 1));
  }

  std::vector<std::array<double, 2>> values_at(double t) const {
    const std::size_t piece = piece_at(t);
    std::vector<std::array<double, 2>> row;
    for (std::size_t j = 0; j < joints().size(); ++j) {
      const Ball<double> v = value(j, piece, Ball<double>::exact(t)).c[0];
      row.push_back({v.lower(), v.upper()});
    }
    return row;
  }

  const Scene& scene_;
  const AssembledMechanism& assembly_;
  const JointFunctions& functions_;
  std::vector<double> borders_;  ///< of the drives' pieces
};

}  // namespace
}  // namespace taut::internal

namespace taut {
using namespace internal;

const char* to_string(MechanismMotion::Outcome outcome) {
  switch (outcome) {
    case MechanismMotion::Outcome::moves:
      return "moves";
    case MechanismMotion::Outcome::locked:
      return "locked";
    case MechanismMotion::Outcome::undecided:
      break;
  }
  return "undecided";
}

MechanismMotion mechanism_motion(const Scene& scene, const MechanismOptions& options) {
  if (!scene.mechanism)
    throw InputError("mechanism", "the scene has none", "write its joints: docs/mechanisms.md, or `taut schema`");
  if (!scene.assembly) return mechanism_motion(assembled(scene), options);
  if (options.instants == 1 || options.instants > 1000000)
    throw InputError("instants", "there are " + std::to_string(options.instants), "2 to 1000000 can be asked for");
  const Budget scope(options.limits);
  MechanismMotion answer;
  try {
    answer = MotionOfJoints(scene).run(options);
    answer.outcome = ends_at_lock(scene) ? MechanismMotion::Outcome::locked : MechanismMotion::Outcome::moves;
    taut::Outcome outcome = taut::Outcome::locked;
    note_undecided_lock(scene, outcome, answer.reason);
    if (outcome == taut::Outcome::undecided) answer.outcome = MechanismMotion::Outcome::undecided;
  } catch (const Interrupted& limit) {
    answer = {};
    answer.outcome = MechanismMotion::Outcome::undecided;
    answer.reason = limit.reason;
  }
  return answer;
}

}  // namespace taut
