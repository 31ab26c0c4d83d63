#include "import/kicad_reader.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "import/affine.hpp"
#include "import/curves.hpp"
#include "import/kicad_drills.hpp"
#include "import/rounded_rectangle.hpp"
#include "import/s_expression.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

constexpr double kicad_turn = 2 * 3.14159265358979323846;
const char* const board_name = "board";
const char* const front_name = "courtyards F";
const char* const back_name = "courtyards B";
/// In mm, of a board that does not say its own, as in KiCad.
constexpr double usual_thickness = 1.6;

/// The centre of the circle through three points; nothing if they are on a line.
std::optional<Point> centre_of(const Point& a, const Point& b, const Point& c) {
  const double x = b.x - a.x, y = b.y - a.y, u = c.x - a.x, v = c.y - a.y, d = 2 * (x * v - y * u);
  if (d == 0) return std::nullopt;
  const double p = x * x + y * y, q = u * u + v * v;
  return Point{a.x + (v * p - y * q) / d, a.y + (x * q - u * p) / d};
}

class KicadReader {
 public:
  KicadReader(const SExpression& board, const std::string& text, const std::string& file,
              const ImportSettings& settings, double tolerance)
      : board_(board),
        text_(text),
        flattener_(settings, tolerance, file),
        scale_(settings.scale),
        root_(scaling(settings.scale, -settings.scale)),
        drills_(root_, settings.drills, flattener_) {
    drawing_.file = file;
    drawing_.format = "KiCad board";
    drawing_.state_unit("mm", 1, settings);
    // Courtyards lie on the board: they are no holes in it.
    drawing_.nests = false;
  }

  Drawing read() {
    for (const SExpression& item : board_.items) {
      if (item.word == "footprint" || item.word == "module")
        read_footprint(item);
      else if (item.word == "via")
        drills_.read(item, root_, place(item));
      else
        read_graphic(item, "gr_", root_, "");
    }
    drawing_.notes = drills_.notes();
    for (Layer& layer : drawing_.layers)
      if (layer.name == board_name) layer.cutouts = drills_.take_holes();
    stack_sides();
    drawing_.curves = flattener_.counts();
    drawing_.kept = flattener_.take_kept();
    return std::move(drawing_);
  }

 private:
  /// Parts of the two sides never meet, and lie on the board. Where only one side has parts, the plane is all there is.
  void stack_sides() {
    const auto has = [&](const char* name) {
      return std::any_of(drawing_.layers.begin(), drawing_.layers.end(),
                         [&](const Layer& l) { return l.name == name; });
    };
    if (!has(front_name) || !has(back_name)) return;
    const SExpression* general = board_.find("general");
    const SExpression* stated = general ? general->find("thickness") : nullptr;
    const double thickness = scale_ * (stated ? stated->number(0).value_or(0) : usual_thickness);
    if (!(thickness > 0)) return drawing_.notes.push_back("the board states no thickness above 0: it has no heights");
    for (Layer& layer : drawing_.layers) {
      Layers z;
      if (layer.name != back_name) z.lo = layer.name == front_name ? thickness : 0;
      if (layer.name != front_name) z.hi = layer.name == back_name ? 0 : thickness;
      for (Sheet& sheet : layer.sheets) sheet.z = z;
    }
  }

  void read_footprint(const SExpression& footprint) {
    const SExpression* at = footprint.find("at");
    const double x = at ? at->number(0).value_or(0) : 0, y = at ? at->number(1).value_or(0) : 0;
    const double degrees = at ? at->number(2).value_or(0) : 0;
    // Angles go counterclockwise on the screen, where y points down.
    const Affine where = root_ * translation(x, y) * rotation(-degrees);
    const std::string name = reference_of(footprint);
    for (const SExpression& item : footprint.items) {
      if (item.word == "pad")
        drills_.read(item, where, place(item));
      else
        read_graphic(item, "fp_", where, name);
    }
  }

  /// R1, say.
  static std::string reference_of(const SExpression& footprint) {
    for (const SExpression& item : footprint.items) {
      const bool named = (item.word == "property" && item.items.size() > 1 && item.items[0].word == "Reference") ||
                         (item.word == "fp_text" && item.items.size() > 1 && item.items[0].word == "reference");
      if (named) return item.items[1].word;
    }
    return "";
  }

  void read_graphic(const SExpression& item, const std::string& prefix, const Affine& where, const std::string& name) {
    static const std::map<std::string, std::string> read{
        {"Edge.Cuts", board_name}, {"F.CrtYd", front_name}, {"B.CrtYd", back_name}};
    if (!item.list || item.word.rfind(prefix, 0) != 0) return;
    const auto layer = read.find(item.text("layer"));
    if (layer == read.end()) return;
    const std::string kind = item.word.substr(prefix.size());
    if (kind == "text" || kind == "text_box") return skip(item, layer->second, "is text");
    Chain chain{{}, false, place(item)};
    if (!trace(kind, item, where, chain))
      return drawing_.skip(lost(place(item), item.word, "is no line or curve that is read", layer->second));
    lines(layer->second, layer->second == board_name ? "" : name).push_back(std::move(chain));
  }

  /// The lines of one footprint are by themselves: their outlines may lie in each other.
  std::vector<Chain>& lines(const std::string& layer, const std::string& name) {
    Layer& target = drawing_.layer(layer);
    for (Sheet& sheet : target.sheets)
      if (sheet.name == name) return sheet.chains;
    target.sheets.push_back({name, Fill::even_odd, {}, true});
    target.sheets.back().alone = true;
    return target.sheets.back().chains;
  }

  bool trace(const std::string& kind, const SExpression& item, const Affine& where, Chain& chain) {
    const auto start = item.point("start"), middle = item.point("mid"), end = item.point("end");
    const auto centre = item.point("center");
    if (kind == "line" && start && end) {
      chain.points = {where(*start), where(*end)};
    } else if (kind == "rect" && start && end) {
      chain = rectangle(*start, *end, item, where);
    } else if (kind == "circle" && centre && end) {
      const double r = std::hypot(end->x - centre->x, end->y - centre->y);
      chain.closed = true;
      flattener_.ellipse(chain.points, where(*centre), where.turn({r, 0}), where.turn({0, r}));
    } else if (kind == "arc" && start && middle && end) {
      return arc(*start, *middle, *end, where, chain);
    } else if (kind == "arc" && start && end && item.find("angle")) {
      // Up to KiCad 5: the centre, the start, and the angle clockwise on the screen.
      return turn_around(*start, *end, item.find("angle")->number(0).value_or(0), where, chain);
    } else if (kind == "poly") {
      return corners_of(item, where, chain);
    } else if (kind == "curve") {
      return bezier_of(item, where, chain);
    } else {
      return false;
    }
    return true;
  }

  Chain rectangle(const Point& a, const Point& b, const SExpression& item, const Affine& where) {
    const Point low{std::min(a.x, b.x), std::min(a.y, b.y)}, high{std::max(a.x, b.x), std::max(a.y, b.y)};
    const SExpression* radius = item.find("radius");
    const double most = std::min(high.x - low.x, high.y - low.y) / 2;
    const double r = std::clamp(radius ? radius->number(0).value_or(0) : 0, 0.0, most);
    return rounded_rectangle(low, high, r, r, where, place(item), flattener_);
  }

  /// Behind the points that the chain has.
  bool arc(const Point& a, const Point& b, const Point& c, const Affine& where, Chain& chain) {
    chain.points.push_back(where(a));
    const auto centre = centre_of(a, b, c);
    if (!centre) {
      chain.points.push_back(where(c));
      return true;
    }
    const auto angle = [&](const Point& p) { return std::atan2(p.y - centre->y, p.x - centre->x); };
    const double from = angle(a);
    double by = std::fmod(angle(b) - from + kicad_turn, kicad_turn),
           to = std::fmod(angle(c) - from + kicad_turn, kicad_turn);
    // The other way round, if the middle is not between the ends.
    if (by > to) to -= kicad_turn;
    const double r = std::hypot(a.x - centre->x, a.y - centre->y);
    flattener_.arc(chain.points, where(*centre), where.turn({r, 0}), where.turn({0, r}), from, to, where(c));
    return true;
  }

  bool turn_around(const Point& centre, const Point& from, double degrees, const Affine& where, Chain& chain) {
    const Point a{from.x - centre.x, from.y - centre.y}, b{-a.y, a.x};
    const double sweep = degrees / 360 * kicad_turn;
    const Point end{centre.x + std::cos(sweep) * a.x + std::sin(sweep) * b.x,
                    centre.y + std::cos(sweep) * a.y + std::sin(sweep) * b.y};
    chain.points = {where(from)};
    flattener_.arc(chain.points, where(centre), where.turn(a), where.turn(b), 0, sweep, where(end));
    return true;
  }

  /// "(xy X Y)", and "(arc (start X Y) (mid X Y) (end X Y))" in between.
  bool corners_of(const SExpression& item, const Affine& where, Chain& chain) {
    const SExpression* list = item.find("pts");
    if (!list) return false;
    for (const SExpression& corner : list->items) {
      const auto x = corner.number(0), y = corner.number(1);
      const auto start = corner.point("start"), middle = corner.point("mid"), end = corner.point("end");
      if (corner.word == "xy" && x && y)
        chain.points.push_back(where({*x, *y}));
      else if (corner.word != "arc" || !start || !middle || !end || !arc(*start, *middle, *end, where, chain))
        return false;
    }
    chain.closed = true;
    return chain.points.size() > 1;
  }

  bool bezier_of(const SExpression& item, const Affine& where, Chain& chain) {
    const SExpression* list = item.find("pts");
    if (!list || list->items.size() != 4) return false;
    std::vector<ControlPoint> control;
    for (const SExpression& point : list->items) {
      const auto x = point.number(0), y = point.number(1);
      if (point.word != "xy" || !x || !y) return false;
      const Point p = where({*x, *y});
      control.push_back({p.x, p.y, 1});
    }
    chain.points.push_back(control[0].point());
    flattener_.bezier(chain.points, control);
    return true;
  }

  std::string place(const SExpression& item) {
    // Of boards that are long, lines are counted on from the place before.
    if (item.offset < counted_) {
      counted_ = 0;
      line_ = 1;
    }
    for (; counted_ < item.offset; ++counted_)
      if (text_[counted_] == '\n') ++line_;
    return drawing_.file + ":" + std::to_string(line_);
  }

  void skip(const SExpression& item, const std::string& layer, const std::string& reason) {
    drawing_.skip({place(item), item.word, reason, layer, "", true});
  }

  const SExpression& board_;
  const std::string& text_;
  Flattener flattener_;
  double scale_;
  Affine root_;
  KicadDrills drills_;
  Drawing drawing_;
  std::size_t counted_ = 0;
  int line_ = 1;
};

}  // namespace

Drawing read_kicad(const std::string& text, const std::string& file, const ImportSettings& settings) {
  const SExpression board = parse_s_expression(text, file);
  if (board.word != "kicad_pcb")
    throw InputError(file, "the file is no board of KiCad: it begins with \"" + io::excerpt(board.word, 20) + "\"",
                     "give a .kicad_pcb file");
  return with_fineness(settings,
                       [&](double tolerance) { return KicadReader(board, text, file, settings, tolerance).read(); });
}

}  // namespace taut::drawing
