#include "problem.hpp"

#include "io/joint_reader.hpp"
#include "io/json_writer.hpp"
#include "taut/io.hpp"

namespace taut::web {
using namespace internal;

namespace {

void write_joints(io::JsonWriter& json, const PathProblem& problem) {
  json.array([&] {
    for (std::size_t k = 0; k < problem.linkage.joints.size(); ++k) {
      const Joint& joint = problem.linkage.joints[k];
      json.object([&] {
        json.member("name", joint.name);
        json.member("range", {joint.lo, joint.hi});
        json.member("periodic", static_cast<bool>(problem.periodic[k]));
      });
    }
  });
}

void write_goal(io::JsonWriter& json, const PathProblem& problem) {
  if (problem.goal_outside) {
    json.string("outside");
    return;
  }
  json.array([&] {
    for (std::size_t k = 0; k < problem.linkage.joints.size(); ++k) {
      if (const auto& range = problem.goal[k])
        json.numbers({(*range)[0], (*range)[1]});
      else
        json.raw("null");
    }
  });
}

}  // namespace

std::string problem_text(const PathProblem& problem) {
  return io::json_text([&](io::JsonWriter& json) {
    json.object([&] {
      write_joints(json.key("joints"), problem);
      json.key("start").array([&] {
        for (std::size_t k = 0; k < problem.linkage.joints.size(); ++k) json.number(problem.start[k]);
      });
      write_goal(json.key("goal"), problem);
      json.key("bodies").raw(io::linked_bodies_json(problem.linkage));
      json.key("scene").raw(write_scene(path_scene(problem, {problem.start, problem.start})));
    });
  });
}

std::string way_text(const PathProblem& problem, const PathOptions& options) {
  const PathAnswer answer = find_path(problem, options);
  const bool found = answer.outcome == PathOutcome::path;
  return "{\"answer\":" + path_json(problem, answer, options) +
         ",\"scene\":" + (found ? write_scene(path_scene(problem, answer.waypoints)) : std::string("null")) + "}";
}

}  // namespace taut::web
