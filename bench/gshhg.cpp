#include "gshhg.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#ifdef TAUT_HAS_NETCDF
#include <netcdf.h>

#include <cstdint>
#include <map>
#include <utility>
#include <vector>
#endif

namespace taut::bench {

#ifdef TAUT_HAS_NETCDF

namespace {

void succeed(int status, const char* what) {
  if (status != NC_NOERR) throw std::runtime_error(fmt::format("{}: {}: {}", gshhg_file, what, nc_strerror(status)));
}

/// An open netCDF file.
class File {
 public:
  File() { succeed(nc_open(gshhg_file, NC_NOWRITE, &id_), "cannot be opened"); }
  ~File() { nc_close(id_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  /// A whole variable of one dimension, or a scalar.
  std::vector<int> all(const char* name) const {
    std::size_t count = 1;
    const int variable = number_of(name);
    int dimensions = 0, dimension[NC_MAX_VAR_DIMS];
    succeed(nc_inq_var(id_, variable, nullptr, nullptr, &dimensions, dimension, nullptr), name);
    if (dimensions > 0) succeed(nc_inq_dimlen(id_, dimension[0], &count), name);
    return part(name, 0, count);
  }
  std::vector<int> part(const char* name, std::size_t first, std::size_t count) const {
    std::vector<int> out(count);
    succeed(nc_get_vara_int(id_, number_of(name), &first, &count, out.data()), name);
    return out;
  }

 private:
  int number_of(const char* name) const {
    int variable = 0;
    succeed(nc_inq_varid(id_, name, &variable), name);
    return variable;
  }
  int id_ = 0;
};

/// Longitude and latitude in 1/65535 degree.
using Place = std::pair<std::int64_t, std::int64_t>;
constexpr std::int64_t degree = 65535;

/// The polygons are cut at the meridians and parallels that are whole degrees. A piece of shoreline within one bin runs
/// from border to border, and the next one begins at the same place.
std::vector<std::vector<Place>> pieces_of(const File& file, int polygon) {
  const std::vector<int> owner = file.all("Id_of_GSHHS_ID");
  const std::vector<int> packed = file.all("Embedded_npts_levels_exit_entry_for_a_segment");
  const std::vector<int> first_point = file.all("Id_of_first_point_in_a_segment");
  const std::vector<int> first_piece = file.all("Id_of_first_segment_in_a_bin");
  const std::vector<int> count = file.all("N_segments_in_a_bin");
  const int columns = file.all("N_bins_in_360_longitude_range").at(0);
  std::vector<std::vector<Place>> pieces;
  for (std::size_t bin = 0; bin < count.size(); ++bin) {
    std::int64_t west = static_cast<std::int64_t>(bin) % columns;
    const std::int64_t south = 89 - static_cast<std::int64_t>(bin) / columns;
    if (west >= 180) west -= 360;
    for (int k = 0; k < (count[bin] & 0xffff); ++k) {
      const auto piece = static_cast<std::size_t>(first_piece[bin] + k);
      if (owner.at(piece) != polygon) continue;
      const std::size_t points = static_cast<std::uint32_t>(packed[piece]) >> 9;
      const auto begin = static_cast<std::size_t>(first_point[piece]);
      const std::vector<int> x = file.part("Relative_longitude_from_SW_corner_of_bin", begin, points);
      const std::vector<int> y = file.part("Relative_latitude_from_SW_corner_of_bin", begin, points);
      std::vector<Place>& out = pieces.emplace_back();
      // 16 bits without a sign, which netCDF does not know.
      for (std::size_t i = 0; i < points; ++i)
        out.emplace_back(west * degree + (x[i] & 0xffff), south * degree + (y[i] & 0xffff));
    }
  }
  return pieces;
}

/// The pieces one after the other, places where they meet only once.
std::vector<Place> ring_of(const std::vector<std::vector<Place>>& pieces, int polygon) {
  std::map<Place, std::size_t> beginning;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!beginning.emplace(pieces[i].front(), i).second)
      throw std::runtime_error(fmt::format("{}: two pieces of polygon {} begin at one place", gshhg_file, polygon));
  }
  std::vector<Place> ring;
  std::size_t at = 0, used = 0;
  do {
    ring.insert(ring.end(), pieces[at].begin(), pieces[at].end() - 1);
    const auto next = beginning.find(pieces[at].back());
    if (next == beginning.end()) throw std::runtime_error(fmt::format("{}: polygon {} has a gap", gshhg_file, polygon));
    at = next->second;
  } while (++used < pieces.size() && at != 0);
  if (used != pieces.size())
    throw std::runtime_error(fmt::format("{}: polygon {} is more than one ring", gshhg_file, polygon));
  return ring;
}

}  // namespace

std::string gshhg_obstacle() {
  if (std::filesystem::exists(gshhg_file)) return {};
  return fmt::format("{} is not there: apt-get install gmt-gshhg-full", gshhg_file);
}

Polygon read_gshhg(int polygon) {
  const File file;
  const std::vector<std::vector<Place>> pieces = pieces_of(file, polygon);
  if (pieces.empty()) throw std::runtime_error(fmt::format("{}: no polygon {}", gshhg_file, polygon));
  Polygon out;
  for (const auto& [x, y] : ring_of(pieces, polygon)) {
    const Point p{static_cast<double>(x) / 65536, static_cast<double>(y) / 65536};
    if (out.empty() || p != out.back()) out.push_back(p);
  }
  return out;
}

#else

std::string gshhg_obstacle() {
  return "taut's benchmarks were built without netCDF: apt-get install libnetcdf-dev, and configure again";
}

Polygon read_gshhg(int) { throw std::runtime_error(gshhg_obstacle()); }

#endif

}  // namespace taut::bench
