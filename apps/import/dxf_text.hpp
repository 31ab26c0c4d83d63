// DXF as text: pairs of a group code and a value, each on a line.
#pragma once

#include <string>
#include <vector>

#include "import/drawing.hpp"

namespace taut::drawing {

struct DxfGroup {
  int code = 0;
  std::string value;
  int line = 0;  ///< of the value
};

/// An entity, or what else begins with a group 0: its type and the groups up to the next one.
class DxfItem {
 public:
  DxfItem(std::string file, std::string type, int line) : file_(std::move(file)), type_(std::move(type)), line_(line) {}

  const std::string& type() const { return type_; }
  std::string place() const { return file_ + ":" + std::to_string(line_); }
  std::string place(const DxfGroup& group) const { return file_ + ":" + std::to_string(group.line); }
  void add(DxfGroup group) { groups_.push_back(std::move(group)); }
  const std::vector<DxfGroup>& groups() const { return groups_; }
  /// Lets `change` change the values that are names.
  template <class Change>
  void each_text(const Change& change) {
    for (DxfGroup& group : groups_)
      if (group.code <= 9) change(group.value);
  }

  /// The first value of the code. Numbers throw InputError with the line if they are none.
  std::string text(int code, const std::string& otherwise = "") const;
  double number(int code, double otherwise = 0) const;
  int integer(int code, int otherwise = 0) const;
  bool has(int code) const;
  /// All values of the code.
  std::vector<double> numbers(int code) const;
  /// Points, whose x is at `code` and whose y at `code` + 10.
  Point point(int code) const { return {number(code), number(code + 10)}; }
  std::vector<Point> points(int code) const;
  /// A value as a number.
  double number_of(const DxfGroup& group) const;

 private:
  const DxfGroup* find(int code) const;
  std::string file_, type_;
  int line_;
  std::vector<DxfGroup> groups_;
};

/// All items of a file. Throws InputError where the text is not such pairs.
std::vector<DxfItem> read_dxf_items(const std::string& text, const std::string& file);

}  // namespace taut::drawing
