#include "table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace taut::paper {

void Table::add(std::vector<std::string> row) {
  if (row.size() != columns_.size()) throw std::logic_error("a row of " + name_ + " has the wrong number of cells");
  rows_.push_back(std::move(row));
}

double Table::number(std::size_t row, const std::string& column) const {
  return std::strtod(text(row, column).c_str(), nullptr);
}

std::size_t Table::index(const std::string& column) const {
  const auto at = std::find(columns_.begin(), columns_.end(), column);
  if (at == columns_.end()) throw std::logic_error("no column " + column + " in " + name_);
  return static_cast<std::size_t>(at - columns_.begin());
}

std::string Table::csv() const {
  std::string out;
  const auto add_line = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) out += (i ? "," : "") + cells[i];
    out += '\n';
  };
  add_line(columns_);
  for (const auto& row : rows_) add_line(row);
  return out;
}

std::string cell(double value, int digits) { return fmt::format("{:.{}g}", value, digits); }
std::string cell(std::uint64_t value) { return fmt::format("{}", value); }
std::string cell(int value) { return fmt::format("{}", value); }

}  // namespace taut::paper
