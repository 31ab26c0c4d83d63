// taut's engines beside collision libraries that test overlap at sampled poses: one process pinned to one core, all in
// turn on the same scenes, medians of processor time, and what each answer is worth. A wrong answer of taut fails.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "compare/engines.hpp"
#include "compare/timing.hpp"
#include "peers/peer_pair.hpp"
#include "peers/verdict.hpp"

namespace taut::bench {
namespace {

struct Options {
  double seconds = 2;
  double limit = 20;
  int largest = 4096;
  std::vector<std::string> only;
};

/// The instants and poses that the libraries are asked about.
struct Samples {
  std::vector<double> times;
  std::vector<RelativePose> poses;

  Samples(const Contest& contest, const PeerPair& pair, int steps) : times(sample_times(contest, steps)) {
    for (const double t : times) poses.push_back(pair.pose(t));
  }
};

/// Where the circles around two shapes are apart, no library need be asked.
class Reach {
 public:
  explicit Reach(const PeerPair& pair) : radius_(pair.fixed().radius + pair.moving().radius + 0.1) {}
  bool apart(const RelativePose& p) const { return p.x * p.x + p.y * p.y > radius_ * radius_; }

 private:
  double radius_;
};

/// One library on one set of samples.
class SampledRun {
 public:
  SampledRun(Peer& peer, const Samples& samples, const Reach& reach, double limit)
      : peer_(peer), samples_(samples), reach_(reach), limit_(limit) {}

  bool cut() const { return cut_; }
  void skip() { cut_ = true; }
  /// Expected of a run with `factor` times as many samples.
  bool would_exceed(double factor) const { return cut_ || (!timing_.empty() && timing_.last() * factor > limit_); }

  void once(int round) {
    // One run is enough if it takes long.
    if (cut_ || (round > 0 && timing_.last() > 3)) return;
    timing_.measure([this] { run(); });
  }

  std::string text(const std::optional<TimeInterval>& contact) const {
    if (cut_) return "-";
    return seconds_text(timing_.median()) + ", " + to_string(verdict_of_samples(contact, samples_.times, hit_));
  }

 private:
  void run() {
    hit_.reset();
    const Stopwatch watch;
    for (std::size_t i = 0; i < samples_.poses.size(); ++i) {
      if (reach_.apart(samples_.poses[i])) continue;
      if (peer_.overlap(samples_.poses[i])) {
        hit_ = i;
        return;
      }
      if (i % 16 == 0 && watch.seconds() > limit_) {
        cut_ = true;
        return;
      }
    }
  }

  Peer& peer_;
  const Samples& samples_;
  const Reach& reach_;
  double limit_;
  Timing timing_;
  std::optional<std::size_t> hit_;
  bool cut_ = false;
};

/// A continuous test along the whole of a straight motion.
class CastRun {
 public:
  CastRun(Peer& peer, const Contest& contest, const PeerPair& pair)
      : peer_(peer), start_(contest.scene.start), length_(contest.scene.end - contest.scene.start) {
    from_ = pair.pose(start_);
    to_ = pair.pose(start_ + length_);
  }
  void once(int) {
    if (peer_.casts()) timing_.measure([this] { share_ = peer_.cast(from_, to_); });
  }
  std::string text(const std::optional<TimeInterval>& contact, double slack) const {
    if (!peer_.casts()) return "-";
    std::optional<double> hit;
    if (share_) hit = start_ + *share_ * length_;
    return seconds_text(timing_.median()) + ", " + to_string(verdict_of_time(contact, hit, slack * length_));
  }

 private:
  Peer& peer_;
  double start_, length_;
  RelativePose from_, to_;
  Timing timing_;
  std::optional<double> share_;
};

/// An engine of taut: its time, and what it says.
class CertifiedRun {
 public:
  CertifiedRun(const Column& column, const Contest& contest) : name_(column.name), engine_(column.make()) {
    engine_->set_up(contest);
  }
  /// What is wrong, or nothing.
  std::string once(const Contest& contest) {
    timing_.measure([this] { answers_ = engine_->run(); });
    const std::string wrong = fault(contest, answers_);
    return wrong.empty() ? wrong : name_ + ": " + wrong;
  }
  const std::vector<Answer>& answers() const { return answers_; }
  std::string text() const { return seconds_text(timing_.median()); }
  std::optional<TimeInterval> contact() const {
    for (const Answer& answer : answers_) {
      if (answer.contact) return answer.contact->time;
    }
    return std::nullopt;
  }

 private:
  std::string name_;
  std::unique_ptr<Engine> engine_;
  Timing timing_;
  std::vector<Answer> answers_;
};

constexpr int few_steps = 256, many_steps = 4096;

/// All rows of one contest.
class Rows {
 public:
  Rows(const Contest& contest, double limit)
      : contest_(contest),
        pair_(contest),
        reach_(pair_),
        few_(contest, pair_, few_steps),
        many_(contest, pair_, many_steps) {
    // With prepared shapes, as the libraries have theirs.
    for (const std::size_t i : {1, 3}) certified_.emplace_back(columns()[i], contest);
    for (const PeerEntry& entry : peers()) {
      peers_.push_back(entry.make(pair_.fixed(), pair_.moving()));
      few_runs_.emplace_back(*peers_.back(), few_, reach_, limit);
      many_runs_.emplace_back(*peers_.back(), many_, reach_, limit);
      cast_runs_.emplace_back(*peers_.back(), contest, pair_);
    }
    casts_ = is_straight(contest) &&
             std::any_of(peers_.begin(), peers_.end(), [](const auto& peer) { return peer->casts(); });
  }

  /// What is wrong with taut's answers, or nothing.
  std::string run(double seconds) {
    const Stopwatch whole;
    for (int round = 0; round < 3 || (whole.seconds() < seconds && round < 31); ++round) {
      for (CertifiedRun& engine : certified_) {
        if (std::string wrong = engine.once(contest_); !wrong.empty()) return wrong;
      }
      if (std::string wrong = disagreement(certified_[0].answers(), certified_[1].answers()); !wrong.empty())
        return wrong;
      for (std::size_t i = 0; i < peers_.size(); ++i) {
        few_runs_[i].once(round);
        if (round == 0 && few_runs_[i].would_exceed(static_cast<double>(many_steps) / few_steps)) many_runs_[i].skip();
        many_runs_[i].once(round);
        if (casts_) cast_runs_[i].once(round);
      }
    }
    return {};
  }

  std::string text() const {
    const std::optional<TimeInterval> contact = certified_[0].contact();
    const std::string head = fmt::format("| {} | {} | {} ", contest_.family, contest_.n, contact ? "contact" : "free");
    const std::string engines = "| " + certified_[0].text() + " | " + certified_[1].text() + " ";
    std::string few = head + engines + fmt::format("| {} |", few_steps);
    std::string many = head + fmt::format("| | | {} |", many_steps), cast = head + "| | | cast |";
    for (std::size_t i = 0; i < peers_.size(); ++i) {
      few += " " + few_runs_[i].text(contact) + " |";
      many += " " + many_runs_[i].text(contact) + " |";
      if (casts_) cast += " " + cast_runs_[i].text(contact, 1.0 / many_steps) + " |";
    }
    return few + "\n" + many + (casts_ ? "\n" + cast : "");
  }

 private:
  const Contest& contest_;
  PeerPair pair_;
  Reach reach_;
  Samples few_, many_;
  bool casts_ = false;
  std::vector<CertifiedRun> certified_;
  std::vector<std::unique_ptr<Peer>> peers_;
  std::vector<SampledRun> few_runs_, many_runs_;
  std::vector<CastRun> cast_runs_;
};

void print_head() {
  fmt::print("{}\n\n", machine_text());
  fmt::print("| family | n | answer | kinetic | spacetime | steps |");
  std::string rule = "|---|---:|---|---:|---:|---:|";
  for (const PeerEntry& entry : peers()) {
    fmt::print(" {} |", entry.name);
    rule += "---:|";
  }
  fmt::print("\n{}\n", rule);
}

int compare(const Options& options) {
  pin_to_this_core();
  print_head();
  bool right = true;
  for (const ContestFamily& family : chosen_families(options.only)) {
    for (const int n : family.sizes) {
      if (n > options.largest) continue;
      const Contest contest = family.make(n);
      Rows rows(contest, options.limit);
      const std::string wrong = rows.run(options.seconds);
      right = right && wrong.empty();
      fmt::print("{}\n", wrong.empty() ? rows.text() : fmt::format("| {} | {} | WRONG: {} |", family.name, n, wrong));
      std::fflush(stdout);
    }
  }
  return right ? 0 : 1;
}

}  // namespace
}  // namespace taut::bench

int main(int argc, char** argv) {
  CLI::App app("Compares taut's engines with collision libraries at sampled poses");
  taut::bench::Options options;
  app.add_option("--seconds", options.seconds, "Processor time for each scene, at least three rounds");
  app.add_option("--limit", options.limit, "Cut a run that takes longer, in seconds");
  app.add_option("--largest", options.largest, "Leave out larger polygons");
  app.add_option("--only", options.only, "Families");
  CLI11_PARSE(app, argc, argv);
  try {
    return taut::bench::compare(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
