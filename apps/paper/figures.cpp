// The paper's figures, from runs of the scenes in examples/paper/.
#include <fmt/format.h>

#include <array>

#include "figure_tools.hpp"
#include "sheet.hpp"
#include "study.hpp"
#include "taut/separator.hpp"

namespace taut::paper {
namespace {

std::string separators(const std::vector<std::pair<Scene, double>>& placements) {
  Sheet sheet(3);
  for (const auto& [scene, t] : placements) {
    const Separator found = separator(scene, t);
    Tiling tiling;
    const std::array<Polygon, 2> bodies = placed(scene, t);
    for (int body : {0, 1}) {
      const Polygon& polygon = bodies[static_cast<std::size_t>(body)];
      for (std::size_t i = 0; i < polygon.size(); ++i)
        tiling.vertices.push_back({{body, static_cast<int>(i)}, polygon[i]});
    }
    const MinimumLinkSeparator& m = found.minimum_link;
    TilingDrawOptions o = panel_options();
    o.width = 400;
    o.paths = {{m.vertices, DrawnPath::Kind::separator, m.closed, {}}};
    const std::string links =
        m.lower == m.upper ? fmt::format("{} links", m.upper) : fmt::format("{} to {} links", m.lower, m.upper);
    sheet.add(draw_svg(scene, tiling, o), fmt::format("{} and {}, t = {}: {}, {}", scene.bodies[0].name,
                                                      scene.bodies[1].name, t, links, m.closed ? "closed" : "open"));
  }
  return sheet.draw();
}

}  // namespace

void draw_figures(Output& output, const std::string& folder) {
  const auto scene = [&folder](const std::string& name) { return read_scene(fmt::format("{}/{}.json", folder, name)); };
  output.write_text("fig1.svg", figure_1(scene("fig1")));
  output.write_text("fig2.svg", figure_2(scene("fig2")));
  output.write_text("fig3.svg", figure_3(scene("fig3")));
  output.write_text("fig4.svg", figure_4(scene("fig3")));
  output.write_text("fig5.svg", figure_5(scene("fig5")));
  output.write_text("fig7.svg", figure_7(scene("fig7")));
  output.write_text("fig8.svg", figure_8(scene("fig8a"), scene("fig8b")));
  output.write_text("fig16.svg", figure_16(scene("fig16")));
  output.write_text("fig17.svg", figure_17(scene("fig17")));
  output.write_text("separators.svg", separators({{scene("../gears"), 0.3},
                                                  {scene("../spiral"), 0.3},
                                                  {scene("../combs"), 0},
                                                  {scene("../jigsaw"), 0},
                                                  {scene("fig3"), 0},
                                                  {scene("fig5"), 6.5}}));
  output.note("figures: 1, 2, 3, 4, 5, 7, 8, 16, 17");
}

}  // namespace taut::paper
