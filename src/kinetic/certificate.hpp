// Corner certificates and the queue of their failure times.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/ids.hpp"
#include "motion/fast_function.hpp"
#include "motion/precise_triple.hpp"

namespace taut {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// What is known of a certificate's next failure.
enum class FailureKind : std::uint8_t {
  not_before,  ///< the certificate holds until `lo` at least
  isolated,    ///< it fails within [lo, hi], where its function is monotone
};

/// One corner u -> v -> w of a face, as long as it keeps its orientation.
struct Certificate {
  FastFunction function;
  double lo = 0, hi = 0;
  double monotone_until = 0;  ///< once isolated: the function is monotone from `lo` to here
  HalfedgeId corner;          ///< the half-edge u -> v of the face
  VertexId u, v, w;
  std::int32_t precise = -1;  ///< index of a multi-precision enclosure of the failure time, or -1
  std::int32_t heap = -1;     ///< position in the queue, or -1
  std::int8_t sign = 0;       ///< +1 convex, -1 reflex
  FailureKind kind = FailureKind::not_before;
};

/// A heap of certificates ordered by exact lower bounds of their failure times: the double `lo`, or within one double
/// the multi-precision enclosure. Events that coincide in the input differ only there.
class EventQueue {
 public:
  struct Entry {
    double key;
    CertificateId id;
  };
  EventQueue(std::vector<Certificate>& certificates, const std::vector<PreciseTime>& pool)
      : certificates_(&certificates), pool_(&pool) {}

  bool empty() const { return entries_.empty(); }
  std::size_t size() const { return entries_.size(); }
  const Entry& entry(std::size_t i) const { return entries_[i]; }
  const Entry& top() const { return entries_[0]; }
  void reserve(std::size_t n) { entries_.reserve(n); }
  std::size_t bytes() const { return entries_.capacity() * sizeof(Entry); }

  void clear() {
    for (const Entry& e : entries_) (*certificates_)[e.id.value].heap = -1;
    entries_.clear();
  }
  /// Puts the certificate where its `lo` belongs; one that never fails is left out.
  void update(CertificateId id) {
    Certificate& c = (*certificates_)[id.value];
    if (c.lo == never) {
      remove(id);
      return;
    }
    if (c.heap < 0) {
      c.heap = static_cast<std::int32_t>(entries_.size());
      entries_.push_back({c.lo, id});
      sift_up(static_cast<std::size_t>(c.heap));
      return;
    }
    const auto i = static_cast<std::size_t>(c.heap);
    entries_[i].key = c.lo;
    sift_up(i);
    sift_down(static_cast<std::size_t>((*certificates_)[id.value].heap));
  }
  void remove(CertificateId id) {
    Certificate& c = (*certificates_)[id.value];
    if (c.heap < 0) return;
    const auto i = static_cast<std::size_t>(c.heap);
    c.heap = -1;
    const Entry last = entries_.back();
    entries_.pop_back();
    if (i == entries_.size()) return;
    place(i, last);
    sift_up(i);
    sift_down(static_cast<std::size_t>((*certificates_)[last.id.value].heap));
  }

 private:
  static constexpr std::size_t arity = 4;

  bool less(const Entry& a, const Entry& b) const {
    return a.key < b.key || (a.key == b.key && breaks_tie((*certificates_)[a.id.value], (*certificates_)[b.id.value]));
  }
  bool breaks_tie(const Certificate& a, const Certificate& b) const {
    if (b.precise < 0) return false;
    if (a.precise < 0) return true;
    return (*pool_)[static_cast<std::size_t>(a.precise)].begins_before((*pool_)[static_cast<std::size_t>(b.precise)]);
  }

  /// Ties are rare: keys alone are compared without branches.
  std::size_t least_of(std::size_t first, std::size_t last) const {
    std::size_t best = first;
    double key = entries_[first].key;
    bool tie = false;
    for (std::size_t k = first + 1; k < last; ++k) {
      const double other = entries_[k].key;
      tie |= other == key;
      const bool smaller = other < key;
      best = smaller ? k : best;
      key = smaller ? other : key;
    }
    if (tie) {
      for (std::size_t k = first; k < last; ++k) {
        if (less(entries_[k], entries_[best])) best = k;
      }
    }
    return best;
  }
  void place(std::size_t i, const Entry& e) {
    entries_[i] = e;
    (*certificates_)[e.id.value].heap = static_cast<std::int32_t>(i);
  }
  void sift_up(std::size_t i) {
    const Entry e = entries_[i];
    while (i > 0) {
      const std::size_t parent = (i - 1) / arity;
      if (!less(e, entries_[parent])) break;
      place(i, entries_[parent]);
      i = parent;
    }
    place(i, e);
  }
  void sift_down(std::size_t i) {
    const Entry e = entries_[i];
    for (;;) {
      const std::size_t first = i * arity + 1;
      if (first >= entries_.size()) break;
      const std::size_t best = least_of(first, std::min(first + arity, entries_.size()));
      if (!less(entries_[best], e)) break;
      place(i, entries_[best]);
      i = best;
    }
    place(i, e);
  }

  std::vector<Certificate>* certificates_;
  const std::vector<PreciseTime>* pool_;
  std::vector<Entry> entries_;
};

}  // namespace taut
