// What check, prove and trace share: they run a scene, watched.
#pragma once

#include <functional>
#include <string>
#include "command_line/command_line.hpp"

#include "progress.hpp"
#include "scene_argument.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"

namespace taut::cli {

/// Adds SCENE, --allow-outside, --at-rest, --touch, --max-events and --max-seconds.
void add_run(const Command& command, SceneSource& scene, CheckOptions& options);

/// What `work` returns; an error in the scene is said to be in its file.
template <class Work>
auto within_file(const std::string& path, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw error.within(display_name(path));
  }
}

/// The same, and meanwhile a terminal shows how far it is.
template <class Work>
auto watched(const Scene& scene, const std::string& path, const Work& work) {
  const Progress progress(scene);
  return within_file(path, work);
}

/// What `run` answers. Ctrl-C ends it with an answer, and progress is shown on a terminal.
Answer watched_run(const Scene& scene, const std::string& path, CheckOptions options,
                   const std::function<Answer(const Scene&, const CheckOptions&)>& run);

}  // namespace taut::cli
