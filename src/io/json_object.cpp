#include "io/json_object.hpp"

#include <algorithm>

#include "io/text.hpp"
#include "io/text_file.hpp"
#include "scene/names.hpp"

namespace taut::internal::io {
namespace {

/// What other formats call it, in the words of this one. Each stands for a key that is known where it is meant.
std::string translated(const std::string& key, const std::vector<std::string>& known) {
  static const std::pair<const char*, const char*> words[] = {
      {"parent", "relative_to"}, {"attached_to", "relative_to"}, {"frame", "relative_to"}, {"holes", "polygon"},
      {"outline", "polygon"},    {"shape", "polygon"},           {"points", "polygon"},    {"vertices", "polygon"},
      {"path", "polygon"},       {"from", "from_deg"},           {"to", "to_deg"},         {"exclude", "ignore"}};
  for (const auto& [word, meant] : words) {
    if (key == word && std::find(known.begin(), known.end(), meant) != known.end()) return meant;
  }
  return "";
}

std::string hint_for_unknown(const std::string& key, const std::vector<std::string>& known) {
  const std::string meant = translated(key, known), near = meant.empty() ? nearest_word(key, known) : meant;
  if (key == "holes" && near == "polygon")
    return R"(write "polygon": {"outline": [[x, y], ...], "holes": [[[x, y], ...], ...]})";
  std::string hint = near.empty() ? "" : "did you mean \"" + near + "\"? ";
  hint += "the keys here are ";
  for (std::size_t i = 0; i < known.size(); ++i) hint += (i ? ", \"" : "\"") + known[i] + "\"";
  return hint;
}

}  // namespace

std::string element_path(const std::string& path, std::size_t index) {
  return path + "[" + std::to_string(index) + "]";
}

std::string hint_for_name(const std::string& word, const std::vector<std::string>& known) {
  constexpr std::size_t most = 12;
  if (const std::string near = nearest_word(word, known); !near.empty()) return "is \"" + excerpt(near) + "\" meant?";
  std::string list;
  for (std::size_t i = 0; i < std::min(known.size(), most); ++i)
    list += (i > 0 ? ", \"" : "\"") + excerpt(known[i]) + "\"";
  if (known.empty()) return "there is none";
  return "there " + std::string(known.size() == 1 ? "is " : "are ") + list + (known.size() > most ? " and others" : "");
}

JsonObject::JsonObject(const JsonDocument& document, std::size_t token, const std::string& path,
                       const std::vector<std::string>& known, const std::string& shape)
    : document_(document), token_(token), path_(path), shape_(shape) {
  document.require(token, JsonKind::object, path, shape);
  const std::size_t end = document.after(token);
  for (std::size_t key = token + 1; key < end; key = document.after(key + 1)) {
    const std::string& name = document.string_at(key);
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw document.error(key, path, "unknown key \"" + excerpt(name) + "\"", hint_for_unknown(name, known));
    }
    if (find(name)) {
      throw document.error(key, path, "the key \"" + name + "\" appears twice", "keep one of the two");
    }
    members_.emplace_back(name, key + 1);
  }
}

bool has_member(const JsonDocument& document, std::size_t token, const std::string& key) {
  const std::size_t end = document.after(token);
  for (std::size_t k = token + 1; k < end; k = document.after(k + 1)) {
    if (document.string_at(k) == key) return true;
  }
  return false;
}

bool has_ranges(const JsonDocument& document) {
  if (document.at(0).kind() != JsonKind::object) return false;
  const auto has = [&](const char* name) { return has_member(document, 0, name); };
  return has("joints") || (has("mechanism") && !has("time"));
}

std::optional<std::size_t> JsonObject::find(const std::string& key) const {
  for (const auto& member : members_) {
    if (member.first == key) return member.second;
  }
  return std::nullopt;
}

std::size_t JsonObject::get(const std::string& key) const {
  if (const auto value = find(key)) return *value;
  throw document_.error(token_, path_, "the key \"" + key + "\" is missing", "write " + shape_);
}

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
