#include "path/conditions.hpp"

#include <algorithm>
#include <cmath>

namespace taut::internal::path {
namespace {

constexpr std::size_t joints = max_joints;
constexpr std::size_t rows = joints + 1;
constexpr int most_steps = 60;

/// The least weighted sum that conditions can have at its largest over the cell: minimise sum w_i c_i + sum (u_k + v_k)
/// with sum w_i = 1 and sum w_i a_ik = u_k - v_k for each joint k, by the simplex method. Where it ends, the prices of
/// the rows are the values at which the least condition is largest.
class Simplex {
 public:
  explicit Simplex(const std::vector<Condition>& conditions) : count_(std::min(conditions.size(), most_conditions)) {
    for (std::size_t i = 0; i < count_; ++i) {
      Column c{conditions[i].constant, {}};
      c.row[joints] = 1;
      for (std::size_t k = 0; k < joints; ++k) c.row[k] = conditions[i].rate[k];
      columns_.push_back(c);
    }
    for (std::size_t k = 0; k < joints; ++k) {
      for (const double sign : {-1.0, 1.0}) {
        Column c{1, {}};
        c.row[k] = sign;
        columns_.push_back(c);
      }
    }
    begin();
    for (int step = 0; step < most_steps && improve(); ++step) {
    }
  }

  std::vector<double> weights() const {
    std::vector<double> w(count_, 0);
    for (std::size_t r = 0; r < rows; ++r) {
      if (basis_[r] < count_) w[basis_[r]] = std::max(0.0, level_[r]);
    }
    return w;
  }
  /// The price of a joint's row: minus the value.
  double price(std::size_t k) const {
    double y = 0;
    for (std::size_t r = 0; r < rows; ++r) y += columns_[basis_[r]].cost * inverse_[r][k];
    return y;
  }

 private:
  struct Column {
    double cost = 0;
    std::array<double, rows> row{};
  };
  using Row = std::array<double, rows>;

  /// The first condition alone, and for each joint the one of u and v that is not negative.
  void begin() {
    basis_[joints] = 0;
    inverse_[joints][joints] = 1;
    level_[joints] = 1;
    for (std::size_t k = 0; k < joints; ++k) {
      const double a = columns_[0].row[k], sign = a > 0 ? -1 : 1;
      basis_[k] = count_ + 2 * k + (sign > 0 ? 1 : 0);
      inverse_[k][k] = sign;
      inverse_[k][joints] = -sign * a;
      level_[k] = std::fabs(a);
    }
  }
  /// One step; false at the end.
  bool improve() {
    Row prices{};
    for (std::size_t k = 0; k < rows; ++k) prices[k] = price(k);
    double least = -1e-13;
    std::size_t entering = columns_.size();
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      double reduced = columns_[c].cost;
      for (std::size_t k = 0; k < rows; ++k) reduced -= prices[k] * columns_[c].row[k];
      if (reduced >= least) continue;
      least = reduced;
      entering = c;
    }
    return entering < columns_.size() && enter(entering);
  }
  bool enter(std::size_t entering) {
    Row along{};
    std::size_t leaving = rows;
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t k = 0; k < rows; ++k) along[r] += inverse_[r][k] * columns_[entering].row[k];
      if (along[r] <= 1e-12) continue;
      if (leaving == rows || level_[r] * along[leaving] < level_[leaving] * along[r]) leaving = r;
    }
    if (leaving == rows) return false;
    const double pivot = along[leaving], step = level_[leaving] / pivot;
    for (std::size_t r = 0; r < rows; ++r) {
      if (r == leaving) continue;
      level_[r] -= step * along[r];
      for (std::size_t k = 0; k < rows; ++k) inverse_[r][k] -= along[r] / pivot * inverse_[leaving][k];
    }
    level_[leaving] = step;
    for (double& x : inverse_[leaving]) x /= pivot;
    basis_[leaving] = entering;
    return true;
  }

  std::size_t count_;
  std::vector<Column> columns_;
  std::array<std::size_t, rows> basis_{};
  std::array<Row, rows> inverse_{};
  Row level_{};
};

/// Certainly no less than the weighted sum anywhere in the cell.
double largest_sum(const std::vector<Condition>& conditions, const std::vector<double>& weights) {
  double sum = 0, magnitude = 0;
  std::array<double, joints> rate{};
  for (std::size_t i = 0; i < weights.size(); ++i) {
    sum += weights[i] * conditions[i].constant;
    magnitude += weights[i] * std::fabs(conditions[i].constant);
    for (std::size_t k = 0; k < joints; ++k) {
      rate[k] += weights[i] * conditions[i].rate[k];
      magnitude += weights[i] * std::fabs(conditions[i].rate[k]);
    }
  }
  for (const double r : rate) sum += std::fabs(r);
  return sum + 0x1p-45 * magnitude;
}

}  // namespace

JointConditions decide(const std::vector<Condition>& conditions) {
  JointConditions found;
  if (conditions.empty()) return found;
  const Simplex simplex(conditions);
  found.weights = simplex.weights();
  found.exclude_each_other = largest_sum(conditions, found.weights) < 0;
  for (std::size_t k = 0; k < joints; ++k) {
    const bool matters =
        std::any_of(conditions.begin(), conditions.end(), [k](const Condition& c) { return c.rate[k] != 0; });
    found.best[k] = matters ? std::clamp(-simplex.price(k), -1.0, 1.0) : 0;
  }
  return found;
}

}  // namespace taut::internal::path
