// How long answers take, one by one.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "taut/scene.hpp"

namespace taut::testing {

/// Asks each question about scenes and remembers what took longest. The idea: a small scene that takes a hundred times
/// what its neighbours take is a defect, and only one question at a time shows it.
class QuestionTimes {
 public:
  /// Those that take longer than the limit, in seconds of processor time, are named.
  explicit QuestionTimes(double limit) : limit_(limit) {}

  /// By each engine alone and by both in turn, both ways of touching. Scenes that are not valid are counted.
  void ask_all(std::uint64_t number, const Scene& scene);
  QuestionTimes& operator+=(const QuestionTimes& o);
  std::string report() const;
  bool all_well() const { return slow_.empty() && undecided_.empty(); }

 private:
  double limit_;
  std::uint64_t questions_ = 0, invalid_ = 0;
  double sum_ = 0, most_ = 0;
  std::string slowest_;                        ///< the question that took most
  std::vector<std::string> slow_, undecided_;  ///< questions
};

}  // namespace taut::testing
