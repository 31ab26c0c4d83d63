// Verdicts on answers from samples, against the certified contact.
#include "peers/verdict.hpp"

#include <gtest/gtest.h>

namespace taut::bench {
namespace {

const std::vector<double> times{0, 1, 2, 3, 4};
const std::optional<TimeInterval> none;
constexpr std::optional<std::size_t> no_hit;

TEST(Verdict, OfSamples) {
  const std::optional<TimeInterval> contact = TimeInterval{1.5, 1.5};
  EXPECT_EQ(verdict_of_samples(contact, times, 0), Verdict::early);
  EXPECT_EQ(verdict_of_samples(contact, times, 1), Verdict::early);
  EXPECT_EQ(verdict_of_samples(contact, times, 2), Verdict::right);
  EXPECT_EQ(verdict_of_samples(contact, times, 3), Verdict::late);
  EXPECT_EQ(verdict_of_samples(contact, times, 4), Verdict::late);
  EXPECT_EQ(verdict_of_samples(contact, times, no_hit), Verdict::missed);
  EXPECT_EQ(verdict_of_samples(none, times, no_hit), Verdict::right);
  EXPECT_EQ(verdict_of_samples(none, times, 0), Verdict::false_alarm);
  EXPECT_EQ(verdict_of_samples(none, times, 4), Verdict::false_alarm);
}

TEST(Verdict, OfSamplesAtTheContactItself) {
  const std::optional<TimeInterval> contact = TimeInterval{2, 2}, start = TimeInterval{0, 0};
  EXPECT_EQ(verdict_of_samples(contact, times, 1), Verdict::early);
  // Bodies that touch may count as overlapping or not.
  EXPECT_EQ(verdict_of_samples(contact, times, 2), Verdict::right);
  EXPECT_EQ(verdict_of_samples(contact, times, 3), Verdict::right);
  EXPECT_EQ(verdict_of_samples(contact, times, 4), Verdict::late);
  EXPECT_EQ(verdict_of_samples(start, times, 0), Verdict::right);
  EXPECT_EQ(verdict_of_samples(start, times, 1), Verdict::right);
  EXPECT_EQ(verdict_of_samples(start, times, 2), Verdict::late);
}

TEST(Verdict, OfATime) {
  const std::optional<TimeInterval> contact = TimeInterval{1.5, 1.5};
  EXPECT_EQ(verdict_of_time(contact, 1.25, 0.125), Verdict::early);
  EXPECT_EQ(verdict_of_time(contact, 1.375, 0.125), Verdict::right);
  EXPECT_EQ(verdict_of_time(contact, 1.625, 0.125), Verdict::right);
  EXPECT_EQ(verdict_of_time(contact, 1.75, 0.125), Verdict::late);
  EXPECT_EQ(verdict_of_time(contact, std::nullopt, 0.125), Verdict::missed);
  EXPECT_EQ(verdict_of_time(none, 1.0, 0.125), Verdict::false_alarm);
  EXPECT_EQ(verdict_of_time(none, std::nullopt, 0.125), Verdict::right);
}

TEST(Verdict, Texts) {
  EXPECT_STREQ(to_string(Verdict::right), "right");
  EXPECT_STREQ(to_string(Verdict::early), "early");
  EXPECT_STREQ(to_string(Verdict::late), "late");
  EXPECT_STREQ(to_string(Verdict::missed), "missed");
  EXPECT_STREQ(to_string(Verdict::false_alarm), "false alarm");
}

}  // namespace
}  // namespace taut::bench
