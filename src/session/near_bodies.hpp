// The pairs of a simulated world that may meet soon.
#pragma once

#include <algorithm>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "scene/instance.hpp"
#include "scene/meeting_boxes.hpp"

namespace taut::internal {

/// Every body has a box that holds it for a while, until a time of its own. Bodies are near each other while their
/// boxes meet, and no other pair meets. A body whose box ends gets a new one, from then on, and is tested against the
/// boxes of all others, in a tree. A box that meets others is at most half as long again as the body; one that meets no
/// other may be long. So a body costs what it moves near others, and a change of its motion costs no more. Pairs of
/// bodies that move alike are never near. A single pair is near all the time.
///
/// A disc around each body keeps most of these pairs apart for longer: see apart_until().
class NearBodies {
 public:
  using Pair = std::pair<int, int>;
  /// The pairs, a < b, that a change has brought near each other, and those that it has parted; each in order.
  struct Changes {
    std::vector<Pair> come, gone;
    std::vector<int> renewed;  ///< bodies with new boxes
  };

  /// The motions must outlive this object. Begins at their start.
  explicit NearBodies(const Instance& instance);
  ~NearBodies();

  /// The pairs at the beginning.
  std::vector<Pair> pairs() const;
  /// When the first box ends; infinite if all of them reach the end of the world.
  double until() const;
  /// When the first one of two boxes ends.
  double until(int a, int b) const {
    return std::min(boxes_[static_cast<std::size_t>(a)].to, boxes_[static_cast<std::size_t>(b)].to);
  }
  /// No box begins later.
  double latest() const { return latest_; }
  /// Renews the boxes that end then, from then on.
  Changes renew();
  /// Up to when discs around the two bodies are certainly apart, from that time on; at most until either box ends. The
  /// time itself if they are not. At that time, bodies may jump by so much.
  double apart_until(int a, int b, double from, double jump = 0) const;
  /// These bodies, in order, move in another way from that time on. Boxes that begin later are renewed from then on,
  /// too.
  Changes change(const std::vector<int>& changed, double from);
  /// The last body has come at that time.
  Changes add(double from);
  /// The body is near no other one any more, and does not change any more.
  Changes remove(int body);
  /// Takes back what add() has done, but for the boxes of others that it has shortened.
  void remove_last();
  /// Are not asked about any more.
  void part(int a, int b);
  /// Bodies that may be at the same place as the body at that time, move like it, and are not excluded.
  std::vector<int> alike_at(int body, double t) const;
  bool has(int a, int b) const {
    const std::vector<int>& near = of(a);
    return std::binary_search(near.begin(), near.end(), b);
  }
  /// The bodies near one body, in order.
  const std::vector<int>& of(int body) const { return near_[static_cast<std::size_t>(body)]; }

 private:
  class Tree;
  struct Disc {
    Point centre;  ///< in the body's coordinates
    double radius = 0;
  };
  /// The centre of the disc moves evenly, but for an error: it is at (x, y) + (t - about) (vx, vy).
  struct Way {
    double about = 0, x = 0, y = 0, vx = 0, vy = 0;
    double error = 0;  ///< infinite where it is not known
  };
  struct Box {
    AxisBox box;
    double from = 0, to = 0;
    Way way;
    double length = 0;  ///< of the time of the last short box
  };

  static Disc disc_around(const RingSet& rings);
  bool may_meet(int a, int b) const;
  double shortest_time() const;
  bool is_short(int body, const AxisBox& box) const;
  bool meets_any(int body, const AxisBox& box) const;
  Box box_until(int body, double from, double to) const;
  Box box_of(int body, double from, bool alone) const;
  std::vector<int> met_by(int body, const AxisBox& box) const;
  Way way_of(int body, double from, double to) const;
  void place(int body, Box box);
  void lift(int body);
  void renew(const std::vector<int>& bodies, double from, Changes& changes);
  void box_anew(const std::vector<int>& bodies, double from, Changes& changes);
  void find_near(int body, Changes& changes);
  void bring(int body, int other);

  const Instance& instance_;
  bool single_;
  std::vector<Box> boxes_;
  std::vector<Disc> discs_;
  std::vector<std::vector<int>> near_;
  std::set<std::pair<double, int>> ends_;  ///< of boxes that end before the world does
  double latest_ = 0;                      ///< no box begins later
  std::unique_ptr<Tree> tree_;
};

}  // namespace taut::internal
