#include <fcntl.h>
#include <iconv.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "io/platform.hpp"

namespace taut::internal::io {
namespace {

constexpr mode_t mode_of_new_files = 0666;

}  // namespace

std::filesystem::path path_of(const std::string& name) { return name; }

std::string name_of(const std::filesystem::path& path) { return path.string(); }

std::string folder_of(const std::string& name) {
  const std::size_t slash = name.rfind('/');
  return slash == std::string::npos ? "." : slash == 0 ? "/" : name.substr(0, slash);
}

bool is_device(const std::string& name) {
  std::error_code ignored;
  const auto status = std::filesystem::status(name, ignored);
  return std::filesystem::exists(status) && std::filesystem::is_other(status);
}

bool replace_file(const std::string& from, const std::string& to) { return std::rename(from.c_str(), to.c_str()) == 0; }

void remove_open_file(const char* name) { ::unlink(name); }

std::optional<std::filesystem::path> running_program() {
  std::error_code error;
  std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return std::nullopt;
  return program;
}

SystemFile SystemFile::to_read(const std::string& name) {
  return SystemFile(::open(name.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
}

SystemFile SystemFile::to_append(const std::string& name) {
  return SystemFile(::open(name.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NONBLOCK, mode_of_new_files));
}

SystemFile SystemFile::to_write(const std::string& name) {
  return SystemFile(::open(name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, mode_of_new_files));
}

std::optional<FileKind> SystemFile::kind() const {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) return std::nullopt;
  if (S_ISREG(status.st_mode)) return FileKind::regular;
  if (S_ISDIR(status.st_mode)) return FileKind::folder;
  if (S_ISFIFO(status.st_mode)) return FileKind::pipe;
  if (S_ISSOCK(status.st_mode)) return FileKind::socket;
  return FileKind::device;
}

std::optional<std::uint64_t> SystemFile::size() const {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) return std::nullopt;
  return static_cast<std::uint64_t>(status.st_size);
}

bool SystemFile::lock() { return ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0; }

bool SystemFile::truncate(std::uint64_t bytes) { return ::ftruncate(descriptor_, static_cast<off_t>(bytes)) == 0; }

std::ptrdiff_t SystemFile::read_at(std::uint64_t offset, char* to, std::size_t most) const {
  return ::pread(descriptor_, to, most, static_cast<off_t>(offset));
}

bool SystemFile::write(const char* from, std::size_t bytes) {
  while (bytes > 0) {
    const ssize_t written = ::write(descriptor_, from, bytes);
    if (written < 0 && errno != EINTR) return false;
    if (written < 0) continue;
    from += written;
    bytes -= static_cast<std::size_t>(written);
  }
  return true;
}

bool SystemFile::close() { return ::close(std::exchange(descriptor_, -1)) == 0; }

std::FILE* SystemFile::to_stream() {
  std::FILE* stream = ::fdopen(descriptor_, "rb");
  if (stream) descriptor_ = -1;
  return stream;
}

std::optional<std::string> decoded(const std::string& text, const std::string& encoding) {
  const iconv_t converter = ::iconv_open("UTF-8", encoding.c_str());
  if (converter == reinterpret_cast<iconv_t>(-1)) return std::nullopt;
  std::string in = text, out;
  char* from = in.data();
  for (std::size_t left = in.size(); left > 0;) {
    char buffer[256];
    char* to = buffer;
    std::size_t room = sizeof buffer;
    const std::size_t before = left;
    const bool stuck = ::iconv(converter, &from, &left, &to, &room) == static_cast<std::size_t>(-1);
    out.append(buffer, to);
    if (!stuck || left < before) continue;
    out += "\xEF\xBF\xBD";
    ++from;
    --left;
  }
  ::iconv_close(converter);
  return out;
}

bool is_terminal(std::FILE* stream) { return ::isatty(::fileno(stream)) != 0; }

std::size_t terminal_width() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

void start_program(int&, char**&) {}

}  // namespace taut::internal::io
