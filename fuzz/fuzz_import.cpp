// Any bytes are a drawing or an InputError, in each of the formats; the bodies of a drawing are valid.
#include "import/import.hpp"
#include "io/text.hpp"
#include "require.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/validate.hpp"

using namespace taut;
using namespace taut::internal;

namespace {

drawing::ImportSettings few() {
  drawing::ImportSettings settings;
  settings.max_points = 2000;
  settings.join = 0.01;
  return settings;
}

void look(const std::string& text, const char* name) {
  try {
    const drawing::Import import = drawing::import_drawings({drawing::read_drawing(text, name, few())}, few());
    fuzz::require(!import.scene.bodies.empty(), "a scene without bodies");
    for (const Body& body : import.scene.bodies) {
      if (!body.polygon.empty()) validate_polygon(body.polygon, body.name);
      for (const Part& part : body.parts) validate_polygon(part.outline, body.name);
    }
    const Scene again = parse_scene(write_scene(import.scene));
    fuzz::require(again.bodies.size() == import.scene.bodies.size(), "the scene changes as text");
    report_json(import, few());
    report_text(import, few());
    report_svg(import);
  } catch (const InputError& error) {
    fuzz::require(!error.problem().empty(), "an error that says nothing");
    fuzz::require(!error.hint().empty(), "an error without a remedy: " + error.problem());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  look(text, "drawing.svg");
  look(text, "drawing.dxf");
  look(text, "drawing.kicad_pcb");
  look(text, "drawing.wkt");
  look(text, "drawing.geojson");
  return 0;
}
