#include "import/rounded_rectangle.hpp"

namespace taut::drawing {

Chain rounded_rectangle(const Point& low, const Point& high, double rx, double ry, const Affine& where,
                        const std::string& place, Flattener& flattener) {
  Chain chain{{}, true, place};
  const auto corner = [&](double cx, double cy, int quarter) {
    if (rx == 0 || ry == 0) return chain.points.push_back(where({cx, cy}));
    const Affine turn = rotation(90 * quarter);
    // From the quarter's first axis to the next one.
    const Point a{turn.a * rx, turn.b * ry}, b{turn.c * rx, turn.d * ry};
    const Point middle{cx - a.x - b.x, cy - a.y - b.y};
    chain.points.push_back(where({middle.x + a.x, middle.y + a.y}));
    flattener.arc(chain.points, where(middle), where.turn(a), where.turn(b), 0, 3.14159265358979323846 / 2,
                  where({middle.x + b.x, middle.y + b.y}));
  };
  corner(high.x, high.y, 0);
  corner(low.x, high.y, 1);
  corner(low.x, low.y, 2);
  corner(high.x, low.y, 3);
  return chain;
}

}  // namespace taut::drawing
