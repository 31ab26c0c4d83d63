#include "watched_run.hpp"

#include "interrupt.hpp"

namespace taut::cli {

void add_run(const Command& command, SceneSource& scene, CheckOptions& options) {
  add_scene(command, scene);
  add_at_rest(command, scene.at_rest);
  add_touch(command, options.touch);
  add_limits(command, options);
}

Answer watched_run(const Scene& scene, const std::string& path, CheckOptions options,
                   const std::function<Answer(const Scene&, const CheckOptions&)>& run) {
  options.limits.stop = stop_on_signals();
  return watched(scene, path, [&] { return run(scene, options); });
}

}  // namespace taut::cli
