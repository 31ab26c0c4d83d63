// Which ends of lines are joined: distances that are too large, and short lines between others.
#include <gtest/gtest.h>

#include "support/drawings.hpp"

namespace taut {
namespace {

TEST(ImportJoin, SaysThatItIsLargerThanWhatIsDrawn) {
  testing::DxfText plate;
  plate.box({0, 0}, {30, 30}).box({10, 10}, {12, 12});
  const auto read = [&](double join) {
    drawing::ImportSettings settings;
    settings.join = join;
    return testing::examine(plate, settings);
  };
  EXPECT_TRUE(read(1).files[0].notes.empty());
  EXPECT_EQ(testing::totals_of(read(1)).holes, 1u);
  ASSERT_EQ(read(3).files[0].notes.size(), 1u);
  EXPECT_NE(read(3).files[0].notes[0].find("--join 3 is larger than 4 of 8 lines, the first one at d.dxf:"),
            std::string::npos);
  const drawing::Import all = read(1000);
  ASSERT_EQ(all.faults.size(), 1u);
  EXPECT_NE(all.faults[0].hint().find("smaller distance to --join"), std::string::npos);
}

/// A line no longer than the distance of joining, between a line that it crosses or touches and one whose end it nearly
/// meets, is no stub that goes beyond the first one.
TEST(ImportJoin, AShortLineLeadsFromOneLineToAnother) {
  const Point corner{-4.6654, 2.5321};
  for (const Point& start : {Point{-4.6574, 2.5359}, corner}) {
    testing::DxfText text;
    text.line({-7.1312, 0.6964}, {-4.68, 2.5177}).line(start, {-4.6817, 2.5273});
    text.line({-3.0471, 3.7466}, corner).line({-3.0471, 3.7466}, {0, 0}).line({0, 0}, {-7.1312, 0.6964});
    drawing::ImportSettings settings;
    settings.join = 0.02;
    testing::expect_totals(testing::examine(text, settings), 12.2956, 1, 0, 0.01);
  }
  // Lines that both go a little beyond their corner are cut back, also where the angle is acute.
  testing::DxfText acute;
  acute.line({0, 0}, {10.006, 0}).line({10.01, -0.005}, {0, 5}).line({0, 5}, {0, 0});
  testing::expect_totals(testing::examine(acute), 25, 1, 0, 0.05);
}

}  // namespace
}  // namespace taut
