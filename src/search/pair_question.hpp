// The first contact of one pair, asked window by window.
#pragma once

#include <optional>
#include <string>

#include "search/pair_search.hpp"
#include "sign/contact_bracket.hpp"

namespace taut {

/// What is known of one pair.
struct PairResult {
  int a = 0, b = 0;  ///< a < b
  Outcome outcome = Outcome::free;
  std::optional<Contact> contact;
  double free_until = 0;
  std::string reason;
  /// Of a contact, in the terms of the pair's geometry: what was found, and on which leg; or how the shapes displaced
  /// outwards overlap at the start.
  std::optional<FoundContact> found;
  std::size_t leg = 0;
  std::optional<spacetime::StartOverlap> touching;
};

/// A pair that boxes do not tell apart: at the start, then in windows of time, in any order. What is found later and
/// happens before what was known takes its place.
class PairQuestion {
 public:
  /// About [start, end] of the world's time.
  PairQuestion(PairSearch search, bool inwards, double start, double end);

  /// Does it overlap, or touch, at the start?
  void ask_start();
  /// Is there a first contact within the window?
  void ask(double from, double to);
  /// Nothing has been found yet.
  bool open() const { return result_.outcome == Outcome::free; }
  const PairResult& result() const { return result_; }
  /// Questions to multi-precision.
  std::uint64_t precise() const { return precise_; }

 private:
  void settle_start();

  PairSearch search_;
  bool inwards_;
  double start_, end_;
  PairResult result_;
  std::uint64_t precise_ = 0;
};

}  // namespace taut
