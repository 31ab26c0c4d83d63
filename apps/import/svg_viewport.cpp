#include "import/svg_viewport.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "io/text.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

constexpr double millimetres_of_pixel = 25.4 / 96;

/// The attribute preserveAspectRatio.
struct AspectRatio {
  bool kept = true, slice = false;
  double x = 0.5, y = 0.5;  ///< what part of the room that is left is before the box
};

AspectRatio aspect_ratio_of(const XmlElement& element) {
  AspectRatio ratio;
  const std::string* text = element.find("preserveAspectRatio");
  if (!text) return ratio;
  std::istringstream words(*text);
  std::string align, how, rest;
  words >> align;
  if (align == "defer") words >> align;
  words >> how >> rest;
  static const std::array<const char*, 3> places{"Min", "Mid", "Max"};
  bool known = align == "none";
  ratio.kept = !known;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (align != std::string("x") + places[i] + "Y" + places[j]) continue;
      known = true;
      ratio.x = static_cast<double>(i) / 2;
      ratio.y = static_cast<double>(j) / 2;
    }
  }
  ratio.slice = how == "slice";
  if (!known || !rest.empty() || (!how.empty() && how != "meet" && how != "slice"))
    throw InputError(element.place, "preserveAspectRatio=\"" + io::excerpt(*text) + "\" cannot be read",
                     "write none, or xMidYMid, say, and meet or slice");
  return ratio;
}

/// How long the box's units are in a viewport, along x and y.
Point scales_of(const ViewBox& box, double width, double height, const AspectRatio& ratio) {
  const double x = width / box.width, y = height / box.height;
  if (!ratio.kept) return {x, y};
  const double both = ratio.slice ? std::max(x, y) : std::min(x, y);
  return {both, both};
}

/// The width or height of a page.
struct PageSize {
  double length = 0;  ///< in millimetres, or pixels; 0 if it is not given
  bool physical = false;
  std::string unread;  ///< what is given instead
};

PageSize page_size_of(const XmlElement& root, const char* key) {
  const std::string* text = root.find(key);
  const auto length = text ? parse_length(*text) : std::nullopt;
  if (!text) return {};
  if (!length || !(length->value > 0)) return {0, false, trimmed_text(*text) == "auto" ? "" : *text};
  if (const auto unit = millimetres(length->unit)) return {length->value * *unit, true, ""};
  if (length->unit.empty() || length->unit == "px") return {length->value, false, ""};
  return {0, false, *text};
}

std::string scale_text(const Page& page, const char* unit) {
  if (page.across == page.up)
    return std::string(unit) + " (" + io::number_text(page.across) + " " + unit + " for each of the drawing's own)";
  return std::string(unit) + " (" + io::number_text(page.across) + " " + unit + " across and " +
         io::number_text(page.up) + " " + unit + " up for each of the drawing's own)";
}

}  // namespace

std::optional<ViewBox> view_box_of(const XmlElement& element) {
  const std::string* text = element.find("viewBox");
  if (!text) return std::nullopt;
  NumberScanner scanner(*text);
  const auto x = scanner.number(), y = scanner.number(), width = scanner.number(), height = scanner.number();
  if (!height || !scanner.at_end() || !(*width > 0 && *height > 0))
    throw InputError(element.place, "viewBox=\"" + io::excerpt(*text) + "\" is not x, y, width and height",
                     "write four numbers, the last two above 0");
  return ViewBox{*x, *y, *width, *height};
}

Affine fitted(const ViewBox& box, const Viewport& viewport, const XmlElement& element) {
  const AspectRatio ratio = aspect_ratio_of(element);
  const Point scale = scales_of(box, viewport.width, viewport.height, ratio);
  return translation(ratio.x * (viewport.width - box.width * scale.x),
                     ratio.y * (viewport.height - box.height * scale.y)) *
         scaling(scale.x, scale.y) * translation(-box.x, -box.y);
}

Page page_of(const XmlElement& root) {
  PageSize width = page_size_of(root, "width"), height = page_size_of(root, "height");
  const auto box = view_box_of(root);
  const bool physical = width.physical || height.physical;
  for (PageSize* size : {&width, &height})
    if (physical && !size->physical) size->length *= millimetres_of_pixel;
  const bool sized = width.length > 0 || height.length > 0;
  Page page;
  page.physical = physical;
  if (box) {
    page.viewport = {box->width, box->height};
    const AspectRatio ratio = aspect_ratio_of(root);
    if (sized) {
      // A page that says one of its sizes has the proportions of its box.
      const double w = width.length > 0 ? width.length : height.length * (box->width / box->height);
      const double h = height.length > 0 ? height.length : width.length * (box->height / box->width);
      const Point scale = scales_of(*box, w, h, ratio);
      // Pixels are no lengths, but the drawing may be stretched to them.
      if (physical || scale.x != scale.y) page.across = scale.x, page.up = scale.y;
    } else if (!ratio.kept && !(width.unread.empty() && height.unread.empty())) {
      page.note = "the drawing is stretched to a page whose size is not given: its viewBox counts";
    }
  } else {
    if (physical) page.across = page.up = millimetres_of_pixel;
    if (width.length > 0) page.viewport.width = width.length / page.across;
    if (height.length > 0) page.viewport.height = height.length / page.up;
  }
  page.units = physical                 ? scale_text(page, "mm")
               : page.across != page.up ? scale_text(page, "px")
                                        : std::string("the drawing's own");
  for (const PageSize* size : {&width, &height})
    if (!sized && !size->unread.empty()) {
      page.units += " (the page's size, " + io::excerpt(size->unread, 20) + ", is no length)";
      break;
    }
  return page;
}

}  // namespace taut::drawing
