// Exact logs by their definition: at sampled instants of every window, bodies that are posed by arithmetic of its own
// lie on the sides of the lines that the log says. The checker that is proved is not needed for that (./dev formal has
// it).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/effort.hpp"
#include "support/small_world.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
namespace {

using nlohmann::json;
using PosedEdge = std::array<Complex, 2>;

/// At its own coordinates.
bool rests(const MadeBody& body) {
  return std::all_of(body.keyframes.begin(), body.keyframes.end(), [](const Keyframe& k) {
    return k.x == 0 && k.y == 0 && std::fmod(k.angle_deg, 360) == 0 && k.by_deg == 0;
  });
}

/// The body and its parents that move, the outermost first.
std::vector<int> moving_chain(const MadeWorld& world, int body) {
  std::vector<int> chain;
  for (int k = body; k >= 0; k = world.bodies[static_cast<std::size_t>(k)].parent) {
    if (!rests(world.bodies[static_cast<std::size_t>(k)])) chain.insert(chain.begin(), k);
  }
  return chain;
}

bool turns(const MadeBody& body) {
  return std::any_of(body.keyframes.begin(), body.keyframes.end(),
                     [](const Keyframe& k) { return k.angle_deg != 0 || k.by_deg != 0; });
}

/// A pivot counts where something turns.
bool move_alike(const MadeBody& a, const MadeBody& b) {
  const auto same = [](const Keyframe& k, const Keyframe& l) {
    return k.t == l.t && k.x == l.x && k.y == l.y && k.angle_deg == l.angle_deg && k.way == l.way &&
           (k.way == Way::straight || (k.centre == l.centre && k.by_deg == l.by_deg));
  };
  return (a.pivot == b.pivot || !turns(a)) &&
         std::equal(a.keyframes.begin(), a.keyframes.end(), b.keyframes.begin(), b.keyframes.end(), same);
}

/// The last motion that two chains have in common, by a body that has it; -1 if there is none.
int last_common(const MadeWorld& world, int a, int b) {
  const std::vector<int> p = moving_chain(world, a), q = moving_chain(world, b);
  int common = -1;
  for (std::size_t k = 0; k < std::min(p.size(), q.size()); ++k) {
    if (!move_alike(world.bodies[static_cast<std::size_t>(p[k])], world.bodies[static_cast<std::size_t>(q[k])])) break;
    common = p[k];
  }
  return common;
}

/// Edges as they are written, seen from the last motion that both bodies follow.
std::vector<PosedEdge> seen_edges(const MadeWorld& world, int body, int from, double t) {
  const MadePose frame = from < 0 ? MadePose{} : pose_of(world, from, t);
  std::vector<PosedEdge> edges;
  for (const PartAtPose& part : posed(world, body, t)) {
    for (const RingAtPose& ring : part.rings) {
      for (std::size_t k = 0; k < ring.size(); ++k)
        edges.push_back({(ring[k] - frame.o) / frame.x, (ring[(k + 1) % ring.size()] - frame.o) / frame.x});
    }
  }
  return edges;
}

/// Walks through the steps of a window as docs/exact-logs.md defines them.
class WindowWalk {
 public:
  WindowWalk(const json& window, double t)
      : window_(window), h_(t - (window[0].get<double>() + window[1].get<double>()) / 2) {}

  void walk(const std::vector<PosedEdge>& p, const std::vector<PosedEdge>& q) {
    ranges(p.data(), p.data() + p.size(), q.data(), q.data() + q.size());
    EXPECT_EQ(at_, window_.size());
  }
  int wrong() const { return wrong_; }

 private:
  using Edges = const PosedEdge*;

  void ranges(Edges p, Edges p_end, Edges q, Edges q_end) {
    ASSERT_LT(at_, window_.size());
    const json& step = window_[at_++];
    if (step.is_array()) return line(step, p, p_end, q, q_end);
    const Edges p_half = p + (p_end - p) / 2, q_half = q + (q_end - q) / 2;
    if (step == 1) {
      ranges(p, p_half, q, q_end);
      ranges(p_half, p_end, q, q_end);
    } else {
      ASSERT_EQ(step, 2);
      ranges(p, p_end, q, q_half);
      ranges(p, p_end, q_half, q_end);
    }
  }

  void line(const json& step, Edges p, Edges p_end, Edges q, Edges q_end) {
    double level = 0;
    for (std::size_t k = step.size(); k-- > 2;) level = level * h_ + step[k].get<double>();
    const auto side = [&](const Complex& z) {
      return step[0].get<double>() * z.real() + step[1].get<double>() * z.imag() - level;
    };
    for (Edges e = p; e != p_end; ++e) wrong_ += !(side((*e)[0]) < 0 && side((*e)[1]) < 0);
    for (Edges e = q; e != q_end; ++e) wrong_ += !(side((*e)[0]) > 0 && side((*e)[1]) > 0);
  }

  const json& window_;
  double h_;
  std::size_t at_ = 2;
  int wrong_ = 0;
};

void expect_right_windows(const MadeWorld& world, const json& pair, double until) {
  const int a = pair["pair"][0], b = pair["pair"][1];
  const int common = last_common(world, a, b);
  double time = 0;
  for (const json& window : pair["windows"]) {
    const double from = window[0], to = window[1];
    EXPECT_EQ(from, time);
    time = to;
    // Not at its ends: where they are joints, other pieces may hold.
    for (const double share : {0.001, 0.5, 0.999}) {
      const double t = from + (to - from) * share;
      WindowWalk walk(window, t);
      walk.walk(seen_edges(world, a, common, t), seen_edges(world, b, common, t));
      EXPECT_EQ(walk.wrong(), 0) << "bodies " << a << " and " << b << " at " << t;
    }
  }
  EXPECT_EQ(time, until);
}

TEST(ExactLogs, LinesSeparateWhatTheySay) {
  int logs = 0, contacts = 0;
  for (std::uint64_t number = 1; number <= effort(4000); ++number) {
    SCOPED_TRACE(number);
    const MadeWorld world = small_world(number).world;
    const Scene scene = scene_of(world);
    CheckOptions options;
    options.touch = Touch::closed;
    const Answer known = check(scene, options);
    std::ostringstream text;
    const Answer answer = prove_exact(scene, text);
    if (text.str().empty()) continue;
    ++logs;
    const json log = json::parse(text.str());
    const double until = log["until"];
    EXPECT_EQ(answer.outcome, known.outcome);
    EXPECT_EQ(log["format"], "taut-exact/1");
    if (known.outcome == Outcome::free) {
      EXPECT_EQ(until, scene.end);
    }
    if (known.contact) {
      ++contacts;
      EXPECT_LE(until, known.contact->time.lo);
      EXPECT_EQ(answer.free_until, until);
    }
    EXPECT_GE(log["pairs"].size(), known.coverage.tested + known.coverage.apart);
    for (const json& pair : log["pairs"]) expect_right_windows(world, pair, until);
  }
  EXPECT_GT(logs, contacts);
  EXPECT_GT(contacts, 0);
}

const char* const squares = R"({"format": "taut-scene/1", "time": [0, 1], "bodies": [
  {"name": "a", "polygon": [[0, 0], [1, 0], [1, 1], [0, 1]]},
  {"name": "b", "polygon": [[0, 0], [1, 0], [1, 1], [0, 1]], "motion": {"x": [X], "y": [0, 0.5]}}]})";

Scene squares_at(const std::string& x) {
  std::string text = squares;
  text.replace(text.find('X'), 1, x);
  return parse_scene(text);
}

TEST(ExactLogs, BodiesThatTouchHaveNone) {
  std::ostringstream log;
  EXPECT_EQ(prove_exact(squares_at("1"), log).outcome, Outcome::contact);
  EXPECT_EQ(log.str(), "");
  EXPECT_EQ(prove_exact(squares_at("1.25"), log).outcome, Outcome::free);
  EXPECT_EQ(json::parse(log.str())["pairs"].size(), 1u);
}

TEST(ExactLogs, WhatIsNotCoveredIsRefusedByName) {
  Scene scene = squares_at("3");
  scene.bodies[0].curves.push_back({{{0, 0}, {ArcTo{1, 1, 0, false, true, {1, 1}}, LineTo{{0, 1}}}}, {}, {}});
  scene.bodies[0].polygon.clear();
  std::ostringstream log;
  try {
    prove_exact(scene, log);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(error.problem().find("curves"), std::string::npos);
  }
  EXPECT_EQ(log.str(), "");
}

}  // namespace
}  // namespace taut::testing
