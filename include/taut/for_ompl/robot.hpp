// A robot for OMPL: one body, or links that turn at joints, among the bodies of a map.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "taut/for_ompl/curves.hpp"
#include "taut/for_ompl/states.hpp"
#include "taut/map_query.hpp"

namespace taut::for_ompl {

/// A link's origin sits at `joint` on its parent, in the parent's own coordinates (without a parent, in the world's),
/// and turns there by its joint's angle.
struct Link {
  Body shape;
  int parent = -1;
  Point joint = {};
};

/// Which coordinates of a state are what:
///   n links and n + 2 coordinates: x, y and angle of the first link, then one angle for each other link;
///   n links and n coordinates: one angle for each link, the first one about its joint in the world;
///   1 link and 2 coordinates: x and y, never turned.
/// Safe to share between threads: each question borrows a MapQuery, and there are as many as were ever needed at once.
class Robot {
 public:
  /// One body. Throws InputError as StaticMap::prepare() does.
  Robot(StaticMap map, const Body& body, const MapQueryOptions& options = {})
      : Robot(std::move(map), std::vector<Link>{{body}}, options) {}
  /// Links, each after its parent. Throws InputError as MapQuery does, and where no link shares a layer with anything
  /// that it could meet: no state would be valid.
  Robot(StaticMap map, std::vector<Link> links, const MapQueryOptions& options = {})
      : map_(std::move(map)), links_(std::move(links)), options_(options) {
    for (const Link& link : links_) movers_.push_back({map_.prepare(link.shape), link.parent});
    idle_.push_back(std::make_unique<Asker>(map_, movers_, options_));
    MapQuery& query = idle_.back()->query;
    if (query.at(std::vector<PoseSE2>(links_.size())).outcome == Outcome::untested)
      throw InputError(links_[0].shape.name, query.reason());
  }

  /// The map that was given.
  const StaticMap& map() const { return map_; }
  /// The links that were given; of one body, one.
  const std::vector<Link>& links() const { return links_; }
  /// How questions are asked.
  const MapQueryOptions& options() const { return options_; }

  /// Throws InputError unless states of that many coordinates say where the robot is.
  void expect(std::size_t coordinates) const {
    const std::size_t n = links_.size();
    if (coordinates == n || coordinates == n + 2 || (n == 1 && coordinates == 2)) return;
    throw InputError(links_.empty() ? "robot" : links_[0].shape.name,
                     "states of " + std::to_string(coordinates) + " coordinates do not say where " + std::to_string(n) +
                         " links are",
                     "n links take n + 2 coordinates (x, y, angles), or n (angles)");
  }
  /// Of each link, seen from its parent.
  void poses(const std::vector<double>& coordinates, std::vector<PoseSE2>& out) const {
    const std::size_t n = links_.size();
    const bool drives = coordinates.size() == n + 2 || (n == 1 && coordinates.size() == 2);
    out.resize(n);
    for (std::size_t k = 0; k < n; ++k)
      out[k] = {links_[k].joint.x, links_[k].joint.y,
                coordinates[std::min(k + (drives ? 2 : 0), coordinates.size() - 1)]};
    if (!drives) return;
    out[0] = {coordinates[0], coordinates[1], coordinates.size() > 2 ? coordinates[2] : 0};
  }

  /// What one question needs, kept for the next one.
  struct Asker {
    /// Used by Robot.
    Asker(const StaticMap& map, const std::vector<RobotLink>& links, const MapQueryOptions& options)
        : query(map, links, options), motions(links.size()) {}
    MapQuery query;
    std::vector<double> coordinates, other;
    std::vector<PoseSE2> from, to;
    std::vector<Motion> motions;
  };
  /// An asker for the time of a question.
  class Borrowed {
   public:
    /// One that is idle, or a new one.
    explicit Borrowed(const Robot& robot) : robot_(robot), asker_(robot.take()) {}
    ~Borrowed() { robot_.give_back(std::move(asker_)); }
    Borrowed(const Borrowed&) = delete;
    Borrowed& operator=(const Borrowed&) = delete;
    /// The asker.
    Asker* operator->() const { return asker_.get(); }
    /// The asker.
    Asker& operator*() const { return *asker_; }

   private:
    const Robot& robot_;
    std::unique_ptr<Asker> asker_;
  };

 private:
  std::unique_ptr<Asker> take() const {
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        std::unique_ptr<Asker> asker = std::move(idle_.back());
        idle_.pop_back();
        return asker;
      }
    }
    return std::make_unique<Asker>(map_, movers_, options_);
  }
  void give_back(std::unique_ptr<Asker> asker) const {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(asker));
  }

  StaticMap map_;
  std::vector<Link> links_;
  MapQueryOptions options_;
  std::vector<RobotLink> movers_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Asker>> idle_;
};

/// How a space's states become motions of the robot: straight in all coordinates, or along a car's curve.
class Steering {
 public:
  /// Throws InputError where space and robot do not fit. The space must stay where it is.
  Steering(const ob::StateSpace& space, const Robot& robot)
      : robot_(robot),
        reader_(space),
        dubins_(dynamic_cast<const ob::DubinsStateSpace*>(&space)),
        reeds_shepp_(dynamic_cast<const ob::ReedsSheppStateSpace*>(&space)) {
    robot.expect(reader_.size());
    if (curved() && robot.links().size() != 1)
      throw InputError(space.getName(), "cars of several links do not drive along Dubins or Reeds-Shepp curves",
                       "give a robot of one body");
  }

  /// Is it along a car's curve?
  bool curved() const { return dubins_ || reeds_shepp_; }

  /// Where the links are in a state.
  void poses(const ob::State* state, std::vector<double>& scratch, std::vector<PoseSE2>& out) const {
    reader_.read(state, scratch);
    robot_.poses(scratch, out);
  }
  /// The two ends of a straight way, the angles of the second going on from those of the first.
  void ends(const ob::State* from, const ob::State* to, Robot::Asker& asker) const {
    reader_.read(from, asker.coordinates);
    reader_.read(to, asker.other);
    for (std::size_t i = 0; i < asker.other.size(); ++i)
      asker.other[i] = reader_.end(i, asker.coordinates[i], asker.other[i]);
    robot_.poses(asker.coordinates, asker.from);
    robot_.poses(asker.other, asker.to);
  }
  /// The curve from one state to another.
  Curve curve(const ob::State* from, const ob::State* to) const {
    return dubins_ ? curve_between(*dubins_, from, to) : curve_between(*reeds_shepp_, from, to);
  }

 private:
  const Robot& robot_;
  StateReader reader_;
  const ob::DubinsStateSpace* dubins_;
  const ob::ReedsSheppStateSpace* reeds_shepp_;
};

}  // namespace taut::for_ompl
