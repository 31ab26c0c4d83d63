// The kinetic simulation: certificates of the active set, events in certified order, repairs.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "kinetic/dormant_certificates.hpp"
#include "kinetic/event_queue.hpp"
#include "kinetic/failure_solver.hpp"
#include "kinetic/repair.hpp"
#include "relative/motion_segments.hpp"
#include "sign/found_contact.hpp"
#include "tiling/prepared_tiling.hpp"

namespace taut::internal {

/// One processed event, for observers.
struct EngineEvent {
  double lo = 0, hi = 0;  ///< of the segment's parameter
  const MotionSegment* segment = nullptr;
  std::size_t segment_index = 0;
  VertexId u, v, w;
  HalfedgeId corner;  ///< enters the corner that the repair went by
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

/// What is known of the bodies alone, displaced as in the pair; null where nothing is.
struct KnownTilings {
  const ShapeTiling *p = nullptr, *q = nullptr;
  /// Or the whole tiling at the start, which is the placement at that parameter of another segment, too. Then the first
  /// segment may be a bridge.
  const PlanarMap* map = nullptr;
  const MotionSegment* placed = nullptr;
  double parameter = 0;
};

/// Follows a sequence of segments. Allocates nothing per event once its buffers have grown.
///
/// It may be left in the middle of an event, by an exception of a long search's interruption point, and be taken up
/// again: what is done by then is kept, and only the search is made anew.
class Engine {
 public:
  /// Builds the tiling at the start of the first segment (not a bridge).
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
  /// Between events: a time before which no certificate fails, as far as is known now. Everything up to it is proved.
  double proved_until() const;
  /// The same in the middle of an event, after an exception.
  double reached() const { return segment().time(reached_); }
  /// work_spent() when what is done now was begun: all before that is kept if it is stopped.
  std::uint64_t work_kept() const { return work_kept_; }

  /// Processes the next event whose failure time is at most t; false if there is none (then the engine stands at t),
  /// or after a contact.
  bool step(double t);
  /// An enclosure of the time of the next event up to t, if there is one.
  std::optional<std::pair<double, double>> next_event(double t);
  /// After next_event found one: the certificate that will fail.
  const Certificate& upcoming() const { return certificates_[next_.value]; }
  /// At the end of its segments: a question begins, of which what came before is no part. Events and certificates are
  /// counted from here.
  void begin_question(MotionSegments segments);
  /// From now on it is told of events; may be null.
  void watch(EngineObserver* observer) { observer_ = observer; }
  const std::shared_ptr<const MotionSegment>& held_segment() const { return segment_; }
  /// Replaces all segments from the present on; the first one must start at time().
  void replan(MotionSegments segments);

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
  void take_map(const KnownTilings& known);
  void begin(const Placement& placement);
  std::size_t mixed_edges() const;
  void add_certificates(const Placement& placement);
  void add_certificates_beside(HalfedgeId edge, const Placement& placement);
  void reserve_certificates(std::size_t room);
  bool find_next(double limit);
  bool certainly_first(CertificateId head);
  void process(CertificateId id, double limit);
  HalfedgeId closing_corner(const Certificate& c, Now& now, VertexId& middle, bool& three);
  void take_up(const RepairReport& report);
  CertificateId certificate_to_start(HalfedgeId h, const Now& now);
  void finish_event();
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
  void finish_sweep();
  void schedule(CertificateId id, double t);
  /// Is nothing half done? Otherwise the queue does not know all that is due.
  bool is_whole() const { return !repaired_.open && sweep_.due == DormantCertificates::Due::nothing; }
  void make_whole() {
    if (sweep_.due != DormantCertificates::Due::nothing) finish_sweep();
    if (repaired_.open) finish_event();
  }

  PairGeometry geometry_;
  MotionSegments segments_;
  std::size_t current_ = 0;
  std::shared_ptr<const MotionSegment> segment_;  ///< that segment
  EngineObserver* observer_;
  PlanarMap map_;
  FailureSolver solver_;
  std::vector<Certificate> certificates_;
  std::vector<CertificateId> free_;
  BlockArray<CertificateId> certificate_of_;  ///< by half-edge
  EventQueue queue_;
  DormantCertificates dormant_;
  /// Certificates that are due at t: those from number `next` on are not scheduled yet.
  struct Sweep {
    DormantCertificates::Due due = DormantCertificates::Due::nothing;
    bool all_due = false;
    double t = 0;
    std::size_t next = 0;
  };
  Sweep sweep_;
  /// The last event, while certificates of its corners are still to be started.
  struct Repaired {
    bool open = false;
    EngineEvent event;
    Now now;
    std::array<CertificateId, 6> fresh;
    std::size_t count = 0, next = 0;
  };
  Repaired repaired_;
  CertificateId next_;
  double parameter_ = 0;
  double reached_ = 0;  ///< a lower bound of the last event's time
  EngineState state_ = EngineState::running;
  bool passing_ = false;  ///< to where the question begins
  std::optional<Overlap> overlap_;
  std::optional<FoundContact> contact_;
  std::uint64_t events_ = 0;
  std::uint64_t work_kept_ = 0;
  std::size_t active_ = 0, initial_ = 0, max_active_ = 0;
  RootState initial_root_ = RootState::disjoint;
  StageCounts at_start_;
};

}  // namespace taut::internal
