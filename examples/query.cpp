// What a planner asks: may the robot be here, may it go from here to there, and what does it meet?
#include <iostream>
#include <taut/taut.hpp>

int main() {
  const taut::StaticMap hall(
      {{"pillar", {{4, 1}, {5, 1}, {5, 2}, {4, 2}}, {}}, {"wall", {{0, 4}, {9, 4}, {9, 5}, {0, 5}}, {}}});
  taut::MapQuery query(hall, hall.prepare({"robot", {{-0.5, -0.2}, {0.5, -0.2}, {0.5, 0.2}, {-0.5, 0.2}}, {}}));
  const taut::PoseSE2 here{1, 2.7, 0}, there{8, 2.7, 1.5}, behind{8, 1.5, 0};
  std::cout << query.at(here).free() << query.passes(here, there).free() << query.passes(here, behind).free() << '\n';
  const taut::MapFinding found = query.along(here, behind);
  std::cout << "free until " << found.free_until << ", then " << hall.body(found.body).name << '\n';
}
