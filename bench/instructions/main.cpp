// Fixed short cases whose instructions `./dev instructions` counts: those within counted_run(), start and reading of
// the program left out. Without an argument, the names of the cases.
#include <fmt/format.h>

#include <cstring>
#include <exception>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "coastline.hpp"
#include "compare/engines.hpp"
#include "taut/simulation.hpp"

namespace {

const std::function<void()>* counted = nullptr;

}  // namespace

// Found by its name in the program.
extern "C" [[gnu::noinline]] void taut_counted_run() { (*counted)(); }

namespace taut::bench {
namespace {

void count(const std::function<void()>& work) {
  counted = &work;
  taut_counted_run();
}

/// A contest asked `times` times by the engine of a column.
void contest(const char* family, int n, const char* column, int times) {
  for (const ContestFamily& f : contest_families()) {
    if (f.name != std::string(family)) continue;
    const Contest c = f.make(n);
    for (const Column& engine_of : columns()) {
      if (engine_of.name != std::string(column)) continue;
      const std::unique_ptr<Engine> engine = engine_of.make();
      engine->set_up(c);
      std::vector<Answer> answers;
      count([&] {
        for (int k = 0; k < times; ++k) answers = engine->run();
      });
      if (const std::string wrong = fault(c, answers); !wrong.empty()) throw std::runtime_error(wrong);
    }
  }
}

/// The tiling of two coastlines, and the first schedule.
void start(std::size_t vertices) {
  const Scene scene = bay(vertices);
  count([&scene] {
    const Simulation simulation(scene);
    if (simulation.contact()) throw std::runtime_error("contact instead of free");
  });
}

struct Case {
  const char* name;
  void (*run)();
};

constexpr Case cases[] = {
    {"gears-512-kinetic", [] { contest("gears", 512, "kinetic, cold", 1); }},
    {"gears-512-spacetime", [] { contest("gears", 512, "spacetime, cold", 1); }},
    {"combs-512-kinetic", [] { contest("combs", 512, "kinetic, cold", 1); }},
    {"combs-512-spacetime", [] { contest("combs", 512, "spacetime, cold", 1); }},
    {"dips_linear-512-kinetic", [] { contest("dips_linear", 512, "kinetic, cold", 1); }},
    {"octagons-1000-kinetic", [] { contest("octagons", 8, "kinetic, cold", 1000); }},
    {"octagons-1000-spacetime", [] { contest("octagons", 8, "spacetime, cold", 1000); }},
    {"start-10000", [] { start(10000); }},
};

int run(int argc, char** argv) {
  for (const Case& c : cases) {
    if (argc < 2) {
      fmt::print("{}\n", c.name);
    } else if (std::strcmp(argv[1], c.name) == 0) {
      c.run();
      return 0;
    }
  }
  if (argc < 2) return 0;
  fmt::print(stderr, "no case {}: the cases are printed without an argument\n", argv[1]);
  return 2;
}

}  // namespace
}  // namespace taut::bench

int main(int argc, char** argv) {
  try {
    return taut::bench::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", argc > 1 ? argv[1] : "", error.what());
    return 1;
  }
}
