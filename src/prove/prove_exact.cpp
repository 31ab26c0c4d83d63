// Writes exact logs, for the checker that is proved (docs/exact-logs.md).
#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

#include "io/json_writer.hpp"
#include "numeric/budget.hpp"
#include "numeric/undecided.hpp"
#include "prove/exact_separation.hpp"
#include "taut/error.hpp"
#include "taut/proof.hpp"

namespace taut {
using namespace internal;
namespace {

/// Windows are halved so often at the most, and pairs get so many at the most.
constexpr int most_halvings = 40;
constexpr std::size_t most_windows = 1'000'000;
/// Of a contact, the log ends before it, by this share of the time up to it: windows near to it become ever shorter.
constexpr double before_contact = 0x1p-10;

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
    if (depth == most_halvings || !(from < middle && middle < to) || windows_ > most_windows)
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

/// The end of the log about what an answer says.
double end_of_log(const Scene& scene, const Answer& answer) {
  if (answer.outcome == Outcome::free) return scene.end;
  const double until = std::min(answer.free_until, scene.end);
  return answer.outcome == Outcome::contact ? until - (until - scene.start) * before_contact : until;
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
  const bool any =
      answer.outcome == Outcome::free || answer.outcome == Outcome::contact || answer.outcome == Outcome::undecided;
  const double until = end_of_log(scene, answer);
  if (!any || (answer.outcome != Outcome::free && !(until > scene.start))) return answer;
  const auto give_up = [&](const std::string& why) {
    answer.reason = std::string("the answer is ") + to_string(answer.outcome) + ", but it has no exact proof: " + why;
    answer.outcome = Outcome::undecided;
    answer.contact.reset();
    answer.pair.reset();
    answer.free_until = scene.start;
  };
  try {
    std::string text;
    const std::string stopped = what_stops([&] { text = ExactWriter(scene, until).write(); });
    if (!stopped.empty()) {
      give_up(stopped);
    } else {
      log << text;
      if (answer.outcome != Outcome::free) answer.free_until = until;
    }
  } catch (const NoWindows& none) {
    give_up("between " + none.a + " and " + none.b + " there is too little room at t = " + std::to_string(none.time));
  }
  return answer;
}

}  // namespace taut
