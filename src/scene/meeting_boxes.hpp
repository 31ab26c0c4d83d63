// Boxes that certainly hold moving bodies: which of them meet, during which times.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "geometry/axis_box.hpp"
#include "geometry/box_tree.hpp"
#include "scene/instance.hpp"
#include "taut/check.hpp"

namespace taut::internal {

/// Over half of the window that the boxes are for, would those of the two bodies be much shorter?
bool is_long(const Instance& instance, int a, const AxisBox& box_a, int b, const AxisBox& box_b);

/// Some bodies of a world, and their boxes over a window.
class MeetingBoxes {
 public:
  MeetingBoxes(const Instance& instance, const std::vector<int>& bodies, double from, double to);

  /// Calls visit(a, b, longer) for all pairs of bodies a < b whose boxes meet and that are asked about. `longer`:
  /// is_long().
  void each(const std::function<void(int, int, bool)>& visit) const;
  /// The same without pairs of one group, to which nothing happens after the start.
  void each_moving(const std::function<void(int, int, bool)>& visit) const;
  /// Of each body, for those who go on with them.
  std::vector<AxisBox> take_boxes() { return std::move(boxes_); }

 private:
  void each(const std::vector<int>& groups, const std::function<void(int, int, bool)>& visit) const;
  std::vector<int> groups() const;

  const Instance& instance_;
  const std::vector<int>& bodies_;
  std::vector<AxisBox> boxes_;
};

// When may two bodies of a world meet at all, as far as boxes show?

/// For each pair the stretches of time outside of which the two bodies' boxes are apart: what has to look at all of a
/// scene's time, and not only up to a first contact, need not follow a pair through the rest. The world's time is
/// divided into the coarse windows, and these are halved as long as that makes boxes much shorter.
class NearStretches {
 public:
  explicit NearStretches(const Instance& instance);

  /// Of each pair a < b that is asked about, the stretches in order and apart from each other; none if boxes over the
  /// halves of windows separate the two throughout. Pairs that boxes over the coarse windows separate are left out.
  const std::map<std::pair<int, int>, std::vector<TimeInterval>>& pairs() const { return stretches_; }

 private:
  void cover(const std::vector<int>& bodies, double from, double to, int depth);

  const Instance& instance_;
  std::map<std::pair<int, int>, std::vector<TimeInterval>> stretches_;
};

// Which bodies of a world come near each other at all, as far as bounding boxes show?

/// The boxes of all bodies over the coarse windows of a world's time.
class CoarseBoxes {
 public:
  explicit CoarseBoxes(const Instance& instance);

  /// In order, all pairs a < b that are asked about and whose boxes are within `reach` of each other in some window,
  /// and perhaps a few more. No other pair that is asked about ever comes closer than `reach`, in internal units.
  std::vector<std::pair<int, int>> pairs_within(double reach) const;
  /// The same with a reach for each pair: the sum of its bodies' shares.
  std::vector<std::pair<int, int>> pairs_within(const std::vector<double>& shares) const;
  /// A lower bound of the distance of two bodies at all times, in internal units.
  double distance(int a, int b) const;

 private:
  const Instance& instance_;
  std::vector<std::vector<AxisBox>> windows_;  ///< of each window, the boxes of all bodies; of a layout, one window
};

// Where a body may be during a window of time: a box along the axes that certainly holds it.

/// The box with room for a margin around it, which is more than the margin by more than is rounded anywhere; the same
/// box for 0.
inline AxisBox grown(const AxisBox& box, double margin) {
  const double more = margin * (1 + 0x1p-40) + (margin > 0 ? 0x1p-48 : 0);
  return {box.lo_x - more, box.lo_y - more, box.hi_x + more, box.hi_y + more};
}

/// Do the boxes of two bodies over a window show less than those over its halves would? `sizes` is the sum of the two
/// bodies' own. A window is short enough for bodies whose boxes it makes at most half as large again.
inline bool is_long(const AxisBox& a, const AxisBox& b, double sizes) {
  return a.longest() + b.longest() > 1.5 * sizes;
}

/// No window is halved more often.
inline constexpr int most_window_halvings = 30;

/// The box of the body, displaced either way, all over [from, to], in the world's frame and in internal coordinates.
/// Infinite where the motion is singular.
AxisBox swept_box(const InstanceBody& body, double from, double to);

/// Into so many windows is a world's time divided to see which bodies may come near each other at all.
inline constexpr int coarse_windows = 16;
/// Where window k of these begins, and the one before ends.
double coarse_boundary(const Instance& instance, int k);

// Boxes of bodies, of which now and then one changes: which of them meet another one.

/// A tree over the boxes as they once were, and a list of those that came, changed or went since. Once these are many,
/// the tree is made anew: so a change costs little, however many boxes there are. No tree is made before a question.
class ChangingBoxes {
 public:
  ChangingBoxes() = default;
  /// Bodies in order, and the box of each.
  ChangingBoxes(std::vector<int> bodies, std::vector<AxisBox> boxes);

  void set(int body, const AxisBox& box);
  void remove(int body);
  /// Of a body that is there.
  const AxisBox& box(int body) const;
  /// The bodies whose boxes meet it, in order.
  std::vector<int> find(const AxisBox& box);

 private:
  std::size_t place(int body) const;
  bool has(int body) const;
  void make_tree();

  std::vector<int> bodies_;
  std::vector<AxisBox> boxes_;
  std::optional<BoxTree> tree_;                            ///< over these
  std::unordered_map<int, std::optional<AxisBox>> since_;  ///< what holds instead; none for a body that went
};

}  // namespace taut::internal
