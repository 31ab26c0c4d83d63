// Mechanisms of any kind against Newton's method in small steps, on equations of their own: three coordinates for each
// body, and what each joint demands of two of them. Shares nothing with src/ but what is judged.
#include <gtest/gtest.h>

#include <map>
#include <optional>

#include "motion/joint_functions.hpp"
#include "motion/pose.hpp"
#include "support/closed_linkage.hpp"
#include "support/effort.hpp"
#include "support/sum_of_doubles.hpp"
#include "taut/error.hpp"

namespace taut::testing {
using namespace internal;
namespace {

using Digits =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<256, boost::multiprecision::digit_base_2>,
                                  boost::multiprecision::et_off>;

/// Where a body is: its drawn origin, and by how much it has turned, in radians.
struct BodyPlace {
  Digits x = 0, y = 0, angle = 0;
};

class Continuation {
 public:
  explicit Continuation(const Scene& scene) : mechanism_(*scene.mechanism), at_(scene.bodies.size()) {
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) number_[scene.bodies[k].name] = k;
    ground_ = number_.at(mechanism_.ground);
    const auto& line = *mechanism_.drives[0].pieces[0].line;
    speed_ = Digits(line[3]) * boost::multiprecision::acos(Digits(-1)) / 180;
  }

  /// Goes on to time t. Returns false if it cannot: where steps become short.
  bool go_to(const Digits& t) {
    while (t_ < t) {
      const Digits next = t - t_ < step_ ? t : Digits(t_ + step_);
      std::vector<BodyPlace> there = at_;
      if (solve(there, next)) {
        at_ = there;
        t_ = next;
        if (step_ < Digits(1) / 512) step_ *= 2;
      } else {
        step_ /= 2;
        if (step_ < Digits(1e-12)) return false;
      }
    }
    return true;
  }
  const Digits& time() const { return t_; }
  std::array<Digits, 2> place(int body, const Point& p) const {
    const BodyPlace& at = at_[static_cast<std::size_t>(body)];
    const Digits c = cos(at.angle), s = sin(at.angle);
    return {at.x + c * p.x - s * p.y, at.y + s * p.x + c * p.y};
  }

 private:
  using Row = std::vector<Digits>;

  /// Newton's method; the steps must be small at once, so that the branch stays the same.
  bool solve(std::vector<BodyPlace>& at, const Digits& t) const {
    for (int k = 0; k < 12; ++k) {
      std::vector<Row> rows = equations(at, t);
      if (rows.empty() || !eliminate(rows)) return false;
      Digits largest = 0;
      const std::size_t n = rows.size();
      for (std::size_t i = 0; i < n; ++i) {
        const Digits& change = rows[i][n];
        BodyPlace& body = at[i / 3 < ground_ ? i / 3 : i / 3 + 1];
        (i % 3 == 0 ? body.x : i % 3 == 1 ? body.y : body.angle) -= change;
        // Coordinates are about ten times as large as angles.
        largest = std::max(largest, Digits(abs(change) / (i % 3 == 2 ? 1 : 10)));
      }
      if (largest < Digits(1e-65)) return true;
      if (largest > Digits(k == 0 ? 0.02 : 0.002)) return false;
    }
    return false;
  }

  /// The derivatives, and the value at the end of each row.
  std::vector<Row> equations(const std::vector<BodyPlace>& at, const Digits& t) const {
    const std::size_t n = 3 * (at.size() - 1);
    std::vector<Row> rows;
    const auto row = [&](const Digits& value) -> Row& {
      rows.emplace_back(n + 1);
      rows.back()[n] = value;
      return rows.back();
    };
    const auto add = [&](Row& to, std::size_t body, int coordinate, const Digits& x) {
      if (body != ground_) to[3 * (body < ground_ ? body : body - 1) + static_cast<std::size_t>(coordinate)] += x;
    };
    for (const MechanismJoint& joint : mechanism_.joints) {
      const std::size_t a = number_.at(joint.first), b = number_.at(joint.second);
      const Digits ca = cos(at[a].angle), sa = sin(at[a].angle), cb = cos(at[b].angle), sb = sin(at[b].angle);
      const Digits ax = ca * joint.at.x - sa * joint.at.y, ay = sa * joint.at.x + ca * joint.at.y;
      const Digits bx = cb * joint.at.x - sb * joint.at.y, by = sb * joint.at.x + cb * joint.at.y;
      const Digits dx = at[b].x + bx - at[a].x - ax, dy = at[b].y + by - at[a].y - ay;
      if (joint.kind == MechanismJoint::Kind::revolute) {
        Row& x = row(dx);
        add(x, b, 0, 1), add(x, a, 0, -1), add(x, b, 2, -by), add(x, a, 2, ay);
        Row& y = row(dy);
        add(y, b, 1, 1), add(y, a, 1, -1), add(y, b, 2, bx), add(y, a, 2, -ax);
      } else {
        // The points at `at` of both bodies are on a line along the direction, as the first body has it.
        const Digits ex = ca * joint.direction.x - sa * joint.direction.y;
        const Digits ey = sa * joint.direction.x + ca * joint.direction.y;
        Row& across = row(ex * dy - ey * dx);
        add(across, b, 1, ex), add(across, a, 1, -ex), add(across, b, 0, -ey), add(across, a, 0, ey);
        add(across, b, 2, ex * bx + ey * by), add(across, a, 2, -(ex * ax + ey * ay));
        add(across, a, 2, -ey * dy - ex * dx);
        Row& turn = row(at[b].angle - at[a].angle);
        add(turn, b, 2, 1), add(turn, a, 2, -1);
      }
      if (joint.name != mechanism_.drives[0].joint) continue;
      Row& drive = row(at[b].angle - at[a].angle - speed_ * t);
      add(drive, b, 2, 1), add(drive, a, 2, -1);
    }
    return rows.size() == n ? rows : std::vector<Row>{};
  }

  static bool eliminate(std::vector<Row>& rows) {
    const std::size_t n = rows.size();
    for (std::size_t k = 0; k < n; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k; i < n; ++i) {
        if (abs(rows[i][k]) > abs(rows[pivot][k])) pivot = i;
      }
      if (rows[pivot][k] == 0) return false;
      std::swap(rows[k], rows[pivot]);
      const Digits inverse = 1 / rows[k][k];
      for (Digits& x : rows[k]) x *= inverse;
      for (std::size_t i = 0; i < n; ++i) {
        if (i == k || rows[i][k] == 0) continue;
        const Digits factor = rows[i][k];
        for (std::size_t j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
      }
    }
    return true;
  }

  const Mechanism& mechanism_;
  std::map<std::string, std::size_t> number_;
  std::size_t ground_ = 0;
  Digits speed_, t_ = 0, step_ = Digits(1) / 512;
  std::vector<BodyPlace> at_;
};

/// A linkage of dyads, driven at another joint: then it is none of dyads, as a rule.
std::optional<Scene> driven_elsewhere(Rng& rng, const ClosedLinkage& linkage) {
  Scene scene = linkage.scene();
  std::vector<std::string> names;
  for (const MechanismJoint& joint : scene.mechanism->joints) {
    if (joint.kind == MechanismJoint::Kind::revolute) names.push_back(joint.name);
  }
  taut::Drive& drive = scene.mechanism->drives[0];
  drive.joint = rng.pick(names);
  (*drive.pieces[0].line)[3] = rng.sign() * rng.real(5, 120);
  try {
    return assembled(scene);
  } catch (const InputError&) {
    // Near a dead point in the drawn pose.
    return std::nullopt;
  }
}

class JudgedByContinuation {
 public:
  JudgedByContinuation(const ClosedLinkage& linkage, const Scene& scene)
      : linkage_(linkage), scene_(scene), oracle_(scene) {}

  /// Returns false if the oracle does not come so far.
  bool at(double t) {
    if (!oracle_.go_to(Digits(t))) return false;
    const std::vector<double> none;
    for (const ClosedLinkage::Marker& marker : linkage_.markers()) {
      const auto expected = oracle_.place(marker.body, marker.at);
      compare<double>(marker, t, expected);
      compare<Real320>(marker, t, expected);
    }
    return true;
  }
  const Continuation& oracle() const { return oracle_; }

 private:
  template <class Real>
  void compare(const ClosedLinkage::Marker& marker, double t, const std::array<Digits, 2>& expected) const {
    const auto found =
        placed_point(pose_of<Jet<Real>>(chain(marker.body), Ball<Real>::exact(t)), LocalPoint(marker.at, {0, 0}));
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_LE(abs(sum_of_doubles<Digits>(found[i].v.mid) - expected[i]), Digits(found[i].v.rad) + Digits(1e-60))
          << t << " body " << marker.body;
    }
  }

  PieceChain chain(int body) const {
    PieceChain pieces;
    for (const Body* b = &scene_.bodies[static_cast<std::size_t>(body)];;) {
      if (!b->motion.pieces.empty()) pieces.insert(pieces.begin(), b->motion.pieces.front());
      if (b->relative_to.empty()) break;
      b = &*std::find_if(scene_.bodies.begin(), scene_.bodies.end(),
                         [&](const Body& other) { return other.name == b->relative_to; });
    }
    if (pieces.empty()) pieces.push_back(MotionPiece{});
    return pieces;
  }

  const ClosedLinkage& linkage_;
  const Scene& scene_;
  Continuation oracle_;
};

TEST(MechanismContinuation, AgreesWithSmallSteps) {
  int locks = 0, turns = 0;
  for (std::uint64_t seed = 0; seed < effort(60); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const ClosedLinkage linkage(rng, rng.between(2, 3));
    const auto scene = driven_elsewhere(rng, linkage);
    if (!scene || (scene->lock && scene->lock->kind == MechanismLock::Kind::undecided)) continue;
    JudgedByContinuation judged(linkage, *scene);
    const double end = scene->lock ? scene->end * (1 - 1e-5) : scene->end;
    for (const double share : {rng.real(0, 0.5), rng.real(0.5, 1), 1.0})
      EXPECT_TRUE(judged.at(end * share)) << "stuck at " << static_cast<double>(judged.oracle().time());
    if (scene->lock) {
      // There is no way beyond the lock.
      ++locks;
      EXPECT_FALSE(judged.at(scene->lock->time[1] * (1 + 1e-9)));
      EXPECT_NEAR(static_cast<double>(judged.oracle().time()), scene->lock->time[0], 1e-4 * scene->lock->time[0]);
    } else {
      ++turns;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(locks, static_cast<int>(enough(10)));
  EXPECT_GT(turns, static_cast<int>(enough(5)));
}

}  // namespace
}  // namespace taut::testing
