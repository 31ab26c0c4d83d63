// A mechanism as a linkage: its links are functions of the driven joints' values, of one or of several that move a loop
// together.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "motion/loop_region.hpp"
#include "scene/linkage.hpp"
#include "scene/mechanism.hpp"
#include "taut/error.hpp"

namespace taut::internal {

bool is_joint_of(const Mechanism& mechanism, const std::string& name) {
  return std::any_of(mechanism.joints.begin(), mechanism.joints.end(),
                     [&](const MechanismJoint& joint) { return joint.name == name && !joint.shared; });
}

namespace {

/// Which drives move which joints. A loop depends on the joints between the two links that it closes, up to what these
/// have in common: all unknowns and drives there hang together.
class DrivesOfJoints {
 public:
  explicit DrivesOfJoints(const LoopEquations& equations)
      : equations_(equations), up_(static_cast<std::size_t>(equations.unknowns) + equations.drives.size()) {
    std::iota(up_.begin(), up_.end(), 0U);
    for (const LoopEquations::Closure& closure : equations.closures) {
      std::vector<std::size_t> together;
      for (const int joint : joints_between(closure.first, closure.second))
        add_terms(equations.joints[static_cast<std::size_t>(joint)].value, together);
      if (closure.value) add_terms(*closure.value, together);
      for (const std::size_t other : together) up_[root(other)] = root(together.front());
    }
  }

  std::set<std::size_t> of(std::size_t joint) const {
    std::vector<std::size_t> terms;
    add_terms(equations_.joints[joint].value, terms);
    std::set<std::size_t> drives;
    for (const std::size_t term : terms) {
      for (std::size_t k = 0; k < equations_.drives.size(); ++k) {
        if (root(of_drive(k)) == root(term)) drives.insert(k);
      }
    }
    return drives;
  }

 private:
  std::size_t of_drive(std::size_t k) const { return static_cast<std::size_t>(equations_.unknowns) + k; }
  std::size_t root(std::size_t i) const {
    while (up_[i] != i) i = up_[i];
    return i;
  }
  void add_terms(const LinearForm& form, std::vector<std::size_t>& to) const {
    for (const LinearForm::Term& term : form.unknowns) to.push_back(static_cast<std::size_t>(term.of));
    for (const LinearForm::Term& term : form.drives) to.push_back(of_drive(static_cast<std::size_t>(term.of)));
  }
  std::set<int> joints_between(int first, int second) const {
    std::set<int> between;
    for_each_joint_on_path(equations_, first, [&](int joint) { between.insert(joint); });
    for_each_joint_on_path(equations_, second, [&](int joint) {
      if (!between.insert(joint).second) between.erase(joint);
    });
    return between;
  }

  const LoopEquations& equations_;
  std::vector<std::size_t> up_;
};

const char* const range_hint = R"(write "drive": {"A": [0, 90]}, in degrees or lengths)";
const char* const reach_hint = "give it a range that does not reach the lock; the drawn pose is at 0";

class DrivenLinkage {
 public:
  explicit DrivenLinkage(Linkage linkage) : linkage_(std::move(linkage)) {
    linkage_.motions.resize(linkage_.scene.bodies.size());
    for (std::size_t k = 0; k < linkage_.joints.size(); ++k) {
      if (is_joint_of(*linkage_.scene.mechanism, linkage_.joints[k].name)) driven_.push_back(k);
    }
  }

  Linkage run() {
    if (driven_.empty()) throw InputError("mechanism: drive", "no joint is driven", range_hint);
    require_free_bodies();
    // What is wrong with the drawing itself is no matter of any range.
    const Scene drawn = assembled(held_scene());
    const AssembledMechanism& mechanism = *drawn.assembly;
    const DrivesOfJoints drives(mechanism.functions->equations());
    // By the drives that move something together. What no drive moves rests, whatever the first one does.
    std::map<std::set<std::size_t>, Moved> moved;
    std::vector<std::set<std::size_t>> of_link;
    for (std::size_t k = 0; k < mechanism.tree.links.size(); ++k) {
      of_link.push_back(drives.of(k));
      if (of_link.back().empty()) of_link.back() = {0};
      moved.try_emplace(of_link.back());
    }
    for (auto& [together, loops] : moved) {
      loops = moved_by(together, drawn);
      linkage_.loops.push_back(
          {static_cast<int>(driven_[*together.begin()]), loops.region ? nullptr : loops.scene.assembly, loops.region});
    }
    for (std::size_t k = 0; k < mechanism.tree.links.size(); ++k) {
      const auto body = static_cast<std::size_t>(mechanism.tree.links[k].body);
      const Moved& loops = moved.at(of_link[k]);
      const Body& link = loops.scene.bodies[body];
      const MotionPiece& piece = link.motion.pieces.front();
      linkage_.scene.bodies[body].relative_to = link.relative_to;
      linkage_.motions[body] =
          JointMotion{LinkMotion{std::get<JointFollower>(piece.rotation), piece.pivot, loops.region},
                      static_cast<int>(driven_[*of_link[k].begin()])};
    }
    return std::move(linkage_);
  }

 private:
  const Joint& joint(std::size_t k) const { return linkage_.joints[k]; }

  void require_free_bodies() const {
    const Mechanism& mechanism = *linkage_.scene.mechanism;
    for (std::size_t i = 0; i < linkage_.scene.bodies.size(); ++i) {
      const std::string& name = linkage_.scene.bodies[i].name;
      const bool joined = name == mechanism.ground ||
                          std::any_of(mechanism.joints.begin(), mechanism.joints.end(),
                                      [&](const MechanismJoint& m) { return m.first == name || m.second == name; });
      if (joined && linkage_.motions[i])
        throw InputError("bodies[" + std::to_string(i) + "].motion",
                         "\"" + name + "\" is a body of the mechanism, and has a motion of its own",
                         "leave its motion out: its joints say how it moves");
    }
  }

  /// All drives are held as drawn.
  Scene held_scene() const {
    Scene scene = linkage_.scene;
    scene.start = 0;
    scene.end = 1;
    scene.mechanism->drives.clear();
    for (const std::size_t k : driven_) {
      scene.mechanism->drives.push_back({joint(k).name, {{}}});
      scene.mechanism->drives.back().pieces.front().polynomial = {0};
    }
    return scene;
  }

  /// How some drives move their loops.
  struct Moved {
    Scene scene;  ///< of one drive: with its value as the time; else as drawn
    std::shared_ptr<const LoopRegion> region = nullptr;
  };
  Moved moved_by(const std::set<std::size_t>& together, const Scene& drawn) const {
    if (together.size() == 1) return {moved_alone(*together.begin())};
    std::vector<LoopRegion::Range> ranges;
    for (const std::size_t drive : together) {
      const Joint& moved = joint(driven_[drive]);
      require_range(moved);
      ranges.push_back({static_cast<int>(driven_[drive]), static_cast<int>(drive), moved.lo, moved.hi});
    }
    return {drawn, std::make_shared<const LoopRegion>(drawn.assembly->functions->equations(), std::move(ranges))};
  }

  static void require_range(const Joint& moved) {
    if (!std::isfinite(moved.lo) || !std::isfinite(moved.hi) || moved.hi < moved.lo)
      throw InputError("mechanism: drive " + moved.name, "its range does not go from a number to one that is no less",
                       range_hint);
  }

  /// One joint goes through its range, with its value as the time.
  Scene moved_alone(std::size_t drive) const {
    const Joint& moved = joint(driven_[drive]);
    require_range(moved);
    Scene scene = held_scene();
    scene.start = moved.lo;
    // A range of one value is for a joint that is held.
    scene.end = moved.hi > moved.lo ? moved.hi : moved.lo + 0x1p-20 * std::max(1.0, std::fabs(moved.lo));
    scene.mechanism->drives[drive].pieces.front().polynomial = {0, 1};
    try {
      scene = assembled(std::move(scene));
    } catch (const InputError& error) {
      throw InputError("mechanism: drive " + moved.name, error.problem(), reach_hint);
    }
    // At the other end of the range, it would lock on the way from the drawn pose to there.
    if (scene.lock && scene.lock->time[0] <= moved.hi) refuse_lock(moved, *scene.lock);
    return scene;
  }

  [[noreturn]] static void refuse_lock(const Joint& joint, const MechanismLock& lock) {
    std::string links;
    for (const std::string& link : lock.links) links += (links.empty() ? "" : ", ") + link;
    throw InputError("mechanism: drive " + joint.name,
                     fmt::format("the mechanism locks within its range [{}, {}], between {} and {} ({}; {})", joint.lo,
                                 joint.hi, lock.time[0], lock.time[1], to_string(lock.kind), links),
                     reach_hint);
  }

  Linkage linkage_;
  std::vector<std::size_t> driven_;  ///< their positions in `joints`
};

}  // namespace
}  // namespace taut::internal

namespace taut {

Linkage assembled(Linkage linkage) {
  const auto is_link = [](const auto& motion) { return motion && std::holds_alternative<LinkMotion>(motion->kind); };
  if (!linkage.scene.mechanism || std::any_of(linkage.motions.begin(), linkage.motions.end(), is_link)) return linkage;
  return internal::DrivenLinkage(std::move(linkage)).run();
}

}  // namespace taut
