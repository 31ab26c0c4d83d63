// What an import says about itself.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "import/import.hpp"
#include "io/json_writer.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

/// The text names so many of a kind; the JSON has all.
constexpr std::size_t most_named = 10;

/// In three digits, not below the value: bounds stay bounds.
double rounded_up(double value) {
  if (!(value > 0)) return 0;
  const double step = std::pow(10, std::floor(std::log10(value)) - 2);
  return std::ceil(value / step) * step;
}

std::string spot(const Point& p) { return fmt::format("({:.7g}, {:.7g})", p.x + 0.0, p.y + 0.0); }

/// "  kind: line" for the first ones, and how many more there are.
template <class Item, class Line>
std::string named_lines(const char* kind, const std::vector<Item>& items, const Line& line) {
  std::string s;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i == most_named) return s + fmt::format("  {}: {} more (--json has all)\n", kind, items.size() - most_named);
    s += fmt::format("  {}: {}\n", kind, line(items[i]));
  }
  return s;
}

std::string layer_text(const std::string& layer) { return layer.empty() ? "" : ", layer " + io::excerpt(layer, 60); }

std::string open_text(const OpenReport& open) {
  std::string s = fmt::format("line at {}{}, from {} to {}", open.place, layer_text(open.layer),
                              spot(open.points.front()), spot(open.points.back()));
  const bool start = open.gap_start >= 0 && (open.gap_end < 0 || open.gap_start <= open.gap_end);
  if (start || open.gap_end >= 0)
    s += fmt::format("; the nearest other end is {:.3g} away, at {}", start ? open.gap_start : open.gap_end,
                     spot(start ? open.nearest_start : open.nearest_end));
  return s;
}

std::string skipped_text(const Skipped& skipped) {
  std::string where = skipped.layer.empty() ? "" : "layer " + io::excerpt(skipped.layer, 60);
  if (!skipped.handle.empty()) where += (where.empty() ? "handle " : ", handle ") + io::excerpt(skipped.handle, 20);
  return fmt::format("{} at {}{} {}{}", skipped.what, skipped.place, where.empty() ? "" : " (" + where + ")",
                     skipped.reason, skipped.times > 1 ? fmt::format(", and {} more", skipped.times - 1) : "");
}

std::string curves_text(const FileReport& file) {
  std::string s;
  if (file.kept > 0)
    s += fmt::format("  {} of {} kept as they are\n", io::counted(file.kept, "segment", "segments"),
                     io::counted(file.curves.segments, "curve", "curves"));
  if (file.curves.segments > 0 && file.kept == 0) {
    s += fmt::format("  {} as {}, nowhere farther than {:.3g} away (--tolerance {:.3g})\n",
                     io::counted(file.curves.segments, "curve", "curves"),
                     io::counted(file.curves.chords, "chord", "chords"), rounded_up(file.curves.deviation),
                     file.fineness.tolerance);
  }
  for (const Chorded& c : file.chorded) {
    s += fmt::format(
        "  as chords: {} at {}{}, layer {}: {} as {}, nowhere farther than {:.3g} away (--tolerance {:.3g})\n", c.what,
        c.place, c.entities > 1 ? fmt::format(", and {} more", c.entities - 1) : "", c.layer,
        io::counted(c.counts.segments, "curve", "curves"), io::counted(c.counts.chords, "chord", "chords"),
        rounded_up(c.counts.deviation), file.fineness.tolerance);
  }
  return s;
}

std::string gaps_text(const FileReport& file) {
  if (file.gaps.empty()) return "";
  const auto widest = std::max_element(file.gaps.begin(), file.gaps.end(),
                                       [](const GapReport& a, const GapReport& b) { return a.width < b.width; });
  std::string s = fmt::format("  {} closed, the widest {:.3g} at {} (--join {:.3g})\n",
                              io::counted(file.gaps.size(), "gap", "gaps"), rounded_up(widest->width),
                              spot(widest->from), file.fineness.join);
  // Those that rounding explains need no list.
  std::vector<GapReport> wide;
  for (const GapReport& gap : file.gaps)
    if (gap.width > file.fineness.join / 100) wide.push_back(gap);
  return s + named_lines("gap", wide, [](const GapReport& gap) {
           return fmt::format("{:.3g} wide, from {} to {}, {}{}", rounded_up(gap.width), spot(gap.from), spot(gap.to),
                              gap.place, layer_text(gap.layer));
         });
}

std::string file_text(const FileReport& file) {
  std::string s = fmt::format("{}: {}, units: {}\n", file.file, file.format, file.units) + curves_text(file);
  s += gaps_text(file);
  if (file.repeated > 0)
    s +=
        fmt::format("  {} drawn more than once, and counted once\n", io::counted(file.repeated, "segment", "segments"));
  s += named_lines("cut off", file.repairs, [&file](const RepairReport& repair) {
    return fmt::format("a {} {:.3g} {} at {}, {}{} (--{} {:.3g})", repair.what, rounded_up(repair.size),
                       repair.what == "spike" ? "long" : "wide", spot(repair.at), repair.place,
                       layer_text(repair.layer), repair.what == "sliver" ? "join" : "repair",
                       repair.what == "sliver" ? file.fineness.join : file.fineness.repair);
  });
  s += named_lines("crossing", file.crossings, [&file](const CrossingReport& crossing) {
    return fmt::format("a contour meets itself at {}, {}{}: what it encloses is divided there (--repair {:.3g})",
                       spot(crossing.at), crossing.place, layer_text(crossing.layer), file.fineness.repair);
  });
  s += named_lines("closed", file.closed, [](const RingReport& ring) {
    return fmt::format("an outline at {}{} by {}, {:.3g} in all", ring.place, layer_text(ring.layer),
                       io::counted(ring.gaps.size(), "straight line", "straight lines"), rounded_up(ring.gap_length));
  });
  s += named_lines("note", file.notes, [](const std::string& note) { return note; });
  s += named_lines("open", file.open, open_text);
  for (const Skipped& skipped : file.skipped) s += "  skipped: " + skipped_text(skipped) + "\n";
  return s;
}

/// A JSON array of what `text` makes of each.
template <class Item, class Text>
std::string array_of(const std::vector<Item>& items, const Text& text) {
  std::string s;
  for (const Item& item : items) s += (s.empty() ? "" : ",") + text(item);
  return "[" + s + "]";
}

std::string point_json(const Point& p) {
  return fmt::format("[{},{}]", io::number_text(p.x + 0.0), io::number_text(p.y + 0.0));
}

std::string place_json(const std::string& place, const std::string& layer) {
  return fmt::format("\"place\":{},\"layer\":{}", io::string_text(place), io::string_text(layer));
}

std::string gap_json(const GapReport& gap) {
  return fmt::format("{{\"width\":{},\"from\":{},\"to\":{},{}}}", io::number_text(gap.width), point_json(gap.from),
                     point_json(gap.to), place_json(gap.place, gap.layer));
}

std::string open_json(const OpenReport& open) {
  const auto nearest = [](const Point& p, double gap) {
    return gap < 0 ? std::string("null")
                   : fmt::format("{{\"at\":{},\"distance\":{}}}", point_json(p), io::number_text(gap));
  };
  return fmt::format("{{\"from\":{},\"to\":{},\"nearest_from\":{},\"nearest_to\":{},{},\"points\":{}}}",
                     point_json(open.points.front()), point_json(open.points.back()),
                     nearest(open.nearest_start, open.gap_start), nearest(open.nearest_end, open.gap_end),
                     place_json(open.place, open.layer), array_of(open.points, point_json));
}

std::string ring_json(const RingReport& ring) {
  const auto gap = [](const std::pair<Point, Point>& g) {
    return "[" + point_json(g.first) + "," + point_json(g.second) + "]";
  };
  return fmt::format("{{\"gaps\":{},\"gap_length\":{},\"line_length\":{},{}}}", array_of(ring.gaps, gap),
                     io::number_text(ring.gap_length), io::number_text(ring.line_length),
                     place_json(ring.place, ring.layer));
}

std::string repair_json(const RepairReport& repair) {
  return fmt::format("{{\"what\":{},\"at\":{},\"size\":{},{}}}", io::string_text(repair.what), point_json(repair.at),
                     io::number_text(repair.size), place_json(repair.place, repair.layer));
}

std::string crossing_json(const CrossingReport& crossing) {
  return fmt::format("{{\"at\":{},{}}}", point_json(crossing.at), place_json(crossing.place, crossing.layer));
}

std::string skipped_json(const Skipped& s) {
  return fmt::format("{{\"what\":{},{},\"handle\":{},\"reason\":{},\"unread\":{},\"times\":{}}}",
                     io::string_text(s.what), place_json(s.place, s.layer), io::string_text(s.handle),
                     io::string_text(s.reason), s.unread, s.times);
}

std::string chorded_json(const Chorded& c) {
  return fmt::format("{{\"what\":{},{},\"entities\":{},\"curves\":{},\"chords\":{},\"deviation\":{}}}",
                     io::string_text(c.what), place_json(c.place, c.layer), c.entities, c.counts.segments,
                     c.counts.chords, io::number_text(c.counts.deviation));
}

std::string file_json(const FileReport& file) {
  double longest = 0;
  for (const GapReport& gap : file.gaps) longest = std::max(longest, gap.width);
  std::string s = fmt::format("{{\"file\":{},\"format\":{},\"units\":{},\"tolerance\":{},\"join\":{},\"repair\":{}",
                              io::string_text(file.file), io::string_text(file.format), io::string_text(file.units),
                              io::number_text(file.fineness.tolerance), io::number_text(file.fineness.join),
                              io::number_text(file.fineness.repair));
  s += fmt::format(",\"curves\":{},\"chords\":{},\"deviation\":{},\"joins\":{},\"longest_join\":{}",
                   file.curves.segments, file.curves.chords, io::number_text(file.curves.deviation), file.gaps.size(),
                   io::number_text(longest));
  if (file.kept > 0) s += fmt::format(",\"kept\":{}", file.kept);
  if (!file.chorded.empty()) s += ",\"as_chords\":" + array_of(file.chorded, chorded_json);
  s += fmt::format(
      ",\"repeated\":{},\"gaps\":{},\"repairs\":{},\"crossings\":{},\"closed\":{},\"suspicious\":{},\"open\":{}",
      file.repeated, array_of(file.gaps, gap_json), array_of(file.repairs, repair_json),
      array_of(file.crossings, crossing_json), array_of(file.closed, ring_json), array_of(file.suspicious, ring_json),
      array_of(file.open, open_json));
  return s + fmt::format(",\"notes\":{},\"skipped\":{}}}",
                         array_of(file.notes, [](const std::string& n) { return io::string_text(n); }),
                         array_of(file.skipped, skipped_json));
}

/// ", z 0..3 and z 3..6", or nothing.
std::string levels_text(const BodyReport& body) {
  std::string s;
  for (const Layers& z : body.z) s += (s.empty() ? ", " : " and ") + io::heights_text(z);
  return s;
}

std::string layers_json(const Layers& z) {
  const auto end = [](double height) { return std::isfinite(height) ? io::number_text(height) : std::string("null"); };
  return "[" + end(z.lo) + "," + end(z.hi) + "]";
}

std::string body_json(const BodyReport& b) {
  return fmt::format(
      "{{\"name\":{},\"file\":{},\"parts\":{},\"holes\":{},\"vertices\":{},\"area\":{},\"overlap\":{},\"box\":[{},{}]{}"
      "}}",
      io::string_text(b.name), io::string_text(b.file), b.parts, b.holes, b.vertices, io::number_text(b.area),
      io::number_text(b.overlap), point_json(b.low), point_json(b.high),
      b.z.empty() ? "" : ",\"z\":" + array_of(b.z, layers_json));
}

std::string fault_json(const InputError& fault) {
  return fmt::format("{{\"place\":{},\"problem\":{},\"hint\":{}}}", io::string_text(fault.place()),
                     io::string_text(fault.problem()), io::string_text(fault.hint()));
}

}  // namespace

std::string report_text(const Import& import, const ImportSettings&) {
  std::string s;
  for (const FileReport& file : import.files) {
    s += file_text(file);
    for (const BodyReport& body : import.bodies) {
      if (body.file != file.file) continue;
      s += fmt::format("  body {}: {}, {}, {}, area {:.6g}{}, {:.5g} x {:.5g}{}\n", body.name,
                       io::counted(body.parts, "part", "parts"), io::counted(body.holes, "hole", "holes"),
                       io::counted(body.vertices, "vertex", "vertices"), body.area,
                       body.overlap > 0 ? fmt::format(" (parts overlap by {:.4g})", body.overlap) : "",
                       body.high.x - body.low.x, body.high.y - body.low.y, levels_text(body));
    }
  }
  return s;
}

std::string report_json(const Import& import, const ImportSettings& settings) {
  std::size_t parts = 0, holes = 0;
  double area = 0;
  for (const BodyReport& body : import.bodies) {
    parts += body.parts;
    holes += body.holes;
    area += body.area;
  }
  return fmt::format(
      "{{\"scale\":{},\"parts\":{},\"holes\":{},\"area\":{},\"files\":{},\"bodies\":{},\"faults\":{}}}\n",
      io::number_text(settings.scale), parts, holes, io::number_text(area), array_of(import.files, file_json),
      array_of(import.bodies, body_json), array_of(import.faults, fault_json));
}

}  // namespace taut::drawing
