// Which pairs of bodies a window of a log of separations has to say something about.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "proof/stated_box.hpp"

namespace taut::internal::proof {

using BodyPairs = std::vector<std::pair<int, int>>;

/// The pairs that are open in a window: all that are asked about but one, as long as windows are halved without a word,
/// and later those that a longer window has left.
struct OpenPairs {
  std::optional<BodyPairs> listed;

  bool all() const { return !listed; }
};

/// The boxes of all bodies in a window: those that windows around it have stated, and of bodies at rest those around
/// their outlines.
class WindowBoxes {
 public:
  /// `room` as stays_within() wants it.
  WindowBoxes(const VerifierScene& scene, double room);

  const AxisBox& of(int body) const { return boxes_[static_cast<std::size_t>(body)]; }
  void state(int body, const AxisBox& box) { boxes_[static_cast<std::size_t>(body)] = box; }
  /// Those of two bodies. Boxes that are stated have room around the body; those of two bodies at rest need it here.
  bool meet(int a, int b) const {
    const bool rest = rests_[static_cast<std::size_t>(a)] && rests_[static_cast<std::size_t>(b)];
    return rest ? within_room(of(a), of(b)) : of(a).meets(of(b));
  }
  /// All pairs that are asked about and whose boxes meet, in order; nothing if they are more than `most`. By sweeping
  /// along the axis along which fewer meet.
  std::optional<BodyPairs> meeting(const VerifierScene& scene, std::size_t most = SIZE_MAX) const;

 private:
  bool sweep_along_x() const;
  bool within_room(const AxisBox& a, const AxisBox& b) const {
    const auto near = [this](double lo, double hi) { return !(lo - hi > room_); };
    return near(a.lo_x, b.hi_x) && near(b.lo_x, a.hi_x) && near(a.lo_y, b.hi_y) && near(b.lo_y, a.hi_y);
  }

  double room_;  ///< with what rounds
  std::vector<AxisBox> boxes_;
  std::vector<bool> rests_;
};

inline AxisBox as_doubles(const StatedBox& b) { return {b.lo_x, b.lo_y, b.hi_x, b.hi_y}; }

/// The bodies that move and are in any of the pairs, in order; where all pairs are open, all that move.
std::vector<int> moving_bodies(const VerifierScene& scene, const OpenPairs& open);

}  // namespace taut::internal::proof
