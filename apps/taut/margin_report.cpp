#include "margin_report.hpp"

#include <fmt/format.h>

#include <optional>

#include "feature_text.hpp"
#include "report.hpp"
#include "terminal.hpp"

namespace taut::cli {
namespace {

std::string margin_subject(const Scene& scene, const PairMargin& pair) { return subject_text(scene, pair.bodies); }

/// What of one body of the pair is so close: a vertex, if it is known to be one, or an edge.
std::string close_feature_text(const Scene& scene, const PairMargin& pair, const EdgeRef& edge) {
  if (pair.features) {
    for (const std::optional<VertexRef>& vertex : {std::optional(pair.features->vertex), pair.features->other}) {
      if (vertex && vertex->body == edge.body) return vertex_text(scene, *vertex);
    }
  }
  return edge_text(scene, edge);
}

/// Of curves, the distance is that of polygons within them, which is no less.
std::string distance_text(const PairMargin& pair, bool curved) {
  return fmt::format("{}{:.9g} apart", curved ? "at most " : "", pair.nearest->hi);
}

std::string proved_margin_in_words(const Scene& scene, const PairMargin& pair, bool curved) {
  const NearestPoints& n = *pair.nearest;
  return fmt::format("  {} at ({:.9g}, {:.9g}), {} at ({:.9g}, {:.9g}): {}\n",
                     close_feature_text(scene, pair, n.edges[0]), n.points[0].x, n.points[0].y,
                     close_feature_text(scene, pair, n.edges[1]), n.points[1].x, n.points[1].y,
                     distance_text(pair, curved));
}

/// One pair of all.
std::string pair_line(const Scene& scene, const PairMargin& pair, bool curved) {
  std::string at;
  if (pair.outcome == Outcome::contact) at = "   t = " + time_text(pair.time);
  if (pair.outcome == Outcome::closer_at_start) at = "   " + distance_text(pair, curved);
  return fmt::format("    {:<16}  {}{}\n", to_string(pair.outcome), margin_subject(scene, pair), at);
}

}  // namespace

std::string margin_in_words(const Scene& scene, double clearance, const MarginAnswer& answer) {
  const std::string kept = scene.clearances.empty() ? fmt::format("{:.9g}", clearance) : "their clearances";
  const std::string all = subject_text(scene, std::nullopt), coverage = grounds_text(scene, answer.coverage);
  if (answer.outcome == Outcome::untested) return "UNTESTED  " + all + "\n  " + answer.reason + "\n";
  if (answer.outcome == Outcome::free || answer.outcome == Outcome::locked)
    return fmt::format("{}  {}   {} {} on [{}, {}]\n{}", answer.outcome == Outcome::free ? "FREE" : "LOCKED", all,
                       answer.coverage.untested() > 0 ? "tested pairs keep" : "all keep", kept, scene.start, scene.end,
                       coverage);
  if (!answer.first) {
    const std::string proved =
        answer.free_until > scene.start
            ? fmt::format("  {} {} on [{}, {})\n", answer.coverage.untested() > 0 ? "tested pairs keep" : "all keep",
                          kept, scene.start, answer.free_until)
            : "";
    return "UNDECIDED  " + all + "\n" + coverage + "  " + answer.reason + "\n" + proved;
  }
  const PairMargin& first = *answer.first;
  const std::string pair = margin_subject(scene, first);
  std::string text;
  if (first.outcome == Outcome::contact)
    text = fmt::format("CONTACT  {}   {} {:.9g} at t = {}\n", pair,
                       first.time.hi <= scene.start ? "as close as" : "closer than", first.margin_at,
                       time_text(first.time));
  if (first.outcome == Outcome::overlap_at_start)
    text = fmt::format("OVERLAP AT START  {}   t = {}\n", pair, scene.start);
  if (first.outcome == Outcome::closer_at_start)
    text = fmt::format("CLOSER AT START  {}   closer than {:.9g} at t = {}\n", pair, first.margin_at, scene.start);
  if (first.outcome == Outcome::undecided) text = fmt::format("UNDECIDED  {}\n", pair);
  text += coverage;
  if (first.outcome == Outcome::undecided) text += fmt::format("  at t = {} {}\n", first.free_until, first.reason);
  if (first.nearest) text += proved_margin_in_words(scene, first, answer.geometry.has_value());
  constexpr std::size_t most = 10;
  const std::size_t n = answer.also.size(), shown = n > most ? most : n;
  for (std::size_t i = 0; i < shown; ++i) text += "  also " + margin_subject(scene, answer.also[i]) + "\n";
  if (n > shown) text += fmt::format("  and {} more pairs (--pairs all)\n", n - shown);
  for (const PairMargin& other : answer.pairs) text += pair_line(scene, other, answer.geometry.has_value());
  return text;
}

}  // namespace taut::cli
