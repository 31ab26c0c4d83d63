#include "import/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace taut::drawing {

Layer& Drawing::layer(const std::string& name) {
  for (Layer& known : layers)
    if (known.name == name) return known;
  layers.push_back({name, {}});
  return layers.back();
}

void Drawing::skip(Skipped more) {
  for (Skipped& known : skipped) {
    if (known.what != more.what || known.reason != more.reason || known.layer != more.layer) continue;
    ++known.times;
    std::move(more.shapes.begin(), more.shapes.end(), std::back_inserter(known.shapes));
    return;
  }
  skipped.push_back(std::move(more));
}

Fineness fineness_of(const ImportSettings& settings, double millimetre, double diagonal) {
  // So many hundredths of a millimetre; for small drawings less, and for large ones more.
  const auto usual = [&](double hundredths) {
    const double length = hundredths * 0.01 * millimetre;
    return diagonal > 0 ? std::clamp(length, hundredths * 5e-6 * diagonal, hundredths * 1e-3 * diagonal) : length;
  };
  return {settings.tolerance.value_or(usual(1)), settings.join.value_or(usual(2)), settings.repair.value_or(usual(10))};
}

std::optional<double> unit_named(const std::string& name) {
  static const std::map<std::string, double> units{{"mm", 1},       {"cm", 10},        {"m", 1000},
                                                   {"um", 1e-3},    {"in", 25.4},      {"ft", 304.8},
                                                   {"mil", 0.0254}, {"pt", 25.4 / 72}, {"px", 25.4 / 96}};
  const auto unit = units.find(name);
  return unit == units.end() ? std::nullopt : std::optional(unit->second);
}

void Drawing::state_unit(const std::string& text, std::optional<double> millimetres, const ImportSettings& settings) {
  const bool given = !millimetres && !settings.unit.empty();
  units = given ? text + ", taken for " + settings.unit + " (--unit)" : text;
  unit = given ? unit_named(settings.unit) : millimetres;
  millimetre = settings.scale / unit.value_or(1);
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

double Drawing::diagonal() const {
  double lo_x = INFINITY, lo_y = INFINITY, hi_x = -INFINITY, hi_y = -INFINITY;
  const auto include = [&](const Point& p) {
    lo_x = std::min(lo_x, p.x);
    lo_y = std::min(lo_y, p.y);
    hi_x = std::max(hi_x, p.x);
    hi_y = std::max(hi_y, p.y);
  };
  for (const Layer& layer : layers) {
    for (const Sheet& sheet : layer.sheets) {
      for (const Chain& chain : sheet.chains) std::for_each(chain.points.begin(), chain.points.end(), include);
      for (const Part& part : sheet.parts) std::for_each(part.outline.begin(), part.outline.end(), include);
    }
  }
  const double diagonal = std::hypot(hi_x - lo_x, hi_y - lo_y);
  return lo_x <= hi_x && std::isfinite(diagonal) ? diagonal : 0;
}

}  // namespace taut::drawing
