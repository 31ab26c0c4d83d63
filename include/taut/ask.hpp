// One question as text: what the command's `--json`, Python and npm have in common.
#pragma once

#include <string>
#include <vector>

#include "taut/check.hpp"
#include "taut/envelope.hpp"
#include "taut/limits.hpp"
#include "taut/path.hpp"
#include "taut/scene.hpp"

namespace taut {

/// A question by its name, and what comes with it.
struct Question {
  /// One of question_names().
  std::string name = {};
  /// A JSON object of options, by the names that the command line has: {"touch": "closed", "max_seconds": 5}. Which
  /// ones a question takes question_descriptions() says; the defaults are those of the command.
  std::string options = "{}";
  /// For "verify": the log.
  std::string log = {};
  /// Give up soon after this becomes true; may be null. Not owned.
  const std::atomic<bool>* stop = nullptr;
};

/// What ask() returns.
struct Reply {
  /// The answer, as the command prints it with `--json`: docs/answers.md.
  std::string json = {};
  /// Of "prove" and "prove_clearance": the log; empty where nothing is proved.
  std::string log = {};
  /// Of "prove" and "prove_clearance": the name of what the log speaks of, as `taut-verify` states it.
  std::string scene_sha256 = {};
};

/// "check", "clearance", "intervals", ..., in the order of the documentation.
std::vector<std::string> question_names();

/// All questions as a JSON array: each one's name, what it means, whether it is about a scene or a linkage, its options
/// with their types, defaults and meanings, whether a log goes in or comes out, and the name of its answer's type in
/// the npm package.
std::string question_descriptions();

/// What a question is about: "scene", "linkage", or "problem", which is a linkage with a start and a goal. Empty for a
/// name that no question has.
std::string asked_about(const std::string& name);

/// Answers a question about a scene. Throws InputError for a scene, a name or an option that is not valid, and
/// UndecidedError or InternalError as the question's own function does.
Reply ask(const Question& question, const Scene& scene);

/// The same about a linkage.
Reply ask(const Question& question, const Linkage& linkage);

/// The same about a linkage with a start and a goal.
Reply ask(const Question& question, const PathProblem& problem);

/// The same about what a text in the format taut-scene/1 says, read as the question needs it. `name` stands for the
/// text in messages, `folder` is where files are looked up that it names.
Reply ask_about_text(const Question& question, const std::string& text, const std::string& name = "scene",
                     const std::string& folder = ".");

}  // namespace taut
