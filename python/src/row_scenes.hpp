// Many scenes that have most in common.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "scene_text.hpp"
#include "shape.hpp"

namespace taut_python {

/// A body's pivots: one for all rows, or one for each. Null is (0, 0).
struct PivotColumn {
  const double* values = nullptr;
  bool one_each = false;

  taut::Point at(std::size_t row) const;
};

/// Keyframes of one body: `count` of them in each row, each t, x, y and, if there are four columns, an angle in
/// degrees.
struct KeyframeColumn {
  std::size_t body;
  const double* values;
  std::size_t count, columns;
  PivotColumn pivots;
};

/// Velocities of one body: vx, vy and the spin in degrees in each row.
struct VelocityColumn {
  std::size_t body;
  const double* values;
  PivotColumn pivots;
};

/// Throws InputError.
taut::Motion motion_of(const KeyframeColumn& column, std::size_t row);
taut::Motion motion_of(const VelocityColumn& column, std::size_t row);

/// Shapes of one body, one for each row.
struct ShapeColumn {
  std::size_t body;
  std::vector<std::shared_ptr<const Shape>> shapes;
};

/// Where the scenes of the rows come from.
class RowScenes {
 public:
  virtual ~RowScenes() = default;
  virtual std::size_t size() const = 0;
  /// What a thread begins with, before it is given rows.
  virtual taut::Scene blank() const = 0;
  /// Makes it the scene of that row; it was a blank, or the scene of another row. Throws InputError.
  virtual void fill(taut::Scene& scene, std::size_t row) const = 0;
};

/// One scene in which some bodies' motions and shapes, and the time, differ from row to row. What the columns point to
/// must live as long.
class TemplateRows final : public RowScenes {
 public:
  TemplateRows(taut::Scene scene, std::size_t rows) : scene_(std::move(scene)), rows_(rows) {}

  std::vector<std::variant<KeyframeColumn, VelocityColumn>> motions;
  std::vector<ShapeColumn> shapes;
  /// Start and end in each row; null: those of the scene.
  const double* times = nullptr;

  const taut::Scene& scene() const { return scene_; }
  std::size_t size() const override { return rows_; }
  taut::Scene blank() const override { return scene_; }
  void fill(taut::Scene& scene, std::size_t row) const override;

 private:
  taut::Scene scene_;
  std::size_t rows_;
};

/// Scenes that have nothing in common.
class TextRows final : public RowScenes {
 public:
  explicit TextRows(std::vector<SceneText> texts) : texts_(std::move(texts)) {}

  std::size_t size() const override { return texts_.size(); }
  taut::Scene blank() const override { return {}; }
  void fill(taut::Scene& scene, std::size_t row) const override { scene = texts_[row].read(); }

 private:
  std::vector<SceneText> texts_;
};

}  // namespace taut_python
