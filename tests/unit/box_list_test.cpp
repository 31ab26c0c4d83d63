// Which boxes of lists are near each other, against all pairs.
#include "geometry/box_list.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "support/rng.hpp"

namespace taut {
using namespace internal;
namespace {

using testing::Rng;
using Pairs = std::multiset<std::pair<std::size_t, std::size_t>>;

/// Along a walk, with coordinates that often are the same.
std::vector<AxisBox> boxes(Rng& rng, int n) {
  std::vector<AxisBox> all;
  double x = 0, y = 0;
  for (int i = 0; i < n; ++i) {
    x += rng.between(-2, 2);
    y += rng.between(-2, 2);
    AxisBox box;
    box.add(Point{x, y});
    box.add(Point{x + rng.between(0, 2), y + rng.between(0, 2)});
    all.push_back(box);
  }
  return all;
}

TEST(BoxList, FindsWhatAllPairsFind) {
  Rng rng(11);
  std::size_t found = 0;
  for (int round = 0; round < 300; ++round) {
    const std::vector<AxisBox> a = boxes(rng, rng.between(0, 20)), b = boxes(rng, rng.between(0, 20));
    const double reach = rng.between(0, 3);
    Pairs near, near_by_all, meeting, meeting_by_all;
    BoxList(a).near(BoxList(b), reach, [&](std::size_t i, std::size_t k) { near.emplace(i, k); });
    BoxList(a).meeting([&](std::size_t i, std::size_t k) { meeting.emplace(i, k); });
    const auto gap = [](double lo, double hi, double other_lo, double other_hi) {
      return hi < other_lo ? other_lo - hi : other_hi < lo ? lo - other_hi : 0;
    };
    const auto apart = [&](const AxisBox& p, const AxisBox& q) {
      return std::hypot(gap(p.lo_x, p.hi_x, q.lo_x, q.hi_x), gap(p.lo_y, p.hi_y, q.lo_y, q.hi_y));
    };
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t k = 0; k < b.size(); ++k) {
        if (apart(a[i], b[k]) <= reach) near_by_all.emplace(i, k);
      }
      for (std::size_t k = i + 1; k < a.size(); ++k) {
        if (apart(a[i], a[k]) == 0) meeting_by_all.emplace(i, k);
      }
    }
    EXPECT_EQ(near, near_by_all);
    EXPECT_EQ(meeting, meeting_by_all);
    found += near.size() + meeting.size();
  }
  EXPECT_GT(found, 1000U);
}

}  // namespace
}  // namespace taut
