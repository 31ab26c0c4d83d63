#include "io/pair_reader.hpp"

#include "io/json_object.hpp"
#include "io/motion_reader.hpp"

namespace taut::internal::io {
namespace {

const char* const ignored_shape = R"("ignore": [["door", "pin"], ["chassis", "*"]])";
const char* const clearances_shape =
    R"("clearances": [{"pair": ["arm", "wall"], "margin": 0.5}, {"pair": ["arm", "*"], "margin": [0.2, 0.05]}])";

std::array<std::string, 2> read_pair(const JsonDocument& document, std::size_t token, const std::string& path,
                                     const std::string& shape) {
  document.require(token, JsonKind::array, path, shape);
  std::vector<std::string> names;
  for (std::size_t k = token + 1; k < document.after(token); k = document.after(k)) {
    document.require(k, JsonKind::string, path, shape);
    names.push_back(document.string_at(k));
  }
  if (names.size() != 2)
    throw document.error(token, path, "expected two names, found " + std::to_string(names.size()), "write " + shape);
  return {names[0], names[1]};
}

/// A number, or the coefficients of a polynomial.
Coefficients read_margin(const JsonDocument& document, std::size_t token, const std::string& path) {
  if (document.at(token).kind() == JsonKind::number) return {read_number(document, token, path)};
  return read_coefficients(document, token, path, "lower the degree");
}

}  // namespace

std::vector<std::array<std::string, 2>> read_ignored(const JsonDocument& document, std::size_t token) {
  document.require(token, JsonKind::array, "ignore", ignored_shape);
  std::vector<std::array<std::string, 2>> pairs;
  for (std::size_t i = token + 1; i < document.after(token); i = document.after(i))
    pairs.push_back(read_pair(document, i, element_path("ignore", pairs.size()), ignored_shape));
  return pairs;
}

std::vector<PairClearance> read_clearances(const JsonDocument& document, std::size_t token) {
  document.require(token, JsonKind::array, "clearances", clearances_shape);
  std::vector<PairClearance> clearances;
  for (std::size_t i = token + 1; i < document.after(token); i = document.after(i)) {
    const JsonObject entry(document, i, element_path("clearances", clearances.size()), {"pair", "margin", "origin"},
                           R"(a clearance as {"pair": ["arm", "wall"], "margin": 0.5})");
    PairClearance clearance;
    clearance.pair = read_pair(document, entry.get("pair"), entry.path("pair"), R"("pair": ["arm", "wall"])");
    clearance.margin.coefficients = read_margin(document, entry.get("margin"), entry.path("margin"));
    if (const auto origin = entry.find("origin"))
      clearance.margin.origin = read_number(document, *origin, entry.path("origin"));
    clearances.push_back(std::move(clearance));
  }
  return clearances;
}

}  // namespace taut::internal::io
