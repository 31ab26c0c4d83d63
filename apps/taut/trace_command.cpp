#include <memory>

#include "commands.hpp"
#include "geometry/prepared_shape.hpp"
#include "io/answer_writer.hpp"
#include "taut/check.hpp"
#include "taut/io.hpp"
#include "terminal.hpp"
#include "watched_run.hpp"

namespace taut::cli {
using namespace internal;

namespace {

/// One line an event, written at once, so that the lines before a crash or a kill are there.
class LineTracer : public Tracer {
 public:
  explicit LineTracer(const Scene& scene) : writer_(scene) {}
  void on_event(const TraceEvent& event) override { print_text(writer_.line(event) + "\n"); }

 private:
  io::TraceWriter writer_;
};

struct TraceArguments {
  SceneSource scene;
  CheckOptions options;
  bool json = false, allow_untested = false;
};

int run_trace(TraceArguments arguments) {
  const Scene scene = load_scene(arguments.scene);
  // Events would be those of polygons that are made on the way, run after run.
  within_file(arguments.scene.path, [&] {
    for (const Body& body : scene.bodies) refuse_curves(body);
    return true;
  });
  LineTracer tracer(scene);
  arguments.options.tracer = &tracer;
  arguments.options.engine = EngineChoice::kinetic;
  const Answer answer = watched_run(scene, arguments.scene.path, arguments.options, check);
  print_text(answer_json(scene, answer, arguments.options.touch) + "\n");
  return exit_code(answer.outcome, arguments.allow_untested);
}

}  // namespace

void add_trace(const Command& app, Action& action) {
  const Command command = app.add_command("trace", "Print one JSON line per event, then the answer");
  command.hide();  // of interest to those who follow the algorithm; `taut --help` is to fit a screen
  const auto arguments = std::make_shared<TraceArguments>();
  add_run(command, arguments->scene, arguments->options);
  add_allow_untested(command, arguments->allow_untested);
  command.add_flag("--json", arguments->json, "accepted for uniformity: the output is always JSON lines");
  command.footer(
      "Example:\n"
      "  taut trace scene.json | head\n"
      "\n"
      "A line has `event` (number), `t` (enclosure of the failure time), `repair` (convex_flip, convex_triangle,\n"
      "reflex_a, reflex_b, reflex_c, collision), `corner` (the three vertices), `flags`, `certificates` (active after\n"
      "the repair). The last line is the answer of `taut check --json`. Exit codes as for `taut check`.\n");
  command.on_chosen([&action, arguments] { action = [arguments] { return run_trace(*arguments); }; });
}

}  // namespace taut::cli
