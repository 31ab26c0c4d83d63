// The tree of a mechanism's joints, and its mobility.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "geometry/predicates.hpp"
#include "scene/mechanism.hpp"
#include "scene/names.hpp"
#include "taut/error.hpp"

namespace taut::internal {

std::string joint_place(const MechanismJoint& joint) { return "mechanism: joint " + joint.name; }

namespace {

/// Which bodies hang together by the joints so far.
class JoinedBodies {
 public:
  explicit JoinedBodies(std::size_t n) : up_(n) { std::iota(up_.begin(), up_.end(), 0); }
  int of(int i) {
    while (up_[static_cast<std::size_t>(i)] != i)
      i = up_[static_cast<std::size_t>(i)] = up_[static_cast<std::size_t>(up_[static_cast<std::size_t>(i)])];
    return i;
  }
  /// False if they hung together already.
  bool join(int a, int b) {
    a = of(a);
    b = of(b);
    up_[static_cast<std::size_t>(a)] = b;
    return a != b;
  }

 private:
  std::vector<int> up_;
};

class TreeBuilder {
 public:
  explicit TreeBuilder(const Scene& scene) : scene_(scene), mechanism_(*scene.mechanism) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) names_.emplace(scene.bodies[i].name, static_cast<int>(i));
    ground_ = body_named(mechanism_.ground, "mechanism: ground");
    for (const MechanismJoint& joint : mechanism_.joints) {
      ends_.push_back({body_named(joint.first, joint_place(joint)), body_named(joint.second, joint_place(joint))});
      if (joint.first == joint.second)
        throw InputError(joint_place(joint), "it joins \"" + joint.first + "\" to itself", "name two bodies");
      require_usual_size(joint);
      if (joint.kind == MechanismJoint::Kind::slide && joint.direction == Point{})
        throw InputError(joint_place(joint), "its direction has no length", "write the direction in which it slides");
    }
  }

  JointTree build() {
    std::vector<bool> in_tree = chosen();
    JointTree tree;
    tree.link_of_body.assign(scene_.bodies.size(), -1);
    std::vector<bool> reached(scene_.bodies.size());
    reached[static_cast<std::size_t>(ground_)] = true;
    for (std::vector<int> front{ground_}; !front.empty();) {
      std::vector<int> next;
      for (const int body : front) grow(body, in_tree, reached, tree, next);
      front = std::move(next);
    }
    for (std::size_t k = 0; k < ends_.size(); ++k) {
      for (const int body : ends_[k]) require_reached(reached, k, body);
      if (!in_tree[k]) tree.closures.push_back(static_cast<int>(k));
    }
    require_free_links(reached);
    return tree;
  }

 private:
  int body_named(const std::string& name, const std::string& place) const {
    const auto found = names_.find(name);
    if (found != names_.end()) return found->second;
    throw no_such_body(names_of(scene_.bodies), name, place, "", "write the name of a body of the scene");
  }

  /// As for coordinates of outlines.
  static void require_usual_size(const MechanismJoint& joint) {
    for (const double x : {joint.at.x, joint.at.y, joint.direction.x, joint.direction.y}) {
      if (in_range(x)) continue;
      throw InputError(joint_place(joint), "it has a number that is not 0 or of magnitude between 2^-400 and 2^400",
                       "choose another unit of length");
    }
  }

  /// Driven and coupled joints are in the tree if possible, since their values are known; then slides, along which
  /// bodies fit exactly; then joints near the ground, so that chains are short.
  std::vector<bool> chosen() const {
    std::set<std::string> known;
    for (const Drive& drive : mechanism_.drives) known.insert(drive.joint);
    for (const Coupling& coupling : mechanism_.couplings) known.insert({coupling.joint, coupling.to});
    const std::vector<int> depth = depths();
    std::vector<std::array<int, 3>> order;
    for (std::size_t k = 0; k < ends_.size(); ++k) {
      const MechanismJoint& joint = mechanism_.joints[k];
      const int kind = known.count(joint.name) ? 0 : joint.kind == MechanismJoint::Kind::slide ? 1 : 2;
      const auto depth_of = [&](int body) { return depth[static_cast<std::size_t>(body)]; };
      order.push_back(
          {kind, kind < 2 ? 0 : std::min(depth_of(ends_[k][0]), depth_of(ends_[k][1])), static_cast<int>(k)});
    }
    std::sort(order.begin(), order.end());
    std::vector<bool> in_tree(ends_.size());
    JoinedBodies components(scene_.bodies.size());
    for (const auto& [kind, distance, k] : order) {
      const auto& [a, b] = ends_[static_cast<std::size_t>(k)];
      in_tree[static_cast<std::size_t>(k)] = components.join(a, b);
    }
    return in_tree;
  }

  std::vector<int> depths() const {
    const int far = static_cast<int>(scene_.bodies.size());
    std::vector<int> depth(scene_.bodies.size(), far);
    depth[static_cast<std::size_t>(ground_)] = 0;
    for (bool changed = true; changed;) {
      changed = false;
      for (const auto& [a, b] : ends_) {
        int& x = depth[static_cast<std::size_t>(a)];
        int& y = depth[static_cast<std::size_t>(b)];
        const int nearer = std::min({x, y, far - 1}) + 1;
        changed = changed || x > nearer || y > nearer;
        x = std::min(x, nearer);
        y = std::min(y, nearer);
      }
    }
    return depth;
  }

  void grow(int body, const std::vector<bool>& in_tree, std::vector<bool>& reached, JointTree& tree,
            std::vector<int>& next) const {
    for (std::size_t k = 0; k < ends_.size(); ++k) {
      if (!in_tree[k] || (ends_[k][0] != body && ends_[k][1] != body)) continue;
      const bool reversed = ends_[k][1] == body;
      const int other = reversed ? ends_[k][0] : ends_[k][1];
      if (reached[static_cast<std::size_t>(other)]) continue;
      reached[static_cast<std::size_t>(other)] = true;
      tree.link_of_body[static_cast<std::size_t>(other)] = static_cast<int>(tree.links.size());
      tree.links.push_back({other, tree.link_of_body[static_cast<std::size_t>(body)], static_cast<int>(k), reversed});
      next.push_back(other);
    }
  }

  void require_reached(const std::vector<bool>& reached, std::size_t joint, int body) const {
    if (reached[static_cast<std::size_t>(body)]) return;
    throw InputError(joint_place(mechanism_.joints[joint]),
                     "the body \"" + scene_.bodies[static_cast<std::size_t>(body)].name +
                         "\" does not hang together with the ground \"" + mechanism_.ground + "\"",
                     "add the joint that holds it");
  }

  void require_free_links(const std::vector<bool>& reached) const {
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const Body& body = scene_.bodies[i];
      if (!reached[i] || (body.motion.pieces.empty() && body.relative_to.empty())) continue;
      const std::string role =
          static_cast<int>(i) == ground_ ? "the ground of the mechanism" : "a link of the mechanism";
      throw InputError(
          body.name,
          "it is " + role + " and has " + (body.relative_to.empty() ? "a motion" : "a `relative_to`") + " of its own",
          "the joints say how links move, and the ground rests: leave it out");
    }
  }

  const Scene& scene_;
  const Mechanism& mechanism_;
  std::map<std::string, int> names_;
  int ground_ = 0;
  std::vector<std::array<int, 2>> ends_;
};

/// Arithmetic modulo the prime 2^61 - 1. A matrix of doubles has full rank if it has so modulo a prime, and the rank is
/// seldom less there.
class Residue {
 public:
  static constexpr std::uint64_t prime = (std::uint64_t{1} << 61) - 1;
  Residue() = default;
  explicit Residue(double x) {
    int exponent = 0;
    const double mantissa = std::ldexp(std::frexp(std::fabs(x), &exponent), 53);
    value_ = static_cast<std::uint64_t>(mantissa);
    exponent = ((exponent - 53) % 61 + 61) % 61;  // 2^61 is 1
    *this = *this * of(std::uint64_t{1} << exponent);
    if (x < 0) *this = Residue() - *this;
  }
  bool is_zero() const { return value_ == 0; }
  friend Residue operator-(Residue a, Residue b) { return of((a.value_ + (prime - b.value_)) % prime); }
  friend Residue operator*(Residue a, Residue b) {
    __extension__ using Wide = unsigned __int128;
    return of(static_cast<std::uint64_t>(static_cast<Wide>(a.value_) * b.value_ % prime));
  }
  Residue inverse() const {
    Residue result = of(1), base = *this;
    for (std::uint64_t e = prime - 2; e > 0; e >>= 1) {
      if (e & 1) result = result * base;
      base = base * base;
    }
    return result;
  }

 private:
  static Residue of(std::uint64_t value) {
    Residue r;
    r.value_ = value;
    return r;
  }
  std::uint64_t value_ = 0;
};

using Row = std::vector<Residue>;

/// Rows in echelon form.
class Rows {
 public:
  bool add(Row row) {
    for (const auto& [lead, known] : rows_) {
      if (row[lead].is_zero()) continue;
      const Residue share = row[lead];
      for (std::size_t i = 0; i < row.size(); ++i) row[i] = row[i] - known[i] * share;
    }
    const auto lead = std::find_if(row.begin(), row.end(), [](const Residue& r) { return !r.is_zero(); });
    if (lead == row.end()) return false;
    const auto place = static_cast<std::size_t>(lead - row.begin());
    const Residue share = lead->inverse();
    for (Residue& r : row) r = r * share;
    rows_.emplace_back(place, std::move(row));
    return true;
  }

 private:
  std::vector<std::pair<std::size_t, Row>> rows_;
};

}  // namespace

JointTree joint_tree(const Scene& scene) { return TreeBuilder(scene).build(); }

/// Each joint that closes a loop must move its second body, against the first, as the joints on the two paths do:
/// by a rotation and the velocity of the origin.
Mobility mobility_of(const Mechanism& mechanism, const JointTree& tree) {
  Mobility out;
  out.loops = static_cast<int>(tree.closures.size());
  Rows rows;
  const std::size_t n = mechanism.joints.size();
  std::map<std::string, int> links;
  for (std::size_t k = 0; k < tree.links.size(); ++k) {
    const JointTree::Link& link = tree.links[k];
    const MechanismJoint& joint = mechanism.joints[static_cast<std::size_t>(link.joint)];
    links[link.reversed ? joint.first : joint.second] = static_cast<int>(k);
  }
  const auto link_of = [&](const std::string& body) {
    const auto found = links.find(body);
    return found == links.end() ? -1 : found->second;
  };
  for (const int closing : tree.closures) {
    std::array<Row, 3> constraint{Row(n), Row(n), Row(n)};
    const auto add = [&](int k, double sign) {
      const MechanismJoint& joint = mechanism.joints[static_cast<std::size_t>(k)];
      const bool slides = joint.kind == MechanismJoint::Kind::slide;
      const std::array<double, 3> twist = slides ? std::array<double, 3>{0, joint.direction.x, joint.direction.y}
                                                 : std::array<double, 3>{1, joint.at.y, -joint.at.x};
      for (std::size_t i = 0; i < 3; ++i)
        constraint[i][static_cast<std::size_t>(k)] =
            constraint[i][static_cast<std::size_t>(k)] - Residue(-sign * twist[i]);
    };
    const auto add_path = [&](const std::string& body, double sign) {
      for (int link = link_of(body); link >= 0; link = tree.links[static_cast<std::size_t>(link)].parent) {
        const JointTree::Link& on_path = tree.links[static_cast<std::size_t>(link)];
        add(on_path.joint, on_path.reversed ? -sign : sign);
      }
    };
    const MechanismJoint& joint = mechanism.joints[static_cast<std::size_t>(closing)];
    add_path(joint.second, 1);
    add_path(joint.first, -1);
    add(closing, -1);
    for (Row& row : constraint) {
      const bool independent = rows.add(std::move(row));
      out.rank += independent;
      if (!independent && out.redundant < 0) out.redundant = closing;
    }
  }
  out.mobility = static_cast<int>(n) - out.rank - static_cast<int>(mechanism.couplings.size());
  return out;
}

}  // namespace taut::internal
