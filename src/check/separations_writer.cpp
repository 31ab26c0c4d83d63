#include "check/separations_writer.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "base/errors.hpp"
#include "base/interruption.hpp"
#include "check/apart_writer.hpp"
#include "check/world_run.hpp"
#include "numeric/undecided.hpp"
#include "proof/header.hpp"
#include "proof/proved_world.hpp"
#include "sign/contact_bracket.hpp"
#include "taut/proof.hpp"

namespace taut {
namespace {

using proof::Claim;
using proof::WorldTime;
using Pairs = std::vector<std::pair<int, int>>;

void put_u32(std::string& out, std::uint32_t x) {
  for (int i = 0; i < 4; ++i) out.push_back(static_cast<char>(x >> (8 * i) & 0xff));
}
void put_f64(std::string& out, double x) {
  const std::uint64_t bits = proof::bits_of(x);
  for (int i = 0; i < 8; ++i) out.push_back(static_cast<char>(bits >> (8 * i) & 0xff));
}

/// What comes after the header, for an answer that is known.
class SeparationsWriter {
 public:
  SeparationsWriter(const WorldPlan& plan, Claim claim, bool inwards)
      : plan_(plan), claim_(claim), world_(plan, inwards) {
    for (const WorldBody& body : plan.bodies()) sizes_.push_back(diagonal(body.rings->bounds()));
  }

  /// Nothing meets before `until`.
  std::string apart_until(double until) {
    if (claim_ == Claim::free_until) put_f64(out_, until);
    all_windows(until);
    return std::move(out_);
  }

  std::string touching(const PairResult& result) {
    const auto [crossing, e, f, inside] = *result.touching;
    put_pair(result);
    out_.push_back(crossing ? 0 : 1);
    put_u32(out_, crossing ? e.value : inside.value);
    put_u32(out_, crossing ? f.value : inside.value);
    all_windows(plan_.start());
    return std::move(out_);
  }

  /// `until`: the earliest instant at which anything may happen.
  std::string contact(const PairResult& result, double until) {
    contact_pair_ = {result.a, result.b};
    const proof::ProvedPair& pair = world_.pair(result.a, result.b);
    const FoundContact& found = *result.found;
    const Leg& leg = pair.legs[result.leg];
    const double about = found.lo + (found.hi - found.lo) / 2;
    proof::Lifetimes lifetimes(pair.geometry);
    lifetimes.enter(leg);
    const auto [since, now] = instant(pair, lifetimes, found, about);
    const double end = std::clamp(now.hi, leg.start, leg.end);
    put_pair(result);
    put_u32(out_, static_cast<std::uint32_t>(result.leg));
    put_u32(out_, found.vertex.value);
    put_u32(out_, found.edge.value);
    for (const double t : {since, about, end, until}) put_f64(out_, t);
    std::vector<proof::LegStretch> way;
    for (std::size_t i = 0; i < result.leg; ++i) way.push_back({i, pair.legs[i].start, pair.legs[i].end});
    way.push_back({result.leg, leg.start, end});
    section(pair, way, now);
    all_windows(until);
    return std::move(out_);
  }

 private:
  void put_pair(const PairResult& result) {
    put_u32(out_, static_cast<std::uint32_t>(result.a));
    put_u32(out_, static_cast<std::uint32_t>(result.b));
  }
  void all_windows(double until) {
    const WorldTime all{plan_.start(), until, true};
    windows(all, world_.meeting(all));
  }

  /// As the verifier reads them: a pair is left to the halves of a window where these tell more.
  void windows(const WorldTime& time, const Pairs& pairs, int depth = 0) {
    proof::BoxesOver boxes(plan_, time);
    Pairs left;
    for (const auto& pair : pairs) {
      interruption_point();
      if (pair == contact_pair_ || !boxes.meet(pair)) continue;
      const double sizes = sizes_[static_cast<std::size_t>(pair.first)] + sizes_[static_cast<std::size_t>(pair.second)];
      const bool later =
          time.divisible() && depth < deepest && is_long(boxes.of(pair.first), boxes.of(pair.second), sizes);
      out_.push_back(later ? 0 : 1);
      if (later) {
        left.push_back(pair);
      } else {
        const proof::ProvedPair& met = world_.pair(pair.first, pair.second);
        section(met, proof::stretches(met.legs, time), {});
      }
    }
    if (left.empty()) return;
    windows({time.from, time.middle(), time.first}, left, depth + 1);
    windows({time.middle(), time.to, false}, left, depth + 1);
  }

  void section(const proof::ProvedPair& pair, const std::vector<proof::LegStretch>& stretches,
               const std::optional<Instant>& until) {
    proof::Lifetimes lifetimes(pair.geometry);
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      lifetimes.enter(pair.legs[stretches[i].leg]);
      const std::optional<Instant> last = i + 1 == stretches.size() ? until : std::nullopt;
      ApartWriter(pair.ranges, lifetimes, last, out_).write(stretches[i].from, stretches[i].to);
    }
  }

  /// The contact as the verifier will find it, and an instant shortly before it since which the vertex is outside.
  static std::pair<double, Instant> instant(const proof::ProvedPair& pair, proof::Lifetimes& lifetimes,
                                            const FoundContact& found, double about) {
    const Leg& leg = lifetimes.leg();
    for (double share = 0x1p-48;; share *= 0x1p8) {
      const double since = std::max(leg.start, found.lo - share * (leg.end - leg.start));
      const proof::Corner corner{found.edge, pair.geometry.next(found.edge), found.vertex, -1, Instant::exactly(since)};
      try {
        return {since, lifetimes.failure(corner, about)};
      } catch (const ProofError&) {
        // Too close to the root for a sign, or not close enough for it to be the first.
        if (share > 0x1p-8) throw Undecidable{"the instant of a contact, for a proof"};
      }
    }
  }

  static constexpr int deepest = 30;

  const WorldPlan& plan_;
  Claim claim_;
  proof::ProvedWorld world_;
  std::vector<double> sizes_;  ///< of the bodies' boxes while nothing moves
  Pairs::value_type contact_pair_{-1, -1};
  std::string out_;
};

/// The pair that the answer names.
const PairResult* headline(const Answer& answer, const std::vector<PairResult>& results) {
  const std::array<int, 2> named = answer.pair.value_or(std::array<int, 2>{0, 1});
  const auto found = std::find_if(results.begin(), results.end(),
                                  [&](const PairResult& r) { return r.a == named[0] && r.b == named[1]; });
  return found == results.end() ? nullptr : &*found;
}

/// What the answer comes to in a log, without its header; nothing where there is nothing to prove.
std::optional<std::pair<Claim, std::string>> body_of_log(const WorldRun& run, const Answer& answer, Touch touch) {
  const WorldPlan& plan = *run.plan();
  const bool inwards = touch == Touch::open;
  const double until = std::clamp(answer.free_until, plan.start(), plan.end());
  if (answer.outcome == Outcome::free)
    return std::pair(Claim::free, SeparationsWriter(plan, Claim::free, inwards).apart_until(plan.end()));
  if (answer.outcome == Outcome::undecided && until > plan.start())
    return std::pair(Claim::free_until, SeparationsWriter(plan, Claim::free_until, inwards).apart_until(until));
  if (answer.outcome != Outcome::contact) return std::nullopt;
  const std::vector<PairResult> results = run.search()->results();
  const PairResult* named = headline(answer, results);
  if (named->touching)
    return std::pair(Claim::touching, SeparationsWriter(plan, Claim::touching, true).touching(*named));
  return std::pair(Claim::contact, SeparationsWriter(plan, Claim::contact, inwards).contact(*named, until));
}

}  // namespace

Answer prove_by_separations(const Scene& scene, std::ostream& log, const CheckOptions& given) {
  CheckOptions options = given;
  options.all_pairs = false;
  WorldRun run(scene, options);
  run.work(UINT64_MAX);
  Answer answer = with_touching(run, scene, options, run_world);
  if (!run.search()) return answer;
  std::string unproved;
  try {
    if (const auto body = body_of_log(run, answer, options.touch)) {
      proof::ByteWriter out(log);
      proof::write_header(out, {proof::of_separations, scene_fingerprint(scene, options.touch), options.touch,
                                static_cast<std::uint8_t>(body->first)});
      for (const char c : body->second) out.u8(static_cast<std::uint8_t>(c));
      out.close();
    }
    return answer;
  } catch (const Undecidable& limit) {
    unproved = not_decided(limit);
  } catch (const Interrupted& limit) {
    unproved = limit.reason;
  }
  Answer undecided;
  undecided.engine = answer.engine;
  undecided.coverage = answer.coverage;
  undecided.free_until = scene.start;
  undecided.reason =
      std::string("the answer is ") + to_string(answer.outcome) + ", but its proof was not finished: " + unproved;
  return undecided;
}

}  // namespace taut
