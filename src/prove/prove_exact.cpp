// Writes exact logs, for the checker that is proved (docs/exact-logs.md).
#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "io/json_writer.hpp"
#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "prove/exact_scene.hpp"
#include "taut/error.hpp"
#include "taut/proof.hpp"

namespace taut {
using namespace internal;
namespace {

/// Windows are halved so often at the most, and there are so many at the most.
constexpr int most_halvings_of_windows = 40;
constexpr std::size_t most_windows = 100'000;
/// Of a contact, the log ends before it, by the first of these shares of the time up to it with which it has windows:
/// near to the contact they become ever shorter.
constexpr double before_contact[] = {0x1p-10, 0x1p-5, 0x1p-2};

/// Thrown where no windows are found.
struct NoWindows {
  std::string a, b;
  double time;
};

class ExactWriter {
 public:
  ExactWriter(const Scene& scene, double until) : exact_(scene), scene_(scene), until_(until) {}

  std::string write() {
    std::string text = "{\"format\":\"taut-exact/1\",\"until\":" + number(until_) + ",\"pairs\":[";
    const char* separator = "\n";
    for (int a = 0; a < exact_.size(); ++a) {
      for (int b = a + 1; b < exact_.size(); ++b) {
        if (!exact_.tested(a, b)) continue;
        text += separator + pair(a, b);
        separator = ",\n";
      }
    }
    return text + "]}\n";
  }

 private:
  static std::string number(double value) {
    io::JsonWriter json;
    json.number(value);
    return json.text();
  }

  std::string pair(int a, int b) {
    const auto chains = exact_.relative_chains(a, b);
    std::vector<double> ends = joints_between(chains, scene_.start, until_);
    // At a joint the piece that ends and the one that begins count: after the last one, an instant.
    const bool joint_at_end = !ends.empty() && ends.back() == until_;
    if (!joint_at_end) ends.push_back(until_);
    if (joint_at_end || ends.back() == scene_.start) ends.push_back(until_);
    std::string text = "{\"pair\":[" + std::to_string(a) + "," + std::to_string(b) + "],\"windows\":[";
    double from = scene_.start;
    windows_ = 0;
    for (const double to : ends) {
      if (from == to && windows_ > 0 && !joint_at_end) break;
      window(a, b, chains, from, to, 0, text);
      from = to;
    }
    return text + "]}";
  }

  void window(int a, int b, const std::array<ExactChain, 2>& chains, double from, double to, int depth,
              std::string& text) {
    checkpoint(16);
    const LocalModels models((to - from) / 2);
    const auto p = placement_in(chains[0], from, to, models), q = placement_in(chains[1], from, to, models);
    if (p && q) {
      ExactSeparation separation(exact_.edges(a), exact_.edges(b), *p, *q, models);
      if (const auto steps = separation.find()) return add(from, to, *steps, text);
    }
    const double middle = from + (to - from) / 2;
    if (depth == most_halvings_of_windows || !(from < middle && middle < to) || windows_ > most_windows)
      throw NoWindows{exact_.name(a), exact_.name(b), from};
    window(a, b, chains, from, middle, depth + 1, text);
    window(a, b, chains, middle, to, depth + 1, text);
  }

  void add(double from, double to, const std::vector<ExactStep>& steps, std::string& text) {
    io::JsonWriter json;
    json.array([&] {
      json.number(from);
      json.number(to);
      for (const ExactStep& step : steps) {
        if (step.kind == ExactStep::Kind::halve_first) {
          json.number(1);
        } else if (step.kind == ExactStep::Kind::halve_second) {
          json.number(2);
        } else if (step.slope == 0) {
          json.numbers({step.normal.x, step.normal.y, step.level});
        } else {
          json.numbers({step.normal.x, step.normal.y, step.level, step.slope});
        }
      }
    });
    text += (windows_++ == 0 ? "\n" : ",\n") + json.text();
  }

  ExactScene exact_;
  const Scene& scene_;
  double until_;
  std::size_t windows_ = 0;
};

/// The ends to be tried for a log about what an answer says, the latest one first.
std::vector<double> ends_of_log(const Scene& scene, const Answer& answer) {
  if (answer.outcome == Outcome::free) return {scene.end};
  const double until = std::min(answer.free_until, scene.end);
  if (!(until > scene.start)) return {};
  if (answer.outcome == Outcome::undecided) return {until};
  std::vector<double> ends;
  if (answer.outcome != Outcome::contact) return ends;
  for (const double share : before_contact) ends.push_back(until - (until - scene.start) * share);
  return ends;
}

/// The log up to the first of these times for which there is one, or why there is none.
struct ExactLog {
  std::string text, reason;
  double until = 0;
};

ExactLog exact_log(const Scene& scene, const std::vector<double>& ends) {
  ExactLog log;
  for (const double until : ends) {
    try {
      log.reason = what_stops([&] { log.text = ExactWriter(scene, until).write(); });
      log.until = until;
      return log;
    } catch (const NoWindows& none) {
      log.reason =
          "between " + none.a + " and " + none.b + " there is too little room at t = " + std::to_string(none.time);
    }
  }
  return log;
}

}  // namespace

Answer prove_exact(const Scene& scene, std::ostream& log, const CheckOptions& given) {
  CheckOptions options = given;
  options.touch = Touch::closed;
  options.all_pairs = false;
  if (options.fit != 0)
    throw InputError("fit", "a proof is about bodies as they are given", "shrink the bodies yourself");
  const Budget scope(options.limits);
  // Refuses what is not covered before anything is asked.
  { const ExactScene covered(scene); }
  Answer answer = check(scene, options);
  const std::vector<double> ends = ends_of_log(scene, answer);
  if (ends.empty()) return answer;
  const ExactLog found = exact_log(scene, ends);
  if (found.reason.empty()) {
    log << found.text;
    if (answer.outcome != Outcome::free) answer.free_until = found.until;
    return answer;
  }
  answer.reason =
      std::string("the answer is ") + to_string(answer.outcome) + ", but it has no exact proof: " + found.reason;
  answer.outcome = Outcome::undecided;
  answer.contact.reset();
  answer.pair.reset();
  answer.free_until = scene.start;
  return answer;
}

}  // namespace taut
