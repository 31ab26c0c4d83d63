#include "import/kicad_drills.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "import/rounded_rectangle.hpp"

namespace taut::drawing {

namespace {

std::string counted_drills(std::size_t n, const char* of) { return fmt::format("{} of {}", n, of); }

}  // namespace

void KicadDrills::read(const SExpression& item, const Affine& footprint, const std::string& place) {
  const SExpression *drill = item.find("drill"), *at = item.find("at");
  if (!drill || !at) return;
  // "(drill oval WIDTH HEIGHT)"; the height may be left out.
  const bool oval = !drill->items.empty() && !drill->items[0].list && drill->items[0].word == "oval";
  const double width = drill->number(oval ? 1 : 0).value_or(0);
  const double height = oval ? drill->number(2).value_or(width) : width;
  if (!(width > 0 && height > 0)) return;
  const bool via = item.word == "via";
  const bool blind = via && std::any_of(item.items.begin(), item.items.end(), [](const SExpression& word) {
                       return !word.list && (word.word == "blind" || word.word == "buried" || word.word == "micro");
                     });
  if (blind) {
    ++blind_;
    return;
  }
  const double least = std::min(width, height) * root_.a;
  if (!least_ || least < *least_) {
    const bool first = pads_ + vias_ == 0;
    narrowest_ = first ? least : std::min(narrowest_, least);
    widest_ = std::max(widest_, least);
    ++(via ? vias_ : pads_);
    return;
  }
  // Pads have their positions in the footprint, and their angles on the board.
  const Point centre = footprint({at->number(0).value_or(0), at->number(1).value_or(0)});
  const Affine turned = Affine{root_.a, root_.b, root_.c, root_.d, 0, 0} * rotation(-at->number(2).value_or(0));
  const Affine where = translation(centre.x, centre.y) * turned;
  const double radius = std::min(width, height) / 2;
  Chain circle{{}, true, place};
  if (width == height) flattener_.ellipse(circle.points, centre, where.turn({radius, 0}), where.turn({0, radius}));
  holes_.push_back(width == height ? std::move(circle)
                                   : rounded_rectangle({-width / 2, -height / 2}, {width / 2, height / 2}, radius,
                                                       radius, where, place, flattener_));
}

std::vector<std::string> KicadDrills::notes() const {
  std::vector<std::string> notes;
  if (!holes_.empty())
    notes.push_back(
        fmt::format("{} {} of the board", holes_.size(), holes_.size() == 1 ? "drill is a hole" : "drills are holes"));
  if (pads_ + vias_ > 0) {
    const std::string of = pads_ == 0   ? counted_drills(vias_, "vias")
                           : vias_ == 0 ? counted_drills(pads_, "pads")
                                        : counted_drills(pads_, "pads") + " and " + counted_drills(vias_, "vias");
    notes.push_back(
        fmt::format("drills are no holes of the board: {}, {:.4g} to {:.4g} wide (with --drills D, those of "
                    "at least D are)",
                    of, narrowest_, widest_));
  }
  if (blind_ > 0)
    notes.push_back(fmt::format("{} of blind, buried or micro vias {} not through the board", blind_,
                                blind_ == 1 ? "drill goes" : "drills go"));
  return notes;
}

}  // namespace taut::drawing
