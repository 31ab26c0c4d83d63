#include "query/bracket.hpp"

#include <algorithm>

namespace taut::internal {
namespace {

/// Calls visit(cell, mark) for the cells of a body that can be refined.
template <class Visit>
void for_each_cell(const CurvedWorld& world, BodyId body, CurvedWorld::Halvings& marks, const Visit& visit) {
  for (std::size_t p = 0; p < world.parts(body).size(); ++p) {
    const auto& bands = world.parts(body)[p].bands();
    for (std::size_t ring = 0; ring < bands.size(); ++ring) {
      const auto& cells = bands[ring].cells();
      for (std::size_t k = 0; k < cells.size(); ++k) {
        if (!cells[k].is_final) visit(cells[k], marks[static_cast<std::size_t>(body)][p][ring][k]);
      }
    }
  }
}

}  // namespace

void Marks::as_thick(const std::array<BodyId, 2>& pair) {
  double thickest = 0;
  for (const BodyId body : pair) {
    for_each_cell(world_, body, halvings_, [&](const curve::Cell& cell, int mark) {
      if (mark > 0) thickest = std::max(thickest, cell.thickness);
    });
  }
  if (thickest == 0) return;
  for (const BodyId body : pair) {
    for_each_cell(world_, body, halvings_, [&](const curve::Cell& cell, int& mark) {
      if (mark > 0 || cell.thickness < thickest / 2) return;
      mark = 1;
      ++count_;
    });
  }
}

CurvedWorld::Halvings Marks::times(int halvings) && {
  for (auto& body : halvings_) {
    for (auto& part : body) {
      for (auto& ring : part) {
        for (int& mark : ring) mark *= halvings;
      }
    }
  }
  return std::move(halvings_);
}

bool CurvedRun::refine_beyond_limit(Marks marks) {
  const std::size_t count = marks.count();
  return count > 0 && world_.refine(std::move(marks).times(count > 64 ? 1 : count > 24 ? 2 : 4));
}

bool CurvedRun::refine(Marks marks, int halvings) {
  return marks.count() > 0 && !at_limit() && world_.refine(std::move(marks).times(halvings));
}

}  // namespace taut::internal
