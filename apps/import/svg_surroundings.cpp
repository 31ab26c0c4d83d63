#include "import/svg_surroundings.hpp"

#include "import/svg_transform.hpp"
#include "io/text_file.hpp"

namespace taut::drawing {
using namespace internal;

std::string svg_name_of(const XmlElement& element, bool group) {
  const std::string* label = group ? element.find("inkscape:label") : nullptr;
  if (!label || label->empty()) label = element.find("id");
  return label ? *label : "";
}

Surroundings SurroundingsReader::inside(std::size_t node, Surroundings s, bool group, const XmlElement* named) {
  const XmlElement& element = xml_.element(node);
  ElementStyle style = styles_.style_of(node);
  style.take_variables(s.variables);
  s.where = s.where * placement(node, style, s.viewport);
  paint(style, s);
  const std::string rule = style.word("fill-rule"), visibility = style.word("visibility");
  if (!rule.empty()) s.fill = rule == "evenodd" ? Fill::even_odd : Fill::nonzero;
  if (!visibility.empty()) s.hidden = visibility != "visible";
  // All within it goes with it.
  if (style.word("display") == "none" || style.is_zero("opacity")) s.displayed = false;
  // The page's own size is read elsewhere.
  if (node > 0) tell_what_is_not_read(element, style);
  clip(element, style, s);
  if (s.layer < 0) {
    s.layer = static_cast<int>(drawing_.layers.size());
    const std::string name = svg_name_of(element, group);
    drawing_.layers.push_back({name.empty() && named ? svg_name_of(*named, group) : name, {}});
  }
  return s;
}

/// A gradient or pattern that is not in the file leaves the colour that is written behind it, or nothing.
std::string SurroundingsReader::paint_of(const ElementStyle& style, const char* name) const {
  const std::string word = style.word(name);
  const std::size_t close = word.find(')');
  if (!word.starts_with("url(") || close == std::string::npos) return word;
  const std::string id = id_in_url(style.text(name).substr(0, close + 1));
  if (id.empty() || xml_.by_id(id)) return word;
  const std::string behind = trimmed_text(word.substr(close + 1));
  return behind.empty() ? "none" : behind;
}

/// Whether fillings and lines are to be seen.
void SurroundingsReader::paint(const ElementStyle& style, Surroundings& s) const {
  const std::string fill = paint_of(style, "fill"), stroke = paint_of(style, "stroke");
  if (!fill.empty()) s.filled = !is_see_through(fill);
  if (!stroke.empty()) s.stroked = !is_see_through(stroke);
  for (const char* paint : {"fill", "stroke"})
    if (!style.word(paint).empty() && style.word(paint) != "none") s.color = style.text(paint);
  if (!style.word("fill-opacity").empty()) s.clear_filling = style.is_zero("fill-opacity");
  if (!style.word("stroke-opacity").empty()) s.clear_line = style.is_zero("stroke-opacity");
  if (!style.word("stroke-width").empty()) s.no_width = style.is_zero("stroke-width");
}

void SurroundingsReader::tell_what_is_not_read(const XmlElement& element, const ElementStyle& style) {
  const std::string property = style.unread(element);
  if (!property.empty())
    drawing_.skip(lost_style(element.place, "\"" + io::excerpt(property, 40) + "\" in a style", "is not read",
                             "use an attribute, with a plain value"));
  for (const char* more : {"filter", "marker", "marker-start", "marker-mid", "marker-end"})
    if (!style.word(more).empty() && style.word(more) != "none")
      drawing_.skip(
          {element.place, "\"" + std::string(more) + "\"", "is not read: shapes are taken without it", "", "", true});
}

/// Of the page by its attribute alone: in styles it has another origin.
Affine SurroundingsReader::placement(std::size_t node, const ElementStyle& style, const Viewport& viewport) {
  const XmlElement& element = xml_.element(node);
  const Affine attribute = parse_transform(element);
  if (node == 0 && element.find("transform")) return attribute;
  std::string unread = "transform";
  const auto placed = placement_of(style, viewport, unread);
  if (node > 0 && placed) return *placed;
  if (!placed || placed->a != 1 || placed->b != 0 || placed->c != 0 || placed->d != 1)
    drawing_.skip(lost_style(element.place, "\"" + unread + "\"", "is not read",
                             "write the transform as a matrix, or apply it to the shapes"));
  return attribute;
}

/// What is clipped by a rectangle is in a frame. Other clips and masks are not obeyed.
void SurroundingsReader::clip(const XmlElement& element, const ElementStyle& style, Surroundings& s) {
  for (const char* cut : {"clip-path", "mask"}) {
    const std::string value = style.text(cut);
    if (value.empty() || style.word(cut) == "none") continue;
    const std::string name = "\"" + std::string(cut) + "\"", id = id_in_url(value);
    const auto target = id.empty() ? std::nullopt : xml_.by_id(id);
    if (!id.empty() && !target) {
      drawing_.skip({element.place, name, "refers to what is not in the file", "", "", true});
      continue;
    }
    const std::vector<Frame> frames =
        target ? clipping_frames(*target, xml_, styles_, s.where, s.viewport) : std::vector<Frame>();
    s.frames.insert(s.frames.end(), frames.begin(), frames.end());
    if (frames.empty())
      drawing_.skip(lost_style(element.place, name, "cuts by something else than one rectangle, and is not obeyed",
                               "cut the shapes in the program that drew them, or remove the clip"));
  }
}

}  // namespace taut::drawing
