// Writes a log of the actions of the kinetic engine. Format: docs/proof-format.md.
#pragma once

#include <iosfwd>

#include "proof/bytes.hpp"
#include "proof/format.hpp"
#include "solver/kinetic_solver.hpp"
#include "solver/run.hpp"

namespace taut::internal {

/// Observes one run. The log is complete when end() returns.
class ProofWriter final : public KineticObserver {
 public:
  /// The tracer, which may be null, is notified of the same events.
  ProofWriter(const Scene& scene, Touch touch, std::ostream& log, Tracer* tracer = nullptr)
      : scene_(scene), touch_(touch), out_(log) {
    if (tracer) trace_.emplace(*tracer);
  }

  void started(const KineticSolver& solver) override;
  void on_event(const KineticSolver& solver, const EngineEvent& event) override;
  /// Called once, with the answer of the run, which becomes what the log proves: up to when nothing happens, or the
  /// contact as a verifier reports it.
  void end(Answer& answer);

 private:
  void kind(proof::Record r) { out_.u8(static_cast<std::uint8_t>(r)); }
  void to_segment(std::size_t segment);
  void header(proof::Shapes shapes);
  void tiling(const PlanarMap& map);
  void contact_at_start(const KineticSolver& solver);
  double free_until(double t);
  void note_contact(const KineticSolver& solver, const EngineEvent& event, double about);
  static double about(const PairGeometry& geometry, const EngineEvent& event);

  const Scene& scene_;
  Touch touch_;
  proof::ByteWriter out_;
  std::optional<TraceWriter> trace_;
  std::size_t segment_ = 0;
  std::optional<double> last_event_;  ///< on this segment
  std::optional<Contact> contact_;    ///< as a verifier will report it
  MotionSegments segments_;           ///< of the observed pair
  bool started_ = false;              ///< is there a header?
};

/// Proves the answer by the kinetic data structure, with a log of a tiling. Requires two bodies of one polygon each.
/// Throws InputError.
Answer prove_by_tiling(const Scene& scene, std::ostream& log, const CheckOptions& options);

}  // namespace taut::internal
