#include "import/drawing.hpp"

namespace taut::drawing {

Layer& Drawing::layer(const std::string& name) {
  for (Layer& known : layers)
    if (known.name == name) return known;
  layers.push_back({name, {}});
  return layers.back();
}

void Drawing::skip(const std::string& place, const std::string& what, const std::string& reason) {
  for (Skipped& known : skipped) {
    if (known.what != what || known.reason != reason) continue;
    ++known.times;
    return;
  }
  skipped.push_back({place, what, reason});
}

}  // namespace taut::drawing
