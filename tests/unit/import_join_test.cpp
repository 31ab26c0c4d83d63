// Distances of joining that are too large.
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

}  // namespace
}  // namespace taut
