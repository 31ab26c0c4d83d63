// taut separator SCENE: what keeps the bodies apart at one instant.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "commands.hpp"
#include "io/json_writer.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/separator.hpp"
#include "taut/simulation.hpp"
#include "terminal.hpp"
#include "watched_run.hpp"

namespace taut::cli {
using namespace internal;

namespace {

struct SeparatorArguments {
  SceneSource scene;
  std::string picture;
  std::optional<double> at;
  bool json = false;
};

std::string vertices_json(const Scene& scene, const std::vector<VertexRef>& vertices) {
  std::string s = "[";
  for (const VertexRef& v : vertices) {
    s += fmt::format("{}{{\"body\":{},\"index\":{}}}", s.size() > 1 ? "," : "",
                     io::string_text(scene.bodies[static_cast<std::size_t>(v.body)].name), v.index);
  }
  return s + "]";
}

std::string to_json(const Scene& scene, double t, const Separator& found) {
  if (found.overlap) return fmt::format("{{\"t\":{},\"overlap\":true}}\n", io::number_text(t));
  const MinimumLinkSeparator& m = found.minimum_link;
  std::string curve = "[";
  for (const Point& p : m.vertices) curve += (curve.size() > 1 ? "," : "") + io::point_text(p);
  return fmt::format(
      "{{\"t\":{},\"overlap\":false,\"minimum_link\":{{\"lower\":{},\"upper\":{},\"closed\":{},\"vertices\":{}]}},"
      "\"moving\":{{\"hulls\":[{},{}],\"contact\":{},\"bichromatic_edges\":[{},{}],\"bichromatic_contact_edges\":{}}}}}"
      "\n",
      io::number_text(t), m.lower, m.upper, m.closed, curve, vertices_json(scene, found.moving.hulls[0]),
      vertices_json(scene, found.moving.hulls[1]), vertices_json(scene, found.moving.contact),
      found.moving.bichromatic_edges[0], found.moving.bichromatic_edges[1], found.moving.bichromatic_contact_edges);
}

std::string shape(const MinimumLinkSeparator& m) {
  if (m.closed) return "a closed curve";
  return m.upper == 1 ? "a line" : "a curve from infinity to infinity";
}

std::string to_text(const Scene& scene, double t, const Separator& found) {
  const std::string pair = scene.bodies[0].name + " x " + scene.bodies[1].name;
  if (found.overlap) return fmt::format("OVERLAP  {}   t = {}\n", pair, t);
  const MinimumLinkSeparator& m = found.minimum_link;
  std::string out = fmt::format("SEPARATE  {}   t = {}\n", pair, t);
  if (m.lower == m.upper) {
    out += fmt::format("  fewest links: {}, {}\n", m.upper, shape(m));
  } else {
    out += fmt::format("  fewest links: at least {}; {} with {}\n", m.lower, shape(m), m.upper);
  }
  const MovingSeparator& s = found.moving;
  out += s.contact.empty()
             ? "  the relative convex hulls do not touch\n"
             : fmt::format("  the relative convex hulls share a path of {} {}, {} of them between the bodies\n",
                           s.contact.size() - 1, s.contact.size() == 2 ? "edge" : "edges", s.bichromatic_contact_edges);
  return out + fmt::format("  edges between the bodies on the hull of {}: {}, of {}: {}\n", scene.bodies[0].name,
                           s.bichromatic_edges[0], scene.bodies[1].name, s.bichromatic_edges[1]);
}

/// The curve between the bodies, run out to the picture's frame where it goes on to infinity.
std::string picture(const Scene& scene, double t, const Separator& found) {
  Tiling tiling;
  tiling.time = t;
  const std::array<Polygon, 2> bodies = placed(scene, t);
  TilingDrawOptions options;
  options.edges = false;
  options.certificates = false;
  for (int body : {0, 1}) {
    const Polygon& polygon = bodies[static_cast<std::size_t>(body)];
    for (std::size_t i = 0; i < polygon.size(); ++i)
      tiling.vertices.push_back({{body, static_cast<int>(i)}, polygon[i]});
    DrawnPath hull;
    hull.kind = body == 0 ? DrawnPath::Kind::geodesic_0 : DrawnPath::Kind::geodesic_1;
    hull.closed = true;
    for (const VertexRef& v : found.moving.hulls[static_cast<std::size_t>(body)])
      hull.points.push_back(bodies[static_cast<std::size_t>(v.body)][static_cast<std::size_t>(v.index)]);
    options.paths.push_back(hull);
  }
  options.paths.push_back({found.minimum_link.vertices, DrawnPath::Kind::separator, found.minimum_link.closed, {}});
  return draw_svg(scene, tiling, options);
}

int run_separator(const SeparatorArguments& arguments) {
  const Scene scene = load_scene(arguments.scene);
  const double t = arguments.at.value_or(scene.start);
  if (!(t >= scene.start && t <= scene.end)) {
    throw InputError("--at", fmt::format("{} is outside the scene's time [{}, {}]", t, scene.start, scene.end),
                     "choose an instant within");
  }
  const Separator found = within_file(arguments.scene.path, [&] { return separator(scene, t); });
  if (!arguments.picture.empty() && !found.overlap) write_file(arguments.picture, picture(scene, t, found));
  print_text(arguments.json ? to_json(scene, t, found) : to_text(scene, t, found));
  if (!arguments.picture.empty() && found.overlap)
    fmt::print(stderr, "taut: {}\n", not_written("picture", arguments.picture));
  return found.overlap ? exit_contact : exit_free;
}

}  // namespace

void add_separator(const Command& app, Action& action) {
  const Command command = app.add_command("separator", "Curves that keep the bodies apart at one instant");
  command.hide();  // of interest to readers of the paper; `taut --help` is to fit a screen
  const auto arguments = std::make_shared<SeparatorArguments>();
  add_scene(command, arguments->scene);
  command.add_option("--at", arguments->at, "the instant; without it, the start").value("T");
  command.add_flag("--json", arguments->json, "one JSON object, with all vertices");
  command.add_option("-o,--output", arguments->picture, "also write a picture (SVG) to FILE").value("FILE");
  command.footer(
      "Example:\n"
      "  taut separator scene.json --at 0.5 -o curve.svg\n"
      "\n"
      "Prints the least number of edges (links) that a polygonal curve between the bodies has, as a number or as "
      "bounds\n"
      "that differ by one, and how many edges between the bodies are on their relative convex hulls. The curve is "
      "checked\n"
      "in exact arithmetic. Exit codes: 0, or 1 if the bodies overlap.\n");
  command.on_chosen([&action, arguments] { action = [arguments] { return run_separator(*arguments); }; });
}

}  // namespace taut::cli
