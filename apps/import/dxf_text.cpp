#include "import/dxf_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include "import/text_encoding.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

const char* const dxf_remedy = "save the drawing as ASCII DXF (R12 or later)";

/// Without the spaces around it, and the return of DOS.
std::string bare(const std::string& text, std::size_t begin, std::size_t end) {
  const auto gap = [&text](std::size_t i) { return text[i] == ' ' || text[i] == '\t' || text[i] == '\r'; };
  while (begin < end && gap(begin)) ++begin;
  while (end > begin && gap(end - 1)) --end;
  return text.substr(begin, end - begin);
}

/// The lines of a text, one after the other. Programs of the old Macintosh end them by a return alone.
class Lines {
 public:
  explicit Lines(const std::string& text)
      : text_(text), line_end_(text.find('\n') == std::string::npos ? '\r' : '\n') {}
  bool next(std::string* line) {
    if (position_ >= text_.size()) return false;
    const std::size_t end = std::min(text_.find(line_end_, position_), text_.size());
    *line = bare(text_, position_, end);
    position_ = end + 1;
    ++number_;
    return true;
  }
  int number() const { return number_; }

 private:
  const std::string& text_;
  char line_end_;
  std::size_t position_ = 0;
  int number_ = 0;
};

int group_code(const std::string& line, const std::string& place) {
  char* end = nullptr;
  const long code = std::strtol(line.c_str(), &end, 10);
  if (line.empty() || *end != 0 || code < -5 || code > 1100)
    throw InputError(place, "expected a group code, a number up to 1071 alone on its line", dxf_remedy);
  return static_cast<int>(code);
}

/// The value of a variable in the header; empty if it is not there.
std::string header_value(const std::vector<DxfItem>& items, const std::string& variable) {
  for (const DxfItem& item : items) {
    if (item.type() == "ENDSEC") break;
    bool found = false;
    for (const DxfGroup& group : item.groups()) {
      if (found) return group.value;
      found = group.code == 9 && group.value == variable;
    }
  }
  return "";
}

/// By the drawing's version and code page, as iconv calls it.
std::string encoding_of(const std::vector<DxfItem>& items) {
  if (header_value(items, "$ACADVER") >= "AC1021") return "UTF-8";
  const std::string page = header_value(items, "$DWGCODEPAGE");
  static const std::map<std::string, std::string> special{
      {"ANSI_932", "SHIFT_JIS"}, {"ANSI_936", "GBK"}, {"ANSI_949", "CP949"}, {"ANSI_950", "BIG5"}, {"UTF-8", "UTF-8"}};
  const auto known = special.find(page);
  if (known != special.end()) return known->second;
  if (page.rfind("ANSI_", 0) == 0 || page.rfind("ansi_", 0) == 0) return "CP" + page.substr(5);
  if (page.rfind("ISO8859-", 0) == 0) return "ISO-8859-" + page.substr(8);
  return "CP1252";
}

/// \U+00E8 as the character.
std::string with_characters(const std::string& text) {
  std::string s;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.compare(i, 3, "\\U+") == 0 && i + 7 <= text.size()) {
      const std::string digits = text.substr(i + 3, 4);
      char* end = nullptr;
      const unsigned long c = std::strtoul(digits.c_str(), &end, 16);
      if (*end == 0 && c > 0 && (c < 0xD800 || c > 0xDFFF)) {
        s += utf8_of(c);
        i += 6;
        continue;
      }
    }
    s += text[i];
  }
  return s;
}

/// Names may be in the encoding of the drawing's code page, whatever its version says.
void decode_texts(std::vector<DxfItem>& items) {
  const std::string encoding = encoding_of(items);
  for (DxfItem& item : items) {
    item.each_text([&encoding](std::string& text) {
      if (text.find('\\') != std::string::npos) text = with_characters(text);
      if (!is_utf8(text)) text = to_utf8(text, encoding == "UTF-8" ? "CP1252" : encoding);
    });
  }
}

}  // namespace

const DxfGroup* DxfItem::find(int code) const {
  for (const DxfGroup& group : groups_)
    if (group.code == code) return &group;
  return nullptr;
}

bool DxfItem::has(int code) const { return find(code) != nullptr; }

std::string DxfItem::text(int code, const std::string& otherwise) const {
  const DxfGroup* group = find(code);
  return group ? group->value : otherwise;
}

double DxfItem::number_of(const DxfGroup& group) const {
  std::size_t position = 0;
  const auto value = io::scan_number(group.value, &position);
  if (!value || position != group.value.size() || !std::isfinite(*value)) {
    throw InputError(place(group),
                     "expected a number for group " + std::to_string(group.code) + " of " + io::excerpt(type_) +
                         ", found \"" + io::excerpt(group.value) + "\"",
                     dxf_remedy);
  }
  return *value;
}

double DxfItem::number(int code, double otherwise) const {
  const DxfGroup* group = find(code);
  return group ? number_of(*group) : otherwise;
}

int DxfItem::integer(int code, int otherwise) const {
  const double value = number(code, otherwise);
  // What no drawing has becomes what no switch knows.
  return std::fabs(value) < 1e9 ? static_cast<int>(value) : -1;
}

std::vector<double> DxfItem::numbers(int code) const {
  std::vector<double> all;
  for (const DxfGroup& group : groups_)
    if (group.code == code) all.push_back(number_of(group));
  return all;
}

std::vector<Point> DxfItem::points(int code) const {
  std::vector<Point> all;
  for (const DxfGroup& group : groups_) {
    if (group.code == code) all.push_back({number_of(group), 0});
    if (group.code == code + 10 && !all.empty()) all.back().y = number_of(group);
  }
  return all;
}

std::vector<DxfItem> read_dxf_items(const std::string& text, const std::string& file) {
  if (text.rfind("AutoCAD Binary DXF", 0) == 0) throw InputError(file, "the file is a binary DXF", dxf_remedy);
  if (text.rfind("AC10", 0) == 0) throw InputError(file, "the file is a DWG", dxf_remedy);
  std::vector<DxfItem> items;
  Lines lines(text);
  std::string code_line, value;
  while (lines.next(&code_line)) {
    const std::string place = file + ":" + std::to_string(lines.number());
    const int code = group_code(code_line, place);
    if (!lines.next(&value)) throw InputError(place, "a group code without a value: the file is cut off", dxf_remedy);
    if (code == 999) continue;
    if (code == 0) {
      if (value == "EOF") {
        decode_texts(items);
        return items;
      }
      items.emplace_back(file, value, lines.number());
    } else if (items.empty()) {
      throw InputError(place, "the first group is not 0", dxf_remedy);
    } else {
      items.back().add({code, value, lines.number()});
    }
  }
  throw InputError(file, items.empty() ? "the file is empty" : "the file ends without EOF: it is cut off", dxf_remedy);
}

}  // namespace taut::drawing
