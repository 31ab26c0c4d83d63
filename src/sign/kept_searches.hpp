// Searches that were interrupted, or are requested again.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <tuple>

#include "base/budget.hpp"
#include "numeric/root_isolation.hpp"
#include "sign/certificate_function.hpp"
#include "sign/precise_time.hpp"

namespace taut::internal {

/// A search at high precision may take longer than the time slice in which it begins, by an unknown factor. It is
/// resumed where it stopped: restarted in each slice, it would take several times as long in all, or never end. The
/// last searches of a segment are kept at each precision with their results, because the work that follows a search may
/// be interrupted, too. Until they are cleared, all of them must be of certificate functions of the same bodies.
class KeptSearches {
 public:
  /// The identity of a search.
  struct Key {
    CertificateFunction function;
    int sign = 0;  ///< just after `from`
    RealMax from{};
    double to = 0;
    int from_end = 0;  ///< 1 or -1 if the variable is the square root of the distance from that end of the segment

    bool operator==(const Key&) const = default;
  };

  void clear() {
    if (kept_) std::apply([](auto&... kept) { (kept.clear(), ...); }, *kept_);
  }
  /// Like internal::first_sign_change(), from a to b, which are the values of the key; refine(root) then tightens the
  /// enclosure. If the refinement is interrupted, it restarts, because its course depends on where it begins.
  template <class Real, class Function, class Cut, class Refine>
  std::optional<RootEnclosure<Real>> root(const Key& key, const Function& f, const Real& a, const Real& b,
                                          const Cut& cut, const Refine& refine) {
    if (!kept_) kept_ = std::make_unique<Kepts>();
    Place<Real>& place = std::get<Kept<Real>>(*kept_).of(key, a, b);
    if (place.sharp) return place.sharp;
    const std::uint64_t before = work_spent();
    std::uint64_t refining = UINT64_MAX;  // work_spent() when the refinement began
    try {
      auto root = place.search.go_on(f, cut);
      if (!root) return std::nullopt;
      refining = work_spent();
      refine(*root);
      return place.sharp = root;
    } catch (const Interrupted&) {
      count_kept_work(std::min(work_spent(), refining) - before);
      throw;
    }
  }

 private:
  template <class Real>
  struct Place {
    std::optional<Key> key;
    SignChangeSearch<Real> search;
    std::optional<RootEnclosure<Real>> sharp;  ///< the result, once it has been refined
  };
  template <class Real>
  class Kept {
   public:
    void clear() {
      for (Place<Real>& p : places_) p.key.reset();
    }
    Place<Real>& of(const Key& key, const Real& a, const Real& b) {
      for (Place<Real>& p : places_) {
        if (p.key == key) return p;
      }
      Place<Real>& place = places_[next_++ % places_.size()];
      place.key = key;
      place.search.begin(key.sign, a, b);
      place.sharp.reset();
      return place;
    }

   private:
    std::array<Place<Real>, 4> places_;
    std::size_t next_ = 0;
  };

  using Kepts = OfEachPrecision<Kept>;
  std::unique_ptr<Kepts> kept_;  ///< few queries need it
};

/// The root, stored in `kept` if that is not null.
template <class Real, class Function, class Cut, class Refine>
std::optional<RootEnclosure<Real>> sharp_root(KeptSearches* kept, const KeptSearches::Key& key, const Function& f,
                                              const Real& a, const Real& b, const Cut& cut, const Refine& refine) {
  if (kept) return kept->root(key, f, a, b, cut, refine);
  auto root = first_sign_change<Real>(f, key.sign, a, b, cut);
  if (root) refine(*root);
  return root;
}

}  // namespace taut::internal
