#include "watched_run.hpp"

#include "interrupt.hpp"
#include "progress.hpp"

namespace taut::cli {

void add_run(const Command& command, SceneSource& scene, CheckOptions& options) {
  add_scene(command, scene);
  add_at_rest(command, scene.at_rest);
  add_touch(command, options.touch);
  add_limits(command, options);
}

Answer watched_run(const Scene& scene, const std::string& path, CheckOptions options,
                   const std::function<Answer(const Scene&, const CheckOptions&)>& run) {
  Progress progress(scene);  // wiped when this function ends, however it does
  if (!options.tracer) options.tracer = &progress;
  options.limits.stop = stop_on_signals();
  return within_file(path, [&] { return run(scene, options); });
}

}  // namespace taut::cli
