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

/// Values with their rates over a ball of times.
using Rate = Series<double, 1>;

/// A bound, above or below, of the angle in degrees, at most 90, whose sine has this square.
double angle_of_square(double square, bool above) {
  double lo = 0, hi = 90;
  for (int k = 0; k < 80; ++k) {
    const double middle = lo + (hi - lo) / 2;
    if (!(lo < middle && middle < hi)) break;
    Series<double, 0> s, c;
    sin_cos_degrees(Series<double, 0>::constant(middle), s, c);
    const int sign = (s.c[0] * s.c[0] - Ball<double>::exact(square)).sign();
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
      const Ball<double> t = Ball<double>::between(a, b);
      const Rate over = function_(piece, t);
      const Ball<double> slope = over.terms > 1 ? over.c[1] : Ball<double>::exact(0);
      // The ends have been sampled.
      if (slope.sign() != 0) continue;
      const double middle = a + (b - a) / 2;
      const Ball<double> there = function_(piece, Ball<double>::exact(middle)).c[0];
      const double least = std::max(over.c[0].lower(), (there + slope * Ball<double>(0, (b - a) / 2)).lower());
      // Shorter times do not make values more certain than those at an instant.
      const bool settled = least >= found_.hi - std::max(tolerance_, 8 * there.rad);
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

  /// The sine of the angle between the two links, squared, is monotone in the transmission angle.
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
    const Ball<double> cross = a[0] * b[1] - a[1] * b[0], along = a[0] * b[0] + a[1] * b[1];
    const Ball<double> lengths = (a[0] * a[0] + a[1] * a[1]) * (b[0] * b[0] + b[1] * b[1]);
    const Function sine = [&](std::size_t piece, const Ball<double>& t) {
      Rate s, c;
      sin_cos_degrees(joint_value<Rate>(functions_, equations().joints.size() + k, piece, t), s, c);
      const Rate height = c * cross + s * along;
      return height * height * (Ball<double>::exact(1) / lengths);
    };
    const auto in_degrees = [](const Extreme& square) {
      return Extreme{angle_of_square(square.lo, false), angle_of_square(square.hi, true), square.t};
    };
    const MechanismJoint& joint = joints()[static_cast<std::size_t>(assembly_.tree.closures[k])];
    return TransmissionAngle{
        joint.name, {joint.first, joint.second}, in_degrees(least(sine, 1)), in_degrees(greatest(sine, 1))};
  }

  std::vector<std::array<double, 2>> values_at(double t) const {
    const std::size_t piece = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(std::upper_bound(borders_.begin(), borders_.end(), t) - borders_.begin() - 1, 0,
                                   static_cast<std::ptrdiff_t>(functions_.pieces()) - 1));
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
