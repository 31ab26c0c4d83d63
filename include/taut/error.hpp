// Errors in what the user gave us.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace taut {

/// The parts of a polygon that are at fault, by index of the input, so that they can be marked in a picture.
struct Culprits {
  std::vector<int> vertices;
  std::vector<int> edges;  ///< edge j joins vertices j and j + 1 (modulo their number)
};

/// The input is not a scene that can be decided. Says what is wrong, where, and how to mend it.
/// `what()` is the whole message, on one line per sentence: "place: problem\nhint: remedy".
class InputError : public std::runtime_error {
 public:
  /// Place, problem, hint and culprits as the functions below give them back.
  InputError(std::string place, std::string problem, std::string hint = {}, Culprits culprits = {})
      : std::runtime_error(compose(place, problem, hint)),
        place_(std::move(place)),
        problem_(std::move(problem)),
        hint_(std::move(hint)),
        culprits_(std::move(culprits)) {}

  /// Where: a file with line and column, a JSON path, a body; possibly several, separated by ": ". May be empty.
  const std::string& place() const { return place_; }
  /// What is wrong, with the culprits.
  const std::string& problem() const { return problem_; }
  /// What to do about it; may be empty.
  const std::string& hint() const { return hint_; }
  /// The vertices and edges that problem() names, where it names any: of the body whose name ends place().
  const Culprits& culprits() const { return culprits_; }

  /// The same error, seen from further out: `outer` (a file name, say) is put before the place.
  InputError within(const std::string& outer) const {
    return InputError(place_.empty() ? outer : outer + ": " + place_, problem_, hint_, culprits_);
  }

 private:
  static std::string compose(const std::string& place, const std::string& problem, const std::string& hint) {
    std::string s = place.empty() ? problem : place + ": " + problem;
    if (!hint.empty()) s += "\nhint: " + hint;
    return s;
  }
  std::string place_, problem_, hint_;
  Culprits culprits_;
};

}  // namespace taut
