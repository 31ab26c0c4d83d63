#include "import/svg_clip.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <set>

#include "import/svg_shapes.hpp"
#include "import/svg_transform.hpp"

namespace taut::drawing {
namespace {

struct OnlyShape {
  std::size_t node;
  std::optional<std::size_t> clone;  ///< the <use> by which it is there
};

/// The shape that a <use> stands for.
std::optional<std::size_t> cloned_shape(const XmlTree& xml, const XmlElement& use) {
  const std::string* link = use.find("href");
  if (!link) link = use.find("xlink:href");
  if (!link || !link->starts_with('#')) return std::nullopt;
  const auto target = xml.by_id(link->substr(1));
  return target && is_svg_shape(xml.element(*target).name) ? target : std::nullopt;
}

std::optional<OnlyShape> only_shape_in(const XmlTree& xml, std::size_t node) {
  std::optional<OnlyShape> only;
  for (std::size_t child = node + 1; child < xml.end(node); child = xml.end(child)) {
    const XmlElement& element = xml.element(child);
    if (element.name == "title" || element.name == "desc") continue;
    const bool clone = element.name == "use";
    const auto shape = clone ? cloned_shape(xml, element) : std::optional(child);
    if (only || !shape || !is_svg_shape(xml.element(*shape).name)) return std::nullopt;
    only = OnlyShape{*shape, clone ? std::optional(child) : std::nullopt};
  }
  return only;
}

/// Does a shape in a clip, or a mask, show what is behind it? What is dark in a mask hides.
bool shows_all(const ElementStyle& style, const XmlElement& shape, bool mask) {
  for (const char* hides : {"clip-path", "mask", "display", "visibility", "opacity", "fill-opacity"})
    if (!style.text(hides).empty() && style.word(hides) != "1") return false;
  if (!style.unread(shape).empty()) return false;
  static const std::set<std::string> bright{"white", "#fff", "#ffffff", "#d9d9d9"};
  return !mask || bright.count(style.word("fill"));
}

}  // namespace

std::vector<Point> corners_of(const Frame& frame) {
  return {frame.where({0, 0}), frame.where({1, 0}), frame.where({1, 1}), frame.where({0, 1})};
}

std::optional<Frame> frame_of(const std::vector<Chain>& chains) {
  if (chains.size() != 1) return std::nullopt;
  std::vector<Point> p = chains[0].points;
  if (p.size() == 5 && p[0] == p[4]) p.pop_back();
  if (p.size() != 4) return std::nullopt;
  const Point u{p[1].x - p[0].x, p[1].y - p[0].y}, v{p[3].x - p[0].x, p[3].y - p[0].y};
  const double size = std::hypot(u.x, u.y) + std::hypot(v.x, v.y);
  if (std::hypot(p[0].x + u.x + v.x - p[2].x, p[0].y + u.y + v.y - p[2].y) > 1e-9 * size) return std::nullopt;
  if (std::fabs(u.x * v.y - u.y * v.x) <= 1e-9 * size * size) return std::nullopt;
  return Frame{{u.x, u.y, v.x, v.y, p[0].x, p[0].y}, "", "remove the clip"};
}

Beyond beyond_frame(const std::vector<Chain>& chains, const Frame& frame) {
  const Affine& f = frame.where;
  const double area = f.a * f.d - f.b * f.c;
  double lo_x = INFINITY, lo_y = INFINITY, hi_x = -INFINITY, hi_y = -INFINITY;
  for (const Chain& chain : chains) {
    for (const Point& p : chain.points) {
      const double x = p.x - f.e, y = p.y - f.f;
      const double u = (x * f.d - y * f.c) / area, v = (y * f.a - x * f.b) / area;
      lo_x = std::min(lo_x, u);
      hi_x = std::max(hi_x, u);
      lo_y = std::min(lo_y, v);
      hi_y = std::max(hi_y, v);
    }
  }
  constexpr double rounding = 1e-6;
  if (lo_x >= -rounding && lo_y >= -rounding && hi_x <= 1 + rounding && hi_y <= 1 + rounding) return Beyond::nothing;
  return hi_x <= 0 || hi_y <= 0 || lo_x >= 1 || lo_y >= 1 ? Beyond::all : Beyond::part;
}

std::string id_in_url(const std::string& text) {
  std::string s;
  for (const char c : text)
    if (!std::isspace(static_cast<unsigned char>(c)) && c != '"' && c != '\'') s += c;
  return s.starts_with("url(#") && s.ends_with(")") ? s.substr(5, s.size() - 6) : "";
}

std::vector<Frame> clipping_frames(std::size_t node, const XmlTree& xml, const StyleSheet& styles, const Affine& where,
                                   const Viewport& viewport) {
  const XmlElement& clip = xml.element(node);
  const bool mask = clip.name == "mask";
  const auto says = [&clip](const char* key, const char* word) {
    const std::string* value = clip.find(key);
    return value && *value == word;
  };
  if ((!mask && clip.name != "clipPath") || clip.find("clip-path") || clip.find("mask") ||
      says(mask ? "maskContentUnits" : "clipPathUnits", "objectBoundingBox"))
    return {};
  const auto only = only_shape_in(xml, node);
  if (!only) return {};
  const XmlElement& shape = xml.element(only->node);
  if (!shows_all(styles.style_of(only->node), shape, mask) || has_unknown_size(shape, viewport)) return {};
  std::string unread;
  const auto own = placement_of(styles.style_of(node), viewport, unread);
  const auto inner = placement_of(styles.style_of(only->node), viewport, unread);
  if (!own || !inner) return {};
  Affine there = where * *own;
  if (only->clone) {
    const XmlElement& use = xml.element(*only->clone);
    const auto moved = placement_of(styles.style_of(*only->clone), viewport, unread);
    const double x = user_length(use, "x", viewport, 0), y = user_length(use, "y", viewport, 0);
    if (!moved || !std::isfinite(x + y) || !shows_all(styles.style_of(*only->clone), use, false)) return {};
    there = there * *moved * translation(x, y);
  }
  const ImportSettings settings;
  Flattener flattener(settings, 1e300, shape.place);
  auto frame = frame_of(svg_shape(shape, viewport, there * *inner, flattener));
  if (!frame || flattener.counts().segments > 0) return {};
  frame->place = shape.place;
  if (!mask || !says("maskUnits", "userSpaceOnUse")) return {*frame};
  const auto length = [&](const char* key) { return user_length(clip, key, viewport, NAN); };
  const double x = length("x"), y = length("y"), w = length("width"), h = length("height");
  if (!(w > 0 && h > 0 && std::isfinite(x + y))) return {};
  return {*frame, {there * translation(x, y) * scaling(w, h), clip.place, frame->remedy}};
}

}  // namespace taut::drawing
