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

std::string closeness_in_words(const Scene& scene, const PairMargin& pair) {
  const NearestPoints& n = *pair.nearest;
  return fmt::format("  {} at ({:.9g}, {:.9g}), {} at ({:.9g}, {:.9g}): {:.9g} apart\n",
                     close_feature_text(scene, pair, n.edges[0]), n.points[0].x, n.points[0].y,
                     close_feature_text(scene, pair, n.edges[1]), n.points[1].x, n.points[1].y, n.hi);
}

}  // namespace

std::string margin_in_words(const Scene& scene, double clearance, const MarginAnswer& answer) {
  if (answer.outcome == Outcome::free)
    return fmt::format("FREE  {}   all keep {:.9g} on [{}, {}]\n", subject_text(scene, std::nullopt), clearance,
                       scene.start, scene.end);
  if (!answer.first) return "UNDECIDED  " + subject_text(scene, std::nullopt) + "\n  " + answer.reason + "\n";
  const PairMargin& first = *answer.first;
  const std::string pair = margin_subject(scene, first);
  std::string text;
  if (first.outcome == Outcome::contact)
    text = fmt::format("CONTACT  {}   closer than {:.9g} at t = {}\n", pair, clearance, time_text(first.time));
  if (first.outcome == Outcome::overlap_at_start)
    text = fmt::format("OVERLAP AT START  {}   closer than {:.9g} at t = {}\n", pair, clearance, scene.start);
  if (first.outcome == Outcome::undecided)
    text = fmt::format("UNDECIDED  {}\n  at t = {} {}\n", pair, first.free_until, first.reason);
  if (first.nearest) text += closeness_in_words(scene, first);
  for (const PairMargin& other : answer.also) text += "  and " + margin_subject(scene, other) + "\n";
  return text;
}

}  // namespace taut::cli
