// Two answers that must not differ in anything that is not time.
#pragma once

#include <gtest/gtest.h>

#include "taut/check.hpp"

namespace taut::testing {

inline void expect_same_answer(const Answer& a, const Answer& b) {
  ASSERT_EQ(a.outcome, b.outcome) << a.reason << b.reason;
  EXPECT_EQ(a.events, b.events);
  EXPECT_EQ(a.certificates_initial, b.certificates_initial);
  EXPECT_EQ(a.certificates_max, b.certificates_max);
  EXPECT_EQ(a.free_until, b.free_until);
  ASSERT_EQ(a.contact.has_value(), b.contact.has_value());
  if (!a.contact) return;
  EXPECT_EQ(a.contact->time.lo, b.contact->time.lo);
  EXPECT_EQ(a.contact->time.hi, b.contact->time.hi);
  EXPECT_EQ(a.contact->vertex, b.contact->vertex);
  EXPECT_EQ(a.contact->edge, b.contact->edge);
}

}  // namespace taut::testing
