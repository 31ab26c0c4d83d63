// The queue of failure times: against a plain list of the same certificates.
#include "kinetic/event_queue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "support/rng.hpp"

namespace taut::testing {
using namespace internal;
namespace {

struct QueueSetting {
  std::vector<Certificate> certificates;
  std::vector<PreciseTime> pool;
  EventQueue queue{certificates, pool};
  std::vector<bool> inside;

  explicit QueueSetting(std::size_t count) {
    certificates.resize(count);
    inside.assign(count, false);
    for (std::size_t i = 0; i < count; ++i) pool.push_back(PreciseTime::between(0, 0));
  }
  /// A time out of few, so that many are the same double; half of them with an enclosure that may begin later.
  void change(Rng& rng, std::uint32_t i) {
    Certificate& c = certificates[i];
    c.lo = rng.below(20) == 0 ? never : rng.between(-3, static_cast<int>(certificates.size()) / 4);
    if (c.lo == 0 && rng.below(2)) c.lo = -0.0;
    c.precise = -1;
    if (c.lo != never && rng.below(2)) {
      c.precise = static_cast<std::int32_t>(i);
      ExactSum<2> from;
      from.add(c.lo);
      from.add((1 + rng.below(5)) * 0x1p-80);
      pool[i] = PreciseTime(ShortSum::of(from), ShortSum(c.lo + 1), Stage::precise);
    }
    queue.update(CertificateId(i));
    inside[i] = c.lo != never;
  }
  bool earlier(std::size_t a, std::size_t b) const {
    const Certificate &x = certificates[a], &y = certificates[b];
    if (x.lo != y.lo) return x.lo < y.lo;
    if (y.precise < 0) return false;
    return x.precise < 0 ||
           pool[static_cast<std::size_t>(x.precise)].begins_before(pool[static_cast<std::size_t>(y.precise)]);
  }
  std::set<std::uint32_t> up_to(double until) const {
    std::set<std::uint32_t> ids;
    for (std::uint32_t i = 0; i < inside.size(); ++i) {
      if (inside[i] && certificates[i].lo <= until) ids.insert(i);
    }
    return ids;
  }
};

void expect_right(const QueueSetting& s, Rng& rng) {
  const std::set<std::uint32_t> all = s.up_to(never);
  ASSERT_EQ(s.queue.empty(), all.empty());
  if (all.empty()) return;
  const std::uint32_t top = s.queue.top().value;
  ASSERT_TRUE(all.count(top));
  for (const std::uint32_t i : all) EXPECT_FALSE(s.earlier(i, top));

  const double until = s.certificates[top].lo + rng.below(4);
  std::set<std::uint32_t> rivals = s.up_to(until), seen;
  rivals.erase(top);
  s.queue.visit_rivals(until, [&](CertificateId id) {
    EXPECT_TRUE(seen.insert(id.value).second);
    return EventQueue::Visit::on;
  });
  EXPECT_EQ(seen, rivals);

  // What lies past one that is waved through is no earlier than it.
  std::set<std::uint32_t> met, waved;
  s.queue.visit_rivals(until, [&](CertificateId id) {
    met.insert(id.value);
    if (rng.below(2)) return EventQueue::Visit::on;
    waved.insert(id.value);
    return EventQueue::Visit::past;
  });
  for (const std::uint32_t i : rivals) {
    if (met.count(i)) continue;
    EXPECT_TRUE(std::any_of(waved.begin(), waved.end(), [&](std::uint32_t w) { return !s.earlier(i, w); }));
  }
  if (rivals.empty()) return;
  int calls = 0;
  s.queue.visit_rivals(until, [&](CertificateId) {
    ++calls;
    return EventQueue::Visit::stop;
  });
  EXPECT_EQ(calls, 1);
}

TEST(EventQueue, AgreesWithAList) {
  for (const int count : {1, 2, 3, 7, 64, 100, 515}) {
    Rng rng(static_cast<std::uint64_t>(count));
    QueueSetting s(static_cast<std::size_t>(count));
    EXPECT_TRUE(s.queue.empty());
    for (int round = 0; round < 2000; ++round) {
      // Numbers grow with the rounds, so that the tree does, too.
      const auto i = static_cast<std::uint32_t>(rng.below(1 + count * round / 2000));
      switch (rng.below(8)) {
        case 0:
          s.queue.remove(CertificateId(i));
          s.inside[i] = false;
          break;
        case 1:
          if (rng.below(50) == 0) {
            s.queue.clear();
            s.inside.assign(s.inside.size(), false);
          }
          break;
        case 2:
          if (rng.below(50) == 0) s.queue.reserve(static_cast<std::size_t>(rng.below(2 * count)));
          break;
        default:
          s.change(rng, i);
      }
      if (round % 4 == 0) expect_right(s, rng);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(EventQueue, PopsInOrder) {
  Rng rng(7);
  QueueSetting s(1000);
  for (std::uint32_t i = 0; i < 1000; ++i) s.change(rng, i);
  std::uint32_t before = s.queue.top().value;
  while (!s.queue.empty()) {
    const std::uint32_t id = s.queue.top().value;
    EXPECT_FALSE(s.earlier(id, before));
    before = id;
    s.queue.remove(CertificateId(id));
    s.inside[id] = false;
  }
  EXPECT_TRUE(s.up_to(never).empty());
}

}  // namespace
}  // namespace taut::testing
