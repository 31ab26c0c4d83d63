#include "scene/names.hpp"

#include <algorithm>
#include <cctype>

namespace taut::internal {
namespace {

std::string lower_case(std::string s) {
  for (char& c : s) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return s;
}

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_word(const std::string& word, const std::vector<std::string>& known) {
  if (word.size() < 3 || word.size() > 40) return "";
  // "angle" is meant for "angle_deg", whatever the distance.
  for (const std::string& candidate : known) {
    if (lower_case(candidate).compare(0, word.size() + 1, lower_case(word) + "_") == 0) return candidate;
  }
  std::string best;
  std::size_t best_distance = word.size() / 3 + 2;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(lower_case(word), lower_case(candidate));
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::vector<std::string> names_of(const std::vector<Body>& bodies) {
  std::vector<std::string> names;
  names.reserve(bodies.size());
  for (const Body& body : bodies) names.push_back(body.name);
  return names;
}

InputError no_such_body(const std::vector<std::string>& known, const std::string& name, const std::string& place,
                        const std::string& what, const std::string& hint) {
  const std::string near = nearest_word(name, known);
  return {place, "there is no body \"" + name + "\"" + what,
          (near.empty() ? "" : "did you mean \"" + near + "\"? ") + hint};
}

}  // namespace taut::internal
