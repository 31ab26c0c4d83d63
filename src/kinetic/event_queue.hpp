// The order of failure times: a tournament tree of certificates.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include "certificate/precise_time.hpp"
#include "kinetic/certificate.hpp"

namespace taut::internal {

/// Certificates ordered by exact lower bounds of their failure times. The bound is the double `lo`, or within one
/// double the multi-precision enclosure. Events that coincide in the input differ only there.
///
/// A complete binary tree has a leaf for every certificate, and every node holds the earlier of its two children.
/// Bounds change far more often than they come first, and mostly from one late time to another. Such a change ends at
/// the first node that another certificate wins, and only the nodes on the path to it are written.
class EventQueue {
 public:
  /// The nodes that a visitor of rivals wants to visit next.
  enum class Visit : std::uint8_t {
    on,    ///< the others
    past,  ///< only those that do not come after this one
    stop,  ///< none
  };

  EventQueue(const std::vector<Certificate>& certificates, const std::vector<PreciseTime>& pool)
      : certificates_(&certificates), pool_(&pool) {}

  bool empty() const { return leaves_ == 0 || keys_[root_] == rank_of_never; }
  /// The earliest certificate. Requires a nonempty queue.
  CertificateId top() const { return CertificateId(ids_[root_]); }
  std::size_t bytes() const { return 2 * capacity_ * (sizeof(std::int64_t) + sizeof(std::uint32_t)); }

  /// Makes room for this many certificates. The memory is not touched until they are added.
  void reserve(std::size_t certificates) {
    if (certificates <= capacity_) return;
    const std::size_t capacity = std::bit_ceil(certificates);
    std::unique_ptr<std::int64_t[]> keys(new std::int64_t[2 * capacity]);
    std::unique_ptr<std::uint32_t[]> ids(new std::uint32_t[2 * capacity]);
    for (std::size_t level = leaves_; level > 0; level /= 2) {
      const std::size_t from = capacity_ / leaves_ * level, to = capacity / leaves_ * level;
      std::copy_n(&keys_[from], level, &keys[to]);
      std::copy_n(&ids_[from], level, &ids[to]);
    }
    keys_ = std::move(keys);
    ids_ = std::move(ids);
    capacity_ = capacity;
    if (leaves_ > 0) root_ = capacity_ / leaves_;
  }
  /// Removes all certificates.
  void clear() {
    if (leaves_ > 0) clear(root_);
  }
  /// Moves the certificate to the position of its `lo`. A certificate that never fails is left out.
  void update(CertificateId id) { set(id, (*certificates_)[id.value].lo); }
  void remove(CertificateId id) {
    if (id.value < leaves_ && keys_[leaf(id)] != rank_of_never) set(id, never);
  }
  /// Calls visit(id) for every certificate but the first whose key is at most `until`, until the visitor returns stop.
  template <class Visitor>
  void visit_rivals(double until, const Visitor& visit) const {
    // Within a subtree, the candidates are the siblings of the nodes on the path from its root to its winner. There are
    // as many as the subtree has levels, and the smallest one is visited next.
    const std::int64_t last = rank(until);
    std::array<std::size_t, 64> open;
    std::size_t count = 0;
    const auto open_beside = [&](std::size_t node) {
      const std::size_t winner = leaf(CertificateId(ids_[node]));
      for (int level = depth(winner) - depth(node); level-- > 0;) {
        const std::size_t other = (winner >> level) ^ 1;
        if (keys_[other] <= last) open[count++] = other;
      }
    };
    open_beside(root_);
    while (count > 0) {
      const std::size_t node = open[--count];
      const Visit next = visit(CertificateId(ids_[node]));
      if (next == Visit::stop) return;
      if (next == Visit::on) open_beside(node);
    }
  }

 private:
  static constexpr std::int64_t rank_of_never = 0x7ff0000000000000;  // the rank of infinity

  std::size_t leaf(CertificateId id) const { return capacity_ + id.value; }

  static int depth(std::size_t node) { return static_cast<int>(std::bit_width(node)); }

  bool breaks_tie(std::uint32_t a, std::uint32_t b) const {
    const std::int32_t pa = (*certificates_)[a].precise, pb = (*certificates_)[b].precise;
    if (pb < 0) return false;
    if (pa < 0) return true;
    return (*pool_)[static_cast<std::size_t>(pa)].begins_before((*pool_)[static_cast<std::size_t>(pb)]);
  }
  /// An integer with the order of the key.
  static std::int64_t rank(double key) {
    const double one_zero = key + 0.0;  // maps -0 to +0
    std::int64_t bits;
    std::memcpy(&bits, &one_zero, sizeof bits);  // std::bit_cast is not in every library yet
    return bits ^ ((bits >> 63) & INT64_MAX);
  }
  /// Does the certificate `other`, with its key, come before `id`?
  bool before(std::int64_t other_key, std::uint32_t other, std::int64_t key, std::uint32_t id) const {
    if (other_key == key && key != rank_of_never) return breaks_tie(other, id);
    return other_key < key;
  }
  void set(CertificateId id, double lo) {
    if (id.value >= leaves_) grow(id.value + std::size_t{1});
    std::int64_t* const keys = keys_.get();
    std::uint32_t* const ids = ids_.get();
    const std::size_t root = root_;
    std::size_t node = leaf(id);
    std::int64_t key = rank(lo);
    std::uint32_t winner = id.value;
    keys[node] = key;
    ids[node] = winner;
    // Go up as far as the certificate itself wins,
    for (; node != root && !before(keys[node ^ 1], ids[node ^ 1], key, winner); node /= 2) {
      keys[node / 2] = key;
      ids[node / 2] = winner;
    }
    if (node == root) return;
    key = keys[node ^ 1];
    winner = ids[node ^ 1];
    // and then as far as it won before. The winner of a comparison there is unpredictable, so no branch depends on it.
    for (node /= 2; ids[node] != winner; node /= 2) {
      keys[node] = key;
      ids[node] = winner;
      if (node == root) return;
      const std::int64_t other = keys[node ^ 1];
      const std::uint32_t other_id = ids[node ^ 1];
      bool loses = other < key;
      if (other == key) loses = before(other, other_id, key, winner);
      key = loses ? other : key;
      winner = loses ? other_id : winner;
    }
  }
  /// Doubles the number of leaves until there are at least `count`. The former root becomes the first half of a larger
  /// tree.
  void grow(std::size_t count) {
    reserve(count);
    if (leaves_ == 0) {
      leaves_ = 1;
      root_ = capacity_;
      keys_[root_] = rank_of_never;
      ids_[root_] = CertificateId().value;
    }
    while (leaves_ < count) {
      for (std::size_t level = leaves_, node = capacity_ + leaves_; level > 0; level /= 2, node /= 2) {
        std::fill_n(&keys_[node], level, rank_of_never);
        std::fill_n(&ids_[node], level, CertificateId().value);
      }
      keys_[root_ / 2] = keys_[root_];
      ids_[root_ / 2] = ids_[root_];
      root_ /= 2;
      leaves_ *= 2;
    }
  }
  void clear(std::size_t node) {
    if (keys_[node] == rank_of_never) return;
    keys_[node] = rank_of_never;
    if (node >= capacity_) return;
    clear(2 * node);
    clear(2 * node + 1);
  }

  const std::vector<Certificate>* certificates_;
  const std::vector<PreciseTime>* pool_;
  /// Node i has the children 2i and 2i + 1. Leaf number k is node capacity_ + k. The first leaves_ leaves are in use.
  std::unique_ptr<std::int64_t[]> keys_;
  std::unique_ptr<std::uint32_t[]> ids_;
  std::size_t capacity_ = 0, leaves_ = 0;  ///< powers of two
  std::size_t root_ = 0;
};

}  // namespace taut::internal
