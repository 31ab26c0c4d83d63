#include "proof/mechanism_cells.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <variant>
#include <vector>

#include "numeric/budget.hpp"

namespace taut::internal::proof {
namespace {

enum class CellKind : std::uint8_t { polynomials, before_dead_point };

void write_cell(ByteWriter& out, const LoopCell& cell) {
  out.u8(static_cast<std::uint8_t>(cell.box ? CellKind::before_dead_point : CellKind::polynomials));
  out.f64(cell.to);
  if (cell.box) {
    out.u32(static_cast<std::uint32_t>(cell.box->parameter));
    for (const auto& [lo, hi] : cell.box->ranges) {
      out.f64(lo);
      out.f64(hi);
    }
    return;
  }
  for (const LoopCell::Coefficients& c : cell.c) {
    std::size_t terms = c.size();
    while (terms > 0 && c[terms - 1] == 0) --terms;
    out.u8(static_cast<std::uint8_t>(terms));
    for (std::size_t k = 0; k < terms; ++k) out.f64(c[k]);
  }
}

class CellReader {
 public:
  CellReader(const AssembledMechanism& mechanism, ByteReader& in) : in_(in), mechanism_(mechanism) {}

  std::shared_ptr<const JointFunctions> read() {
    const LoopEquations& equations = mechanism_.functions->equations();
    values_.assign(static_cast<std::size_t>(equations.unknowns), Ball<double>::exact(0));
    const LoopEquations approach = mechanism_.approach_equations();
    if (!mechanism_.approach.empty()) {
      read_path({approach, 0, equations.unknowns}, mechanism_.approach, 0, false);
      const auto exactly = for_exact_drives({equations, 0, equations.unknowns}, mechanism_.start, values_);
      if (!exactly) throw ProofError("the beginning of the drives is not reached");
      values_ = *exactly;
    }
    std::vector<std::vector<LoopCell>> all;
    double start = mechanism_.start;
    for (std::size_t piece = 0; piece < mechanism_.functions->pieces(); ++piece) {
      const std::vector<LoopCell>& own = mechanism_.functions->cells(piece);
      const bool is_last = piece + 1 == mechanism_.functions->pieces();
      all.push_back(read_path({equations, piece, equations.unknowns}, own, start, is_last));
      start = own.back().to;
    }
    return std::make_shared<const JointFunctions>(equations, std::move(all), mechanism_.functions->drawn_at());
  }

 private:
  /// From a time to where the path is known to end: there, the drives pass to another piece, or the mechanism locks.
  std::vector<LoopCell> read_path(const LoopCurve& curve, const std::vector<LoopCell>& own, double from, bool is_last) {
    std::vector<LoopCell> cells;
    for (std::uint32_t left = in_.u32(); left > 0; --left) {
      checkpoint();
      const std::uint8_t kind = in_.u8();
      const double to = in_.f64();
      if (!(to > from || (to == from && own.front().from == own.back().to)) || !(to <= own.back().to))
        throw ProofError("a part of the time that makes no sense");
      if (kind == static_cast<std::uint8_t>(CellKind::before_dead_point)) {
        // Nothing can follow: of its end, only the box is known.
        if (left > 1 || cells.empty() || !is_last)
          throw ProofError("a cell before a dead point that is not the last one");
        cells.push_back(read_box(curve, from, to));
      } else if (kind == static_cast<std::uint8_t>(CellKind::polynomials)) {
        cells.push_back(read_cell(curve, from, to));
      } else {
        throw ProofError("a cell of an unknown kind");
      }
      from = to;
    }
    if (cells.empty() || cells.back().to != own.back().to)
      throw ProofError("the cells of the mechanism do not cover the time");
    return cells;
  }

  LoopCell read_box(const LoopCurve& curve, double from, double to) {
    const std::uint32_t parameter = in_.u32();
    if (parameter >= curve.size()) throw ProofError("a parameter that is no unknown");
    CurveBox box{static_cast<int>(parameter), {}};
    for (std::size_t i = 0; i <= curve.size(); ++i) {
      const double lo = in_.f64(), hi = in_.f64();
      if (!(-INFINITY < lo && lo < hi && hi < INFINITY)) throw ProofError("a range of a box that is none");
      box.ranges.push_back({lo, hi});
    }
    if (!holds_motion(box, curve.equations, curve.piece, from, to, values_))
      throw ProofError("the joints of the mechanism are not shown to stay in the box before a dead point");
    return {from, to, from + (to - from) / 2, to - from, std::move(box), {}, {}, {}};
  }

  LoopCell read_cell(const LoopCurve& curve, double from, double to) {
    LoopCell cell = LoopCell::between(from, to);
    for (std::size_t i = 0; i < curve.size(); ++i) {
      LoopCell::Coefficients& c = cell.c.emplace_back();
      const std::uint8_t terms = in_.u8();
      if (terms > c.size()) throw ProofError("a polynomial of too high a degree");
      for (std::size_t k = 0; k < terms; ++k) c[k] = in_.f64();
      if (!std::all_of(c.begin(), c.end(), [](double x) { return std::isfinite(x); }))
        throw ProofError("a coefficient that is no number");
    }
    const auto shown = [&](GapFrame frame) {
      LoopCurve as_seen = curve;
      as_seen.seen = frame;
      return certify(cell, as_seen, values_).has_value();
    };
    if (!shown(GapFrame::ground) && !shown(GapFrame::turning))
      throw ProofError("the joints of the mechanism are not shown to follow the polynomials from t = " +
                       std::to_string(from));
    values_ = values_at_end(cell);
    return cell;
  }

  ByteReader& in_;
  const AssembledMechanism& mechanism_;
  Balls<double> values_;  ///< of the unknowns, where the last cell ends
};

bool has_loops(const AssembledMechanism& mechanism) { return mechanism.functions->equations().unknowns > 0; }

}  // namespace

bool has_loops(const Scene& scene) { return scene.assembly && has_loops(*scene.assembly); }

void write_cells(ByteWriter& out, const AssembledMechanism& mechanism) {
  const auto write_path = [&](const std::vector<LoopCell>& cells) {
    out.u32(static_cast<std::uint32_t>(cells.size()));
    for (const LoopCell& cell : cells) write_cell(out, cell);
  };
  if (!mechanism.approach.empty()) write_path(mechanism.approach);
  for (std::size_t piece = 0; piece < mechanism.functions->pieces(); ++piece)
    write_path(mechanism.functions->cells(piece));
}

std::shared_ptr<const JointFunctions> read_stated_functions(const AssembledMechanism& mechanism, ByteReader& in) {
  return CellReader(mechanism, in).read();
}

Scene with_stated_cells(const Scene& scene, ByteReader& in) {
  const auto functions = read_stated_functions(*scene.assembly, in);
  Scene out = scene;
  auto assembly = std::make_shared<AssembledMechanism>(*scene.assembly);
  assembly->functions = functions;
  out.assembly = std::move(assembly);
  for (Body& body : out.bodies) {
    for (MotionPiece& piece : body.motion.pieces) {
      if (auto* follower = std::get_if<JointFollower>(&piece.rotation)) follower->functions = functions;
    }
  }
  return out;
}

PathProblem with_stated_cells(const PathProblem& problem, ByteReader& in) {
  PathProblem out = problem;
  for (const DrivenLoops& driven : problem.linkage.loops) {
    if (driven.region || !has_loops(*driven.assembly)) continue;
    const auto functions = read_stated_functions(*driven.assembly, in);
    for (std::optional<JointMotion>& motion : out.linkage.motions) {
      if (!motion || motion->joint != driven.joint) continue;
      if (auto* link = std::get_if<LinkMotion>(&motion->kind)) link->follows.functions = functions;
    }
  }
  return out;
}

void write_cells(ByteWriter& out, const PathProblem& problem) {
  for (const DrivenLoops& driven : problem.linkage.loops) {
    if (!driven.region && has_loops(*driven.assembly)) write_cells(out, *driven.assembly);
  }
}

}  // namespace taut::internal::proof
