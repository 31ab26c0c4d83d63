// Writes a log of the actions of the kinetic engine. Format: docs/proof-format.md.
#pragma once

#include <iosfwd>

#include "check/run_watcher.hpp"
#include "proof/bytes.hpp"
#include "proof/format.hpp"

namespace taut::internal {

/// Observes one run. The log is complete when ended() returns.
class ProofWriter : public RunWatcher {
 public:
  ProofWriter(const Scene& scene, Touch touch, std::ostream& log) : scene_(scene), touch_(touch), out_(log) {}

  void started(const Session& session) override;
  void on_event(const EngineEvent& event) override;
  void ended(const Session& session, const Answer& answer) override;

 private:
  void kind(proof::Record r) { out_.u8(static_cast<std::uint8_t>(r)); }
  void to_segment(std::size_t segment);
  void header(proof::Shapes shapes);
  void tiling(const PlanarMap& map);
  void contact_at_start(const Session& session);
  double about(const EngineEvent& event) const;

  const Scene& scene_;
  Touch touch_;
  proof::ByteWriter out_;
  std::size_t segment_ = 0;
  const PairGeometry* geometry_ = nullptr;  ///< of the observed session
};

/// Proves the answer by the kinetic data structure, with a log of a tiling. Requires two bodies of one polygon each.
/// Throws InputError.
Answer prove_by_tiling(const Scene& scene, std::ostream& log, const CheckOptions& options);

}  // namespace taut::internal
