// Searches that were stopped, or are asked for again.
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

/// A search at high precision may take longer than the turn in which it is begun, and nobody knows by how much. It is
/// gone on with where it was: begun anew in each turn it would take several times as long in all, or never end. The
/// last ones of a segment are kept at each precision, with what came of them, since what comes after one may be
/// stopped, too. All of them are of forms of the same bodies, until they are cleared.
class KeptSearches {
 public:
  /// What is searched.
  struct Key {
    CertificateFunction function;
    int sign = 0;  ///< just after `from`
    RealMax from{};
    double to = 0;
    int from_end = 0;  ///< 1 or -1 where the function is one of the distance's root from that end of the segment

    bool operator==(const Key&) const = default;
  };

  void clear() {
    if (kept_) std::apply([](auto&... kept) { (kept.clear(), ...); }, *kept_);
  }
  /// As taut::first_sign_change() has it, from a to b, which are what the key says; refine(root) then encloses it
  /// better. That is begun anew if it is stopped: how it is done hangs on where it begins.
  template <class Real, class Function, class Cut, class Refine>
  std::optional<RootEnclosure<Real>> root(const Key& key, const Function& f, const Real& a, const Real& b,
                                          const Cut& cut, const Refine& refine) {
    if (!kept_) kept_ = std::make_unique<Kepts>();
    Place<Real>& place = std::get<Kept<Real>>(*kept_).of(key, a, b);
    if (place.sharp) return place.sharp;
    const std::uint64_t before = work_spent();
    std::uint64_t refining = UINT64_MAX;  // work_spent() when that began
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
    std::optional<RootEnclosure<Real>> sharp;  ///< what came of it, once it has been refined
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
  std::unique_ptr<Kepts> kept_;  ///< few questions need any
};

/// The root, kept if `kept` is not null.
template <class Real, class Function, class Cut, class Refine>
std::optional<RootEnclosure<Real>> sharp_root(KeptSearches* kept, const KeptSearches::Key& key, const Function& f,
                                              const Real& a, const Real& b, const Cut& cut, const Refine& refine) {
  if (kept) return kept->root(key, f, a, b, cut, refine);
  auto root = first_sign_change<Real>(f, key.sign, a, b, cut);
  if (root) refine(*root);
  return root;
}

}  // namespace taut::internal
