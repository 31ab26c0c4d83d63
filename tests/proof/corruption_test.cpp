// Thousands of damaged logs: each is rejected, or what it still proves is true.
//
// A damaged log that is accepted is no hole by itself. The verifier accepts any valid tiling and any valid sequence of
// changes, so a change may leave a proof: a time shifted by less than its enclosure; a corner's own number in the last
// event exchanged for another corner of the same triangle, all of which fail at once; an opened triangle instead of an
// exchanged edge, at the end of a log, which is also a tiling of pseudo-triangles. The argument that such a log is a
// proof is the verifier's; what is tested here is its soundness: whatever it accepts is true of the scene, in the touch
// mode that it names, by the answers of two other engines.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <sstream>

#include "log_text.hpp"
#include "support/effort.hpp"
#include "support/random_scenes.hpp"
#include "support/rng.hpp"
#include "truth.hpp"

namespace taut::testing {
namespace {

/// A scene with a valid log in parts.
struct Specimen {
  Scene scene;
  Touch touch;
  LogParts parts;
  std::uint32_t vertices;
};

struct Count {
  int tried = 0, accepted = 0;
};

class Corruption : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    specimens_ = new std::vector<Specimen>;
    truths_ = new std::vector<Truth>;
    for (std::uint64_t seed = 0; specimens_->size() < effort(40); ++seed) {
      SceneOptions options;
      options.grid = seed % 3 == 0;
      const Scene scene = random_scene(500 + seed, all_families[seed % std::size(all_families)], options);
      const Touch touch = seed % 4 == 3 ? Touch::closed : Touch::open;
      const Proved proved = prove_in_memory(scene, touch);
      if (proved.answer.outcome == Outcome::overlap_at_start || proved.answer.events < 4 || proved.answer.events > 60) {
        continue;
      }
      const auto vertices = static_cast<std::uint32_t>(scene.bodies[0].polygon.size() + scene.bodies[1].polygon.size());
      specimens_->push_back({scene, touch, take_apart(proved.log, vertices), vertices});
      truths_->emplace_back(scene);
    }
  }
  static void TearDownTestSuite() {
    int tried = 0, accepted = 0;
    for (const auto& [name, count] : counts_) {
      std::cout << name << ": " << count.tried << " damaged logs, " << count.accepted << " still proofs\n";
      tried += count.tried;
      accepted += count.accepted;
    }
    std::cout << tried << " in all, " << accepted << " still proofs\n";
    EXPECT_GE(static_cast<std::uint64_t>(tried), enough(10000));
    delete specimens_;
    delete truths_;
  }

  /// Checks a damaged log against the scene of specimen `of`; true if it is accepted (and then true).
  static bool judge(const std::string& name, std::size_t of, const std::string& log) {
    Count& count = counts_[name];
    ++count.tried;
    std::istringstream in(log);
    try {
      const Verified v = verify((*specimens_)[of].scene, in);
      ++count.accepted;
      EXPECT_EQ((*truths_)[of].refutation(v), "") << name << ", specimen " << of;
      return true;
    } catch (const ProofError&) {
      return false;
    }
  }

  /// Damages every specimen in every place that `damage` finds: it gets parts to change and a place, and returns false
  /// where there is no such place.
  static void everywhere(const std::string& name, const std::function<bool(LogParts&, std::size_t)>& damage) {
    for (std::size_t i = 0; i < specimens_->size(); ++i) {
      for (std::size_t place = 0;; ++place) {
        LogParts parts = (*specimens_)[i].parts;
        if (!damage(parts, place)) break;
        // Two ends of segments in a row, exchanged, are the same log.
        if (parts.records == (*specimens_)[i].parts.records && parts.header == (*specimens_)[i].parts.header) continue;
        judge(name, i, put_together(parts));
      }
    }
  }

  static std::vector<Specimen>* specimens_;
  static std::vector<Truth>* truths_;
  static std::map<std::string, Count> counts_;
};

std::vector<Specimen>* Corruption::specimens_ = nullptr;
std::vector<Truth>* Corruption::truths_ = nullptr;
std::map<std::string, Count> Corruption::counts_;

bool is_event(const std::string& record) { return record.size() == 13; }

double time_of(const std::string& record) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    bits |= static_cast<std::uint64_t>(static_cast<std::uint8_t>(record[1 + i])) << (8 * i);
  }
  return std::bit_cast<double>(bits);
}
void set_time(std::string& record, double t) {
  const auto bits = std::bit_cast<std::uint64_t>(t);
  for (std::size_t i = 0; i < 8; ++i) record[1 + i] = static_cast<char>(bits >> (8 * i));
}
void set_halfedge(std::string& record, std::uint32_t h) {
  for (std::size_t i = 0; i < 4; ++i) record[9 + i] = static_cast<char>(h >> (8 * i));
}
std::uint32_t halfedge_of(const std::string& record) {
  std::uint32_t h = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    h |= static_cast<std::uint32_t>(static_cast<std::uint8_t>(record[9 + i])) << (8 * i);
  }
  return h;
}

TEST_F(Corruption, NothingDamagedIsAccepted) {
  for (std::size_t i = 0; i < specimens_->size(); ++i) {
    EXPECT_TRUE(judge("nothing", i, put_together((*specimens_)[i].parts)));
  }
  counts_.erase("nothing");
}

/// An event is there because a corner fails: without it, that corner does not last.
TEST_F(Corruption, DroppedRecords) {
  everywhere("dropped", [](LogParts& p, std::size_t k) {
    if (k >= p.records.size()) return false;
    p.records.erase(p.records.begin() + static_cast<std::ptrdiff_t>(k));
    return true;
  });
  EXPECT_EQ(counts_["dropped"].accepted, 0);
}

TEST_F(Corruption, RepeatedRecords) {
  everywhere("repeated", [](LogParts& p, std::size_t k) {
    if (k >= p.records.size()) return false;
    p.records.insert(p.records.begin() + static_cast<std::ptrdiff_t>(k), p.records[k]);
    return true;
  });
  EXPECT_EQ(counts_["repeated"].accepted, 0);
}

TEST_F(Corruption, SwappedRecords) {
  everywhere("swapped", [](LogParts& p, std::size_t k) {
    if (k + 1 >= p.records.size()) return false;
    std::string &a = p.records[k], &b = p.records[k + 1];
    // A time only tells where to look: two failures in a row of one corner that are closer than that are one log.
    const bool twice = is_event(a) && is_event(b) && a[0] == b[0] && halfedge_of(a) == halfedge_of(b);
    if (!twice || std::fabs(time_of(a) - time_of(b)) > 1e-12) std::swap(a, b);
    return true;
  });
  EXPECT_EQ(counts_["swapped"].accepted, 0);
}

/// Far beyond what an enclosure may be wide.
TEST_F(Corruption, ShiftedTimes) {
  for (const double by : {1e-9, -1e-9, 1e-3, -1e-3, 0.5, -0.5}) {
    everywhere("shifted", [by](LogParts& p, std::size_t k) {
      if (k >= p.records.size() || !is_event(p.records[k])) return false;
      set_time(p.records[k], time_of(p.records[k]) + by);
      return true;
    });
  }
  EXPECT_EQ(counts_["shifted"].accepted, 0);
}

TEST_F(Corruption, TimesThatAreNone) {
  for (const double t : std::initializer_list<double>{NAN, INFINITY, -INFINITY, 1e308, -1e308}) {
    everywhere("not a time", [t](LogParts& p, std::size_t k) {
      if (k >= p.records.size() || !is_event(p.records[k])) return false;
      set_time(p.records[k], t);
      return true;
    });
  }
  EXPECT_EQ(counts_["not a time"].accepted, 0);
}

/// The time of one event in another.
TEST_F(Corruption, TimesOfNeighbours) {
  everywhere("time of the next", [](LogParts& p, std::size_t k) {
    if (k + 1 >= p.records.size() || !is_event(p.records[k]) || !is_event(p.records[k + 1])) return false;
    set_time(p.records[k], time_of(p.records[k + 1]));
    return true;
  });
}

/// Another corner instead. It may be one of the same triangle: all three fail at once.
TEST_F(Corruption, OtherCorners) {
  Rng rng(3);
  for (int round = 0; round < 6; ++round) {
    everywhere("other corner", [&rng](LogParts& p, std::size_t k) {
      if (k >= p.records.size() || !is_event(p.records[k])) return false;
      const std::uint32_t h = halfedge_of(p.records[k]);
      const std::uint32_t others[] = {h ^ 1u, h + 2, h - 2, static_cast<std::uint32_t>(rng.below(200)), 0xffffffffu};
      set_halfedge(p.records[k], others[rng.below(5)]);
      return true;
    });
  }
}

TEST_F(Corruption, OtherKinds) {
  for (int kind = 0; kind < 12; ++kind) {
    everywhere("other kind", [kind](LogParts& p, std::size_t k) {
      if (k >= p.records.size() || !is_event(p.records[k])) return false;
      if (p.records[k][0] != static_cast<char>(kind)) {
        p.records[k][0] = static_cast<char>(kind);
      } else {
        p.records[k][0] = 99;
      }
      return true;
    });
  }
}

/// Cut off after any record, with an end that claims the rest.
TEST_F(Corruption, ExtendedBeyondWhatIsThere) {
  everywhere("claims the rest", [](LogParts& p, std::size_t k) {
    if (k + 1 >= p.records.size()) return false;
    p.records.resize(k);
    p.records.push_back(std::string(1, 6));  // Record::free
    return true;
  });
  EXPECT_EQ(counts_["claims the rest"].accepted, 0);
}

/// Beyond the contact: it is taken for a body passing through.
TEST_F(Corruption, ExtendedBeyondTheContact) {
  everywhere("beyond the contact", [](LogParts& p, std::size_t k) {
    const char last = p.records.back()[0];
    if (k > 3 || (last != 3 && last != 4)) return false;
    if (k == 0) p.records.back() = std::string(1, 6);
    if (k == 1) p.records.push_back(std::string(1, 6));
    if (k >= 2) {
      p.records.back()[0] = static_cast<char>(k - 1);
      p.records.push_back(std::string(1, 6));
    }
    return true;
  });
  EXPECT_EQ(counts_["beyond the contact"].accepted, 0);
}

TEST_F(Corruption, Truncated) {
  Rng rng(4);
  for (std::size_t i = 0; i < specimens_->size(); ++i) {
    const std::string log = put_together((*specimens_)[i].parts);
    for (int k = 0; k < 20; ++k) {
      const std::string part = log.substr(0, static_cast<std::size_t>(rng.below(static_cast<int>(log.size()) - 8)));
      judge("truncated", i, part);
      judge("truncated, sealed", i, sealed(part));
    }
  }
  EXPECT_EQ(counts_["truncated"].accepted, 0);
  EXPECT_EQ(counts_["truncated, sealed"].accepted, 0);
}

TEST_F(Corruption, SomethingAfterTheEnd) {
  for (std::size_t i = 0; i < specimens_->size(); ++i) {
    const std::string log = put_together((*specimens_)[i].parts);
    judge("longer", i, log + '\0');
    judge("longer", i, log + log);
  }
  EXPECT_EQ(counts_["longer"].accepted, 0);
}

/// The log of another scene, even with the fingerprint of this one.
TEST_F(Corruption, OtherScenes) {
  for (std::size_t i = 0; i < specimens_->size(); ++i) {
    for (std::size_t j = 0; j < specimens_->size(); j += 7) {
      if (i == j) continue;
      LogParts parts = (*specimens_)[j].parts;
      judge("other scene", i, put_together(parts));
      parts.header.replace(8, 32, (*specimens_)[i].parts.header, 8, 32);
      judge("other scene, same fingerprint", i, put_together(parts));
    }
  }
  EXPECT_EQ(counts_["other scene"].accepted, 0);
  EXPECT_EQ(counts_["other scene, same fingerprint"].accepted, 0);
}

/// Touch mode and shapes: a tiling around the outward shapes proves nothing about the inward ones, and so on.
TEST_F(Corruption, OtherClaims) {
  for (std::size_t i = 0; i < specimens_->size(); ++i) {
    const Specimen& of = (*specimens_)[i];
    const Touch other = of.touch == Touch::open ? Touch::closed : Touch::open;
    const Fingerprint id = scene_fingerprint(of.scene, other);
    for (int k = 0; k < 3; ++k) {
      LogParts parts = of.parts;
      if (k != 1) parts.header[40] ^= 1;
      if (k != 0) parts.header[41] ^= 1;
      if (k != 1) {
        EXPECT_FALSE(judge("other touch", i, put_together(parts)));
        std::copy(id.begin(), id.end(), parts.header.begin() + 8);
      }
      judge("other claim", i, put_together(parts));
    }
  }
}

/// Every bit of what follows the fingerprint; the checksum is made right, so that the meaning must be looked at.
TEST_F(Corruption, FlippedBits) {
  Rng rng(5);
  for (std::size_t i = 0; i < specimens_->size(); ++i) {
    const std::string log = put_together((*specimens_)[i].parts), bytes = log.substr(0, log.size() - 8);
    for (int k = 0; k < 120; ++k) {
      std::string damaged = bytes;
      const auto at = static_cast<std::size_t>(rng.below(static_cast<int>(bytes.size())));
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << rng.below(8)));
      judge("bit flip, sealed", i, sealed(damaged));
      if (k % 10 == 0) judge("bit flip", i, damaged + log.substr(log.size() - 8));
    }
  }
  EXPECT_EQ(counts_["bit flip"].accepted, 0);
}

}  // namespace
}  // namespace taut::testing
