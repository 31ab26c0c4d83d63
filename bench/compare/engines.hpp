// Who takes part in the comparison.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "compare/cases.hpp"

namespace taut::bench {

/// One way to answer a contest.
class Engine {
 public:
  virtual ~Engine() = default;
  /// Everything that is done once for a pair of shapes.
  virtual void set_up(const Contest& contest) = 0;
  /// The whole question, from where nothing but the shapes is known; says what was answered.
  virtual std::vector<Answer> run() = 0;
};

struct Column {
  const char* name;
  std::unique_ptr<Engine> (*make)();
};

const std::vector<Column>& columns();

/// What is wrong with the answers; empty if nothing.
std::string fault(const Contest& contest, const std::vector<Answer>& answers);

/// Why two engines' answers to one contest, neither at fault, cannot both be true; empty if they can.
std::string disagreement(const std::vector<Answer>& first, const std::vector<Answer>& second);

}  // namespace taut::bench
