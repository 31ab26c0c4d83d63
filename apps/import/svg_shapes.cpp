#include "import/svg_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "import/rounded_rectangle.hpp"
#include "import/svg_path.hpp"
#include "taut/error.hpp"

namespace taut::drawing {

namespace {

class SvgShape {
 public:
  SvgShape(const XmlElement& element, const Viewport& viewport, const Affine& where, Flattener& flattener)
      : element_(element), viewport_(viewport), where_(where), flattener_(flattener) {}

  std::vector<Chain> chains() {
    const std::string& name = element_.name;
    if (name == "path") return read_path(element_, where_, flattener_);
    if (name == "rect") return rectangle();
    if (name == "polygon" || name == "polyline") return corners();
    if (name == "line") return line();
    return ellipse(name == "circle");
  }

 private:
  double length(const char* key, double otherwise = 0) const {
    return user_length(element_, key, viewport_, otherwise);
  }

  std::vector<Chain> line() const {
    const Point a{length("x1"), length("y1")}, b{length("x2"), length("y2")};
    if (a == b) return {};
    return {{{where_(a), where_(b)}, false, element_.place}};
  }

  std::vector<Chain> ellipse(bool circle) {
    double rx = length(circle ? "r" : "rx", -1), ry = circle ? rx : length("ry", -1);
    // An axis that is not given, or is "auto", is as long as the other one.
    if (rx < 0) rx = ry;
    if (ry < 0) ry = rx;
    if (!(rx > 0 && ry > 0)) return {};
    Chain chain{{}, true, element_.place};
    flattener_.ellipse(chain.points, where_({length("cx"), length("cy")}), where_.turn({rx, 0}), where_.turn({0, ry}));
    return {chain};
  }

  std::vector<Chain> rectangle() {
    const double x = length("x"), y = length("y"), width = length("width"), height = length("height");
    if (!(width > 0 && height > 0)) return {};
    double rx = length("rx", -1), ry = length("ry", -1);
    if (rx < 0) rx = std::max(ry, 0.0);
    if (ry < 0) ry = rx;
    rx = std::min(rx, width / 2);
    ry = std::min(ry, height / 2);
    return {rounded_rectangle({x, y}, {x + width, y + height}, rx, ry, where_, element_.place, flattener_)};
  }

  std::vector<Chain> corners() const {
    const std::string* text = element_.find("points");
    if (!text) return {};
    NumberScanner scanner(*text);
    Chain chain{{}, element_.name == "polygon", element_.place};
    while (!scanner.at_end()) {
      const auto x = scanner.number(), y = scanner.number();
      if (!x || !y) {
        throw InputError(element_.place,
                         "points=\"...\" has something else than pairs of numbers, at character " +
                             std::to_string(scanner.position() + 1),
                         "write points=\"x,y x,y ...\"");
      }
      chain.points.push_back(where_({*x, *y}));
    }
    if (chain.points.size() < 2) return {};
    return {chain};
  }

  const XmlElement& element_;
  const Viewport& viewport_;
  const Affine& where_;
  Flattener& flattener_;
};

}  // namespace

bool has_unknown_size(const XmlElement& shape, const Viewport& viewport) {
  static const std::map<std::string, std::vector<const char*>> lengths{
      {"rect", {"x", "y", "width", "height", "rx", "ry"}},
      {"circle", {"cx", "cy", "r"}},
      {"ellipse", {"cx", "cy", "rx", "ry"}},
      {"line", {"x1", "y1", "x2", "y2"}}};
  const auto keys = lengths.find(shape.name);
  if (keys == lengths.end()) return false;
  for (const char* key : keys->second)
    if (std::isnan(user_length(shape, key, viewport, 0))) return true;
  return false;
}

std::vector<Chain> svg_shape(const XmlElement& shape, const Viewport& viewport, const Affine& where,
                             Flattener& flattener) {
  return SvgShape(shape, viewport, where, flattener).chains();
}

}  // namespace taut::drawing
