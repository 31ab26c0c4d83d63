// Occupancy grids of map_server: a little YAML, and a PGM.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "io/outline_reader.hpp"
#include "io/platform.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"
#include "taut/grid.hpp"

namespace taut::internal::io {
namespace {

const char* const yaml_shape =
    "a map has lines like:  image: map.pgm  resolution: 0.05  origin: [-10, -10, 0]  negate: 0  "
    "occupied_thresh: 0.65  free_thresh: 0.25";

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The keys that maps have, one a line; comments begin with # after a space or at the start of a line.
class MapYaml {
 public:
  MapYaml(const std::string& text, std::string file) : file_(std::move(file)) {
    std::size_t number = 0;
    for (std::size_t at = 0; at <= text.size(); ++number) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      if (!add(text.substr(at, end - at), number + 1)) break;
      at = end + 1;
    }
  }

  bool has(const std::string& key) const { return lines_.count(key) > 0; }

  std::string text(const std::string& key) const {
    const std::string value = found(key).value;
    if (value.empty()) refuse(key, "`" + key + "` has no value");
    const bool quoted = value.size() > 1 && (value.front() == '"' || value.front() == '\'');
    if (!quoted) return value;
    if (value.back() != value.front()) refuse(key, "the quotes of `" + key + "` are not closed");
    return value.substr(1, value.size() - 2);
  }

  double number(const std::string& key) const { return number_in(key, text(key)); }

  double number_or(const std::string& key, double otherwise) const { return has(key) ? number(key) : otherwise; }

  /// 0 and 1, or words.
  bool flag(const std::string& key) const {
    if (!has(key)) return false;
    const std::string word = text(key);
    if (word == "1" || word == "true" || word == "True") return true;
    if (word == "0" || word == "false" || word == "False") return false;
    refuse(key, "`" + key + "` is neither 0 nor 1");
  }

  /// [x, y, yaw].
  std::vector<double> list(const std::string& key) const {
    std::string value = text(key);
    if (value.front() != '[' || value.back() != ']') refuse(key, "`" + key + "` is not a list in brackets");
    value = value.substr(1, value.size() - 2);
    std::vector<double> numbers;
    for (std::size_t at = 0; at <= value.size();) {
      const std::size_t comma = std::min(value.find(',', at), value.size());
      numbers.push_back(number_in(key, trimmed(value.substr(at, comma - at))));
      at = comma + 1;
    }
    return numbers;
  }

  [[noreturn]] void refuse(const std::string& key, const std::string& what) const {
    const auto line = lines_.find(key);
    throw InputError(line == lines_.end() ? file_ : file_ + ":" + std::to_string(line->second.number), what,
                     yaml_shape);
  }

 private:
  struct Line {
    std::size_t number;
    std::string value;
    bool dashes = false;  ///< the value is a list whose items are on lines of their own
  };

  /// False at the end of the document.
  bool add(std::string line, std::size_t number) {
    char quote = 0;
    for (std::size_t k = 0; k < line.size(); ++k) {
      const bool first = k == 0 || line[k - 1] == ' ' || line[k - 1] == '\t' || line[k - 1] == ':';
      if (quote != 0)
        quote = line[k] == quote ? '\0' : quote;
      else if (first && (line[k] == '"' || line[k] == '\''))
        quote = line[k];
      else if (first && line[k] == '#' && (k == 0 || line[k - 1] != ':'))
        line.resize(k);
    }
    line = trimmed(line);
    if (line == "...") return false;
    if (line.empty() || line.starts_with("---") || line.front() == '%') return true;
    if (continues(line)) return true;
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos)
      throw InputError(file_ + ":" + std::to_string(number), "the line \"" + excerpt(line) + "\" is no `key: value`",
                       yaml_shape);
    const std::string key = trimmed(line.substr(0, colon));
    const auto [place, is_new] = lines_.emplace(key, Line{number, trimmed(line.substr(colon + 1))});
    if (!is_new)
      throw InputError(file_ + ":" + std::to_string(number), "`" + excerpt(key) + "` is given twice", yaml_shape);
    last_ = &place->second;
    return true;
  }

  /// Of the value before: items of a list, each on a line after a dash, or more of one in brackets.
  bool continues(const std::string& line) {
    if (!last_) return false;
    std::string& value = last_->value;
    const bool item = line == "-" || line.starts_with("- ") || line.starts_with("-\t");
    if (item && (value.empty() || last_->dashes)) {
      last_->dashes = true;
      if (!value.empty()) value.pop_back();
      value += (value.empty() ? "[" : ", ") + trimmed(line.substr(1)) + "]";
      return true;
    }
    const bool open = !value.empty() && value.front() == '[' && value.find(']') == std::string::npos;
    if (!open && !(value.empty() && line.front() == '[')) return false;
    value += (value.empty() ? "" : " ") + line;
    return true;
  }

  const Line& found(const std::string& key) const {
    const auto line = lines_.find(key);
    if (line == lines_.end()) refuse(key, "`" + key + "` is missing");
    return line->second;
  }

  double number_in(const std::string& key, const std::string& word) const {
    std::size_t position = word.size() > 1 && word[0] == '+' ? 1 : 0;
    const std::optional<double> value = scan_number(word, &position);
    if (!value || position != word.size() || !std::isfinite(*value))
      refuse(key, "`" + key + "`: \"" + excerpt(word) + "\" is not a finite number");
    return *value;
  }

  std::string file_;
  std::map<std::string, Line> lines_;
  Line* last_ = nullptr;
};

/// P2 (numbers) or P5 (bytes).
class PgmReader {
 public:
  PgmReader(const std::string& text, std::string file) : text_(text), file_(std::move(file)) {}

  GreyImage read() {
    const bool plain = text_.compare(0, 2, "P2") == 0;
    if (!plain && text_.compare(0, 2, "P5") != 0)
      fail("this is no PGM: it begins with neither P2 nor P5", "convert it, for example: convert map.png map.pgm");
    at_ = 2;
    GreyImage image;
    image.width = number("the width", 1, 1 << 15);
    image.height = number("the height", 1, 1 << 15);
    const int most = number("the largest grey", 1, 65535);
    const std::size_t cells = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (plain) {
      if (cells > text_.size()) short_of(cells);
      for (std::size_t k = 0; k < cells; ++k) image.grey.push_back(number("a grey", 0, most) / double(most));
    } else {
      read_bytes(image, cells, most);
    }
    return image;
  }

 private:
  void read_bytes(GreyImage& image, std::size_t cells, int most) {
    ++at_;  // one white space ends the header
    const std::size_t bytes = most < 256 ? 1 : 2;
    if (text_.size() < at_ || (text_.size() - at_) / bytes < cells) short_of(cells);
    for (std::size_t k = 0; k < cells; ++k) {
      unsigned value = 0;
      for (std::size_t b = 0; b < bytes; ++b) value = 256 * value + static_cast<unsigned char>(text_[at_++]);
      image.grey.push_back(std::min(1.0, value / double(most)));
    }
  }

  [[noreturn]] void short_of(std::size_t cells) {
    fail("the image ends before its " + std::to_string(cells) + " cells", "the file was cut off: get it anew");
  }

  int number(const char* what, int least, int most) {
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '#')
        at_ = std::min(text_.find('\n', at_), text_.size() - 1);
      else if (!std::isspace(static_cast<unsigned char>(text_[at_])))
        break;
    }
    long value = 0;
    const std::size_t begin = at_;
    for (; at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) && value <= 65535; ++at_)
      value = 10 * value + (text_[at_] - '0');
    if (at_ == begin || value < least || value > most)
      fail(std::string(what) + " is not a number from " + std::to_string(least) + " to " + std::to_string(most),
           "see the format: https://netpbm.sourceforge.net/doc/pgm.html");
    return static_cast<int>(value);
  }

  [[noreturn]] void fail(const std::string& what, const std::string& hint) {
    throw InputError(place_in_text(text_, file_, at_), what, hint);
  }

  const std::string& text_;
  std::string file_;
  std::size_t at_ = 0;
};

struct Thresholds {
  double occupied = 0.65, free = 0.25;
  bool negate = false;
};

Thresholds thresholds_of(const MapYaml& yaml) {
  Thresholds t;
  t.occupied = yaml.number_or("occupied_thresh", t.occupied);
  t.free = yaml.number_or("free_thresh", t.free);
  t.negate = yaml.flag("negate");
  if (!(t.free <= t.occupied)) yaml.refuse("free_thresh", "`free_thresh` is above `occupied_thresh`");
  const std::string mode = yaml.has("mode") ? yaml.text("mode") : "trinary";
  if (mode != "trinary" && mode != "scale") yaml.refuse("mode", "`mode` \"" + excerpt(mode) + "\" is not read");
  return t;
}

}  // namespace
}  // namespace taut::internal::io

namespace taut {
using namespace internal;

OccupancyGrid read_grid(const std::string& yaml_file, const GridOptions& options, const ReadLimits& limits) {
  const io::MapYaml yaml(io::read_text_file(yaml_file, limits.max_bytes), yaml_file);
  const std::vector<double> origin = yaml.list("origin");
  if (origin.size() != 3) yaml.refuse("origin", "`origin` has " + std::to_string(origin.size()) + " numbers, not 3");
  const io::Thresholds limit = io::thresholds_of(yaml);
  OccupancyGrid grid;
  grid.resolution = yaml.number("resolution");
  if (!(grid.resolution > 0)) yaml.refuse("resolution", "`resolution` is not positive");
  grid.origin = {origin[0], origin[1]};
  grid.yaw = origin[2];
  std::string image;
  try {
    image = io::named_file(io::folder_of(yaml_file), yaml.text("image"), limits.allow_outside);
  } catch (const InputError& error) {
    yaml.refuse("image", error.problem());
  }
  const std::string bytes = io::read_text_file(image, limits.max_bytes);
  std::optional<GreyImage> other = options.read_image ? options.read_image(bytes, image) : std::nullopt;
  const GreyImage grey = other ? std::move(*other) : io::PgmReader(bytes, image).read();
  grid.width = grey.width;
  grid.height = grey.height;
  grid.occupied.resize(grey.grey.size());
  for (int j = 0; j < grid.height; ++j) {
    for (int i = 0; i < grid.width; ++i) {
      const auto row = static_cast<std::size_t>(grid.height - 1 - j), width = static_cast<std::size_t>(grid.width);
      const double g = grey.grey[row * width + static_cast<std::size_t>(i)], dark = limit.negate ? g : 1 - g;
      const bool taken = options.unknown_occupied ? !(dark < limit.free) : dark > limit.occupied;
      grid.occupied[static_cast<std::size_t>(j) * width + static_cast<std::size_t>(i)] = taken ? 1 : 0;
    }
  }
  return grid;
}

}  // namespace taut
