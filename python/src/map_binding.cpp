// StaticMap: one body among many that rest, asked once, or many times at once.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "ask/map_answer.hpp"
#include "attended.hpp"
#include "bindings.hpp"
#include "buffers.hpp"
#include "each_row.hpp"
#include "numeric/budget.hpp"
#include "scene_text.hpp"
#include "taut/motions.hpp"
#include "taut/static_map.hpp"

namespace py = pybind11;

namespace taut_python {
namespace {

/// A mover, and its body for the texts of answers.
struct MapMover {
  taut::StaticMap::Mover mover;
  taut::Body body;
};

taut::StaticMap map_of(const SceneText& text, double reach) {
  return attended<taut::StaticMap>([&](const std::atomic<bool>& stop) {
    const taut::internal::Budget scope(taut::Limits{.stop = &stop});
    return taut::StaticMap(text.read().bodies, reach);
  });
}

/// The scene's only body.
MapMover mover_of(const taut::StaticMap& map, const SceneText& text) {
  return attended<MapMover>([&](const std::atomic<bool>& stop) {
    const taut::internal::Budget scope(taut::Limits{.stop = &stop});
    taut::Body body = text.read().bodies.at(0);
    taut::StaticMap::Mover mover = map.prepare(body);
    return MapMover{std::move(mover), std::move(body)};
  });
}

/// `text` is a scene of one body, which has the motion, on the time that is asked about.
py::tuple check_on_map(const taut::StaticMap& map, const MapMover& mover, const SceneText& text,
                       const RunOptions& options) {
  using taut::internal::MapAnswerText;
  const MapAnswerText found = attended<MapAnswerText>([&](const std::atomic<bool>& stop) {
    const taut::CheckOptions how = check_options(options, stop);
    taut::Scene asked = text.read();
    taut::Body body = mover.body;
    body.motion = std::move(asked.bodies.at(0).motion);
    const taut::Answer answer = map.check(mover.mover, body.motion, asked.start, asked.end, how);
    return taut::internal::map_answer_text(map, body, asked.start, asked.end, answer, how.touch);
  });
  return py::make_tuple(found.before, found.after);
}

/// At the end of the time of the scene, which is as in check_on_map().
std::optional<int> overlapped_on_map(const taut::StaticMap& map, const MapMover& mover, const SceneText& text,
                                     const RunOptions& options) {
  return attended<std::optional<int>>([&](const std::atomic<bool>& stop) -> std::optional<int> {
    const taut::CheckOptions how = check_options(options, stop);
    const taut::Scene asked = text.read();
    return map.overlapped(mover.mover, asked.bodies.at(0).motion, asked.end, how.touch);
  });
}

/// Motions of one mover, and the times on which they are asked about, for Python to fill in.
class MapRows {
 public:
  explicit MapRows(std::size_t rows) : rows_(rows) {}
  void keyframes(std::size_t body, const py::buffer& values, std::size_t count, std::size_t columns,
                 const py::object& pivots) {
    const double* found = buffers_.doubles(values, rows_ * count * columns);
    motions_ = KeyframeColumn{body, found, count, columns, buffers_.pivots(pivots, rows_)};
  }
  void velocities(std::size_t body, const py::buffer& values, const py::object& pivots) {
    motions_ = VelocityColumn{body, buffers_.doubles(values, rows_ * 3), buffers_.pivots(pivots, rows_)};
  }
  void times(const py::buffer& values) { times_ = buffers_.doubles(values, rows_ * 2); }

  std::size_t size() const { return rows_; }
  taut::Motion motion(std::size_t row) const {
    return std::visit([row](const auto& column) { return motion_of(column, row); }, motions_);
  }
  double start(std::size_t row) const { return times_[2 * row]; }
  double end(std::size_t row) const { return times_[2 * row + 1]; }

 private:
  std::size_t rows_;
  Buffers buffers_;
  std::variant<KeyframeColumn, VelocityColumn> motions_;
  const double* times_ = nullptr;
};

void check_rows_on_map(const taut::StaticMap& map, const MapMover& mover, const MapRows& rows,
                       const RunOptions& options, std::size_t threads, const py::buffer& into) {
  Buffers buffers;
  AnswerRow* answers = buffers.answers(into, rows.size());
  attended<bool>([&](const std::atomic<bool>& stop) {
    const taut::CheckOptions how = check_options(options, stop);
    each_row(rows.size(), threads, stop, [&]() -> RowWork {
      return [&](std::size_t row) {
        const taut::Answer answer = map.check(mover.mover, rows.motion(row), rows.start(row), rows.end(row), how);
        answers[row] = answer_row(answer);
      };
    });
    return true;
  });
}

/// Into each row the first body that is overlapped, or -1. Placements are x, y and an angle in degrees.
void overlapped_rows_on_map(const taut::StaticMap& map, const MapMover& mover, const py::buffer& placements,
                            std::size_t rows, const RunOptions& options, std::size_t threads, const py::buffer& into) {
  Buffers buffers;
  const double* numbers = buffers.doubles(placements, 3 * rows);
  double* found = buffers.doubles(into, rows, true);
  attended<bool>([&](const std::atomic<bool>& stop) {
    const taut::Touch touch = check_options(options, stop).touch;
    each_row(rows, threads, stop, [&]() -> RowWork {
      return [&](std::size_t row) {
        const double* at = numbers + 3 * row;
        const taut::Motion motion = taut::from_keyframes({{0, at[0], at[1], at[2]}});
        found[row] = map.overlapped(mover.mover, motion, 0, touch).value_or(-1);
      };
    });
    return true;
  });
}

}  // namespace

void bind_maps(py::module_& module) {
  py::class_<MapMover>(module, "MapMover");
  py::class_<taut::StaticMap>(module, "StaticMap")
      .def(py::init(&map_of))
      .def("prepare", &mover_of)
      .def("check", &check_on_map)
      .def("overlapped", &overlapped_on_map)
      .def("check_rows", &check_rows_on_map)
      .def("overlapped_rows", &overlapped_rows_on_map);
  py::class_<MapRows>(module, "MapRows")
      .def(py::init<std::size_t>())
      .def("keyframes", &MapRows::keyframes)
      .def("velocities", &MapRows::velocities)
      .def("times", &MapRows::times);
}

}  // namespace taut_python
