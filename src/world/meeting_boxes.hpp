// Which bodies of a world may meet during a window of time, and would a shorter one tell more?
#pragma once

#include <functional>
#include <vector>

#include "world/swept_box.hpp"

namespace taut {

/// Some bodies of a world, and their boxes over a window.
class MeetingBoxes {
 public:
  MeetingBoxes(const WorldPlan& plan, const std::vector<int>& bodies, double from, double to);

  /// Calls visit(a, b, longer) for all pairs of bodies whose boxes meet and that are asked about: a sweep along x.
  /// `longer`: over half of the window their boxes would be much shorter.
  void each(const std::function<void(int, int, bool)>& visit) const;

 private:
  bool longer(std::size_t i, std::size_t j) const;

  const WorldPlan& plan_;
  const std::vector<int>& bodies_;
  std::vector<SweptBox> boxes_;
};

}  // namespace taut
