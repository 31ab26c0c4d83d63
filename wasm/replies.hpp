// How functions that JavaScript calls answer: JSON text, which stays valid until the next call. No exception passes:
// errors are JSON, too.
#pragma once

#include <exception>
#include <string>

namespace taut::web {

/// {"error": {"kind": ..., "place": ..., "problem": ..., "hint": ...}} of what is being handled.
std::string present_error();

/// Keeps the text for JavaScript.
const char* kept(std::string text);

/// The JSON that `work()` gives, or its error.
template <class Work>
const char* replied(const Work& work) {
  try {
    return kept(work());
  } catch (...) {
    return kept(present_error());
  }
}

}  // namespace taut::web
