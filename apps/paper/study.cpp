#include "study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "taut/io.hpp"

namespace taut::paper {

void Output::write(const Table& table) const { write_file(folder_ + "/" + table.name() + ".csv", table.csv()); }
void Output::write(const std::string& name, const Plot& plot) const { write_text(name + ".svg", draw(plot)); }
void Output::write_text(const std::string& file, const std::string& text) const {
  write_file(folder_ + "/" + file, text);
}
void Output::note(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
  summary_ += line + "\n";
}
void Output::finish() const { write_text("summary.txt", summary_); }

std::vector<std::pair<double, double>> samples(const Table& table, const std::string& x, const std::string& y,
                                               const std::string& key, const std::string& value) {
  std::vector<std::pair<double, double>> out;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (key.empty() || table.text(i, key) == value) out.emplace_back(table.number(i, x), table.number(i, y));
  }
  return out;
}

std::vector<std::string> values(const Table& table, const std::string& column) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const std::string& v = table.text(i, column);
    if (std::find(out.begin(), out.end(), v) == out.end()) out.push_back(v);
  }
  return out;
}

}  // namespace taut::paper
