#include "io/json_numbers.hpp"

#include "io/json_object.hpp"

namespace taut::internal::io {

namespace {

/// The paths of vertices are only put together when there is something to complain about.
[[noreturn]] void fail_point(const JsonDocument& document, std::size_t token, const std::string& path,
                             std::size_t index) {
  const std::string here = element_path(path, index);
  const std::string shape = "a vertex as [x, y] with two numbers";
  document.require(token, JsonKind::array, here, shape);
  const std::size_t end = document.after(token);
  std::size_t count = 0;
  for (std::size_t i = token + 1; i < end; i = document.after(i), ++count) {
    if (count < 2) document.require(i, JsonKind::number, element_path(here, count), shape);
  }
  throw document.error(token, here, "a vertex has two coordinates, found " + std::to_string(count), "write " + shape);
}

}  // namespace

void fail_size(const JsonDocument& document, std::size_t token, const std::string& path, std::size_t max_vertices) {
  throw document.error(token, path, "more vertices than the limit of " + std::to_string(max_vertices),
                       "simplify the outline, or raise ReadLimits::max_vertices");
}

double read_number(const JsonDocument& document, std::size_t token, const std::string& path) {
  document.require(token, JsonKind::number, path, "a number, without quotes");
  return document.at(token).number;
}

std::vector<double> read_numbers(const JsonDocument& document, std::size_t token, const std::string& path,
                                 const std::string& shape, std::size_t max_count, const std::string& limit_hint) {
  document.require(token, JsonKind::array, path, shape);
  std::vector<double> numbers;
  const std::size_t end = document.after(token);
  for (std::size_t i = token + 1; i < end; i = document.after(i)) {
    if (numbers.size() == max_count) {
      throw document.error(i, path, "more than " + std::to_string(max_count) + " numbers", limit_hint);
    }
    document.require(i, JsonKind::number, element_path(path, numbers.size()), shape);
    numbers.push_back(document.at(i).number);
  }
  return numbers;
}

Polygon read_points(const JsonDocument& document, std::size_t token, const std::string& path, std::size_t max_vertices,
                    bool more_coordinates) {
  document.require(token, JsonKind::array, path, "a polygon as [[x, y], [x, y], ...]");
  Polygon polygon;
  const std::size_t end = document.after(token);
  for (std::size_t i = token + 1; i < end; i = document.after(i)) {
    if (polygon.size() == max_vertices) fail_size(document, i, path, max_vertices);
    const bool pair = document.at(i).kind() == JsonKind::array &&
                      (more_coordinates ? document.after(i) >= i + 3 : document.after(i) == i + 3) &&
                      document.at(i + 1).kind() == JsonKind::number && document.at(i + 2).kind() == JsonKind::number;
    if (!pair) fail_point(document, i, path, polygon.size());
    polygon.push_back({document.at(i + 1).number, document.at(i + 2).number});
  }
  return polygon;
}

}  // namespace taut::internal::io
