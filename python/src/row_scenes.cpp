#include "row_scenes.hpp"

#include "taut/motions.hpp"

namespace taut_python {

taut::Motion motion_of(const KeyframeColumn& column, std::size_t row) {
  std::vector<taut::Keyframe> keyframes(column.count);
  const double* values = column.values + row * column.count * column.columns;
  for (taut::Keyframe& k : keyframes) {
    k.t = values[0];
    k.x = values[1];
    k.y = values[2];
    if (column.columns == 4) k.angle_deg = values[3];
    values += column.columns;
  }
  return taut::from_keyframes(keyframes, column.pivots.at(row));
}

taut::Motion motion_of(const VelocityColumn& column, std::size_t row) {
  const double* values = column.values + row * 3;
  return taut::from_velocity({values[0], values[1]}, values[2], column.pivots.at(row));
}

taut::Point PivotColumn::at(std::size_t row) const {
  if (!values) return {};
  const double* pivot = values + (one_each ? 2 * row : 0);
  return {pivot[0], pivot[1]};
}

void TemplateRows::fill(taut::Scene& scene, std::size_t row) const {
  for (const ShapeColumn& column : shapes) column.shapes[row]->put_into(scene.bodies[column.body]);
  if (times) {
    scene.start = times[2 * row];
    scene.end = times[2 * row + 1];
  }
  for (const auto& any : motions) {
    std::visit(
        [&](const auto& column) {
          taut::Body& body = scene.bodies[column.body];
          try {
            body.motion = motion_of(column, row);
          } catch (const taut::InputError& error) {
            throw error.within(body.name);
          }
        },
        any);
  }
}

}  // namespace taut_python
