// Several pictures on one sheet.
#pragma once

#include <string>
#include <vector>

namespace taut::paper {

/// Pictures (whole SVG documents) in rows, each with a caption above it.
class Sheet {
 public:
  explicit Sheet(int columns) : columns_(columns) {}
  void add(const std::string& svg, const std::string& caption);
  std::string draw() const;

 private:
  struct Panel {
    std::string svg, caption;
    double width = 0, height = 0;
  };
  int columns_;
  std::vector<Panel> panels_;
};

}  // namespace taut::paper
