// An answer in words.
#pragma once

#include <chrono>
#include <string>

#include "taut/check.hpp"
#include "taut/scene.hpp"

namespace taut::cli {

/// An instant, with nine digits, or as many as distinguish it from those a billionth of the scene's time away.
std::string instant_text(const Scene& scene, double t);
/// The digits on which both ends of an interval agree: "0.104166...".
std::string time_text(const TimeInterval& time);

/// Where the scene's mechanism locks, in a line; empty if it does not.
std::string lock_text(const Scene& scene);
/// What an answer is about: the pairs, and where a mechanism locks. Reports have it after their first line.
std::string grounds_text(const Scene& scene, const Coverage& coverage);

double seconds_since(std::chrono::steady_clock::time_point start);
/// 0.0031 as "3.1 ms".
std::string seconds_text(double seconds);

/// A few lines for a person.
std::string report(const Scene& scene, const Answer& answer, Touch touch);

}  // namespace taut::cli
