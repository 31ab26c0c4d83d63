// What an import says about itself.
#include <fmt/format.h>

#include <cmath>

#include "import/import.hpp"
#include "io/json_text.hpp"

namespace taut::drawing {

namespace {

/// In three digits, not below the value: bounds stay bounds.
double rounded_up(double value) {
  if (!(value > 0)) return 0;
  const double step = std::pow(10, std::floor(std::log10(value)) - 2);
  return std::ceil(value / step) * step;
}

std::string counted(std::size_t n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

std::string file_text(const FileReport& file, const ImportSettings& settings) {
  std::string s = fmt::format("{}: {}, units: {}\n", file.file, file.format, file.units);
  if (file.kept > 0)
    s += fmt::format("  {} of {} kept as they are\n", counted(file.kept, "segment", "segments"),
                     counted(file.curves.segments, "curve", "curves"));
  if (file.curves.segments > 0 && file.kept == 0) {
    s += fmt::format("  {} as {}, nowhere farther than {:.3g} away (--tolerance {})\n",
                     counted(file.curves.segments, "curve", "curves"), counted(file.curves.chords, "chord", "chords"),
                     rounded_up(file.curves.deviation), settings.tolerance);
  }
  for (const Chorded& c : file.chorded) {
    s += fmt::format("  as chords: {} at {}{}, layer {}: {} as {}, nowhere farther than {:.3g} away (--tolerance {})\n",
                     c.what, c.place, c.entities > 1 ? fmt::format(", and {} more", c.entities - 1) : "", c.layer,
                     counted(c.counts.segments, "curve", "curves"), counted(c.counts.chords, "chord", "chords"),
                     rounded_up(c.counts.deviation), settings.tolerance);
  }
  if (file.joins.joins > 0) {
    s += fmt::format("  {} closed, the widest {:.3g} (--join {})\n", counted(file.joins.joins, "gap", "gaps"),
                     rounded_up(file.joins.longest), settings.join_distance());
  }
  for (const Skipped& skipped : file.skipped) {
    s += fmt::format("  skipped: {} at {} {}{}\n", skipped.what, skipped.place, skipped.reason,
                     skipped.times > 1 ? fmt::format(", and {} more", skipped.times - 1) : "");
  }
  return s;
}

std::string file_json(const FileReport& file) {
  std::string skipped;
  for (const Skipped& s : file.skipped) {
    skipped += fmt::format("{}{{\"what\":{},\"place\":{},\"reason\":{},\"times\":{}}}", skipped.empty() ? "" : ",",
                           io::string_text(s.what), io::string_text(s.place), io::string_text(s.reason), s.times);
  }
  std::string chorded;
  for (const Chorded& c : file.chorded) {
    chorded += fmt::format(
        "{}{{\"what\":{},\"place\":{},\"layer\":{},\"entities\":{},\"curves\":{},\"chords\":{},\"deviation\":{}}}",
        chorded.empty() ? "" : ",", io::string_text(c.what), io::string_text(c.place), io::string_text(c.layer),
        c.entities, c.counts.segments, c.counts.chords, io::number_text(c.counts.deviation));
  }
  if (!chorded.empty()) chorded = "\"as_chords\":[" + chorded + "],";
  return fmt::format(
      "{{\"file\":{},\"format\":{},\"units\":{},\"curves\":{},\"chords\":{},\"deviation\":{},\"joins\":{},"
      "\"longest_join\":{},{}{}\"skipped\":[{}]}}",
      io::string_text(file.file), io::string_text(file.format), io::string_text(file.units), file.curves.segments,
      file.curves.chords, io::number_text(file.curves.deviation), file.joins.joins, io::number_text(file.joins.longest),
      file.kept > 0 ? fmt::format("\"kept\":{},", file.kept) : "", chorded, skipped);
}

}  // namespace

std::string report_text(const Import& import, const ImportSettings& settings) {
  std::string s;
  for (const FileReport& file : import.files) {
    s += file_text(file, settings);
    for (const BodyReport& body : import.bodies) {
      if (body.file != file.file) continue;
      s += fmt::format("  body {}: {}, {}, {}\n", body.name, counted(body.parts, "part", "parts"),
                       counted(body.holes, "hole", "holes"), counted(body.vertices, "vertex", "vertices"));
    }
  }
  return s;
}

std::string report_json(const Import& import, const ImportSettings& settings) {
  std::string files, bodies;
  for (const FileReport& file : import.files) files += (files.empty() ? "" : ",") + file_json(file);
  for (const BodyReport& b : import.bodies) {
    bodies += fmt::format("{}{{\"name\":{},\"file\":{},\"parts\":{},\"holes\":{},\"vertices\":{}}}",
                          bodies.empty() ? "" : ",", io::string_text(b.name), io::string_text(b.file), b.parts, b.holes,
                          b.vertices);
  }
  return fmt::format("{{\"tolerance\":{},\"join\":{},\"scale\":{},\"files\":[{}],\"bodies\":[{}]}}\n",
                     io::number_text(settings.tolerance), io::number_text(settings.join_distance()),
                     io::number_text(settings.scale), files, bodies);
}

}  // namespace taut::drawing
