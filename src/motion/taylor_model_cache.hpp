// A segment's frame functions at any instant, in doubles with error bounds, from models that are computed once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "motion/frame_model.hpp"
#include "motion/frame_sample.hpp"
#include "numeric/thread_local_pool.hpp"

namespace taut::internal {

/// A dyadic part of a segment's interval.
struct ModelPlace {
  int level;            ///< the segment is divided into 2^level parts,
  std::uint64_t index;  ///< and this is one of them
  double start, end;
  bool leaf;    ///< the cell is fine enough: values come from it
  int ahead;    ///< if it is not a leaf, the next cell that may be one is about this many levels finer
  bool sharp;   ///< the model's values are sharp; if not, the frame itself is evaluated
  bool widest;  ///< a leaf, and the next larger cell is almost certainly not one
};

/// A place with a model of the frame over it.
struct ModelCell : ModelPlace {
  FrameModel model;
  FrameCurvature pp, qq;
  FrameThird pp_third, qq_third;  ///< not on a bridge

  /// Bounds of the second derivatives over the cell.
  const FrameCurvature& curvature(bool of_pp) const { return of_pp ? pp : qq; }
  const FrameThird& third(bool of_pp) const { return of_pp ? pp_third : qq_third; }
};

/// Evaluates a segment's frame from Taylor models over a dyadic subdivision of its interval, which is as fine as the
/// motion requires: cells shrink towards an instant at which the motion is singular. Cells are computed on first use,
/// and the last ones are kept, so that memory does not depend on the segment.
class TaylorModelCache {
 public:
  /// Do all functions of mixed triples change linearly with time?
  static bool is_straight(const MotionSegment& segment) {
    return segment.translation && segment.degree <= 1 && !segment.bridge;
  }
  /// Makes room for a segment that is not straight, so that nothing is allocated later, except for the needs of the
  /// first singular instant.
  void reserve_cells() {
    if (!store_) store_ = ThreadLocalPool<Store>::take();
  }
  /// Gives the room back, for others in this thread to use. Cells are computed again when they are needed.
  void release();
  /// The memory reserved for cells, most of which is never touched.
  std::size_t bytes() const { return store_ ? sizeof(Store) + (store_->deep ? sizeof(Store::Deep) : 0) : 0; }
  /// Prepares a segment; the reference must stay valid.
  void reset(const MotionSegment& segment);
  const MotionSegment& segment() const { return *segment_; }
  /// On a straight segment, the functions at its middle determine everything.
  bool straight() const { return straight_; }
  const FrameSample& straight_side() const { return straight_side_; }
  double straight_middle() const { return straight_middle_; }
  /// The functions at parameter t. The last instants are cached.
  const FrameSample& at(double t, bool pp) {
    Side& side = pp || segment_->translation ? pp_ : qq_;
    if (t != side.t || !side.known) evaluate(t, side);
    return side.functions;
  }
  /// The functions at an instant `at`, a little before t or equal to t. Each cell has few of these instants, so that
  /// many queries share one.
  const FrameSample& shortly_before(double t, bool pp, double& at);
  /// The cell for parameter t. Like every reference to a cell, it is valid until the next call of a member of this
  /// cache.
  const ModelCell& cell(double t) { return last_ && t >= last_->start && t < last_->end ? *last_ : find_cell(t); }
  /// The next larger cell around this one; null for the whole segment.
  const ModelCell* wider(const ModelPlace& cell);
  /// Like wider(), but only the place and the third derivatives are set: far cheaper to compute.
  const ModelCell* parent_bounds(const ModelPlace& cell);
  /// Bounds of the third derivatives that hold on the whole segment and are hardly worse than those over a part of it;
  /// null if there are none.
  const FrameThird* third_throughout(bool of_pp) const {
    return !steady_ ? nullptr : of_pp ? &pp_steady_ : &qq_steady_;
  }

 private:
  /// The slot of cell number 2^level + index. Cells down to level 8 have a slot each. Deeper ones (some hundreds around
  /// a singular instant) are distributed over the others by a hash. Where bodies rotate uniformly, cells other than the
  /// current one are not used again, and are quickly computed. A few slots, which stay in the processor's cache,
  /// suffice for them.
  static constexpr std::size_t own = 512, scattered = 4096;
  static constexpr int scattered_bits = 12, even_bits = 6;
  std::size_t slot_of(std::uint64_t key) const {
    return key < own ? static_cast<std::size_t>(key)
                     : own + static_cast<std::size_t>((key * 0x9e3779b97f4a7c15u) >>
                                                      (64 - (even_ ? even_bits : scattered_bits)));
  }

  const ModelCell& at_level(int level, std::uint64_t index);
  const ModelCell& uniform_parent_bounds(int level, std::uint64_t index);
  void make_parent_bounds(ModelCell& cell, int level, std::uint64_t index) const;
  const ModelCell& whole_segment();
  void place(ModelCell& cell, int level, std::uint64_t index) const;
  const ModelCell& find_cell(double t);
  const ModelCell& find_leaf(double t);
  double boundary(int level, std::uint64_t index) const;
  std::uint64_t index_of(int level, double t) const;
  void make(ModelCell& cell);
  int levels_ahead(const ModelCell& cell) const;
  /// The functions of one kind of triple at an instant.
  struct Side {
    int first;  ///< the first of the model's functions
    bool known = false;
    double t = 0;
    FrameSample functions{};
  };
  void evaluate(double t, Side& side);
  static constexpr int samples = 32;  ///< instants per cell that are evaluated once
  struct SampleGrid {
    int first;
    std::array<double, samples> at;  ///< the instants that are known: NaN at the beginning
    std::array<FrameSample, samples> functions;
  };

  const MotionSegment* segment_ = nullptr;
  std::shared_ptr<const UniformRotation> even_;  ///< set if the segment rotates uniformly
  bool steady_ = false;                          ///< third derivatives have the same bounds everywhere:
  FrameThird pp_steady_{}, qq_steady_{};
  bool straight_ = false;
  double straight_middle_ = 0;
  FrameSample straight_side_{};
  std::unique_ptr<ModelCell> straight_cell_;  ///< the whole of a straight segment; made with the first one
  bool straight_cell_made_ = false;
  int level_ = 0;  ///< of the leaf used last
  std::uint64_t index_ = 0;
  const ModelCell* last_ = nullptr;       ///< that leaf, while it is cached
  Side pp_{.first = 0}, qq_{.first = 2};  ///< on a translation, the first one serves both
  /// Data that straight segments do not need. The memory is allocated with the first cell, and not touched beyond the
  /// cells in use.
  struct Store {
    SampleGrid pp_samples, qq_samples;
    std::array<std::uint64_t, own> keys;  ///< the cell in each slot
    std::array<bool, own> parent_bounds_known;
    std::array<ModelCell, own> cells;
    /// The hashed cells are nine tenths of all, and few segments have a singular instant. They are allocated on first
    /// use.
    struct Deep {
      std::array<std::uint64_t, scattered> keys;
      std::array<ModelCell, scattered> cells;
      /// For uniform rotations: cells with only their place and third derivatives.
      std::array<std::uint64_t, std::size_t{1} << even_bits> parent_bounds_keys;
      std::array<ModelCell, std::size_t{1} << even_bits> all_parent_bounds;
    };
    std::unique_ptr<Deep> deep;
    bool deep_used;  ///< for the current segment

    void clear();
    bool holds(std::size_t slot, std::uint64_t wanted);
    std::uint64_t& key(std::size_t slot) { return slot < own ? keys[slot] : deep->keys[slot - own]; }
    ModelCell& cell(std::size_t slot) { return slot < own ? cells[slot] : deep->cells[slot - own]; }
  };
  ThreadLocalPool<Store>::Pointer store_;
  bool stored_ = false;  ///< the store belongs to the current segment
};

}  // namespace taut::internal
