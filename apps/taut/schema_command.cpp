// taut schema: the scene format for editors and validators.
#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "scene_argument.hpp"
#include "scene_schema.hpp"

namespace taut::cli {

void add_schema(const Command& app, Action& action) {
  const Command command = app.add_command("schema", "Print the JSON Schema of the scene format");
  command.hide();  // not in `taut --help`, which is to fit a screen; its last line names it
  const auto output = std::make_shared<std::string>();
  command.add_option("-o,--output", *output, "write to FILE instead of standard output").value("FILE");
  command.footer(
      "Example:\n"
      "  taut schema -o taut-scene-1.schema.json\n"
      "\n"
      "Name the file in a scene, {\"$schema\":\"taut-scene-1.schema.json\",\"format\":...}, and editors complete its "
      "keys\n"
      "and mark what is wrong. The schema knows the shape of a scene, not its geometry: `taut check` says the "
      "rest.\n");
  command.on_chosen([&action, output] {
    action = [output] {
      write_output(*output, scene_schema);
      return static_cast<int>(exit_free);
    };
  });
}

}  // namespace taut::cli
