// Which pairs are listed: those that may come as close as a distance, whatever their boxes say.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut {
namespace {

/// Thin diagonal bars side by side, 1 apart in x and less from each other, whose boxes overlap; and one far away.
Scene row_of_bars(const char* last) {
  std::string bodies;
  for (int k = 0; k < 6; ++k) {
    const std::string x = std::to_string(k), right = std::to_string(k) + ".25";
    bodies += R"({"name":"bar)" + x + R"(","polygon":[[)" + x + ",0],[" + right + ",0],[1" + right + ",10],[1" + x +
              ",10]]},";
  }
  return parse_scene(R"({"format":"taut-scene/1","time":[0,1],"bodies":[)" + bodies + last + "]}");
}

const char* const far_square = R"({"name":"far","polygon":[[100,0],[101,0],[101,1],[100,1]]})";
const char* const near_disc = R"({"name":"disc","polygon":{"path":"M-1 0 A1 1 0 0 1 -3 0 A1 1 0 0 1 -1 0 Z"}})";

void expect_listed(const Scene& scene, double within) {
  ClearanceOptions all;
  all.all_pairs = true;
  const Clearance every = clearance(scene, all);
  ASSERT_EQ(every.reason, "");
  all.within = within;
  const Clearance near = clearance(scene, all);
  std::vector<NearestPoints> expected;
  for (const NearestPoints& pair : every.pairs) {
    if (pair.lo <= within) expected.push_back(pair);
  }
  ASSERT_EQ(near.pairs.size(), expected.size()) << within;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_EQ(near.pairs[k].pair, expected[k].pair) << within;
    EXPECT_EQ(near.pairs[k].hi, expected[k].hi) << within;
  }
  EXPECT_EQ(near.outcome, every.outcome);
  ASSERT_TRUE(near.nearest);
  EXPECT_EQ(near.nearest->pair, every.nearest->pair) << within;
  EXPECT_EQ(near.nearest->hi, every.nearest->hi) << within;
  EXPECT_EQ(near.coverage.pairs, every.coverage.pairs);
  EXPECT_LE(near.coverage.tested, every.coverage.tested);
}

TEST(ClearanceWithin, ListsThePairsThatAreNear) {
  // Distances are k / sqrt(2) - 0.25 / sqrt(2), for neighbours about 0.53.
  for (const double within : {0.1, 0.5, 0.54, 1.2, 5.0, 99.0, 1000.0}) expect_listed(row_of_bars(far_square), within);
}

TEST(ClearanceWithin, HoldsForCurves) {
  for (const double within : {0.5, 0.99, 1.01, 2.5}) expect_listed(row_of_bars(near_disc), within);
}

TEST(ClearanceWithin, TestsFewPairsOfManyBodies) {
  ClearanceOptions near;
  near.all_pairs = true;
  near.within = 60;
  EXPECT_EQ(clearance(row_of_bars(far_square), near).coverage.apart, 6u);
}

TEST(ClearanceWithin, IsADistanceOfListedPairs) {
  ClearanceOptions options;
  options.within = 1;
  EXPECT_THROW(clearance(row_of_bars(far_square), options), InputError);
  options.all_pairs = true;
  for (const double within : {0.0, -1.0, std::nan("")}) {
    options.within = within;
    EXPECT_THROW(clearance(row_of_bars(far_square), options), InputError) << within;
  }
}

}  // namespace
}  // namespace taut
