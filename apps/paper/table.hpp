// A table of measurements: written as CSV, and what plots are drawn from.
#pragma once

#include <string>
#include <vector>

namespace taut::paper {

/// Columns of text: numbers are formatted when they are put in, so that the file and the plot show the same.
class Table {
 public:
  Table(std::string name, std::vector<std::string> columns) : name_(std::move(name)), columns_(std::move(columns)) {}

  /// One cell for each column.
  void add(std::vector<std::string> row);
  const std::string& name() const { return name_; }
  std::size_t rows() const { return rows_.size(); }
  const std::string& text(std::size_t row, const std::string& column) const { return rows_[row][index(column)]; }
  double number(std::size_t row, const std::string& column) const;
  /// Comma-separated, with a header line.
  std::string csv() const;

 private:
  std::size_t index(const std::string& column) const;

  std::string name_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// Cells.
std::string cell(double value, int digits = 6);
std::string cell(std::uint64_t value);
std::string cell(int value);

}  // namespace taut::paper
