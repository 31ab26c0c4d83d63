#include "import/svg_reader.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "import/svg_path.hpp"
#include "import/svg_styles.hpp"
#include "import/svg_values.hpp"
#include "import/xml_tree.hpp"
#include "io/number_text.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

/// No colour, or one that lets everything through: rgba(0, 0, 0, 0), #0000, #00000000.
bool is_see_through(const std::string& fill) {
  if (fill == "none" || fill == "transparent") return true;
  if (fill.starts_with('#')) {
    return (fill.size() == 5 && fill.back() == '0') || (fill.size() == 9 && fill.ends_with("00"));
  }
  if (!fill.starts_with("rgba(") && !fill.starts_with("hsla(")) return false;
  const std::string alpha = fill.substr(fill.find_last_of(",/") + 1);
  return !alpha.empty() && alpha.find_first_not_of(" 0.%)") == std::string::npos &&
         alpha.find('0') != std::string::npos;
}

constexpr int deepest_clone = 16;
constexpr std::size_t most_cloned = 1000000;

/// What an element hands down to those inside it.
struct Surroundings {
  Affine where;
  bool filled = true, displayed = true, hidden = false;
  std::string color;  ///< of the line, or else of the filling
  Fill fill = Fill::nonzero;
  int layer = -1;
  int clones = 0;  ///< how many <use> it is within
};

class SvgReader {
 public:
  SvgReader(const XmlTree& xml, const std::string& file, const ImportSettings& settings, double tolerance)
      : xml_(xml), settings_(settings), flattener_(settings, tolerance, file) {
    drawing_.file = file;
    drawing_.format = "SVG";
  }

  Drawing read() {
    open_root();
    for (const auto& [node, css] : xml_.style_texts()) styles_.read(css, xml_.element(node), drawing_);
    while (!open_.empty()) {
      Level& level = open_.back();
      if (level.next == level.end) {
        open_.pop_back();
        continue;
      }
      const std::size_t node = level.next;
      level.next = xml_.end(node);
      if (level.around.clones > 0 && ++cloned_ > most_cloned)
        throw InputError(xml_.element(node).place, "clones within clones make more than 1000000 elements",
                         "unlink the clones that are wanted");
      open(node);
    }
    tell_what_is_not_drawn();
    drawing_.curves = flattener_.counts();
    drawing_.kept = flattener_.take_kept();
    return std::move(drawing_);
  }

 private:
  /// Elements whose turn comes, and what surrounds them.
  struct Level {
    std::size_t next, end;
    Surroundings around;
  };

  void open(std::size_t node) {
    const XmlElement& element = xml_.element(node);
    if (element.name == "g" || element.name == "a" || element.name == "switch") {
      open_.push_back({node + 1, xml_.end(node), inside(element, true)});
    } else if (is_shape(element.name)) {
      read_shape(element, inside(element, false));
    } else if (element.name == "use") {
      open_clone(element);
    } else if (element.name == "defs" || element.name == "symbol") {
      definitions_.push_back(node);
    } else {
      pass_over(element);
    }
  }

  void open_root() {
    if (xml_.size() == 0) throw InputError(drawing_.file, "there is no <svg> element", "give an SVG drawing");
    const XmlElement& element = xml_.element(0);
    if (xml_.end(0) != xml_.size() || element.name != "svg")
      throw InputError(element.place,
                       "the document is not an SVG drawing: its element is <" + io::excerpt(element.name) + ">",
                       "give an SVG drawing, or WKT, GeoJSON or DXF with its usual file ending");
    Surroundings root;
    const double unit = unit_of(element) * settings_.scale;
    root.where = scaling(unit, -unit);
    drawing_.millimetre = settings_.scale;
    if (element.find("transform")) root.where = root.where * parse_transform(element);
    open_.push_back({1, xml_.end(0), root});
  }

  /// What a <use> stands for, as if it were within it.
  void open_clone(const XmlElement& use) {
    const std::string* link = use.find("href");
    if (!link) link = use.find("xlink:href");
    const auto target = link && !link->empty() && (*link)[0] == '#' ? xml_.by_id(link->substr(1)) : std::nullopt;
    // Programs show nothing for a name that is not there, and what is there for one of another file.
    const bool elsewhere = link && !link->empty() && (*link)[0] != '#';
    if (elsewhere) return lose(use, "clones what is in another file");
    if (!target) return unread(use, "clones what is not in the file");
    const XmlElement& what = xml_.element(*target);
    if (what.name == "symbol" && what.find("viewBox"))
      return lose(use, "clones a symbol with a viewBox: unlink it in the program that drew it");
    Surroundings s = inside(use, true, what);
    if (++s.clones > deepest_clone)
      throw InputError(use.place, "clones are within clones more than 16 deep",
                       "an element must not clone what it is within: unlink the clone");
    s.where = s.where * translation(user_length(use, "x", 0), user_length(use, "y", 0));
    drawn_definitions_.insert(*target);
    if (what.name != "symbol") return open_.push_back({*target, xml_.end(*target), s});
    // What stands for the symbol is a group.
    open_.push_back({*target + 1, xml_.end(*target), s});
  }

  /// Shapes of definitions that no clone has drawn.
  void tell_what_is_not_drawn() {
    for (const std::size_t definition : definitions_) {
      const XmlElement& element = xml_.element(definition);
      bool idle = false;
      for (std::size_t node = definition; node < xml_.end(definition) && !idle;) {
        const bool drawn = drawn_definitions_.count(node) != 0;
        idle = !drawn && is_shape(xml_.element(node).name);
        node = drawn || is_paint(xml_.element(node).name) ? xml_.end(node) : node + 1;
      }
      if (idle) drawing_.skip(element.place, "<" + element.name + ">", "is not drawn where it stands, nor cloned");
    }
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

  /// The words of style sheets are the same in capitals.
  std::string word_of(const XmlElement& element, const std::string& name) const {
    std::string word = styles_.property(element, name);
    for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return word;
  }

  Surroundings inside(const XmlElement& element, bool group) { return inside(element, group, element); }

  /// `named`: by which the layer is called where the element itself has no name.
  Surroundings inside(const XmlElement& element, bool group, const XmlElement& named) {
    Surroundings s = open_.back().around;
    s.where = s.where * parse_transform(element);
    const std::string fill = styles_.property(element, "fill"), rule = word_of(element, "fill-rule");
    if (!fill.empty() && word_of(element, "fill") != "inherit") s.filled = !is_see_through(word_of(element, "fill"));
    const std::string stroke = styles_.property(element, "stroke");
    for (const std::string* color : {&fill, &stroke})
      if (!color->empty() && *color != "inherit" && *color != "none") s.color = *color;
    if (!rule.empty() && rule != "inherit") s.fill = rule == "evenodd" ? Fill::even_odd : Fill::nonzero;
    const std::string visibility = word_of(element, "visibility");
    if (!visibility.empty() && visibility != "inherit") s.hidden = visibility != "visible";
    if (word_of(element, "display") == "none") s.displayed = false;
    tell_what_is_not_obeyed(element);
    if (s.layer < 0) {
      s.layer = static_cast<int>(drawing_.layers.size());
      const std::string name = name_of(element, group);
      drawing_.layers.push_back({name.empty() ? name_of(named, group) : name, {}});
    }
    return s;
  }

  void tell_what_is_not_obeyed(const XmlElement& element) {
    for (const char* cut : {"clip-path", "mask"}) {
      const std::string* value = element.find(cut);
      if (value && *value != "none")
        drawing_.skip(
            {element.place, "\"" + std::string(cut) + "\"", "is not obeyed: the whole of it is taken", "", "", true});
    }
    const std::string property = unread_in_style(element);
    if (!property.empty())
      drawing_.skip(lost(element.place, "\"" + property + "\" in a style", "is not read: use the attribute"));
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

  /// What fills or marks others.
  static bool is_paint(const std::string& name) {
    for (const char* known : {"pattern", "marker", "clipPath", "mask", "linearGradient", "radialGradient", "filter"})
      if (name == known) return true;
    return false;
  }

  void read_shape(const XmlElement& element, const Surroundings& s) {
    if (s.hidden || !s.displayed) return drawing_.skip(element.place, "<" + element.name + ">", "is not visible");
    if (is_background(element)) return unread(element, "is as large as the page: its background");
    if (in_percent(element)) return lose(element, "has a size in percent of the page");
    std::vector<Chain> chains = chains_of(element, s.where);
    if (chains.empty()) return drawing_.skip(element.place, "<" + element.name + ">", "has no extent");
    Layer& layer = settings_.by == Grouping::color ? drawing_.layer(s.color.empty() ? "no color" : s.color)
                                                   : drawing_.layers[static_cast<std::size_t>(s.layer)];
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

  static bool is_background(const XmlElement& element) {
    const std::string *width = element.find("width"), *height = element.find("height");
    return element.name == "rect" && width && height && *width == "100%" && *height == "100%";
  }

  static bool in_percent(const XmlElement& element) {
    for (const char* key : {"x", "y", "width", "height", "cx", "cy", "r", "rx", "ry", "x1", "y1", "x2", "y2"}) {
      const std::string* value = element.find(key);
      if (value && !value->empty() && value->back() == '%') return true;
    }
    return false;
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
    if (element.name == "style" || element.name == "script" || is_paint(element.name)) return;
    if (element.name == "text") return unread(element, "is text: turn it into paths if it is to be part of a body");
    if (element.name == "svg") return lose(element, "is a drawing in the drawing: ungroup it");
    unread(element, "is no path or basic shape");
  }

  /// What bounds nothing.
  void unread(const XmlElement& element, const std::string& reason) {
    drawing_.skip({element.place, "<" + io::excerpt(element.name, 30) + ">", reason, "", "", true});
  }

  /// What may be a shape, anywhere.
  void lose(const XmlElement& element, const std::string& reason) {
    drawing_.skip(lost(element.place, "<" + io::excerpt(element.name, 30) + ">", reason));
  }

  const XmlTree& xml_;
  ImportSettings settings_;
  Flattener flattener_;
  StyleSheet styles_;
  Drawing drawing_;
  std::vector<Level> open_;
  std::vector<std::size_t> definitions_;
  std::set<std::size_t> drawn_definitions_;
  std::size_t cloned_ = 0;
};

}  // namespace

Drawing read_svg(const std::string& text, const std::string& file, const ImportSettings& settings) {
  const XmlTree xml(text, file);
  return with_fineness(settings, [&](double tolerance) { return SvgReader(xml, file, settings, tolerance).read(); });
}

}  // namespace taut::drawing
