#include "import/heights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/predicates.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

/// The number that is all of the text, or `none` if there is no text.
double height_in(const std::string& text, double none, const std::string& name, const char* option) {
  if (text.empty()) return none;
  std::size_t end = 0;
  const auto height = io::scan_number(text, &end);
  if (height && end == text.size() && in_range(*height)) return *height;
  throw InputError(option, fmt::format("\"{}\" is no height for layer \"{}\"", io::excerpt(text), io::excerpt(name)),
                   "give two numbers in the units of the scene, as --layer NAME=0:3");
}

Layers layers_in(const std::string& text, const std::string& name, const char* option) {
  const std::size_t colon = text.find(':');
  Layers z;
  z.lo = height_in(text.substr(0, colon), z.lo, name, option);
  z.hi = height_in(text.substr(colon + 1), z.hi, name, option);
  if (z.lo < z.hi) return z;
  throw InputError(option,
                   fmt::format("layer \"{}\" runs from {} to {}, and the first height is not below the second one",
                               io::excerpt(name), io::number_text(z.lo), io::number_text(z.hi)),
                   "give the lower height first, as --layer NAME=0:3");
}

}  // namespace

void choose_layer(ImportSettings& settings, const std::string& choice, const char* option) {
  const std::size_t sign = choice.rfind('=');
  const bool has_heights = sign != std::string::npos && choice.find(':', sign) != std::string::npos;
  settings.layers.push_back(choice.substr(0, has_heights ? sign : std::string::npos));
  if (!has_heights) return;
  const std::string& name = settings.layers.back();
  settings.heights.push_back({name, layers_in(choice.substr(sign + 1), name, option)});
}

std::vector<Level> take_levels(Drawing& drawing) {
  std::vector<Level> levels;
  const auto level_at = [&](const std::optional<Layers>& z) -> Level& {
    const auto known = std::find_if(levels.begin(), levels.end(), [&z](const Level& level) { return level.z == z; });
    if (known != levels.end()) return *known;
    levels.push_back({z, {}});
    Drawing& part = levels.back().drawing;
    part.file = drawing.file;
    part.format = drawing.format;
    part.nests = drawing.nests;
    for (const Layer& layer : drawing.layers) part.layers.push_back({layer.name, {}});
    return levels.back();
  };
  for (std::size_t k = 0; k < drawing.layers.size(); ++k) {
    for (Sheet& sheet : drawing.layers[k].sheets)
      level_at(sheet.z).drawing.layers[k].sheets.push_back(std::move(sheet));
    drawing.layers[k].sheets.clear();
  }
  if (levels.empty()) level_at(std::nullopt);
  return levels;
}

}  // namespace taut::drawing
