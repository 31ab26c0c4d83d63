#include "tiling/block_array.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/rng.hpp"

namespace taut::testing {
using namespace internal;
namespace {

using Array = BlockArray<std::uint32_t>;

/// What a block becomes when it is first touched.
void squares(std::size_t first, std::uint32_t* block) {
  for (std::size_t k = 0; k < Array::block_size; ++k) block[k] = static_cast<std::uint32_t>((first + k) * (first + k));
}

TEST(BlockArray, HasNothingBeforeItIsWritten) {
  Array array(100);
  EXPECT_GE(array.capacity(), 100u);
  for (std::size_t i = 0; i < array.capacity(); ++i) {
    EXPECT_FALSE(array.has(i));
    EXPECT_EQ(array.get(i), 0u);
  }
  array.for_each_block([](std::size_t, std::size_t) { ADD_FAILURE() << "a block without being touched"; });
  array.touch(37) = 5;
  EXPECT_EQ(array.get(37), 5u);
  EXPECT_EQ(array.get(36), 0u);
  EXPECT_TRUE(array.has(32));
  EXPECT_FALSE(array.has(31));
  EXPECT_FALSE(array.has(48));
}

TEST(BlockArray, BlocksAreMadeOnce) {
  Array array(200);
  int made = 0;
  const auto make = [&made](std::size_t first, std::uint32_t* block) {
    squares(first, block);
    ++made;
  };
  EXPECT_EQ(array.touch(50, make), 2500u);
  array.touch(50, make) = 7;
  EXPECT_EQ(array.touch(51, make), 2601u);
  EXPECT_EQ(array[50], 7u);
  EXPECT_EQ(made, 1);
  array.touch(199, make);
  EXPECT_EQ(made, 2);
  std::vector<std::size_t> blocks;
  array.for_each_block([&blocks](std::size_t begin, std::size_t end) {
    blocks.push_back(begin);
    EXPECT_EQ(end, begin + Array::block_size);
  });
  EXPECT_EQ(blocks, (std::vector<std::size_t>{48, 192}));
}

TEST(BlockArray, FollowsAVectorThroughCopiesAndGrowth) {
  Rng rng(5);
  Array array(64);
  std::vector<std::uint32_t> model(64, 0);
  for (int step = 0; step < 20000; ++step) {
    const auto i = static_cast<std::size_t>(rng.below(static_cast<int>(model.size())));
    const int what = rng.below(1000);
    if (what == 0 && model.size() < 5000) {
      array.grow(model.size() + 100);
      model.resize(array.capacity(), 0);
    } else if (what < 3) {
      Array copy = array;
      copy.touch(i) = 12345;
      EXPECT_EQ(array.get(i), model[i]) << "a copy is the same array";
      copy = array;
      array = std::move(copy);
    } else if (what < 500) {
      array.touch(i) = model[i] = static_cast<std::uint32_t>(step);
    } else {
      ASSERT_EQ(array.get(i), model[i]) << "at " << i << " in step " << step;
    }
  }
  EXPECT_GT(model.size(), 1000u);
}

}  // namespace
}  // namespace taut::testing
