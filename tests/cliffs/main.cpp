// Small inputs that cost far more than others like them. Random scenes, each beside its twin with every coordinate
// moved a little, are asked of each engine alone and of both in turn; those that cost most, absolutely and against the
// twin, are printed and written to files, and how the two engines in turn fare beside the better one is counted.
// `./dev cliffs --minutes N` builds and runs it.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "bench/stopwatch.hpp"
#include "command_line/command_line.hpp"
#include "generators/shapes.hpp"
#include "numeric/budget.hpp"
#include "soak/soak_scene.hpp"
#include "support/prepared_scene.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut::testing {
using namespace internal;
namespace {

constexpr std::array<EngineChoice, 3> engines{EngineChoice::kinetic, EngineChoice::spacetime, EngineChoice::either};
constexpr std::array<const char*, 3> engine_names{"kinetic", "spacetime", "either"};
constexpr std::size_t kinetic = 0, spacetime = 1, either = 2;

/// What everything costs that is no engine's fault.
constexpr double base_cost = 20e-6;

struct Timed {
  double seconds = 0;
  std::uint64_t work = 0;  ///< in units of checkpoint()
  Outcome outcome = Outcome::undecided;
};

struct CliffOptions {
  double minutes = 1, seconds = 5;
  std::uint64_t first = 0;
  std::size_t vertices = 200, worst = 20;
  std::string folder = ".";
};

/// The shortest of a few runs, more of them if they are short. Bodies are prepared before.
Timed time_of(const Scene& bare, EngineChoice engine, Touch touch, double limit) {
  const Scene scene = prepared(bare);
  CheckOptions options;
  options.engine = engine;
  options.touch = touch;
  options.limits.max_seconds = limit;
  Timed timed{std::numeric_limits<double>::infinity()};
  double whole = 0;
  for (int round = 0; round < 3 || (round < 20 && whole < 1e-3); ++round) {
    const bench::Stopwatch watch;
    const std::uint64_t work_before = work_spent();
    timed.outcome = check(scene, options).outcome;
    timed.work = work_spent() - work_before;
    const double taken = watch.seconds();
    timed.seconds = std::min(timed.seconds, taken);
    whole += taken;
    if (whole > 0.1) break;
  }
  return timed;
}

/// Every coordinate moved by a ten millionth of the body's size.
Scene twin_of(Scene scene, std::uint64_t seed) {
  gen::Random random(seed);
  for (Body& body : scene.bodies) {
    double size = 0;
    for (const Point& p : body.polygon) {
      size = std::max({size, std::fabs(p.x - body.polygon[0].x), std::fabs(p.y - body.polygon[0].y)});
    }
    const double nudge = 1e-7 * size;
    for (Point& p : body.polygon) p = {p.x + random.uniform(-nudge, nudge), p.y + random.uniform(-nudge, nudge)};
  }
  return scene;
}

/// One engine's way with one scene.
struct Cliff {
  std::uint64_t number = 0;
  bool contacts = false;
  std::string family, engine;
  double seconds = 0, twin_seconds = 0;
  bool undecided = false;
  std::uint64_t work = 0;

  double ratio() const { return seconds / (twin_seconds + base_cost); }
  std::string file() const { return fmt::format("{}{}.json", contacts ? "contact-" : "scene-", number); }
};

/// The greatest of many, by a measure.
template <double (*Measure)(const Cliff&)>
class Greatest {
 public:
  explicit Greatest(std::size_t room) : room_(room) {}
  void add(const Cliff& cliff) {
    all_.push_back(cliff);
    if (all_.size() < 4 * room_ + 64) return;
    trim();
  }
  const std::vector<Cliff>& sorted() {
    trim();
    return all_;
  }

 private:
  void trim() {
    std::stable_sort(all_.begin(), all_.end(), [](const Cliff& a, const Cliff& b) { return Measure(a) > Measure(b); });
    if (all_.size() > room_) all_.resize(room_);
  }
  std::size_t room_;
  std::vector<Cliff> all_;
};

double by_ratio(const Cliff& c) { return c.ratio(); }
double by_seconds(const Cliff& c) { return c.seconds; }
/// What a unit of its work took, of those that are long enough to tell.
double by_unit(const Cliff& c) {
  return c.seconds < 4 * base_cost ? 0 : 1e9 * c.seconds / static_cast<double>(c.work + 1);
}
double by_small_unit(const Cliff& c) { return c.seconds < 4 * base_cost ? -1e9 : -by_unit(c); }

SoakScene scene_of_cliff(std::uint64_t number, bool contacts) {
  return contacts ? soak_contact_scene(number) : soak_scene(number);
}

class Search {
 public:
  explicit Search(const CliffOptions& options)
      : options_(options),
        steepest_(options.worst),
        longest_(options.worst),
        turns_(options.worst),
        uncounted_(options.worst),
        overcounted_(options.worst) {}

  void run() {
    const std::time_t end = std::time(nullptr) + static_cast<std::time_t>(60 * options_.minutes);
    for (number_ = options_.first; std::time(nullptr) < end; ++number_) look_at(number_);
  }

  void report() {
    fmt::print("{} scenes of up to {} vertices, numbers {} to {}; {} answers undecided\n", scenes_, options_.vertices,
               options_.first, number_, undecided_);
    fmt::print(
        "both engines in turn took more than 2.5 times the better one and 20 us in {} of them, {:.1f} times at "
        "most\n\n",
        slow_turns_, worst_turn_);
    print("against its twin", "its twin", steepest_.sorted());
    print("longest", "its twin", longest_.sorted());
    print("in turn", "the better engine", turns_.sorted());
    print("more work than counted", "its twin", uncounted_.sorted());
    print("less work than counted", "its twin", overcounted_.sorted());
  }

 private:
  void look_at(std::uint64_t number) {
    const bool contacts = number % 2 == 0;
    const SoakScene s = scene_of_cliff(number, contacts);
    if (s.scene.bodies[0].polygon.size() + s.scene.bodies[1].polygon.size() > options_.vertices) return;
    try {
      std::array<Timed, engines.size()> own;
      for (std::size_t i = 0; i < engines.size(); ++i) own[i] = time_of(s.scene, engines[i], s.touch, options_.seconds);
      ++scenes_;
      judge_turns(s, number, contacts, own);
      for (std::size_t i = 0; i < engines.size(); ++i) note(s, number, contacts, i, own[i]);
    } catch (const InputError&) {
      // Some injections spoil a scene.
    } catch (const InternalError&) {
      const std::string file = fmt::format("{}/defect-{}.json", options_.folder, number);
      write_file(file, write_scene(s.scene));
      fmt::print(stderr, "scene {}, touch {}, or its twin:\n", file, s.touch == Touch::open ? "open" : "closed");
      throw;
    }
  }

  void judge_turns(const SoakScene& s, std::uint64_t number, bool contacts,
                   const std::array<Timed, engines.size()>& own) {
    double better = std::numeric_limits<double>::infinity();
    for (const std::size_t i : {kinetic, spacetime}) {
      if (own[i].outcome != Outcome::undecided) better = std::min(better, own[i].seconds);
    }
    if (!std::isfinite(better)) return;
    slow_turns_ += own[either].seconds > 2.5 * better + base_cost;
    const Cliff cliff{number, contacts, s.family,        engine_names[either], own[either].seconds,
                      better, false,    own[either].work};
    worst_turn_ = std::max(worst_turn_, cliff.ratio());
    turns_.add(cliff);
  }

  void note(const SoakScene& s, std::uint64_t number, bool contacts, std::size_t engine, const Timed& own) {
    const Timed twin = time_of(twin_of(s.scene, number), engines[engine], s.touch, options_.seconds);
    undecided_ += own.outcome == Outcome::undecided;
    // Bodies that touch may overlap once they are moved: that is another question.
    if (twin.outcome != own.outcome && own.outcome != Outcome::undecided) return;
    const Cliff cliff{
        number,  contacts, s.family, engine_names[engine], own.seconds, twin.seconds, own.outcome == Outcome::undecided,
        own.work};
    steepest_.add(cliff);
    longest_.add(cliff);
    if (engine == either) return;
    uncounted_.add(cliff);
    overcounted_.add(cliff);
  }

  void print(const char* title, const char* other, const std::vector<Cliff>& cliffs) const {
    fmt::print("| {} | family | engine | ms | {}, ms | ratio | ns a unit |\n|---|---|---|---:|---:|---:|---:|\n", title,
               other);
    for (const Cliff& c : cliffs) {
      fmt::print("| {} | {} | {}{} | {:.3f} | {:.3f} | {:.1f} | {:.0f} |\n", c.file(), c.family, c.engine,
                 c.undecided ? ", undecided" : "", 1e3 * c.seconds, 1e3 * c.twin_seconds, c.ratio(), by_unit(c));
      write_file(options_.folder + "/" + c.file(), write_scene(scene_of_cliff(c.number, c.contacts).scene));
    }
    fmt::print("\n");
  }

  CliffOptions options_;
  Greatest<by_ratio> steepest_;
  Greatest<by_seconds> longest_;
  Greatest<by_ratio> turns_;
  Greatest<by_unit> uncounted_;
  Greatest<by_small_unit> overcounted_;
  std::uint64_t number_ = 0, scenes_ = 0, undecided_ = 0, slow_turns_ = 0;
  double worst_turn_ = 0;
};

}  // namespace
}  // namespace taut::testing

int main(int argc, char** argv) {
  taut::cli::Program program("Searches small scenes that cost far more than others like them.", "taut_cliffs");
  const taut::cli::Command app = program.command();
  taut::testing::CliffOptions options;
  app.add_option("--minutes", options.minutes, "How long").positive();
  app.add_option("--seconds", options.seconds, "Limit for each answer").positive();
  app.add_option("--first", options.first, "Number of the first scene");
  app.add_option("--vertices", options.vertices, "Leave out larger scenes");
  app.add_option("--worst", options.worst, "How many are printed");
  app.add_option("--folder", options.folder, "Where they are written").existing_folder();
  return taut::cli::run_program(program, argc, argv, [&] {
    taut::testing::Search search(options);
    search.run();
    search.report();
    return 0;
  });
}
