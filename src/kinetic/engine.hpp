// The kinetic simulation: certificates of the active set, events in certified order, and repairs.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "certificate/contact_bracket.hpp"
#include "kinetic/dormant_certificates.hpp"
#include "kinetic/event_queue.hpp"
#include "kinetic/failure_solver.hpp"
#include "kinetic/repair.hpp"
#include "motion/motion_segments.hpp"
#include "tiling/prepared_tiling.hpp"

namespace taut::internal {

/// One processed event, for observers.
struct EngineEvent {
  double lo = 0, hi = 0;  ///< in the segment's parameter
  const MotionSegment* segment = nullptr;
  std::size_t segment_index = 0;
  VertexId u, v, w;
  HalfedgeId corner;  ///< enters the corner that determined the repair
  RepairReport report;
  bool three_corners = false;
  ChainNode face;  ///< of the failed corner, before the repair
};

class EngineObserver {
 public:
  virtual ~EngineObserver() = default;
  virtual void on_event(const EngineEvent& event) = 0;
};

enum class EngineState : unsigned char { running, finished, contact, overlap };

/// Known tilings of the single bodies, displaced as in the pair. A pointer is null if the tiling is not known.
struct KnownTilings {
  const ShapeTiling *p = nullptr, *q = nullptr;
};

/// Follows a sequence of segments. Once its buffers have grown, it allocates nothing per event.
///
/// An exception thrown by a checkpoint, or by Undecidable, may leave it in the middle of an event. Then it reports up
/// to when everything is proved (reached()), and it must not be used any more.
class Engine {
 public:
  /// Builds the tiling at the start of the first segment, which must not be a bridge.
  Engine(PairGeometry geometry, MotionSegments segments, EngineObserver* observer = nullptr,
         const KnownTilings& known = {});
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  EngineState state() const { return state_; }
  const std::optional<Overlap>& overlap() const { return overlap_; }
  const std::optional<FoundContact>& contact() const { return contact_; }
  const PairGeometry& geometry() const { return geometry_; }
  const PlanarMap& map() const { return map_; }
  const MotionSegment& segment() const { return *segment_; }
  std::size_t segment_index() const { return current_; }
  /// The parameter of the current segment up to which everything is proved and processed.
  double parameter() const { return parameter_; }
  double time() const { return segment().time(parameter_); }
  /// Valid between events: a time before which, as far as is known now, no certificate fails. Everything up to it is
  /// proved.
  double proved_until() const;
  /// The corresponding time in the middle of an event, after an exception.
  double reached() const { return segment().time(reached_); }

  /// Processes the next event whose failure time is at most t. Returns false after a contact, or if there is no such
  /// event; in the latter case the engine has advanced to t.
  bool step(double t);
  /// An enclosure of the time of the next event up to t, if there is one.
  std::optional<std::pair<double, double>> next_event(double t);
  /// The certificate that will fail next. Requires that next_event() found one.
  const Certificate& upcoming() const { return certificates_[next_.value]; }
  /// Can all segments from that time on be replaced? The engine must not have come to a joint at that time, or beyond
  /// the time; and there must be no event up to then. A contact changes no tiling: the time may be right before it.
  bool can_replan_at(double t) const;
  /// Replaces all segments from that time on, at which the first new one starts: see can_replan_at().
  void replan(MotionSegments segments);

  /// Of many engines, one after the other works: this one gives memory that it can do without to the next one.
  void put_aside() {
    solver_.put_aside();
    segments_.give_back();
  }

  std::uint64_t events() const { return events_; }
  std::size_t active_certificates() const { return active_; }
  std::size_t initial_certificates() const { return initial_; }
  std::size_t max_certificates() const { return max_active_; }
  RootState initial_root() const { return initial_root_; }
  StageCounts stages() const { return StageCounts(at_start_) += solver_.stages(); }
  /// Calls visit(certificate) for the active set.
  template <class Visit>
  void for_each_certificate(const Visit& visit) const {
    for (const Certificate& c : certificates_) {
      if (c.corner.valid()) visit(c);
    }
  }
  std::size_t bytes() const;

 private:
  void build(const KnownTilings& known);
  void begin(const Placement& placement);
  std::size_t mixed_edges() const;
  void add_certificates(const Placement& placement);
  void add_certificates_beside(HalfedgeId edge, const Placement& placement);
  void reserve_certificates(std::size_t room);
  bool find_next(double limit);
  bool certainly_first(CertificateId head);
  void process(CertificateId id, double limit);
  HalfedgeId closing_corner(const Certificate& c, Now& now, VertexId& middle, bool& three);
  void start_corners(const RepairReport& report, Now& now);
  CertificateId certificate_to_start(HalfedgeId h, const Now& now);
  void drop_corner(HalfedgeId h);
  /// The vertices of the corner that h enters.
  struct Corner {
    VertexId u, v, w;
  };
  Corner corner(HalfedgeId h) const;
  bool is_mixed(const Corner& c) const;
  CertificateId add_certificate(HalfedgeId h, const Corner& vertices);
  void reserve_for_segments();
  void enter_segment();
  void check_dormant(double t, bool all_due);
  void schedule(CertificateId id, double t);

  PairGeometry geometry_;
  MotionSegments segments_;
  std::size_t current_ = 0;
  std::shared_ptr<const MotionSegment> segment_;  ///< the segment number current_
  EngineObserver* observer_;
  PlanarMap map_;
  FailureSolver solver_;
  std::vector<Certificate> certificates_;
  std::vector<CertificateId> free_;
  BlockArray<CertificateId> certificate_of_;  ///< by half-edge
  EventQueue queue_;
  DormantCertificates dormant_;
  CertificateId next_;
  double parameter_ = 0;
  double reached_ = 0;         ///< a lower bound of the last event's time
  double before_contact_ = 0;  ///< up to this parameter, events before the contact were processed
  EngineState state_ = EngineState::running;
  std::optional<Overlap> overlap_;
  std::optional<FoundContact> contact_;
  std::uint64_t events_ = 0;
  std::size_t active_ = 0, initial_ = 0, max_active_ = 0;
  RootState initial_root_ = RootState::disjoint;
  StageCounts at_start_;
};

}  // namespace taut::internal
