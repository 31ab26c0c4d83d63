#include "import/file_kinds.hpp"

#ifdef TAUT_HAS_PNG
// What libpng is built on.
#include <zlib.h>
#endif

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>
#include <vector>

#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut::drawing {

namespace {

struct OtherKind {
  std::vector<const char*> endings;
  const char* problem;
  const char* remedy;
};

const std::vector<OtherKind>& other_kinds() {
  static const std::vector<OtherKind> kinds{
      {{".pgm", ".png"},
       "is an image: the YAML file of the map says how large its cells are",
       "give that file, which names the image (taut import map.yaml); if there is none, write one: image: map.pgm, "
       "resolution: 0.05, origin: [0, 0, 0], negate: 0, occupied_thresh: 0.65, free_thresh: 0.196, a line each"},
      {{".jpg", ".jpeg", ".gif", ".bmp", ".tif", ".tiff", ".webp"},
       "is an image, and no drawing",
       "trace it to SVG (Inkscape: Path > Trace Bitmap); a robot's map is read as PGM or PNG, by its YAML file"},
      {{".dwg", ".dxb"},
       "is a drawing in a format of AutoCAD",
       "save it as ASCII DXF: SAVEAS in AutoCAD, the ODA File Converter, or dwg2dxf of LibreDWG"},
      {{".kicad_mod"},
       "is a footprint of KiCad, and no board",
       "place it on a board and give its .kicad_pcb file, or export it from the footprint editor as SVG"},
      {{".kicad_sch", ".kicad_pro", ".sch", ".brd"},
       "is no board of KiCad",
       "give the .kicad_pcb file of the board; KiCad imports boards of other programs"},
      {{".gbr", ".ger", ".gm1", ".gko", ".drl"},
       "is made for the plotter of a board",
       "export the board's edge as DXF or SVG, or give the .kicad_pcb file"},
      {{".pdf", ".eps", ".ps", ".ai", ".cdr", ".vsd", ".vsdx", ".odg", ".emf", ".wmf"},
       "is a page in a format that is not read",
       "open it in Inkscape, and save it as plain SVG"},
      {{".step", ".stp", ".iges", ".igs", ".stl", ".obj", ".3mf", ".ply", ".f3d", ".sldprt", ".fcstd", ".scad", ".ipt"},
       "is a model in space, and scenes are planar",
       "export the outline, a sketch or a section of it, as DXF or SVG"},
      {{".shp", ".gpkg", ".kml", ".gml", ".gpx", ".osm", ".fgb"},
       "is a map in a format that is not read",
       "convert it to GeoJSON: ogr2ogr map.geojson FILE"},
      {{".topojson"}, "is TopoJSON, whose shapes share arcs", "convert it to GeoJSON: ogr2ogr map.geojson FILE"},
      {{".zip", ".gz", ".7z", ".tar"}, "is an archive", "unpack it, and give the drawing that is in it"}};
  return kinds;
}

}  // namespace

std::string ending_of(const std::string& file) {
  const std::size_t dot = file.rfind('.'), slash = file.rfind('/');
  if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
  std::string ending = file.substr(dot);
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

void refuse_kind(const std::string& file) {
  const std::string ending = ending_of(file);
  for (const OtherKind& kind : other_kinds())
    if (std::find(kind.endings.begin(), kind.endings.end(), ending) != kind.endings.end())
      throw InputError(file, std::string("the file ") + kind.problem, kind.remedy);
  throw InputError(file,
                   "the ending of the file's name is none of .svg, .svgz, .dxf, .kicad_pcb, .wkt, .geojson, .geojsonl, "
                   ".json and .yaml",
                   "give the file the ending of its format");
}

bool is_gzip(const std::string& bytes) { return bytes.compare(0, 2, "\x1f\x8b") == 0; }

#ifdef TAUT_HAS_PNG
std::string unzipped(const std::string& bytes, const std::string& file) {
  z_stream stream{};
  constexpr int gzip_window = 15 + 16;
  if (inflateInit2(&stream, gzip_window) != Z_OK) throw InputError(file, "there is no memory to unpack it", "");
  const std::unique_ptr<z_stream, int (*)(z_stream*)> owner(&stream, inflateEnd);
  // The library does not write to what it reads.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string text;
  std::array<char, 1 << 16> piece;
  for (int state = Z_OK; state != Z_STREAM_END;) {
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    state = inflate(&stream, Z_NO_FLUSH);
    text.append(piece.data(), piece.size() - stream.avail_out);
    if (state != Z_OK && state != Z_STREAM_END)
      throw InputError(file, "the compressed file is damaged, or not all there",
                       "save the drawing again, as plain SVG");
    if (text.size() > ReadLimits{}.max_bytes)
      throw InputError(file, "what the file holds is too large", "save the drawing again with less in it");
  }
  return text;
}
#else
std::string unzipped(const std::string&, const std::string& file) {
  throw InputError(file, "this program was built without zlib, and does not read compressed files",
                   "unpack it: gunzip -c drawing.svgz > drawing.svg");
}
#endif

}  // namespace taut::drawing
