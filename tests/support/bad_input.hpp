// Input that has to be refused, and what the refusal says.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "taut/error.hpp"

namespace taut::testing {

struct BadInput {
  std::string name, text;
  std::string place;    ///< all of it
  std::string problem;  ///< a part of it
  std::string hint;     ///< a part of it
};

inline void PrintTo(const BadInput& bad, std::ostream* out) { *out << bad.name; }
inline std::string name_of(const ::testing::TestParamInfo<BadInput>& bad) { return bad.param.name; }

/// `read` is given the text, and has to throw.
template <class Read>
void expect_refused(const BadInput& bad, const Read& read) {
  try {
    read(bad.text);
    FAIL() << "was accepted";
  } catch (const InputError& e) {
    EXPECT_EQ(e.place(), bad.place) << e.what();
    EXPECT_NE(e.problem().find(bad.problem), std::string::npos) << e.what();
    EXPECT_NE(e.hint().find(bad.hint), std::string::npos) << e.what();
    EXPECT_FALSE(e.hint().empty());
    EXPECT_LT(std::string(e.what()).size(), 700u);
  }
}

}  // namespace taut::testing
