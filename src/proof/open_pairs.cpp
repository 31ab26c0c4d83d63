#include "proof/open_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "numeric/budget.hpp"

namespace taut::internal::proof {
namespace {

/// An interval along the axis of the sweep.
struct Swept {
  double lo, hi;
  int body;
};

/// The intervals that have begun, of which some are over already: these are thrown out when the list is traversed.
class BegunIntervals {
 public:
  void add(const Swept& swept) { list_.push_back(swept); }
  template <class Visit>
  void each(double from, const Visit& visit) {
    std::size_t kept = 0;
    for (const Swept& swept : list_) {
      if (swept.hi < from) continue;
      list_[kept++] = swept;
      visit(swept.body);
    }
    list_.resize(kept);
  }
  bool empty() const { return list_.empty(); }

 private:
  std::vector<Swept> list_;
};

}  // namespace

WindowBoxes::WindowBoxes(const VerifierScene& scene, double room) : room_(room * (1 + 0x1p-40)) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (int i = 0; i < scene.size(); ++i) {
    const AxisBox& b = scene[i].rings->bounds();
    rests_.push_back(scene[i].rests());
    boxes_.push_back(rests_.back() ? AxisBox{b.lo_x, b.lo_y, b.hi_x, b.hi_y}
                                   : AxisBox{-infinite, -infinite, infinite, infinite});
  }
}

/// Are boxes shorter along x than along y, relative to how far they are spread?
bool WindowBoxes::sweep_along_x() const {
  double long_x = 0, long_y = 0, lo_x = INFINITY, lo_y = INFINITY, hi_x = -INFINITY, hi_y = -INFINITY;
  for (const AxisBox& b : boxes_) {
    if (!std::isfinite(b.lo_x + b.hi_x + b.lo_y + b.hi_y)) continue;
    long_x += b.hi_x - b.lo_x;
    long_y += b.hi_y - b.lo_y;
    lo_x = std::min(lo_x, b.lo_x);
    lo_y = std::min(lo_y, b.lo_y);
    hi_x = std::max(hi_x, b.hi_x);
    hi_y = std::max(hi_y, b.hi_y);
  }
  return !(long_x * (hi_y - lo_y) > long_y * (hi_x - lo_x));
}

std::optional<BodyPairs> WindowBoxes::meeting(const VerifierScene& scene, std::size_t most) const {
  const bool along_x = sweep_along_x();
  std::vector<Swept> order;
  for (int i = 0; i < scene.size(); ++i) {
    if (scene.ignores(i)) continue;
    const AxisBox& b = of(i);
    // A little longer than it is, so that bodies at rest are seen that are within the room of each other.
    order.push_back({along_x ? b.lo_x : b.lo_y, (along_x ? b.hi_x : b.hi_y) + 2 * room_, i});
  }
  std::sort(order.begin(), order.end(),
            [](const Swept& a, const Swept& b) { return a.lo != b.lo ? a.lo < b.lo : a.body < b.body; });
  BodyPairs found;
  // By bodies that move alike, most of which are not asked about each other. Those that have no interval left are gone.
  std::map<int, BegunIntervals> begun;
  for (const Swept& next : order) {
    checkpoint();
    const auto visit = [&](int other) {
      checkpoint();
      if (meet(next.body, other) && scene.asked(next.body, other)) found.push_back(std::minmax(next.body, other));
    };
    const int own = scene[next.body].alike;
    for (auto& [alike, intervals] : begun) {
      if (alike != own || scene.tests_alike()) intervals.each(next.lo, visit);
    }
    std::erase_if(begun, [](const auto& of) { return of.second.empty(); });
    begun[own].add(next);
    // Many bodies may meet one: what is over the limit is dropped at once.
    if (found.size() > most) return std::nullopt;
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<int> moving_bodies(const VerifierScene& scene, const OpenPairs& open) {
  std::vector<int> bodies;
  if (open.all()) {
    bodies.resize(static_cast<std::size_t>(scene.size()));
    std::iota(bodies.begin(), bodies.end(), 0);
  } else {
    for (const auto& [a, b] : *open.listed) bodies.insert(bodies.end(), {a, b});
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  }
  std::erase_if(bodies, [&](int i) { return scene[i].rests(); });
  return bodies;
}

}  // namespace taut::internal::proof
