#include "scene/mechanism.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "numeric/budget.hpp"
#include "scene/validate_scene.hpp"
#include "taut/error.hpp"

namespace taut::internal {
namespace {

/// With drives that go straight from the drawn pose to where they begin at `start`, over [0, 1].
LoopEquations to_beginning(LoopEquations equations, double start) {
  for (Drive& drive : equations.drives) {
    const double begins = drive_value(drive.pieces.front(), Series<double, 0>::constant(start)).c[0].mid;
    drive.pieces = {{1, std::array<double, 4>{0, 0, 1, begins}, {}}};
  }
  return equations;
}

class Assembly {
 public:
  explicit Assembly(Scene scene) : scene_(std::move(scene)) {}

  Scene run() {
    validate_time(scene_);
    tree_ = joint_tree(scene_);
    TimedEquations timed = loop_equations(scene_, tree_);
    mobility_ = mobility_of(*scene_.mechanism, tree_);
    require_mobility();
    equations_ = std::move(timed.equations);
    if (equations_.equations() != equations_.unknowns) fail_mobility("the drives do not determine the joints");
    const double asked_end = scene_.end;
    follow_all(timed.ends);
    const auto drawn_at = begins_as_drawn() ? std::optional(scene_.start) : std::nullopt;
    const auto functions = std::make_shared<const JointFunctions>(std::move(equations_), std::move(cells_), drawn_at);
    move_links(functions, timed.ends);
    scene_.assembly = std::make_shared<const AssembledMechanism>(
        AssembledMechanism{functions, std::move(approach_), tree_, mobility_, scene_.start, asked_end, scene_.end});
    return std::move(scene_);
  }

 private:
  const Mechanism& mechanism() const { return *scene_.mechanism; }

  [[noreturn]] void fail_mobility(const std::string& problem) const {
    throw InputError(
        "mechanism",
        fmt::format("{}: its mobility is {}, with {} joints, {} loops and {} couplings, and {} joints are driven",
                    problem, mobility_.mobility, mechanism().joints.size(), mobility_.loops,
                    mechanism().couplings.size(), mechanism().drives.size()),
        hint());
  }

  std::string hint() const {
    const std::string link = link_without_length();
    return link.empty() ? "the number of driven joints must be the mobility" + candidate() : link;
  }

  /// A link all of whose pins are at one place holds what it joins, or nothing: driving other joints is no help.
  std::string link_without_length() const {
    for (const JointTree::Link& link : tree_.links) {
      const std::string& name = scene_.bodies[static_cast<std::size_t>(link.body)].name;
      std::vector<const MechanismJoint*> own;
      for (const MechanismJoint& joint : mechanism().joints) {
        if (joint.first == name || joint.second == name) own.push_back(&joint);
      }
      const auto is_there = [&](const MechanismJoint* joint) {
        return joint->kind == MechanismJoint::Kind::revolute && joint->at.x == own[0]->at.x &&
               joint->at.y == own[0]->at.y;
      };
      if (own.size() > 1 && own[0]->name != own[1]->name && std::all_of(own.begin(), own.end(), is_there))
        return fmt::format(
            "link \"{}\" has no length, as its joints \"{}\" and \"{}\" are at one place: move one of them, or leave "
            "the "
            "link out and pin its neighbours to each other",
            name, own[0]->name, own[1]->name);
    }
    return "";
  }

  /// A joint that could be driven as well, or that is driven in vain.
  std::string candidate() const {
    const auto driven = static_cast<int>(mechanism().drives.size());
    if (driven >= mobility_.mobility)
      return driven > mobility_.mobility
                 ? ": leave out the drive of \"" + mechanism().drives.back().joint + "\", for instance"
                 : "";
    for (const MechanismJoint& joint : mechanism().joints) {
      const auto named = [&](const auto& other) { return other.joint == joint.name; };
      const bool known = std::any_of(mechanism().drives.begin(), mechanism().drives.end(), named) ||
                         std::any_of(mechanism().couplings.begin(), mechanism().couplings.end(), named);
      if (!known && !joint.shared) return ": drive \"" + joint.name + "\" as well, for instance";
    }
    return "";
  }

  void require_mobility() const {
    if (mobility_.redundant >= 0) {
      const std::string& name = mechanism().joints[static_cast<std::size_t>(mobility_.redundant)].name;
      fail_mobility("the loop that joint \"" + name + "\" closes is constrained by others in the drawn pose already, " +
                    "so that the joint is redundant, or the pose is a dead point");
    }
    if (mobility_.mobility != static_cast<int>(mechanism().drives.size()))
      fail_mobility(static_cast<int>(mechanism().drives.size()) < mobility_.mobility
                        ? "the drives leave it free to move in other ways"
                        : "more joints are driven than can move independently");
  }

  /// From the drawn pose to the beginning of the drives, and on to the end.
  void follow_all(const std::vector<double>& ends) {
    Balls<double> values(static_cast<std::size_t>(equations_.unknowns), Ball<double>::exact(0));
    cells_.resize(ends.size());
    if (equations_.unknowns == 0) return;
    require_regular_drawing();
    values = at_beginning(std::move(values));
    double from = scene_.start;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      LoopPath path = follow(equations_, k, from, ends[k], values);
      if (path.singular) return lock(k, ends[k], std::move(path));
      values = std::move(path.last);
      cells_[k] = std::move(path.cells);
      from = ends[k];
    }
  }

  void require_regular_drawing() const {
    LoopEquations drawn = equations_;
    for (Drive& drive : drawn.drives) drive.pieces = {{1, std::array<double, 4>{0, 0, 1, 0}, {}}};
    const std::vector<double> zero(static_cast<std::size_t>(drawn.unknowns));
    std::vector<double> about = zero;
    const LoopCurve curve{drawn, 0, drawn.unknowns};
    const auto inverse = newton(curve, about, 0);
    if (inverse && solve_at<double>(curve, zero, 0, *inverse, weights_of(drawn))) return;
    throw InputError("mechanism",
                     fmt::format("the drawn pose is a dead point, or too near to one for doubles: with the driven "
                                 "joints held, {} could still move",
                                 joint_list(loose_parts(drawn, 0, 0, zero))),
                     "draw it in a pose in which no two links are in line, or drive another joint");
  }

  std::string joint_list(const LooseParts& loose) const {
    std::string s;
    const std::vector<std::string> names = joint_names(loose);
    for (const std::string& name : names) s += (s.empty() ? "\"" : ", \"") + name + "\"";
    return names.empty() ? "some joint" : (names.size() == 1 ? "joint " : "joints ") + s;
  }

  std::vector<std::string> joint_names(const LooseParts& loose) const {
    std::set<int> joints;
    for (const std::size_t k : loose.joints) joints.insert(tree_.links[k].joint);
    for (const std::size_t k : loose.closures) joints.insert(tree_.closures[k]);
    std::vector<std::string> names;
    for (const int k : joints) {
      const std::string& name = mechanism().joints[static_cast<std::size_t>(k)].name;
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return names;
  }

  /// Do all drives begin at 0, exactly?
  bool begins_as_drawn() const {
    return std::all_of(equations_.drives.begin(), equations_.drives.end(), [&](const Drive& drive) {
      const Drive::Piece& piece = drive.pieces.front();
      const Dyadic t = Dyadic::exact(scene_.start);
      Dyadic sum;
      if (!piece.line) {
        for (std::size_t k = piece.polynomial.size(); k-- > 0;) sum = sum * t + Dyadic::exact(piece.polynomial[k]);
        return sum.is_zero();
      }
      const auto [t0, v0, t1, v1] = *piece.line;
      if (t0 == t1) return v0 == 0;
      const Dyadic since = t - Dyadic::exact(t0), until = Dyadic::exact(t1) - t;
      return (since * Dyadic::exact(v1) + until * Dyadic::exact(v0)).is_zero();
    });
  }

  Balls<double> at_beginning(Balls<double> values) {
    if (begins_as_drawn()) return values;
    LoopPath path = follow(to_beginning(equations_, scene_.start), 0, 0, 1, values);
    if (!path.singular) {
      approach_ = std::move(path.cells);
      if (const auto exactly = for_exact_drives({equations_, 0, equations_.unknowns}, scene_.start, path.last))
        return *exactly;
    }
    throw InputError(
        "mechanism",
        fmt::format("it locks on the way from the drawn pose to the beginning of the drives, at {:.4g} of it",
                    path.until),
        "draw it in a pose from which the drives' beginning can be reached");
  }

  void lock(std::size_t piece, double piece_end, LoopPath path) {
    const double asked_end = scene_.end;
    if (path.cells.empty() && piece == 0) fail_beginning(path);
    auto dead = dead_point_after(equations_, piece, path);
    // Where the drives turn back before, it is no dead point of the motion.
    if (dead && piece_end < asked_end && !(dead->time[1] <= piece_end)) dead.reset();
    if (!dead) {
      scene_.lock = MechanismLock{{path.until, asked_end}, MechanismLock::Kind::undecided, {}, {}};
      std::vector<double> values;
      for (const Ball<double>& x : path.last) values.push_back(x.mid);
      name(loose_parts(equations_, piece, path.until, values), *scene_.lock);
      if (const auto time = change_point_after(equations_, piece, path.until, asked_end)) {
        scene_.lock->time = *time;
        scene_.lock->kind = MechanismLock::Kind::change_point;
      }
    }
    if (dead && dead->time[0] <= asked_end) {
      MechanismLock found;
      found.time = dead->time;
      std::vector<double> values;
      for (std::size_t i = 0; i < path.last.size(); ++i) values.push_back(dead->box.range(i).mid);
      name(loose_parts(equations_, piece, dead->time[0], values), found);
      scene_.lock = found;
    }
    if (dead && dead->time[1] >= asked_end) {
      path.cells.push_back(up_to_lock(*dead, path.until));
    } else {
      scene_.end = path.until;
    }
    if (!path.cells.empty()) cells_[piece++] = std::move(path.cells);
    cells_.resize(piece);
  }

  /// Up to the end, or to the lock if it comes first, only the values are enclosed.
  LoopCell up_to_lock(const DeadPoint& dead, double from) const {
    const double to = scene_.end;
    return {from, to, from + (to - from) / 2, to - from, dead.box, {}, {}, {}};
  }

  [[noreturn]] void fail_beginning(const LoopPath& path) const {
    std::vector<double> values;
    for (const Ball<double>& x : path.last) values.push_back(x.mid);
    throw InputError("mechanism",
                     fmt::format("where the drives begin, it cannot be followed: with the driven joints held, {} could "
                                 "still move, or nearly so",
                                 joint_list(loose_parts(equations_, 0, path.until, values))),
                     "let the drives begin where no two links are in line, and the time last longer than 1e-250");
  }

  void name(const LooseParts& loose, MechanismLock& lock) const {
    lock.joints = joint_names(loose);
    for (const std::size_t k : loose.links)
      lock.links.push_back(scene_.bodies[static_cast<std::size_t>(tree_.links[k].body)].name);
  }

  void move_links(const std::shared_ptr<const JointFunctions>& functions, const std::vector<double>& ends) {
    for (std::size_t k = 0; k < tree_.links.size(); ++k) {
      const JointTree::Link& link = tree_.links[k];
      const MechanismJoint& joint = mechanism().joints[static_cast<std::size_t>(link.joint)];
      Body& body = scene_.bodies[static_cast<std::size_t>(link.body)];
      if (link.parent >= 0)
        body.relative_to =
            scene_.bodies[static_cast<std::size_t>(tree_.links[static_cast<std::size_t>(link.parent)].body)].name;
      const bool slides = joint.kind == MechanismJoint::Kind::slide;
      for (std::size_t i = 0; i < functions->pieces(); ++i) {
        MotionPiece piece;
        piece.rotation = JointFollower{
            functions, static_cast<int>(k), static_cast<int>(i), slides, joint.direction, link.reversed ? -1 : 1, 0};
        if (!slides) piece.pivot = joint.at;
        if (i + 1 < functions->pieces()) piece.until = ends[i];
        body.motion.pieces.push_back(std::move(piece));
      }
    }
  }

  Scene scene_;
  JointTree tree_;
  Mobility mobility_;
  LoopEquations equations_;
  std::vector<std::vector<LoopCell>> cells_;
  std::vector<LoopCell> approach_;
};

}  // namespace

LoopEquations AssembledMechanism::approach_equations() const { return to_beginning(functions->equations(), start); }

}  // namespace taut::internal

namespace taut {

const char* to_string(MechanismLock::Kind kind) {
  switch (kind) {
    case MechanismLock::Kind::dead_point:
      return "dead point";
    case MechanismLock::Kind::change_point:
      return "change point";
    default:
      return "undecided";
  }
}

Scene assembled(Scene scene) {
  if (!scene.mechanism || scene.assembly) return scene;
  return internal::Assembly(std::move(scene)).run();
}

}  // namespace taut
