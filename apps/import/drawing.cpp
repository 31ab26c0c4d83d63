#include "import/drawing.hpp"

#include <algorithm>

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

void Drawing::count_chorded(const Chorded& more) {
  for (Chorded& known : chorded) {
    if (known.what != more.what || known.layer != more.layer) continue;
    known.entities += more.entities;
    known.counts.segments += more.counts.segments;
    known.counts.chords += more.counts.chords;
    known.counts.deviation = std::max(known.counts.deviation, more.counts.deviation);
    return;
  }
  chorded.push_back(more);
}

}  // namespace taut::drawing
