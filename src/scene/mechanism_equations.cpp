// The equations of a mechanism from its joints, drives and couplings.
#include <algorithm>
#include <map>
#include <set>

#include "scene/mechanism.hpp"
#include "taut/error.hpp"

namespace taut::internal {
namespace {

class EquationBuilder {
 public:
  EquationBuilder(const Scene& scene, const JointTree& tree)
      : scene_(scene), mechanism_(*scene.mechanism), tree_(tree) {
    for (std::size_t k = 0; k < mechanism_.joints.size(); ++k) {
      if (!mechanism_.joints[k].shared) joints_.emplace(mechanism_.joints[k].name, static_cast<int>(k));
      if (mechanism_.joints[k].shared) shared_.insert({mechanism_.joints[k].name, static_cast<int>(k)});
    }
    for (std::size_t i = 0; i < mechanism_.drives.size(); ++i) {
      const int joint = joint_named(mechanism_.drives[i].joint, "mechanism: drive");
      if (!drives_.emplace(joint, static_cast<int>(i)).second)
        throw InputError(joint_place(at(joint)), "it is driven twice", "drive it once");
    }
    for (std::size_t i = 0; i < mechanism_.couplings.size(); ++i) add_coupling(static_cast<int>(i));
  }

  TimedEquations build() {
    TimedEquations out;
    LoopEquations& equations = out.equations;
    for (const JointTree::Link& link : tree_.links) {
      const MechanismJoint& joint = at(link.joint);
      equations.joints.push_back({link.parent, joint.kind == MechanismJoint::Kind::slide, place_of(joint),
                                  joint.direction, link.reversed ? -1.0 : 1.0, value_of(link.joint, 0)});
    }
    for (const int k : tree_.closures) {
      const MechanismJoint& joint = at(k);
      LoopEquations::Closure closure{link_named(joint.first),
                                     link_named(joint.second),
                                     joint.kind == MechanismJoint::Kind::slide,
                                     place_of(joint),
                                     joint.at,
                                     joint.direction,
                                     {}};
      if (drives_.count(k) || couplings_.count(k) || is_source(joint.name)) closure.value = value_of(k, 0);
      equations.closures.push_back(std::move(closure));
    }
    equations.implied = links_on_one_pin();
    equations.unknowns = unknowns_;
    out.ends = ends();
    for (const Drive& drive : mechanism_.drives) equations.drives.push_back(in_pieces(drive, out.ends));
    return out;
  }

 private:
  /// Slides have no place: they are at the origin.
  LocalPoint place_of(const MechanismJoint& joint) const {
    const auto first =
        std::find_if(mechanism_.joints.begin(), mechanism_.joints.end(),
                     [](const MechanismJoint& other) { return other.kind == MechanismJoint::Kind::revolute; });
    return joint.kind == MechanismJoint::Kind::slide ? LocalPoint{} : LocalPoint(joint.at, first->at);
  }

  const MechanismJoint& at(int joint) const { return mechanism_.joints[static_cast<std::size_t>(joint)]; }

  int joint_named(const std::string& name, const std::string& place) const {
    const auto found = joints_.find(name);
    if (found != joints_.end()) return found->second;
    if (shared_.count(name))
      throw InputError(place, "joint \"" + name + "\" joins several bodies, and each of them has a value of its own",
                       "write a joint for each two bodies");
    throw InputError(place, "there is no joint \"" + name + "\"", "name one of the mechanism's joints");
  }

  void add_coupling(int i) {
    const Coupling& coupling = mechanism_.couplings[static_cast<std::size_t>(i)];
    const int joint = joint_named(coupling.joint, "mechanism: couple");
    joint_named(coupling.to, "mechanism: couple");
    if (drives_.count(joint))
      throw InputError(joint_place(at(joint)), "it is driven and coupled to \"" + coupling.to + "\"",
                       "a joint has one value: leave out one of the two");
    if (!couplings_.emplace(joint, i).second)
      throw InputError(joint_place(at(joint)), "it is coupled twice", "couple it to one joint");
  }

  bool is_source(const std::string& name) const {
    return std::any_of(mechanism_.couplings.begin(), mechanism_.couplings.end(),
                       [&](const Coupling& coupling) { return coupling.to == name; });
  }

  LinearForm value_of(int joint, int depth) {
    if (const auto drive = drives_.find(joint); drive != drives_.end()) return LinearForm::drive(drive->second);
    if (const auto found = couplings_.find(joint); found != couplings_.end()) {
      const Coupling& coupling = mechanism_.couplings[static_cast<std::size_t>(found->second)];
      if (depth > static_cast<int>(couplings_.size()))
        throw InputError(joint_place(at(joint)), "it is coupled to itself, through others",
                         "couplings must end at a joint that is not coupled");
      return value_of(joint_named(coupling.to, "mechanism: couple"), depth + 1).times(Dyadic::exact(coupling.times));
    }
    const auto [known, fresh] = unknown_of_.emplace(joint, unknowns_);
    unknowns_ += fresh;
    return LinearForm::unknown(known->second);
  }

  /// Each two bodies on one pin turn about it, whether a joint joins them or others between them.
  std::vector<LoopEquations::Closure> links_on_one_pin() const {
    std::map<std::pair<double, double>, std::vector<std::set<std::string>>> pins;
    for (const MechanismJoint& joint : mechanism_.joints) {
      if (joint.kind == MechanismJoint::Kind::slide) continue;
      // Groups of bodies that hang together there.
      std::vector<std::set<std::string>>& groups = pins[{joint.at.x, joint.at.y}];
      std::set<std::string> joined{joint.first, joint.second};
      const auto apart = std::partition(groups.begin(), groups.end(), [&](const std::set<std::string>& group) {
        return !group.count(joint.first) && !group.count(joint.second);
      });
      for (auto group = apart; group != groups.end(); ++group) joined.merge(*group);
      groups.erase(apart, groups.end());
      groups.push_back(std::move(joined));
    }
    std::vector<LoopEquations::Closure> out;
    for (const auto& [at, groups] : pins) {
      for (const std::set<std::string>& group : groups) {
        if (group.size() == 2) continue;
        for (auto a = group.begin(); a != group.end(); ++a) {
          for (auto b = std::next(a); b != group.end(); ++b)
            out.push_back({link_named(*a), link_named(*b), false, {}, {at.first, at.second}, {}, {}});
        }
      }
    }
    return out;
  }

  int link_named(const std::string& body) const {
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      if (scene_.bodies[i].name == body) return tree_.link_of_body[i];
    }
    return -1;
  }

  /// Where a piece of some drive ends, within the time; and the end of the time.
  std::vector<double> ends() const {
    std::vector<double> ends{scene_.end};
    for (const Drive& drive : mechanism_.drives) {
      for (const Drive::Piece& piece : drive.pieces) {
        if (piece.until > scene_.start && piece.until < scene_.end) ends.push_back(piece.until);
      }
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    return ends;
  }

  Drive in_pieces(const Drive& drive, const std::vector<double>& ends) const {
    if (drive.pieces.empty())
      throw InputError("mechanism: drive " + drive.joint, "it has no values", "write from where to where");
    Drive out{drive.joint, {}};
    for (const double end : ends) {
      const auto found = std::find_if(drive.pieces.begin(), drive.pieces.end(),
                                      [end](const Drive::Piece& piece) { return end <= piece.until; });
      out.pieces.push_back(found == drive.pieces.end() ? drive.pieces.back() : *found);
      out.pieces.back().until = end;
    }
    return out;
  }

  const Scene& scene_;
  const Mechanism& mechanism_;
  const JointTree& tree_;
  std::map<std::string, int> joints_, shared_;
  std::map<int, int> drives_, couplings_;  ///< by joint
  std::map<int, int> unknown_of_;
  int unknowns_ = 0;
};

}  // namespace

TimedEquations loop_equations(const Scene& scene, const JointTree& tree) {
  return EquationBuilder(scene, tree).build();
}

}  // namespace taut::internal
