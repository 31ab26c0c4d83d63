#include "io/outline_reader.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "io/platform.hpp"
#include "taut/error.hpp"

namespace taut::internal::io {
namespace {

namespace fs = std::filesystem;

std::string in_folder(const std::string& folder, const std::string& file) {
  // A drive, or a root, of Windows is another folder, too.
  const fs::path path = path_of(file);
  const bool absolute = path.has_root_name() || path.has_root_directory();
  return absolute || folder.empty() || folder == "." ? file : folder + "/" + file;
}

/// Paths that cannot be followed are not below anything.
bool lies_below(const std::string& path, const std::string& folder) {
  std::error_code error;
  const fs::path home = fs::canonical(path_of(folder.empty() ? "." : folder), error);
  if (error) return false;
  const fs::path target = fs::weakly_canonical(fs::absolute(path_of(path), error), error);
  if (error) return false;
  return std::mismatch(home.begin(), home.end(), target.begin(), target.end()).first == home.end();
}

}  // namespace

std::string named_file(const std::string& folder, const std::string& file, bool allow_outside) {
  if (file.find('\0') != std::string::npos)
    throw InputError("", "the name of a file has a NUL in it", "write the name without it");
  std::string path = in_folder(folder, file);
  if (!allow_outside && !lies_below(path, folder)) {
    throw InputError("", "the file \"" + file + "\" is not below the scene's folder",
                     "move it there, or allow this with --allow-outside (in C++ with ReadLimits::allow_outside)");
  }
  return path;
}

}  // namespace taut::internal::io
