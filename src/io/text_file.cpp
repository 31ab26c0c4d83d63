#include "io/text_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>

#include "io/platform.hpp"
#include "taut/error.hpp"

namespace taut::internal::io {

void require_size(const std::string& text, const std::string& name, std::size_t max_bytes) {
  require_size(text.size(), name, max_bytes);
}

std::string read_text_file(const std::string& path, std::size_t max_bytes) {
  const FilePointer file = open_regular_file(path, max_bytes);
  std::string text;
  char buffer[1 << 16];
  while (std::size_t n = std::fread(buffer, 1, sizeof buffer, file.get())) {
    text.append(buffer, n);
    require_size(text, path, max_bytes);
  }
  if (std::ferror(file.get())) {
    throw InputError(path, std::string("cannot read the file: ") + std::strerror(errno),
                     "give the path of a text file");
  }
  drop_byte_order_mark(text);
  return text;
}

void drop_byte_order_mark(std::string& text) {
  if (text.compare(0, 3, "\xEF\xBB\xBF") == 0) text.erase(0, 3);
}

std::string place_in_text(const std::string& text, const std::string& name, std::size_t offset) {
  offset = std::min(offset, text.size());
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(offset);
  const auto line = 1 + std::count(text.begin(), end, '\n');
  const std::size_t newline = offset == 0 ? std::string::npos : text.rfind('\n', offset - 1);
  const std::size_t column = newline == std::string::npos ? offset + 1 : offset - newline;
  return name + ":" + std::to_string(line) + ":" + std::to_string(column);
}

std::string excerpt(const std::string& text, std::size_t length) {
  std::string s = text.substr(0, length);
  if (text.size() > length) {
    // Bytes 10xxxxxx continue a character: drop the character that was cut.
    while (!s.empty() && (static_cast<unsigned char>(text[s.size()]) & 0xC0) == 0x80) s.pop_back();
    s += "...";
  }
  for (char& c : s) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  }
  return s;
}

namespace {

[[noreturn]] void fail_to_open(const std::string& path, int error) {
  throw InputError(path, std::string("cannot open the file: ") + std::strerror(error),
                   error == EACCES ? "ask its owner for permission to read it, as `chmod +r` gives" : "check the path");
}

const char* words_for(FileKind kind) {
  switch (kind) {
    case FileKind::regular:
      return "it is a file";
    case FileKind::folder:
      return "it is a folder";
    case FileKind::pipe:
      return "it is a pipe";
    case FileKind::socket:
      return "it is a socket";
    case FileKind::device:
      break;
  }
  return "it is a device";
}

}  // namespace

void require_size(std::uintmax_t bytes, const std::string& name, std::size_t max_bytes) {
  if (bytes > max_bytes)
    throw InputError(name, "the file is larger than the limit of " + std::to_string(max_bytes) + " bytes",
                     "simplify the outline, or raise ReadLimits::max_bytes");
}

FilePointer open_regular_file(const std::string& path, std::size_t max_bytes) {
  // What follows a NUL would be lost.
  if (path.find('\0') != std::string::npos) fail_to_open(path, EINVAL);
  // Opening a pipe by the standard library would wait for somebody to write to it.
  SystemFile file = SystemFile::to_read(path);
  if (!file.is_open()) fail_to_open(path, errno);
  const std::optional<FileKind> kind = file.kind();
  if (!kind) fail_to_open(path, errno);
  if (*kind != FileKind::regular)
    throw InputError(path, std::string("cannot read the file: ") + words_for(*kind),
                     "give the path of a text file; what comes through a pipe can be read from standard input");
  const std::optional<std::uint64_t> size = file.size();
  if (!size) fail_to_open(path, errno);
  require_size(*size, path, max_bytes);
  std::FILE* stream = file.to_stream();
  if (!stream) fail_to_open(path, errno);
  return {stream, &std::fclose};
}

}  // namespace taut::internal::io
