// Cells that a body touches: as JSON, and as a map for map_server.
#include <algorithm>

#include "io/answer_writer.hpp"
#include "io/number_text.hpp"
#include "taut/cells.hpp"
#include "taut/scene.hpp"

namespace taut {
using namespace internal;
namespace {

struct CellRange {
  int i0 = 0, j0 = 0, i1 = -1, j1 = -1;
};

CellRange range_of_cells(const CoveredCells& covered) {
  if (covered.cells.empty()) return {};
  CellRange r{covered.cells[0][0], covered.cells[0][1], covered.cells[0][0], covered.cells[0][1]};
  for (const auto& [i, j] : covered.cells) {
    r.i0 = std::min(r.i0, i);
    r.i1 = std::max(r.i1, i);
    r.j0 = std::min(r.j0, j);
    r.j1 = std::max(r.j1, j);
  }
  return r;
}

}  // namespace

std::string cells_json(const Scene& scene, BodyId body, const CoveredCells& covered) {
  io::AnswerWriter json(scene);
  json.object([&] {
    json.key("body");
    json.name(body);
    json.member("resolution", covered.resolution);
    json.member("origin", covered.origin);
    if (scene.lock) json.lock(*scene.lock);
    json.key("cells").array(covered.cells, [&](const std::array<int, 2>& cell) {
      json.array([&] {
        json.integer(cell[0]);
        json.integer(cell[1]);
      });
    });
  });
  return json.text();
}

std::string cells_pgm(const CoveredCells& covered) {
  const CellRange r = range_of_cells(covered);
  if (covered.cells.empty()) return {};
  const auto width = static_cast<std::size_t>(r.i1 - r.i0 + 1), height = static_cast<std::size_t>(r.j1 - r.j0 + 1);
  std::string pixels(width * height, '\xfe');
  for (const auto& [i, j] : covered.cells)
    pixels[static_cast<std::size_t>(r.j1 - j) * width + static_cast<std::size_t>(i - r.i0)] = '\0';
  return "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n" + pixels;
}

std::string cells_yaml(const CoveredCells& covered, const std::string& image_file) {
  const CellRange r = range_of_cells(covered);
  const double x = covered.origin.x + covered.resolution * r.i0, y = covered.origin.y + covered.resolution * r.j0;
  return "image: " + image_file + "\nresolution: " + io::number_text(covered.resolution) + "\norigin: [" +
         io::number_text(x) + ", " + io::number_text(y) + ", 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n";
}

}  // namespace taut
