// Searches that were stopped, or are asked for again.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <tuple>

#include "base/interruption.hpp"
#include "numeric/root_isolation.hpp"
#include "sign/form.hpp"
#include "sign/precise_time.hpp"

namespace taut {

/// A search at high precision may take longer than the turn in which it is begun, and nobody knows by how much. It is
/// gone on with where it was: begun anew in each turn it would take several times as long in all, or never end. The
/// last ones of a leg are kept at each precision, with what came of them, since what comes after one may be stopped,
/// too. All of them are of forms of the same bodies, until they are cleared.
class KeptSearches {
 public:
  /// What is searched.
  struct Key {
    Form form;
    int sign = 0;  ///< just after `from`
    RealMax from{};
    double to = 0;
    int from_end = 0;  ///< 1 or -1 where the function is one of the distance's root from that end of the leg

    bool operator==(const Key&) const = default;
  };

  void clear() {
    if (kept_) std::apply([](auto&... kept) { (kept.clear(), ...); }, *kept_);
  }
  /// As taut::first_sign_change() has it, from a to b, which are what the key says; refine(root) then encloses it
  /// better.
  template <class Real, class Function, class Cut, class Refine>
  std::optional<RootEnclosure<Real>> root(const Key& key, const Function& f, const Real& a, const Real& b,
                                          const Cut& cut, const Refine& refine) {
    if (!kept_) kept_ = std::make_unique<Kepts>();
    SignChangeSearch<Real>& search = std::get<Kept<Real>>(*kept_).of(key, a, b);
    const std::uint64_t before = work_spent();
    try {
      RootEnclosure<Real>* const found = search.go_on(f, cut);
      if (!found) return std::nullopt;
      refine(*found);
      return *found;
    } catch (const Interrupted&) {
      keep_work(work_spent() - before);
      throw;
    }
  }

 private:
  template <class Real>
  class Kept {
   public:
    void clear() {
      for (Place& p : places_) p.key.reset();
    }
    SignChangeSearch<Real>& of(const Key& key, const Real& a, const Real& b) {
      for (Place& p : places_) {
        if (p.key == key) return p.search;
      }
      Place& place = places_[next_++ % places_.size()];
      place.key = key;
      place.search.begin(key.sign, a, b);
      return place.search;
    }

   private:
    struct Place {
      std::optional<Key> key;
      SignChangeSearch<Real> search;
    };
    std::array<Place, 4> places_;
    std::size_t next_ = 0;
  };

  using Kepts = std::tuple<Kept<Real320>, Kept<Real640>, Kept<RealMax>>;
  std::unique_ptr<Kepts> kept_;  ///< few questions need any
};

}  // namespace taut
