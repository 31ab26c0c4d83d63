// Finds the separation trees of which a log of a world consists.
#pragma once

#include <array>
#include <limits>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "proof/apart_checker.hpp"

namespace taut::internal {

/// What has been written of a stretch that is not finished: a log of its own, of the stretch up to that time. Time is
/// halved first, so the first of its halves, of these the first half, and so on, are written before everything else.
struct WrittenUntil {
  double time;
  std::size_t begin, end;  ///< in the output
};

/// Writes the separations of one pair on one stretch of one segment. It is known that nothing meets before `until` or,
/// with a margin, that nothing comes as close as that. Time is halved where the ranges move far relative to their size,
/// otherwise the larger range is, until something separates them. Everything that is written has been proved by the
/// functions that check it.
class ApartWriter {
 public:
  ApartWriter(const proof::RangedPair& pair, proof::Lifetimes& lifetimes, const std::optional<Instant>& until,
              std::string& out, double margin = 0)
      : pair_(pair), lifetimes_(lifetimes), until_(until), out_(out), margin_(margin), windows_(lifetimes.segment()) {}

  /// Throws Undecidable if nothing separates two edges.
  void write(double from, double to) {
    from_ = from;
    to_ = to;
    windows_.begin(from, to);
    visit({}, {from, to}, std::numeric_limits<double>::infinity());
  }
  /// Up to when separations are written if write() was stopped; none if that is not known.
  const std::optional<WrittenUntil>& written() const { return written_; }

 private:
  void step(std::uint8_t named) { out_.push_back(static_cast<char>(named)); }
  /// `doubt` is the uncertainty of the motion in the window of which this one is a half.
  void visit(const proof::RangePair& ranges, const proof::HalvedTime& time, double doubt);
  void halve_time(const proof::RangePair& ranges, const proof::HalvedTime& time, double doubt);
  void note_written(const proof::HalvedTime& half, std::size_t begin);
  void halve_range(const proof::RangePair& ranges, const proof::HalvedTime& time, double doubt);
  /// The reasons by which a vertex may be off an edge, and their approximate margins in the middle of a window, the
  /// largest first.
  using Candidates = std::array<std::pair<double, proof::SeparationReason>, 4>;
  /// The evaluation of one vertex and one edge over a window.
  struct Evaluation {
    proof::Incidence incidence;
    Candidates candidates;
    double none;                                   ///< a margin as small as this counts as zero in doubles
    double doubt = 0;                              ///< or possibly as zero, given the uncertainty of the motion
    std::optional<proof::SeparationReason> why{};  ///< decided in doubles
    bool far = false;                              ///< the largest margin is evident
    bool left_to_halves = false;                   ///< doubles may decide in shorter windows
    bool some_room() const { return candidates[0].first > none; }
  };
  Evaluation evaluate(const proof::Incidence& incidence, const proof::MotionWindow& window,
                      const proof::HalvedTime& time, bool halves_help);
  std::optional<proof::SeparationReason> reason_in_doubles(const Evaluation& seen, const proof::HalvedTime& time);
  std::optional<proof::SeparationReason> precise_reason(const Evaluation& seen, const proof::HalvedTime& time,
                                                        bool halves_help);
  bool is_new_tie(const proof::Incidence& incidence, proof::SeparationReason why, const proof::HalvedTime& time);
  bool stays_separated(const proof::Incidence& incidence, proof::SeparationReason why, const proof::HalvedTime& time,
                       const Instant& end);
  std::optional<proof::SeparationReason> reason_for_margin(const proof::Incidence& incidence,
                                                           const proof::WindowModel& model,
                                                           const proof::HalvedTime& time);
  std::optional<std::uint8_t> margin_kept(const proof::RangePair& ranges, const proof::HalvedTime& time);
  std::optional<std::uint8_t> ends_apart(const proof::RangePair& ranges, const proof::HalvedTime& time,
                                         bool halves_help);

  const proof::RangedPair& pair_;
  proof::Lifetimes& lifetimes_;
  const std::optional<Instant>& until_;
  std::string& out_;
  double margin_;
  proof::HalvedWindows windows_;
  double from_ = 0, to_ = 0;  ///< the ends of the stretch
  std::optional<WrittenUntil> written_;
  std::optional<proof::MotionWindow> at_start_, at_end_;  ///< at the ends of the stretch, on first use
  std::set<std::tuple<std::uint32_t, std::uint32_t, proof::SeparationReason>>
      ties_;  ///< vertex and edge; tried already
};

}  // namespace taut::internal
