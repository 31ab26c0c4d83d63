#include "draw/svg_legend.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "draw/svg_canvas.hpp"
#include "draw/world_shapes.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "scene/joined_parts.hpp"

namespace taut::internal::io {
namespace {

constexpr double left = 24;
constexpr double row_height = 18;

std::string line(const char* colour, double width) {
  return fmt::format("<path d=\"M0-4H16\" stroke=\"{}\" stroke-width=\"{}\"/>", colour, width);
}

std::string arc(const char* colour) {
  return fmt::format("<path d=\"M1 0A8 8 0 0 1 15 0\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.4\"/>", colour);
}

}  // namespace

PathStyle path_style(DrawnPath::Kind kind) {
  switch (kind) {
    case DrawnPath::Kind::geodesic_0:
      return {geodesic_colour[0], 3.4, false, "geodesic"};
    case DrawnPath::Kind::geodesic_1:
      return {geodesic_colour[1], 1.8, false, "geodesic"};
    case DrawnPath::Kind::separator:
      return {separator_colour, 2.4, false, "separator"};
    case DrawnPath::Kind::gone:
      return {gone_colour, 2.4, true, "edge that goes"};
    case DrawnPath::Kind::guide:
      return {gone_colour, 0.8, true, "guide"};
    default:
      return {come_colour, 2.8, false, "edge that comes"};
  }
}

SvgLegend::SvgLegend(const Scene& scene, const Tiling& tiling, const TilingDrawOptions& options)
    : width_(std::max(options.width, 200)), x_(left) {
  for (std::size_t b = 0; b < 2 && b < scene.bodies.size(); ++b) {
    add(fmt::format("<rect y=\"-10\" width=\"16\" height=\"11\" fill=\"{}\"/>", body_fill[b]),
        excerpt(scene.bodies[b].name, 30));
  }
  if (!tiling.edges.empty() && options.edges) {
    add(line(tiling_colour, 0.8), "tiling");
    add(line(pq_colour, 2.2), "edge between the bodies");
  }
  if (options.certificates && !tiling.faces.empty()) {
    add(arc(convex_colour), "convex corner");
    add(arc(reflex_colour), "reflex corner");
  }
  std::vector<DrawnPath::Kind> seen;
  for (const DrawnPath& path : options.paths) {
    if (std::find(seen.begin(), seen.end(), path.kind) != seen.end()) continue;
    seen.push_back(path.kind);
    const PathStyle style = path_style(path.kind);
    const bool geodesic = path.kind == DrawnPath::Kind::geodesic_0 || path.kind == DrawnPath::Kind::geodesic_1;
    const std::size_t body = path.kind == DrawnPath::Kind::geodesic_1 ? 1 : 0;
    const std::string of = geodesic && body < scene.bodies.size() ? " of " + excerpt(scene.bodies[body].name, 30) : "";
    add(line(style.colour, style.width), style.label + of);
  }
  if (options.contact) add(line(contact_colour, 2.5), "contact");
}

void SvgLegend::add(std::string mark, const std::string& label) {
  // No font metrics here: a generous average width does.
  const double width = 42 + 6.6 * static_cast<double>(label.size());
  if (x_ > left && x_ + width > width_) {
    x_ = left;
    ++row_;
  }
  entries_.push_back({std::move(mark), label, x_, row_});
  x_ += width;
}

double SvgLegend::height() const { return 8 + row_height * (row_ + 1); }

std::string SvgLegend::draw(double picture_height) const {
  std::string out = "<g font-size=\"12\" fill=\"#333\">\n";
  for (const Entry& entry : entries_) {
    const double y = picture_height - 12 - row_height * (row_ - entry.row);
    out += fmt::format("<g transform=\"translate({:.0f} {:.0f})\">{}<text x=\"22\">{}</text></g>\n", entry.x, y,
                       entry.mark, escape_xml(entry.label));
  }
  return out + "</g>\n";
}

namespace {

constexpr double left_edge = 24, row_step = 18, indentation = 14, swatch = 24;
/// More bodies, or pairs, than these are counted instead of listed.
constexpr std::size_t most_bodies = 60, most_ignored = 8;
constexpr std::size_t longest_name = 24, most_layers = 2;
/// No font metrics here: a generous average width does.
constexpr double letter = 6.6;

std::string ignored_name(const std::string& name) { return name == "*" ? "every other body" : excerpt(name, 30); }

/// Lines of at most about so many bytes.
std::vector<std::string> wrapped(const std::vector<std::string>& items, const std::string& title, std::size_t length) {
  std::vector<std::string> lines{title};
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string item = items[i] + (i + 1 < items.size() ? ", " : "");
    if (lines.back().size() + item.size() > length && lines.back() != title) lines.emplace_back("    ");
    lines.back() += item;
  }
  return lines;
}

/// What is written behind the name of a body: its layers, unless it reaches through all of them.
std::string layers_behind(const Body& body) {
  std::vector<Layers> layers = layers_of_parts(body);
  std::sort(layers.begin(), layers.end(),
            [](const Layers& a, const Layers& b) { return std::pair(a.lo, a.hi) < std::pair(b.lo, b.hi); });
  layers.erase(std::unique(layers.begin(), layers.end()), layers.end());
  if (layers.size() == 1 && layers[0] == Layers{}) return "";
  if (layers.size() > most_layers) return fmt::format(", {} layers", layers.size());
  std::string text;
  for (const Layers& z : layers) text += ", " + heights_text(z);
  return text;
}

}  // namespace

WorldLegend::WorldLegend(const Scene& scene, int width) : scene_(scene), width_(std::max(width, 200)) {
  std::map<std::string, std::size_t> names;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) names.emplace(scene.bodies[i].name, i);
  std::vector<std::vector<std::size_t>> children(scene.bodies.size());
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const auto parent = names.find(scene.bodies[i].relative_to);
    (parent == names.end() ? roots : children[parent->second]).push_back(i);
  }
  for (const std::size_t root : roots) add_family(children, root, 0);
  shown_ = std::min(entries_.size(), most_bodies);
  choose_rows();
  add_notes();
}

void WorldLegend::add_family(const std::vector<std::vector<std::size_t>>& children, std::size_t body, int depth) {
  entries_.push_back({body, depth, 0, 0, layers_behind(scene_.bodies[body])});
  for (const std::size_t child : children[body]) add_family(children, child, depth + 1);
}

/// How many of the entries shown belong to the family that begins there.
std::size_t WorldLegend::family_at(std::size_t entry) const {
  std::size_t end = entry + 1;
  while (end < shown_ && entries_[end].depth > 0) ++end;
  return end - entry;
}

/// Puts entries into columns of so many rows, a family into one column where it is not longer; returns how many
/// columns.
std::size_t WorldLegend::place(std::size_t rows) {
  std::size_t column = 0, row = 0;
  for (std::size_t k = 0; k < shown_; ++k) {
    const std::size_t size = entries_[k].depth == 0 ? family_at(k) : 1;
    if (row == rows || (row > 0 && size <= rows && row + size > rows)) row = 0, ++column;
    entries_[k].column = column;
    entries_[k].row = row++;
  }
  return column + 1;
}

void WorldLegend::choose_rows() {
  constexpr std::size_t longest_kept = 12;
  const auto fit = static_cast<std::size_t>(std::max(1.0, (width_ - 2 * left_edge) / column_width()));
  rows_ = (shown_ + fit - 1) / fit;
  for (std::size_t k = 0; k < shown_; ++k) {
    if (entries_[k].depth == 0) rows_ = std::max(rows_, std::min(family_at(k), longest_kept));
  }
  while (place(rows_) > fit && rows_ < shown_) ++rows_;
}

double WorldLegend::column_width() const {
  double widest = 0;
  for (std::size_t k = 0; k < shown_; ++k) {
    const std::size_t letters =
        std::min(scene_.bodies[entries_[k].body].name.size(), longest_name) + entries_[k].layers.size();
    widest = std::max(widest, indentation * entries_[k].depth + letter * static_cast<double>(letters));
  }
  return widest + swatch + 24;
}

void WorldLegend::add_notes() {
  if (entries_.size() > shown_) notes_.push_back(fmt::format("and {} more bodies", entries_.size() - shown_));
  if (scene_.ignore.empty()) return;
  std::vector<std::string> pairs;
  for (const auto& pair : scene_.ignore) {
    if (pairs.size() == most_ignored) break;
    pairs.push_back(ignored_name(pair[0]) + " x " + ignored_name(pair[1]));
  }
  if (scene_.ignore.size() > pairs.size())
    pairs.push_back(fmt::format("and {} more", scene_.ignore.size() - pairs.size()));
  const auto length = static_cast<std::size_t>((width_ - 2 * left_edge) / letter);
  const std::string title = fmt::format("ignored ({}): ", scene_.ignore.size());
  for (const std::string& line : wrapped(pairs, title, length)) notes_.push_back(line);
}

double WorldLegend::height() const { return 10 + row_step * static_cast<double>(rows_ + notes_.size()); }

std::string WorldLegend::draw_entry(const Entry& entry, double top) const {
  const BodyStyle style = body_style(entry.body);
  const double x = left_edge + column_width() * static_cast<double>(entry.column) + indentation * entry.depth;
  const double y = top + row_step * static_cast<double>(entry.row + 1);
  return fmt::format(
      "<g transform=\"translate({:.0f} {:.0f})\"><rect y=\"-11\" width=\"{}\" height=\"14\" fill=\"{}\" "
      "stroke=\"{}\"/>"
      "<text x=\"{}\" text-anchor=\"middle\" font-size=\"11\" fill=\"{}\">{}</text><text x=\"{}\">{}</text></g>\n",
      x, y, swatch, style.fill, style.line, swatch / 2, style.ink, entry.body + 1, swatch + 6,
      escape_xml(excerpt(scene_.bodies[entry.body].name, longest_name) + entry.layers));
}

std::string WorldLegend::draw(double top) const {
  std::string out = "<g font-size=\"12\" fill=\"#333\">\n";
  for (std::size_t k = 0; k < shown_; ++k) out += draw_entry(entries_[k], top);
  for (std::size_t k = 0; k < notes_.size(); ++k) {
    out += fmt::format("<text x=\"{}\" y=\"{:.0f}\" fill=\"#555\" xml:space=\"preserve\">{}</text>\n", left_edge,
                       top + row_step * static_cast<double>(rows_ + k + 1), escape_xml(notes_[k]));
  }
  return out + "</g>\n";
}

}  // namespace taut::internal::io
