#include "soak_totals.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "taut/io.hpp"

namespace taut::testing {
namespace {

using Json = nlohmann::ordered_json;

/// Which soaks have the column.
enum class Of { all, worlds, curves, both };

struct Column {
  const char* key;
  const char* title;
  std::uint64_t Tally::*value;
  Of of = Of::all;
};

constexpr Column columns[] = {{"scenes", "scenes", &Tally::scenes},
                              {"free", "free", &Tally::free},
                              {"contact", "contact", &Tally::contact},
                              {"overlap_at_start", "overlap at the start", &Tally::at_start},
                              {"invalid", "invalid", &Tally::invalid},
                              {"proofs", "proofs verified", &Tally::proofs},
                              {"judged", "judged by definition", &Tally::judged},
                              {"assumed", "on an assumption", &Tally::assumed},
                              {"beyond", "beyond the oracle", &Tally::beyond},
                              {"events", "events", &Tally::events},
                              {"large", "of 10 bodies or more", &Tally::large, Of::worlds},
                              {"unproved", "proofs not finished", &Tally::unproved, Of::both},
                              {"simulated", "simulations", &Tally::simulated, Of::worlds},
                              {"intervals", "intervals of worlds", &Tally::intervals, Of::worlds},
                              {"ranges", "ranges", &Tally::ranges, Of::worlds},
                              {"maps", "maps", &Tally::maps, Of::worlds},
                              {"laws", "laws", &Tally::laws, Of::worlds},
                              {"clearances", "clearances", &Tally::clearances, Of::worlds},
                              {"profiles", "profiles", &Tally::profiles, Of::worlds},
                              {"refused", "damaged proofs refused", &Tally::refused, Of::curves},
                              {"still_true", "damaged, and still true", &Tally::still_true, Of::curves}};

bool shown(const Column& c, const Tally& all) {
  const bool worlds = all.intervals > 0, curves = all.refused > 0;
  switch (c.of) {
    case Of::worlds:
      return worlds;
    case Of::curves:
      return curves;
    case Of::both:
      return worlds || curves;
    default:
      return true;
  }
}

std::string row(const std::string& name, const Tally& tally, const Tally& all) {
  std::string line = "| " + name + " |";
  for (const Column& c : columns) {
    if (shown(c, all)) line += fmt::format(" {} |", tally.*c.value);
  }
  return line + '\n';
}

std::string table(const char* what, const std::map<std::string, Tally>& rows, const Tally& all) {
  std::string text = fmt::format("| {} |", what), rule = "|---|";
  for (const Column& c : columns) {
    if (!shown(c, all)) continue;
    text += fmt::format(" {} |", c.title);
    rule += "---:|";
  }
  text += '\n' + rule + '\n';
  for (const auto& [name, tally] : rows) text += row(name, tally, all);
  return text + row("all", all, all) + '\n';
}

Json to_json(const std::map<std::string, Tally>& rows) {
  Json json = Json::object();
  for (const auto& [name, tally] : rows) {
    for (const Column& c : columns) json[name][c.key] = tally.*c.value;
  }
  return json;
}

std::array<Stage, stage_count> all_stages() {
  std::array<Stage, stage_count> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Stage>(i);
  return all;
}

/// For tables, and for files that are read again.
std::string name_of(Stage stage) {
  constexpr const char* names[] = {"doubles", "first_order", "exact", "relative", "fixed"};
  if (stage < Stage::precise) return names[static_cast<int>(stage)];
  return "bits_" + with_stage(stage, [](auto zero) { return std::to_string(RealTraits<decltype(zero)>::bits); });
}

std::map<std::string, Tally> tallies(const Json& json) {
  std::map<std::string, Tally> rows;
  for (const auto& [name, row] : json.items()) {
    for (const Column& c : columns) rows[name].*c.value = row.value(c.key, std::uint64_t{0});
  }
  return rows;
}

}  // namespace

Tally& Tally::operator+=(const Tally& o) {
  for (const Column& c : columns) this->*c.value += o.*c.value;
  return *this;
}

SoakTotals& SoakTotals::operator+=(const SoakTotals& o) {
  for (const auto& [name, tally] : o.by_family) by_family[name] += tally;
  for (const auto& [name, tally] : o.by_injection) by_injection[name] += tally;
  stages += o.stages;
  findings.insert(findings.end(), o.findings.begin(), o.findings.end());
  return *this;
}

Tally SoakTotals::all() const {
  Tally sum;
  for (const auto& [name, tally] : by_family) sum += tally;
  return sum;
}

std::string SoakTotals::report() const {
  const Tally sum = all();
  std::string text = table("family", by_family, sum);
  if (!by_injection.empty()) text += table("injection", by_injection, sum);
  text += "| stage | told the kinetic engine |\n|---|---:|\n";
  for (const Stage stage : all_stages()) text += fmt::format("| {} | {} |\n", name_of(stage), stages[stage]);
  text += '\n';
  text += fmt::format("{} scenes, of which {} are valid; {} findings; the next scene is {}\n", sum.scenes,
                      sum.scenes - sum.invalid, findings.size(), next_scene);
  for (const std::string& finding : findings) text += "  " + finding + '\n';
  return text;
}

SoakTotals read_soak_totals(const std::string& file) {
  SoakTotals totals;
  if (!std::filesystem::exists(file)) return totals;
  const Json json = Json::parse(std::ifstream(file));
  totals.next_scene = json.at("next_scene").get<std::uint64_t>();
  totals.by_family = tallies(json.at("by_family"));
  totals.by_injection = tallies(json.at("by_injection"));
  const Json& stages = json.at("stages");
  for (const Stage stage : all_stages()) totals.stages[stage] = stages.value(name_of(stage), std::uint64_t{0});
  totals.findings = json.at("findings").get<std::vector<std::string>>();
  return totals;
}

void write_soak_totals(const std::string& file, const SoakTotals& totals) {
  Json stages;
  for (const Stage stage : all_stages()) stages[name_of(stage)] = totals.stages[stage];
  const Json json = {{"next_scene", totals.next_scene},
                     {"by_family", to_json(totals.by_family)},
                     {"by_injection", to_json(totals.by_injection)},
                     {"stages", stages},
                     {"findings", totals.findings}};
  write_file(file, json.dump(2) + '\n');
}

}  // namespace taut::testing
