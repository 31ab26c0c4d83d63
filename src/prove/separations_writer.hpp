// Writes the reasons why bodies stay disjoint, for a known answer. Format: docs/separation-logs.md.
#pragma once

#include <array>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "proof/format.hpp"
#include "proof/motion_window.hpp"
#include "proof/verifier_world.hpp"
#include "prove/apart_writer.hpp"
#include "solver/pair_solver.hpp"
#include "solver/run.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"

namespace taut::internal {

/// The contents of a log after its header, and after the clearance if there is one.
struct SeparationsBody {
  proof::Claim claim;
  std::string bytes;
  double free_until;                        ///< up to when the windows of the log prove that nothing meets
  std::optional<Contact> contact = {};      ///< as a verifier will report it
  std::optional<TimeInterval> closer = {};  ///< in which two features come closer, as a verifier will report it
  std::string stopped = {};                 ///< why that is earlier than was asked for; empty if it is not
};

/// Writes one log. The answer states that bodies are disjoint. This class finds the reasons in the terms of a verifier:
/// windows of time, boxes, directions between ranges of edges. If the format has no reason that applies, it throws
/// Undecidable. If that, or a limit, comes before the end, a log of two bodies proves what has been found until then.
class SeparationsWriter {
 public:
  /// The scene must outlive this object. The margin is in internal units; 0 for a query about contact.
  SeparationsWriter(const proof::VerifierScene& scene, Offset offset, double margin = 0)
      : scene_(scene), world_(scene, offset, margin) {}

  /// Nothing meets. May return what it has proved when it is stopped.
  SeparationsBody free();
  /// Nothing meets before that time. May return what it has proved when it is stopped.
  SeparationsBody free_until(double until);
  /// Two bodies touch at the start, and nothing overlaps.
  SeparationsBody touching(const PairResult& result);
  /// Two features are as close as the margin at the start, and nothing is closer.
  SeparationsBody close_at_start(const std::array<BodyId, 2>& bodies, const CloseFeatures& features);
  /// Two features come closer than the margin at about the end of that time, and nothing does before its beginning.
  SeparationsBody closer(const std::array<BodyId, 2>& bodies, const CloseFeatures& features, const TimeInterval& time);
  /// A contact found on these segments; `until` is the earliest instant at which anything may happen. May return what
  /// it has proved when it is stopped.
  SeparationsBody contact(const PairResult& result, double until);

  const proof::VerifierPair& pair(int a, int b) { return world_.pair(a, b); }

 private:
  /// Where in the output separations are that prove something of their own, and up to when.
  struct Unfinished {
    std::size_t begin, end;   ///< of stretches that are finished
    WrittenUntil of_stretch;  ///< the one after these
  };

  template <class Write>
  SeparationsBody as_far_as_written(const Write& write);
  SeparationsBody unfinished(const std::string& why) const;
  void note_written(const proof::VerifierPair& pair, std::size_t stretches, const Unfinished& found);
  SeparationsBody contact_on(const PairResult& result, double until);
  void put_pair(const PairResult& result);
  void all_windows(double until);
  void section(const proof::VerifierPair& pair, const std::vector<proof::SegmentStretch>& stretches,
               const std::optional<Instant>& until);
  std::pair<std::size_t, proof::FineInstant> instant_of_margin(const proof::VerifierPair& pair,
                                                               const proof::Incidence& close, bool is_edge,
                                                               const TimeInterval& about) const;

  const proof::VerifierScene& scene_;
  proof::VerifierWorld world_;
  std::pair<int, int> contact_pair_{-1, -1};
  std::string out_;
  std::optional<Unfinished> unfinished_;
};

// The writers of the kinds of logs that prove() chooses from, besides that of tilings.

/// Proves the answer by the spacetime engine, for any scene: first the answer, then the log, which is written when it
/// is complete. An answer for which no log was found is `undecided`. Throws InputError.
Answer prove_by_separations(const Scene& scene, std::ostream& log, const CheckOptions& options);

/// Proves the answer of a run that has ended.
Answer prove_by_separations(const Run& run, const Scene& scene, std::ostream& log, const CheckOptions& options);

/// Like prove(), for scenes with curves. Throws InputError.
Answer prove_curves(const Scene& scene, std::ostream& log, const CheckOptions& options);

/// Like prove_clearance(), for scenes with curves. Throws InputError.
MarginAnswer prove_clearance_of_curves(const Scene& scene, double clearance, std::ostream& log,
                                       const CheckOptions& options);

}  // namespace taut::internal
