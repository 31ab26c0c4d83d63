// A mechanism with the functions of time that its joints' values are.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "motion/joint_functions.hpp"
#include "taut/mechanism.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

/// For messages.
std::string joint_place(const MechanismJoint& joint);

/// The joints of a mechanism as a tree from the ground, and those that close loops.
struct JointTree {
  struct Link {
    int body;       ///< of the scene
    int parent;     ///< the number of the link that carries it; -1: the ground does
    int joint;      ///< of the mechanism
    bool reversed;  ///< the link is the joint's first body
  };
  std::vector<Link> links;    ///< parents first
  std::vector<int> closures;  ///< joints of the mechanism
  /// The link of a body of the scene; -1 for the ground.
  std::vector<int> link_of_body;
};

/// Throws InputError if bodies or joints are missing, or do not hang together.
JointTree joint_tree(const Scene& scene);

/// How many independent ways to move the loops leave, by the exact rank of their constraints in the drawn pose.
struct Mobility {
  int loops = 0;
  int rank = 0;        ///< of 3 constraints for each loop
  int mobility = 0;    ///< joints less the rank and couplings
  int redundant = -1;  ///< a joint that closes a loop with fewer than 3 new constraints; -1: there is none
};
Mobility mobility_of(const Mechanism& mechanism, const JointTree& tree);

struct AssembledMechanism {
  std::shared_ptr<const JointFunctions> functions;
  /// The way from the drawn pose to the beginning of the drives, over [0, 1]; empty if they begin there, or without
  /// loops.
  std::vector<LoopCell> approach;
  /// The equations of that way: the drives go straight.
  LoopEquations approach_equations() const;
  JointTree tree;
  Mobility mobility;
  double start = 0;      ///< of the scene's time
  double asked_end = 0;  ///< the end of the scene's time as it was given
  double end = 0;        ///< and that up to a lock
};

/// The equations of the joints, for each part of the time with one piece of every drive; `ends` are their ends.
struct TimedEquations {
  LoopEquations equations;
  std::vector<double> ends;
};
TimedEquations loop_equations(const Scene& scene, const JointTree& tree);

/// The dead point that a path ends before, or nothing if it cannot be shown to be one. The box holds the motion from
/// the path's end to there.
struct DeadPoint {
  std::array<double, 2> time;
  CurveBox box;
};
std::optional<DeadPoint> dead_point_after(const LoopEquations& equations, std::size_t piece, const LoopPath& path);

/// The instant, after `from`, at which the bars of a parallelogram, the only loop, come in line. Nothing if there is no
/// such loop, or it does not until `end`.
std::optional<std::array<double, 2>> change_point_after(const LoopEquations& equations, std::size_t piece, double from,
                                                        double end);

/// What could move at some values of the unknowns while the drives rest, approximately: by number, joints of the tree,
/// closures, and links.
struct LooseParts {
  std::vector<std::size_t> joints, closures, links;
};
LooseParts loose_parts(const LoopEquations& equations, std::size_t piece, double t,
                       const std::vector<double>& unknowns);

}  // namespace taut::internal
