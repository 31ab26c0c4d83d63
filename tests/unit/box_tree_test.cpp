// Which boxes meet, against all pairs; and what is of one group costs nothing.
#include "geometry/box_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "support/rng.hpp"

namespace taut {
using namespace internal;
namespace {

using testing::Rng;
using IndexPairs = std::multiset<std::pair<int, int>>;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// With coordinates that often are the same, and now and then without bounds.
AxisBox some_box(Rng& rng) {
  if (rng.between(0, 20) == 0) return {-infinite, -infinite, infinite, infinite};
  const double x = rng.between(-12, 12), y = rng.between(-12, 12);
  return {x, y, x + rng.between(0, 3), rng.between(0, 20) == 0 ? infinite : y + rng.between(0, 3)};
}

/// By definition: a point that is in both.
bool share_a_point(const AxisBox& a, const AxisBox& b) {
  return std::max(a.lo_x, b.lo_x) <= std::min(a.hi_x, b.hi_x) && std::max(a.lo_y, b.lo_y) <= std::min(a.hi_y, b.hi_y);
}

TEST(BoxTree, FindsWhatAllPairsFind) {
  Rng rng(7);
  std::size_t found = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<AxisBox> boxes;
    for (int n = rng.between(0, 40); n > 0; --n) boxes.push_back(some_box(rng));
    const BoxTree tree(boxes);
    IndexPairs meeting, meeting_by_all;
    tree.each_two([&](int i, int k) { meeting.emplace(std::min(i, k), std::max(i, k)); });
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t k = i + 1; k < boxes.size(); ++k) {
        if (share_a_point(boxes[i], boxes[k])) meeting_by_all.emplace(static_cast<int>(i), static_cast<int>(k));
      }
    }
    EXPECT_EQ(meeting, meeting_by_all);
    const AxisBox asked = some_box(rng);
    std::vector<int> of_it, of_it_by_all;
    tree.find(asked, of_it);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (share_a_point(boxes[i], asked)) of_it_by_all.push_back(static_cast<int>(i));
    }
    EXPECT_EQ(of_it, of_it_by_all);
    EXPECT_EQ(tree.any(asked), !of_it.empty());
    found += meeting.size();
  }
  EXPECT_GT(found, 1000U);
}

/// By definition: of the intervals along each axis.
double distance(const AxisBox& a, const AxisBox& b) {
  const auto gap = [](double lo, double hi, double other_lo, double other_hi) {
    return hi < other_lo ? other_lo - hi : other_hi < lo ? lo - other_hi : 0;
  };
  return std::hypot(gap(a.lo_x, a.hi_x, b.lo_x, b.hi_x), gap(a.lo_y, a.hi_y, b.lo_y, b.hi_y));
}

TEST(BoxTree, FindsNearBoxesOfAnotherTree) {
  Rng rng(11);
  std::size_t found = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<AxisBox> a, b;
    for (int n = rng.between(0, 40); n > 0; --n) a.push_back(some_box(rng));
    for (int n = rng.between(0, 40); n > 0; --n) b.push_back(some_box(rng));
    const double reach = rng.between(0, 3);
    IndexPairs near, near_by_all;
    BoxTree(a).each_near(BoxTree(b), reach, [&](int i, int k) { near.emplace(i, k); });
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t k = 0; k < b.size(); ++k) {
        if (distance(a[i], b[k]) <= reach) near_by_all.emplace(static_cast<int>(i), static_cast<int>(k));
      }
    }
    EXPECT_EQ(near, near_by_all);
    found += near.size();
  }
  EXPECT_GT(found, 1000U);
}

TEST(BoxTree, OfDifferentGroupsEveryTwoAreFound) {
  Rng rng(8);
  for (int round = 0; round < 300; ++round) {
    std::vector<AxisBox> boxes;
    std::vector<int> groups;
    const int kinds = rng.between(1, 5);
    for (int n = rng.between(0, 40); n > 0; --n) {
      boxes.push_back(some_box(rng));
      groups.push_back(rng.between(1, kinds));
    }
    IndexPairs with_groups, without;
    BoxTree(boxes, groups).each_two([&](int i, int k) { with_groups.emplace(std::min(i, k), std::max(i, k)); });
    BoxTree(boxes).each_two([&](int i, int k) {
      const bool together = groups[static_cast<std::size_t>(i)] == groups[static_cast<std::size_t>(k)];
      if (!together) without.emplace(std::min(i, k), std::max(i, k));
    });
    EXPECT_EQ(with_groups, without);
  }
}

TEST(BoxTree, WhatMovesTogetherCostsNothing) {
  // All of them meet: half a million pairs, of which none is asked about but those of the one that moves alone.
  const std::vector<AxisBox> boxes(1000, AxisBox{0, 0, 1, 1});
  std::vector<int> groups(boxes.size(), 0);
  const auto visits = [&] {
    int count = 0;
    BoxTree(boxes, groups).each_two([&](int, int) { ++count; });
    return count;
  };
  EXPECT_EQ(visits(), 0);
  groups[500] = 1;
  EXPECT_EQ(visits(), 999);
}

}  // namespace
}  // namespace taut
