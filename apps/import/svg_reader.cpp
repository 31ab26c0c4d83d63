#include "import/svg_reader.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "import/svg_path.hpp"
#include "import/svg_values.hpp"
#include "io/number_text.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::drawing {

namespace {

/// What an element hands down to those inside it.
struct Surroundings {
  Affine where;
  bool filled = true, visible = true;
  Fill fill = Fill::nonzero;
  int layer = -1;
};

class SvgReader {
 public:
  SvgReader(const std::string& text, const std::string& file, const ImportSettings& settings)
      : xml_(text, file), settings_(settings), flattener_(settings, file) {
    drawing_.file = file;
    drawing_.format = "SVG";
  }

  Drawing read() {
    for (;;) {
      const XmlReader::Event event = xml_.next();
      if (event == XmlReader::Event::end) break;
      if (event == XmlReader::Event::open)
        open(xml_.element());
      else if (ignored_ > 0)
        --ignored_;
      else
        stack_.pop_back();
    }
    if (!rooted_) throw InputError(drawing_.file, "there is no <svg> element", "give an SVG drawing");
    drawing_.curves = flattener_.counts();
    return std::move(drawing_);
  }

 private:
  void open(const XmlElement& element) {
    if (ignored_ > 0) {
      ++ignored_;
    } else if (stack_.empty()) {
      open_root(element);
    } else if (element.name == "g" || element.name == "a" || element.name == "switch") {
      stack_.push_back(inside(element, true));
    } else if (is_shape(element.name)) {
      stack_.push_back(inside(element, false));
      read_shape(element);
    } else {
      pass_over(element);
      ++ignored_;
    }
  }

  void open_root(const XmlElement& element) {
    if (rooted_ || element.name != "svg")
      throw InputError(element.place,
                       "the document is not an SVG drawing: its element is <" + io::excerpt(element.name) + ">",
                       "give an SVG drawing, or WKT, GeoJSON or DXF with its usual file ending");
    rooted_ = true;
    Surroundings root;
    const double unit = unit_of(element) * settings_.scale;
    root.where = scaling(unit, -unit);
    stack_.push_back(root);
    if (element.find("transform")) stack_.back().where = root.where * parse_transform(element);
  }

  /// How long a unit of the drawing is in millimetres, where the document says so; otherwise 1.
  double unit_of(const XmlElement& root) {
    const std::string* width = root.find("width");
    const std::string* box = root.find("viewBox");
    const auto length = width ? parse_length(*width) : std::nullopt;
    const auto millimetre = length ? millimetres(length->unit) : std::nullopt;
    double across = 0;
    if (box) {
      NumberScanner scanner(*box);
      scanner.number();
      scanner.number();
      across = scanner.number().value_or(0);
      if (!(across > 0))
        throw InputError(root.place, "viewBox=\"" + io::excerpt(*box) + "\" is not x, y, width and height",
                         "write four numbers, the last two above 0");
    }
    if (!millimetre || !(length->value > 0)) {
      drawing_.units = "the drawing's own";
      return 1;
    }
    const double unit = box ? length->value * *millimetre / across : 25.4 / 96;
    drawing_.units = "mm (" + io::number_text(unit) + " mm for each of the drawing's own)";
    return unit;
  }

  Surroundings inside(const XmlElement& element, bool group) {
    Surroundings s = stack_.back();
    s.where = s.where * parse_transform(element);
    const std::string fill = style_property(element, "fill"), rule = style_property(element, "fill-rule");
    if (!fill.empty() && fill != "inherit") s.filled = fill != "none" && fill != "transparent";
    if (!rule.empty() && rule != "inherit") s.fill = rule == "evenodd" ? Fill::even_odd : Fill::nonzero;
    const std::string visibility = style_property(element, "visibility");
    if (style_property(element, "display") == "none" || visibility == "hidden") s.visible = false;
    if (s.layer < 0) {
      s.layer = static_cast<int>(drawing_.layers.size());
      drawing_.layers.push_back({name_of(element, group), {}});
    }
    return s;
  }

  static std::string name_of(const XmlElement& element, bool group) {
    const std::string* label = group ? element.find("inkscape:label") : nullptr;
    if (!label || label->empty()) label = element.find("id");
    return label ? *label : "";
  }

  static bool is_shape(const std::string& name) {
    for (const char* known : {"path", "rect", "circle", "ellipse", "polygon", "polyline", "line"})
      if (name == known) return true;
    return false;
  }

  void read_shape(const XmlElement& element) {
    const Surroundings& s = stack_.back();
    if (!s.visible) return drawing_.skip(element.place, "<" + element.name + ">", "is not visible");
    std::vector<Chain> chains = chains_of(element, s.where);
    if (chains.empty()) return drawing_.skip(element.place, "<" + element.name + ">", "has no extent");
    Layer& layer = drawing_.layers[static_cast<std::size_t>(s.layer)];
    const bool filled = s.filled && element.name != "line";
    if (filled) {
      // What is filled is closed.
      for (Chain& chain : chains) chain.closed = true;
      layer.sheets.push_back({name_of(element, false), s.fill, std::move(chains)});
      return;
    }
    auto lines = std::find_if(layer.sheets.begin(), layer.sheets.end(), [](const Sheet& x) { return x.lines; });
    if (lines == layer.sheets.end()) lines = layer.sheets.insert(lines, Sheet{"", Fill::even_odd, {}, true});
    for (Chain& chain : chains) lines->chains.push_back(std::move(chain));
  }

  std::vector<Chain> chains_of(const XmlElement& e, const Affine& where) {
    if (e.name == "path") return read_path(e, where, flattener_);
    if (e.name == "rect") return rectangle(e, where);
    if (e.name == "polygon" || e.name == "polyline") return points_of(e, where);
    const auto length = [&e](const char* key) { return user_length(e, key, 0); };
    if (e.name == "line") {
      const Point a{length("x1"), length("y1")}, b{length("x2"), length("y2")};
      if (a == b) return {};
      return {{{where(a), where(b)}, false, e.place}};
    }
    const bool circle = e.name == "circle";
    const double rx = length(circle ? "r" : "rx"), ry = length(circle ? "r" : "ry");
    if (!(rx > 0 && ry > 0)) return {};
    Chain chain{{}, true, e.place};
    flattener_.ellipse(chain.points, where({length("cx"), length("cy")}), where.turn({rx, 0}), where.turn({0, ry}));
    return {chain};
  }

  std::vector<Chain> rectangle(const XmlElement& e, const Affine& where) {
    const double x = user_length(e, "x", 0), y = user_length(e, "y", 0);
    const double width = user_length(e, "width", 0), height = user_length(e, "height", 0);
    if (!(width > 0 && height > 0)) return {};
    double rx = user_length(e, "rx", -1), ry = user_length(e, "ry", -1);
    if (rx < 0) rx = std::max(ry, 0.0);
    if (ry < 0) ry = rx;
    rx = std::min(rx, width / 2);
    ry = std::min(ry, height / 2);
    Chain chain{{}, true, e.place};
    const auto corner = [&](double cx, double cy, int quarter) {
      if (rx == 0 || ry == 0) return chain.points.push_back(where({cx, cy}));
      const Affine turn = rotation(90 * quarter);
      // From the quarter's first axis to the next one.
      const Point a{turn.a * rx, turn.b * ry}, b{turn.c * rx, turn.d * ry};
      const Point middle{cx - a.x - b.x, cy - a.y - b.y};
      chain.points.push_back(where({middle.x + a.x, middle.y + a.y}));
      flattener_.arc(chain.points, where(middle), where.turn(a), where.turn(b), 0, 3.14159265358979323846 / 2,
                     where({middle.x + b.x, middle.y + b.y}));
    };
    corner(x + width, y + height, 0);
    corner(x, y + height, 1);
    corner(x, y, 2);
    corner(x + width, y, 3);
    return {chain};
  }

  std::vector<Chain> points_of(const XmlElement& e, const Affine& where) const {
    const std::string* text = e.find("points");
    if (!text) return {};
    NumberScanner scanner(*text);
    Chain chain{{}, e.name == "polygon", e.place};
    while (!scanner.at_end()) {
      const auto x = scanner.number(), y = scanner.number();
      if (!x || !y) {
        throw InputError(e.place,
                         "points=\"...\" has something else than pairs of numbers, at character " +
                             std::to_string(scanner.position() + 1),
                         "write points=\"x,y x,y ...\"");
      }
      chain.points.push_back(where({*x, *y}));
    }
    if (chain.points.size() < 2) return {};
    return {chain};
  }

  /// What describes the drawing, or is of its program, is no part of it; other elements are told.
  void pass_over(const XmlElement& element) {
    static const std::set<std::string> described{"title", "desc", "metadata"};
    if (described.count(element.name) || element.name.find(':') != std::string::npos) return;
    const std::string what = "<" + io::excerpt(element.name, 30) + ">";
    if (element.name == "defs" || element.name == "symbol" || element.name == "clipPath" || element.name == "mask")
      return drawing_.skip(element.place, what, "is not drawn where it stands");
    if (element.name == "use")
      return drawing_.skip(element.place, what, "is a clone: unlink it in the program that drew it");
    if (element.name == "text")
      return drawing_.skip(element.place, what, "is text: turn it into paths if it is to be part of a body");
    if (element.name == "style") return drawing_.skip(element.place, what, "style sheets are not read");
    if (element.name == "svg") return drawing_.skip(element.place, what, "is a drawing in the drawing: ungroup it");
    drawing_.skip(element.place, what, "is no path or basic shape");
  }

  XmlReader xml_;
  ImportSettings settings_;
  Flattener flattener_;
  Drawing drawing_;
  std::vector<Surroundings> stack_;
  int ignored_ = 0;
  bool rooted_ = false;
};

}  // namespace

Drawing read_svg(const std::string& text, const std::string& file, const ImportSettings& settings) {
  return SvgReader(text, file, settings).read();
}

}  // namespace taut::drawing
