// The kinetic data structure, online: advance, inspect, change a motion.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/feature.hpp"
#include "taut/scene.hpp"
#include "taut/tracer.hpp"

namespace taut {

/// Which kind of free face (or polygon interior) lies to the left of a half-edge.
enum class FaceKind : std::uint8_t {
  node,              ///< the pseudo-triangle of a node of one of the two chain trees
  root,              ///< the root pseudo-triangle
  infinite,          ///< the infinite face
  polygon_interior,  ///< the inside of a body
};

/// One face of the tiling, for drawing and study.
struct TilingFace {
  FaceKind kind = FaceKind::node;
  BodyId body = 0;  ///< for node and polygon_interior: whose tree
  int depth = 0;    ///< depth of the node in its tree, 0 at the root
  /// The boundary, face on the left: indices into Tiling::vertices. Empty for polygon interiors.
  std::vector<int> boundary;
  /// For node: the ends of its chain, counterclockwise around the body, as indices into Tiling::vertices.
  int chain_from = 0, chain_to = 0;
};

/// A vertex of a body, where it is now.
struct TilingVertex {
  VertexRef vertex;
  Point position;  ///< world coordinates, rounded
};

/// An edge of the tiling.
struct TilingEdge {
  int from = 0, to = 0;  ///< indices into Tiling::vertices
  bool polygon = false;  ///< an edge of a body
  bool pq = false;       ///< joins the two bodies
};

/// A copy of the planar map at one instant.
struct Tiling {
  double time = 0;
  std::vector<TilingVertex> vertices;
  std::vector<TilingEdge> edges;
  std::vector<TilingFace> faces;
};

/// An edge of a tiling between two rings of a world.
struct NearEdge {
  VertexRef from, to;
  bool pq = false;  ///< joins the two bodies
};

/// The tiling of the free space between a ring of one body and a ring of another one, without the rings' own edges.
struct NearTiling {
  std::array<BodyId, 2> bodies{};
  bool contained = false;  ///< one of the rings is a hole, and the other one is in it
  std::vector<NearEdge> edges;
};

/// The tilings at time t, built from scratch, of a single pair, or of the pairs that are near: whose boxes meet before
/// a sixteenth of the scene's time has passed. Where bodies overlap or touch at t, those of a moment before. For
/// drawing and study. The scene must be valid, without curves, and t within its time; limits are those of check():
/// parts that have no tiling, as they overlap, are left out.
std::vector<NearTiling> tilings_of_near_pairs(const Scene& scene, double t, Touch touch = Touch::open);

/// One half-edge of the planar map, the form in which the map can be followed through its events. Half-edges 2k and
/// 2k + 1 are the two directions of one edge; the first ones are the edges of the bodies.
struct TilingHalfedge {
  int origin = -1;                 ///< index into Tiling::vertices; -1: not in use at present
  int next = -1;                   ///< the half-edge after this one along the boundary of the face on its left
  FaceKind kind = FaceKind::node;  ///< of the face on its left
  BodyId body = 0;                 ///< of that face, as in TilingFace
  int depth = 0;                   ///< of that face, as in TilingFace
  friend bool operator==(const TilingHalfedge& a, const TilingHalfedge& b) {
    return a.origin == b.origin && a.next == b.next && a.kind == b.kind && a.body == b.body && a.depth == b.depth;
  }
};

/// A pinned geodesic cycle (section 2 of the paper): the shortest paths between the ends of the chains of one level of
/// a body's tree, each homotopic to its chain.
struct GeodesicCycle {
  BodyId body = 0;
  int level = 0;
  /// In order, counterclockwise around the body: indices into Tiling::vertices. Where the cycle touches itself,
  /// vertices come twice.
  std::vector<int> vertices;
  /// Positions in `vertices` at which the cycle is pinned: the ends of the chains.
  std::vector<int> pinned;
};

/// A corner u -> v -> w of a face whose certificate is active.
struct ActiveCertificate {
  VertexRef u, v, w;
  bool convex = false;
  double not_before = 0;  ///< the certificate certainly holds until this time
};

/// Where a simulation stands.
enum class SimulationState : std::uint8_t {
  running,           ///< the tested pairs are free of collisions up to time(), but for events that nearly coincide with
                     ///< the last one (see time()), and there may be more events
  finished,          ///< the tested pairs are free of collisions to the end of the scene
  contact,           ///< a collision, see contact(); resume() goes on
  overlap_at_start,  ///< the bodies overlap already at the start
  undecided,         ///< a limit was reached; reason() says which, and nothing is claimed beyond time()
  untested,          ///< the end of the scene was reached, and no pair was tested at any time: see coverage()
  locked,            ///< finished, and the scene ends there because its mechanism locks: see Scene::lock
};

/// "running", "finished", "contact", "overlap_at_start", "undecided", "untested" or "locked".
const char* to_string(SimulationState state);

/// How to simulate. The wall time is that of one call, the constructor's included; beyond it the state is `undecided`.
struct SimulationOptions {
  Touch touch = Touch::open;
  /// Become `undecided` where there may be an event after this many.
  std::uint64_t max_events = UINT64_MAX;
  /// Told of every event; may be null. Not owned.
  Tracer* tracer = nullptr;
  Limits limits = {};
  /// Become `undecided` where one pair of bodies comes into contact more often than this within `contact_time`: a ball
  /// that bounces lower and lower has infinitely many contacts in a finite time.
  std::uint64_t max_contacts_per_time = 1000;
  /// In the scene's units of time; 0 stands for 2^-20 of the time that the simulation begins with.
  double contact_time = 0;
  /// Keep all motions, for record().
  bool record = false;
};

/// A number that is enclosed.
struct Enclosure {
  double lo = 0, hi = 0;
};

/// How two bodies move at a contact, in world coordinates. Each number is enclosed for all instants of Contact::time.
struct ContactMotion {
  /// The unit outward normal of the edge's body.
  std::array<Enclosure, 2> normal;
  /// The velocity of the vertex, as the edge's body sees it: less the velocity that the material of that body has
  /// there.
  std::array<Enclosure, 2> velocity;
  /// The component of the velocity along the normal: negative while the bodies approach.
  Enclosure along_normal;
};

/// Any number of moving bodies, with parts, holes and parents. Every pair of rings that is near has an external
/// relative geodesic triangulation (a tiling), which is kept up to date event by event. The current time only grows.
/// Not thread-safe; distinct simulations are independent.
///
/// Events are those of all pairs that are near. Distant pairs cost nothing until they may be near; a single pair is
/// always near. The simulation answers as check() would about the rest of its time, whatever motions have been changed.
///
/// A contact stops it: state() is `contact`, and time() is the last double up to which the motion is proved free. There
/// set_motion() gives bodies other motions from time() on, and resume() goes on. Whether bodies come apart is never
/// assumed: if they still approach, or the rounding of their new motions makes them overlap, the next answer is a
/// contact at the same time, and contact_again() says so. Bodies that slide along each other go on where touching is no
/// collision (Touch::open). To be free of rounding, move a body off the contact by a few units in the last place of
/// its coordinates, along the normal: a jump so small is bridged, and proved free like any other motion.
///
/// Two bodies of one ring each have one tiling. Only they can have a tracer, and only of them tiling(), halfedges(),
/// halfedge(), changed_halfedges(), active_set(), levels() and geodesic_cycle() are known. For other scenes these throw
/// InputError, and so they do, but for tiling(), if the two bodies overlap at the start or touch there.
///
/// If the highest precision does not decide, or a limit of the options is reached, state() is `undecided` from then on,
/// as an answer of check() would be: an event may be half done. state(), reason(), time(), contact(), overlap_point()
/// and the counters events(), certificates() and certificates_max() still return what is known; next_event() and step()
/// return nothing more; everything else throws UndecidedError with the reason.
///
/// If an exception leaves the constructor, next_event(), step(), advance_to() or set_motion() (thrown by a Tracer at
/// any event, or by a lack of memory), an event is half done: after that every call throws UnusableError, and the
/// simulation may only be destroyed or assigned to. An InputError of taut's own changes nothing.
class Simulation {
 public:
  /// Validates the scene, builds the tiling at its start. Throws InputError.
  explicit Simulation(const Scene& scene, const SimulationOptions& options = {});
  /// The same without limits.
  Simulation(const Scene& scene, Touch touch, Tracer* tracer = nullptr);
  ~Simulation();
  /// The one moved from may only be destroyed or assigned to.
  Simulation(Simulation&&) noexcept;
  /// The one moved from may only be destroyed or assigned to.
  Simulation& operator=(Simulation&&) noexcept;

  /// Whether it can go on, and if not, why.
  SimulationState state() const;
  /// Why state() is `undecided`, in words; empty otherwise.
  const std::string& reason() const;
  /// Which pairs are tested at present: `tested` counts all of them, and `apart` is 0. set_motion() may change that.
  Coverage coverage() const;
  /// Up to when the motion is proved free, and the time to which the tiling corresponds. After an event it is the upper
  /// end of the event's enclosure, or, where the next one nearly coincides with it, a little less. It never decreases.
  double time() const;
  /// Enclosure of the time of the next event, which never begins before time(): of events that nearly coincide, those
  /// after the first count as no earlier than the end of its enclosure. Empty if none is left before the end, or it is
  /// undecided. Looks as far as it must: if a motion's next piece begins before the event, time() moves on to that
  /// joint, or to the end of a window in which nothing happens.
  std::optional<TimeInterval> next_event();
  /// Processes one event; if several pairs are near, also those whose enclosures are not later. Returns false if there
  /// is none before the end, after a contact, or if it is undecided.
  bool step();
  /// Processes all events before t (clamped to the end of the scene) and stands at t, unless a contact comes first.
  /// A time before time() changes nothing; one that is not a number is an InputError. After a contact it returns
  /// `contact` until resume() is called.
  SimulationState advance_to(double t);
  /// Goes on after a contact, usually with other motions: see set_motion(). Time stays; pairs that are still in
  /// contact, with the motions that they had, are in contact again at once. Returns the state. Throws InputError unless
  /// state() is `contact`.
  SimulationState resume();
  /// Replaces a body's motion from time() on. The new motion is in absolute time, like the old one; where its pose
  /// at time() differs from the present one by rounding, the gap is bridged as between two pieces of a scene, a
  /// larger jump is an InputError and changes nothing. Events that nearly coincide with the last one are processed
  /// first; if one of them is the contact, it stays the answer. The motion is relative to the body's parent, and bodies
  /// that are attached to the body move with it. The tilings of its pairs stay; only their certificates are computed
  /// anew. Pairs that have moved alike until then are tested from now on; if they overlap, state() is
  /// `overlap_at_start`, at the latest when time goes on. After a contact the state stays `contact`, and the motion
  /// counts once resume() is called. After an overlap it changes nothing.
  void set_motion(BodyId body, const Motion& motion);

  /// The next four cost what they are about, in worlds of more than two bodies: the pairs of the body that are near.
  /// They cost what a new simulation does where add_body() gets a body that is larger than all others (by the power of
  /// 2 above its largest coordinate), or any body has cross-sections on different layers; and so does set_motion() at
  /// the very instant at which a body was added or attached. An InputError changes nothing; they throw it also where
  /// bodies would overlap. Adds a body from time() on, which other bodies must not overlap. Returns its number: that of
  /// the last body, and 1.
  BodyId add_body(const Body& body);
  /// Takes a body away from time() on. The others keep their numbers. Throws InputError if a body is attached to it.
  void remove_body(BodyId body);
  /// The pair is not tested from time() on.
  void ignore(BodyId a, BodyId b);
  /// From time() on, the body is attached to that parent, or to none, and moves as seen from there. Its place in the
  /// world at time() must stay, up to a jump like that of set_motion().
  void set_parent(BodyId body, std::optional<BodyId> parent, const Motion& motion);

  /// The contact, once state() is `contact`.
  const std::optional<Contact>& contact() const;
  /// Whether the contact is one from which the simulation was resumed: the same features, at the same time.
  bool contact_again() const;
  /// How the bodies of a contact move at that time: contact(), or one of also(). Of the motions that hold from time()
  /// on, so after set_motion() the new ones.
  ContactMotion relative_velocity(const Contact& contact) const;
  /// How many contacts there have been, without those that came again.
  std::uint64_t contacts() const;
  /// The two bodies of the contact, or of the overlap; or of what is not decided, if that is one pair of a world.
  std::optional<std::array<BodyId, 2>> pair() const;
  /// As Answer::also.
  const std::vector<PairAnswer>& also() const;
  /// As Answer::overlap_point, if state() is `overlap_at_start`.
  const std::optional<Point>& overlap_point() const;
  /// Events processed so far.
  std::uint64_t events() const;
  /// Size of the active set; of a world, of those of the pairs that are near.
  std::uint64_t certificates() const;
  /// The largest that the active set has been; of a world, after one of the calls.
  std::uint64_t certificates_max() const;
  /// The planar map at time(). If the bodies overlap or touch at the start, it has vertices only.
  Tiling tiling() const;
  /// The same map as half-edges. Their number may grow with an event, and never shrinks.
  std::vector<TilingHalfedge> halfedges() const;
  /// One of them, by its position in halfedges(); its origin is -1 if there is no such half-edge, or it is not in use.
  TilingHalfedge halfedge(int index) const;
  /// The half-edges that the last event may have changed: a constant number, all others are as before. Between events
  /// the map does not change. A Tracer may ask from on_event(), where events are seen one by one. Empty before the
  /// first event.
  std::vector<int> changed_halfedges() const;
  /// The certificates that can fail: corners with vertices of both bodies.
  std::vector<ActiveCertificate> active_set() const;
  /// The scene as it goes on from time(): motions, parents and ignored pairs as they are now. Bodies that were removed
  /// are still there, at rest and ignored by all others.
  const Scene& scene() const;
  /// All that was done until time(), as ordinary scenes: one for each stretch of time between two calls of add_body(),
  /// remove_body(), ignore() or set_parent(), mostly a single one. They are free of contacts: every motion gives way to
  /// the next one right before it. (Where such a call comes at time() itself, the last one has no length: it may begin
  /// with a contact, or with an overlap by the jump that a motion may make.) Requires SimulationOptions::record; throws
  /// InputError otherwise.
  std::vector<Scene> record() const;
  /// Number of levels of a body's tree, the edges of the body being the last.
  int levels(BodyId body) const;
  /// The pinned geodesic cycle of one level at time(), built from scratch in O(n log n). Level 0 is the relative convex
  /// hull, the last level (and what lies beyond) the body's own boundary. Throws InputError if there is no such body,
  /// if the bodies overlap, or while the jump between two pieces of a motion is being bridged.
  GeodesicCycle geodesic_cycle(BodyId body, int level) const;

  struct Impl;

 private:
  Impl& usable() const;
  std::unique_ptr<Impl> impl_;
};

}  // namespace taut
