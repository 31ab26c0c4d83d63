#include "import/svg_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "import/body_text.hpp"
#include "import/outlines.hpp"
#include "import/svg_clip.hpp"
#include "import/svg_shapes.hpp"
#include "import/svg_styles.hpp"
#include "import/svg_surroundings.hpp"
#include "import/svg_viewport.hpp"
#include "import/xml_tree.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

Skipped styles_elsewhere(const std::string& place, const char* what) {
  return lost_style(place, what, "takes styles from another file, which is not read",
                    "put the styles into the drawing");
}

constexpr int deepest_clone = 16;
constexpr std::size_t most_cloned = 1000000;
/// Of what surrounds all layers.
constexpr int no_layer = 1000000000;
const char* const percent_reason = "has a length in percent of the page, whose size is not known";

class SvgReader {
 public:
  /// `unpainted`: shapes with neither a fill nor a stroke are outlines.
  SvgReader(const XmlTree& xml, const std::string& file, const ImportSettings& settings, double tolerance,
            bool unpainted)
      : xml_(xml),
        settings_(settings),
        flattener_(settings, tolerance, file),
        styles_(xml),
        surroundings_(xml, styles_, drawing_),
        reads_unpainted_(unpainted),
        coarse_(tolerance >= coarsest) {
    drawing_.file = file;
    drawing_.format = "SVG";
  }

  Drawing read() {
    for (const auto& [node, css] : xml_.style_texts()) styles_.read(css, xml_.element(node), drawing_);
    open_root();
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
    if (unpainted_ > 0 && reads_unpainted_)
      drawing_.notes.push_back(
          fmt::format("nothing in the file is painted: its {} read as outlines",
                      unpainted_ == 1 ? "one shape is" : std::to_string(unpainted_) + " shapes are"));
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
    const Surroundings& around = open_.back().around;
    if (element.name == "g" || element.name == "a") {
      open_.push_back({node + 1, xml_.end(node), surroundings_.inside(node, around, true)});
    } else if (element.name == "switch") {
      open_switch(node);
    } else if (is_svg_shape(element.name)) {
      read_shape(element, surroundings_.inside(node, around, false));
    } else if (element.name == "svg") {
      open_frame(node, surroundings_.inside(node, around, true), element);
    } else if (element.name == "use") {
      open_clone(node);
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
    const Page page = page_of(element);
    drawing_.state_unit(page.units, page.physical ? std::optional(1.0) : std::nullopt, settings_);
    if (!page.note.empty()) drawing_.notes.push_back(page.note);
    open_.push_back({1, xml_.end(0), {}});
    Surroundings root;
    root.where = scaling(page.across * settings_.scale, -page.up * settings_.scale);
    root.viewport = page.viewport;
    root.layer = no_layer;
    const auto box = view_box_of(element);
    const double x = box ? box->x : 0, y = box ? box->y : 0;
    const double w = page.viewport.width, h = page.viewport.height;
    if (w > 0 && h > 0) page_ = Frame{root.where * translation(x, y) * scaling(w, h), element.place, ""};
    root = surroundings_.inside(0, root, true);
    root.layer = -1;
    open_.back().around = std::move(root);
  }

  /// The first of the alternatives that needs no extension; of languages, English.
  void open_switch(std::size_t node) {
    const auto suits = [this](std::size_t child) {
      const std::string* extensions = xml_.element(child).find("requiredExtensions");
      const std::string* languages = xml_.element(child).find("systemLanguage");
      return (!extensions || extensions->empty()) && (!languages || languages->find("en") != std::string::npos);
    };
    const Surroundings around = surroundings_.inside(node, open_.back().around, true);
    bool chosen = false;
    for (std::size_t child = node + 1; child < xml_.end(node); child = xml_.end(child)) {
      const XmlElement& element = xml_.element(child);
      if (!chosen && suits(child)) {
        chosen = true;
        open_.push_back({child, xml_.end(child), around});
      } else {
        drawing_.skip(element.place, "<" + io::excerpt(element.name, 30) + ">", "is another alternative of a <switch>");
      }
    }
  }

  /// What a <use> stands for, as if it were within it.
  void open_clone(std::size_t node) {
    const XmlElement& use = xml_.element(node);
    const std::string* link = use.find("href");
    if (!link) link = use.find("xlink:href");
    const auto target = link && !link->empty() && (*link)[0] == '#' ? xml_.by_id(link->substr(1)) : std::nullopt;
    // Programs show nothing for a name that is not there, and what is there for one of another file.
    const bool elsewhere = link && !link->empty() && (*link)[0] != '#';
    if (elsewhere) return lose(use, "clones what is in another file");
    if (!target) return unread(use, "clones what is not in the file");
    const XmlElement& what = xml_.element(*target);
    Surroundings s = surroundings_.inside(node, open_.back().around, true, &what);
    if (++s.clones > deepest_clone)
      throw InputError(use.place, "clones are within clones more than 16 deep",
                       "an element must not clone what it is within: unlink the clone");
    const double x = user_length(use, "x", s.viewport, 0), y = user_length(use, "y", s.viewport, 0);
    if (std::isnan(x) || std::isnan(y)) return lose(use, percent_reason);
    s.where = s.where * translation(x, y);
    drawn_definitions_.insert(*target);
    if (what.name == "symbol" || what.name == "svg")
      return open_frame(*target, surroundings_.inside(*target, s, true), use);
    open_.push_back({*target, xml_.end(*target), s});
  }

  /// A drawing in the drawing, or a symbol, in a viewport as large as `sized` says, or else it itself.
  void open_frame(std::size_t node, Surroundings s, const XmlElement& sized) {
    const XmlElement& element = xml_.element(node);
    const auto size = [&](const char* key, double all) {
      return user_length(sized, key, s.viewport, user_length(element, key, s.viewport, all));
    };
    const Viewport viewport{size("width", s.viewport.width), size("height", s.viewport.height)};
    const double x = user_length(element, "x", s.viewport, 0), y = user_length(element, "y", s.viewport, 0);
    const auto box = view_box_of(element);
    const bool known = !std::isnan(viewport.width) && !std::isnan(viewport.height);
    if (std::isnan(x) || std::isnan(y) || (box && !known)) return lose(element, percent_reason);
    if (element.find("refX") || element.find("refY")) return lose(element, "has refX or refY, which are not read");
    if (viewport.width <= 0 || viewport.height <= 0)
      return drawing_.skip(element.place, "<" + element.name + ">", "has no extent");
    s.where = s.where * translation(x, y);
    const std::string overflow = styles_.style_of(node).word("overflow");
    s.nested = true;
    if (known && overflow != "visible" && overflow != "auto")
      s.frames.push_back(
          {s.where * scaling(viewport.width, viewport.height), element.place, "give the frame overflow=\"visible\""});
    if (box) s.where = s.where * fitted(*box, viewport, element);
    s.viewport = box ? Viewport{box->width, box->height} : viewport;
    open_.push_back({node + 1, xml_.end(node), std::move(s)});
  }

  /// Shapes of definitions that no clone has drawn.
  void tell_what_is_not_drawn() {
    for (const std::size_t definition : definitions_) {
      const XmlElement& element = xml_.element(definition);
      bool idle = false;
      for (std::size_t node = definition; node < xml_.end(definition) && !idle;) {
        const bool drawn = drawn_definitions_.count(node) != 0;
        idle = !drawn && is_svg_shape(xml_.element(node).name);
        node = drawn || is_paint(xml_.element(node).name) ? xml_.end(node) : node + 1;
      }
      if (idle) drawing_.skip(element.place, "<" + element.name + ">", "is not drawn where it stands, nor cloned");
    }
  }

  /// What fills or marks others.
  static bool is_paint(const std::string& name) {
    for (const char* known : {"pattern", "marker", "clipPath", "mask", "linearGradient", "radialGradient", "filter"})
      if (name == known) return true;
    return false;
  }

  void read_shape(const XmlElement& element, const Surroundings& s) {
    const std::string what = "<" + element.name + ">";
    if (s.hidden || !s.displayed) return hide(element, s);
    const bool filled = s.paints_filling() && element.name != "line";
    if (!filled && !s.paints_line()) {
      ++unpainted_;
      if (!reads_unpainted_)
        return drawing_.skip(element.place, what, "has neither a fill nor a stroke: it is not visible");
    }
    const bool painted_only = filled && !s.paints_line() && !s.nested;
    if (painted_only && is_all_of_page(element)) return leave_out_background(element, s);
    if (has_unknown_size(element, s.viewport)) return lose(element, percent_reason);
    std::vector<Chain> chains = svg_shape(element, s.viewport, s.where, flattener_);
    if (chains.empty()) return drawing_.skip(element.place, what, "has no extent");
    if (painted_only && fills_page(chains)) return leave_out_background(element, s);
    if (is_beyond_frames(element, s, chains)) return;
    std::vector<Chain> filled_chains;
    if (filled) filled_chains = take_filled(chains, s.fill);
    if (!chains.empty()) add_lines(element, s, std::move(chains));
    if (!filled_chains.empty())
      layer_of(s).sheets.push_back({svg_name_of(element, false), s.fill, std::move(filled_chains)});
  }

  /// What is not to be seen; lines may go on where it ends.
  void hide(const XmlElement& element, const Surroundings& s) {
    Skipped skipped{element.place, "<" + element.name + ">", "is not visible"};
    try {
      ImportSettings plain = settings_;
      plain.curves = false;
      Flattener flattener(plain, coarsest, drawing_.file);
      if (!has_unknown_size(element, s.viewport))
        for (const Chain& chain : svg_shape(element, s.viewport, s.where, flattener))
          if (!chain.closed && chain.points.size() > 1)
            skipped.shapes.push_back({element.place, {chain.points.front(), chain.points.back()}, false, true});
    } catch (const InputError&) {
      // It is not read in any case.
    }
    drawing_.skip(std::move(skipped));
  }

  /// Those that enclose something, closed as what is filled is. The others stay: a filling does not show them.
  std::vector<Chain> take_filled(std::vector<Chain>& chains, Fill fill) const {
    require_range(chains);
    std::vector<Chain> taken, left;
    for (Chain& chain : chains) {
      // The single chord of a half circle encloses nothing.
      const bool encloses = coarse_ || encloses_area(chain, fill, settings_.max_points, drawing_.file);
      if (encloses) chain.closed = true;
      (encloses ? taken : left).push_back(std::move(chain));
    }
    chains = std::move(left);
    return taken;
  }

  void add_lines(const XmlElement& element, const Surroundings& s, std::vector<Chain> chains) {
    if (s.paints_filling() && !s.paints_line() && element.name != "line") {
      ++unpainted_;
      if (!reads_unpainted_)
        return drawing_.skip(chains.front().place, "<" + element.name + ">",
                             "encloses nothing that its fill could paint, and has no stroke: it is not visible");
    }
    Layer& layer = layer_of(s);
    auto lines = std::find_if(layer.sheets.begin(), layer.sheets.end(), [](const Sheet& x) { return x.lines; });
    if (lines == layer.sheets.end()) lines = layer.sheets.insert(lines, Sheet{"", Fill::even_odd, {}, true});
    for (Chain& chain : chains) lines->chains.push_back(std::move(chain));
  }

  Layer& layer_of(const Surroundings& s) {
    return settings_.by == Grouping::color ? drawing_.layer(s.color.empty() ? "no color" : s.color)
                                           : drawing_.layers[static_cast<std::size_t>(s.layer)];
  }

  /// Also of a page whose size is not known.
  static bool is_all_of_page(const XmlElement& element) {
    const std::string *width = element.find("width"), *height = element.find("height");
    return element.name == "rect" && width && height && *width == "100%" && *height == "100%" && !element.find("rx") &&
           !element.find("ry") && !element.find("x") && !element.find("y") && !element.find("transform");
  }

  bool fills_page(const std::vector<Chain>& chains) const {
    if (!page_) return false;
    const auto frame = frame_of(chains);
    return frame && beyond_frame(chains, *page_) == Beyond::nothing &&
           beyond_frame({{corners_of(*page_), true, ""}}, *frame) == Beyond::nothing;
  }

  /// A rectangle without a line, as large as the page. If it is white, it is what programs write for the paper.
  void leave_out_background(const XmlElement& element, const Surroundings& s) {
    std::string color;
    for (const char c : s.color)
      if (!std::isspace(static_cast<unsigned char>(c)))
        color += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    static const std::set<std::string> white{"white", "#fff", "#ffffff", "rgb(255,255,255)", "rgb(100%,100%,100%)"};
    if (white.count(color)) return unread(element, "is white and as large as the page: its background");
    drawing_.skip(lost_style(element.place, "<" + element.name + ">",
                             "fills all of the page: it may be the background, or a plate",
                             "delete it if it is the background; if it is a shape, give it a stroke"));
  }

  /// What is in part beyond a frame is an error, or its whole is taken.
  bool is_beyond_frames(const XmlElement& element, const Surroundings& s, const std::vector<Chain>& chains) {
    for (const Frame& frame : s.frames) {
      const Beyond beyond = beyond_frame(chains, frame);
      if (beyond == Beyond::all) {
        drawing_.skip(element.place, "<" + element.name + ">", "lies beyond the frame at " + frame.place);
        return true;
      }
      if (beyond == Beyond::part) {
        const std::string reason = "reaches beyond the frame at " + frame.place + ", which hides a part of it";
        drawing_.skip({element.place,
                       "<" + element.name + ">",
                       reason,
                       "",
                       "",
                       true,
                       1,
                       {{element.place, chains.front().points}},
                       "cut it off there, or " + frame.remedy});
      }
    }
    return false;
  }

  /// What describes the drawing, or is of its program, is no part of it; other elements are reported.
  void pass_over(const XmlElement& element) {
    static const std::set<std::string> described{"title", "desc", "metadata"};
    const std::string* relation = element.name.ends_with("link") ? element.find("rel") : nullptr;
    if (relation && *relation == "stylesheet") return drawing_.skip(styles_elsewhere(element.place, "<link>"));
    if (described.count(element.name) || element.name.find(':') != std::string::npos) return;
    if (element.name == "style" || element.name == "script" || is_paint(element.name)) return;
    if (element.name == "text") return unread(element, "is text: turn it into paths if it is to be part of a body");
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
  SurroundingsReader surroundings_;
  std::vector<Level> open_;
  std::vector<std::size_t> definitions_;
  std::set<std::size_t> drawn_definitions_;
  std::optional<Frame> page_;  ///< if its size is known
  std::size_t cloned_ = 0, unpainted_ = 0;
  bool reads_unpainted_, coarse_;
};

}  // namespace

Drawing read_svg(const std::string& text, const std::string& file, const ImportSettings& settings) {
  const XmlTree xml(text, file);
  // Files in which nothing is painted are meant as outlines.
  const auto read = [&](bool unpainted) {
    return with_fineness(settings,
                         [&](double tolerance) { return SvgReader(xml, file, settings, tolerance, unpainted).read(); });
  };
  Drawing drawing = read(false);
  if (drawing.diagonal() == 0) drawing = read(true);
  if (text.find("<?xml-stylesheet") != std::string::npos) drawing.skip(styles_elsewhere(file, "<?xml-stylesheet?>"));
  return drawing;
}

}  // namespace taut::drawing
