// What the files of the benchmark program share.
#pragma once

#include <benchmark/benchmark.h>

#include <string>

#include "stopwatch.hpp"

namespace taut::bench {

/// A wrong answer: shown in the table, and the program will exit with 1.
void fail(benchmark::State& state, const std::string& what);

/// `quick`: as few repetitions as make sense.
void register_kinetic(bool quick);
void register_spacetime(bool quick);
void register_static(bool quick);
void register_static_map(bool quick);
void register_worlds(bool quick);

}  // namespace taut::bench
