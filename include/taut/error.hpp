// Everything that taut throws on purpose.
//
//   Error                   catch this to catch all of them
//     InputError            the input is not a scene that can be decided (exit code 2 of the command)
//     ProofError            a log does not prove what it claims
//     UndecidedError        precision, or a limit, does not suffice (exit code 3)
//     UnusableError         a simulation that an exception left in the middle of an event
//     InternalError         a defect of taut (exit code 4)
//       StructureError      a data structure is not what it must be
//       EngineDisagreement  the two engines contradict each other
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "taut/feature.hpp"

namespace taut {

struct Answer;

/// The base of all errors that taut throws. Besides them only the standard library's may come out, such as
/// std::bad_alloc, and those of your own Tracer.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The parts of a polygon that are at fault, so that they can be marked in a picture.
struct Culprits {
  std::vector<VertexRef> vertices;
  std::vector<EdgeRef> edges;
};

/// The input is not a scene that can be decided. Says what is wrong, where, and how to mend it.
/// `what()` is the whole message, on one line per sentence: "place: problem\nhint: remedy".
class InputError : public Error {
 public:
  /// Place, problem, hint and culprits as the functions below give them back.
  InputError(std::string place, std::string problem, std::string hint = {}, Culprits culprits = {})
      : Error(compose(place, problem, hint)),
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
  /// The vertices and edges that problem() names, where it names any: of the body whose name ends place(). For a
  /// polygon that was validated by itself, body 0.
  const Culprits& culprits() const { return culprits_; }

  /// The same error, seen from further out: `outer` (a file name, say) is put before the place.
  InputError within(const std::string& outer) const {
    return InputError(place_.empty() ? outer : outer + ": " + place_, problem_, hint_, culprits_);
  }
  /// The same error about a polygon of this body.
  InputError about(BodyId body) const {
    Culprits culprits = culprits_;
    for (VertexRef& v : culprits.vertices) v.body = body;
    for (EdgeRef& e : culprits.edges) e.body = body;
    return InputError(place_, problem_, hint_, std::move(culprits));
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

/// The log does not prove what it claims, or belongs to another scene.
class ProofError : public Error {
 public:
  using Error::Error;
};

/// A sign that even the highest precision does not decide, or a limit that was reached, where there is no answer to say
/// so in: check(), prove() and Simulation say it as an outcome or a state.
class UndecidedError : public Error {
 public:
  using Error::Error;
};

/// A simulation was asked after an exception came out of the middle of an event; see Simulation.
class UnusableError : public Error {
 public:
  UnusableError()
      : Error(
            "the simulation was left in the middle of an event by an exception, from a Tracer, say: "
            "make a new one") {}
};

/// A defect of taut, noticed before it became an answer. Please report it, together with the scene.
class InternalError : public Error {
 public:
  using Error::Error;
};

/// A data structure is not what it must be: a broken invariant.
class StructureError : public InternalError {
 public:
  using InternalError::InternalError;
};

/// The two engines contradict each other: one of them is wrong.
class EngineDisagreement : public InternalError {
 public:
  /// What they disagree about, and the answers of the kinetic and of the spacetime engine.
  EngineDisagreement(const std::string& what, const Answer& kinetic, const Answer& spacetime);
  /// What the kinetic engine says.
  const Answer& kinetic() const { return *kinetic_; }
  /// What the spacetime engine says.
  const Answer& spacetime() const { return *spacetime_; }

 private:
  std::shared_ptr<const Answer> kinetic_, spacetime_;
};

}  // namespace taut
