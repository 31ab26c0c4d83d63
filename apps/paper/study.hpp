// The parts of the study, one file each. Every part fills tables, and draws its plots from them.
#pragma once

#include <string>
#include <vector>

#include "plot.hpp"
#include "table.hpp"

namespace taut::paper {

/// Where the results go: a folder that exists.
class Output {
 public:
  explicit Output(std::string folder) : folder_(std::move(folder)) {}
  void write(const Table& table) const;
  void write(const std::string& name, const Plot& plot) const;
  void write_text(const std::string& file, const std::string& text) const;
  /// A line of docs/paper/summary.txt, and of the standard output: what a run found.
  void note(const std::string& line);
  void finish() const;

 private:
  std::string folder_;
  std::string summary_;
};

/// Lemma 2.4, Theorem 2.6: the active set against the size of a separator.
void study_compactness(Output& output);
/// What a repair changes, and how long an event takes.
void study_responsiveness(Output& output);
/// What a change of plan costs.
void study_locality(Output& output);
/// Theorems 3.1 and 3.2: numbers of events.
void study_efficiency(Output& output);
/// Structures of others, beside the tiling of a pair.
void study_structures(Output& output);
/// One tiling of all bodies of a world, beside tilings of pairs.
void study_worlds(Output& output);
/// The figures, from the scenes in `scenes`.
void draw_figures(Output& output, const std::string& scenes);

/// The samples (x, y) of a table, of the rows whose cell in `key` is `value` (all rows if `key` is empty).
std::vector<std::pair<double, double>> samples(const Table& table, const std::string& x, const std::string& y,
                                               const std::string& key = "", const std::string& value = "");
/// The different cells of a column, in order.
std::vector<std::string> values(const Table& table, const std::string& column);

}  // namespace taut::paper
