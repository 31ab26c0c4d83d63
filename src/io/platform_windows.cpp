#define NOMINMAX
#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#include <fcntl.h>
#include <io.h>
#include <shellapi.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <utility>
#include <vector>

#include "io/platform.hpp"

namespace taut::internal::io {
namespace {

std::wstring wide(const std::string& text, UINT page = CP_UTF8) {
  const int bytes = static_cast<int>(std::min<std::size_t>(text.size(), INT_MAX));
  const int length = MultiByteToWideChar(page, 0, text.data(), bytes, nullptr, 0);
  std::wstring result(static_cast<std::size_t>(length), L'\0');
  MultiByteToWideChar(page, 0, text.data(), bytes, result.data(), length);
  return result;
}

std::string narrow(const std::wstring& text) {
  const int units = static_cast<int>(std::min<std::size_t>(text.size(), INT_MAX));
  const int length = WideCharToMultiByte(CP_UTF8, 0, text.data(), units, nullptr, 0, nullptr, nullptr);
  std::string result(static_cast<std::size_t>(length), '\0');
  WideCharToMultiByte(CP_UTF8, 0, text.data(), units, result.data(), length, nullptr, nullptr);
  return result;
}

/// Without an order of bytes in its name, UTF-16 has a mark that tells it; a little end comes first where that is
/// missing.
std::wstring utf16(const std::string& text, const std::string& encoding) {
  const auto byte = [&text](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(text[i])); };
  const bool marked_big = text.size() >= 2 && byte(0) == 0xFE && byte(1) == 0xFF;
  const bool big = encoding == "UTF-16BE" || (encoding == "UTF-16" && marked_big);
  std::wstring units;
  units.reserve(text.size() / 2);
  for (std::size_t i = 0; i + 1 < text.size(); i += 2)
    units += static_cast<wchar_t>(big ? byte(i) << 8 | byte(i + 1) : byte(i + 1) << 8 | byte(i));
  return units;
}

/// The page that an encoding is: those of drawings, which name most by number, as "CP1252".
std::optional<UINT> code_page(const std::string& encoding) {
  constexpr std::pair<const char*, UINT> by_name[] = {
      {"UTF-8", CP_UTF8}, {"SHIFT_JIS", 932}, {"GBK", 936}, {"BIG5", 950}};
  for (const auto& [name, page] : by_name) {
    if (encoding == name) return page;
  }
  UINT number = 0;
  char beyond = 0;
  if (std::sscanf(encoding.c_str(), "ISO-8859-%2u%c", &number, &beyond) == 1) {
    number += 28590;
  } else if (std::sscanf(encoding.c_str(), "CP%5u%c", &number, &beyond) != 1) {
    return std::nullopt;
  }
  if (IsValidCodePage(number) == 0) return std::nullopt;
  return number;
}

/// The error of Windows that came last, as the nearest one of C.
int last_errno() {
  switch (GetLastError()) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_DRIVE:
    case ERROR_BAD_NETPATH:
      return ENOENT;
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
    case ERROR_WRITE_PROTECT:
      return EACCES;
    case ERROR_INVALID_NAME:
    case ERROR_BAD_PATHNAME:
      return EINVAL;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
      return ENOSPC;
    case ERROR_TOO_MANY_OPEN_FILES:
      return EMFILE;
    case ERROR_ALREADY_EXISTS:
    case ERROR_FILE_EXISTS:
      return EEXIST;
    default:
      return EIO;
  }
}

bool failed() {
  errno = last_errno();
  return false;
}

/// Opened so that others may read, replace and remove the file, as elsewhere. Folders, too, so that kind() can say so.
HANDLE opened_handle(const std::string& name, DWORD access, DWORD creation) {
  return CreateFileW(wide(name).c_str(), access, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr,
                     creation, FILE_ATTRIBUTE_NORMAL | FILE_FLAG_BACKUP_SEMANTICS, nullptr);
}

int opened(const std::string& name, DWORD access, DWORD creation, int flags) {
  const HANDLE handle = opened_handle(name, access, creation);
  if (handle == INVALID_HANDLE_VALUE) {
    failed();
    return -1;
  }
  const int descriptor = _open_osfhandle(reinterpret_cast<std::intptr_t>(handle), flags | _O_BINARY | _O_NOINHERIT);
  if (descriptor < 0) CloseHandle(handle);
  return descriptor;
}

std::optional<FileKind> kind_of(HANDLE handle) {
  switch (GetFileType(handle)) {
    case FILE_TYPE_PIPE:
      return FileKind::pipe;  // sockets are among them
    case FILE_TYPE_CHAR:
      return FileKind::device;
    case FILE_TYPE_DISK:
      break;
    default:
      failed();
      return std::nullopt;
  }
  BY_HANDLE_FILE_INFORMATION information{};
  if (GetFileInformationByHandle(handle, &information) == 0) return FileKind::device;  // a whole disk
  return (information.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0 ? FileKind::folder : FileKind::regular;
}

HANDLE handle_of(int descriptor) { return reinterpret_cast<HANDLE>(_get_osfhandle(descriptor)); }

/// A place in a file, for functions that take it apart.
OVERLAPPED at(std::uint64_t offset) {
  OVERLAPPED place{};
  place.Offset = static_cast<DWORD>(offset);
  place.OffsetHigh = static_cast<DWORD>(offset >> 32);
  return place;
}

constexpr std::size_t most_at_once = std::size_t{1} << 30;

/// Locks of Windows keep others from reading, too: this byte is beyond what any file has.
constexpr std::uint64_t locked_byte = std::uint64_t{1} << 62;

void prepare_terminal(DWORD standard_handle) {
  const HANDLE handle = GetStdHandle(standard_handle);
  DWORD mode = 0;
  if (GetConsoleMode(handle, &mode) != 0) SetConsoleMode(handle, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

/// The code page belongs to the console, which other programs use after this one.
UINT code_page_before = 0;
void restore_code_page() { SetConsoleOutputCP(code_page_before); }

void prepare_streams() {
  for (std::FILE* stream : {stdin, stdout, stderr}) _setmode(_fileno(stream), _O_BINARY);
  code_page_before = GetConsoleOutputCP();
  if (code_page_before != 0 && code_page_before != CP_UTF8 && SetConsoleOutputCP(CP_UTF8) != 0)
    std::atexit(restore_code_page);
  prepare_terminal(STD_OUTPUT_HANDLE);
  prepare_terminal(STD_ERROR_HANDLE);
}

}  // namespace

std::filesystem::path path_of(const std::string& name) { return wide(name); }

std::string name_of(const std::filesystem::path& path) { return narrow(path.wstring()); }

std::string folder_of(const std::string& name) {
  const std::size_t end = name.find_last_of("/\\:");
  if (end == std::string::npos) return ".";
  // A root keeps its slash, and a drive its colon.
  const bool root = end == 0 || name[end] == ':' || name[end - 1] == ':';
  return name.substr(0, root ? end + 1 : end);
}

bool is_device(const std::string& name) {
  // Without access, which asks only what it is.
  const HANDLE handle = opened_handle(name, 0, OPEN_EXISTING);
  if (handle == INVALID_HANDLE_VALUE) return false;
  const std::optional<FileKind> kind = kind_of(handle);
  CloseHandle(handle);
  return kind && *kind != FileKind::regular && *kind != FileKind::folder;
}

bool replace_file(const std::string& from, const std::string& to) {
  return MoveFileExW(wide(from).c_str(), wide(to).c_str(), MOVEFILE_REPLACE_EXISTING) != 0 || failed();
}

void remove_open_file(const char* name) { DeleteFileW(wide(name).c_str()); }

std::optional<std::filesystem::path> running_program() {
  std::wstring name(1 << 15, L'\0');
  const DWORD length = GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size()));
  if (length == 0 || length >= name.size()) return std::nullopt;
  name.resize(length);
  return name;
}

SystemFile SystemFile::to_read(const std::string& name) {
  return SystemFile(opened(name, GENERIC_READ, OPEN_EXISTING, _O_RDONLY));
}

SystemFile SystemFile::to_append(const std::string& name) {
  return SystemFile(opened(name, GENERIC_READ | GENERIC_WRITE, OPEN_ALWAYS, _O_RDWR | _O_APPEND));
}

SystemFile SystemFile::to_write(const std::string& name) {
  return SystemFile(opened(name, GENERIC_WRITE, CREATE_ALWAYS, _O_WRONLY));
}

std::optional<FileKind> SystemFile::kind() const { return kind_of(handle_of(descriptor_)); }

std::optional<std::uint64_t> SystemFile::size() const {
  LARGE_INTEGER bytes{};
  if (GetFileSizeEx(handle_of(descriptor_), &bytes) != 0) return static_cast<std::uint64_t>(bytes.QuadPart);
  failed();
  return std::nullopt;
}

bool SystemFile::lock() {
  OVERLAPPED place = at(locked_byte);
  return LockFileEx(handle_of(descriptor_), LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0, &place) !=
             0 ||
         failed();
}

bool SystemFile::truncate(std::uint64_t bytes) {
  LARGE_INTEGER end{};
  end.QuadPart = static_cast<LONGLONG>(bytes);
  const HANDLE handle = handle_of(descriptor_);
  return (SetFilePointerEx(handle, end, nullptr, FILE_BEGIN) != 0 && SetEndOfFile(handle) != 0) || failed();
}

std::ptrdiff_t SystemFile::read_at(std::uint64_t offset, char* to, std::size_t most) const {
  OVERLAPPED place = at(offset);
  DWORD got = 0;
  if (ReadFile(handle_of(descriptor_), to, static_cast<DWORD>(std::min(most, most_at_once)), &got, &place) != 0)
    return static_cast<std::ptrdiff_t>(got);
  if (GetLastError() == ERROR_HANDLE_EOF) return 0;
  failed();
  return -1;
}

bool SystemFile::write(const char* from, std::size_t bytes) {
  while (bytes > 0) {
    // By the C library, which goes to the end first where the file is open to append.
    const int written = _write(descriptor_, from, static_cast<unsigned>(std::min(bytes, most_at_once)));
    if (written < 0) return false;
    from += written;
    bytes -= static_cast<std::size_t>(written);
  }
  return true;
}

bool SystemFile::close() { return _close(std::exchange(descriptor_, -1)) == 0; }

std::FILE* SystemFile::to_stream() {
  std::FILE* stream = _fdopen(descriptor_, "rb");
  if (stream) descriptor_ = -1;
  return stream;
}

std::optional<std::string> decoded(const std::string& text, const std::string& encoding) {
  if (encoding.rfind("UTF-16", 0) == 0) return narrow(utf16(text, encoding));
  const std::optional<UINT> page = code_page(encoding);
  if (!page) return std::nullopt;
  return narrow(wide(text, *page));
}

bool is_terminal(std::FILE* stream) {
  // _isatty() takes every device for one, NUL among them.
  DWORD mode = 0;
  return GetConsoleMode(handle_of(_fileno(stream)), &mode) != 0;
}

std::size_t terminal_width() {
  CONSOLE_SCREEN_BUFFER_INFO information{};
  if (GetConsoleScreenBufferInfo(GetStdHandle(STD_ERROR_HANDLE), &information) == 0) return 80;
  const int columns = information.srWindow.Right - information.srWindow.Left + 1;
  return columns > 0 ? static_cast<std::size_t>(columns) : 80;
}

void start_program(int& argc, char**& argv) {
  prepare_streams();
  // The words that main() is given are in the system's code page, which may not have their characters.
  int count = 0;
  wchar_t** const words = CommandLineToArgvW(GetCommandLineW(), &count);
  if (!words) return;
  static std::vector<std::string> texts;
  static std::vector<char*> pointers;
  for (int i = 0; i < count; ++i) texts.push_back(narrow(words[i]));
  LocalFree(words);
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  argc = count;
  argv = pointers.data();
}

}  // namespace taut::internal::io
