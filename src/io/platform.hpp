// What differs between operating systems: names of files, open files, and the terminal. Everything else is standard
// C++.
//
// platform_posix.cpp and platform_windows.cpp implement it; CMake takes one of them. Names and arguments are UTF-8 on
// every system, whatever the code page of a Windows console is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

namespace taut::internal::io {

/// The path that a name in UTF-8 stands for, for functions and streams of the standard library.
std::filesystem::path path_of(const std::string& name);

/// A path as a name in UTF-8.
std::string name_of(const std::filesystem::path& path);

/// The folder that a name is in: "." for a bare one.
std::string folder_of(const std::string& name);

/// Is it a device or a pipe, which is written to, never replaced?
bool is_device(const std::string& name);

/// Renames a file; one that has the new name already is replaced at once. False, with errno, if it cannot be done.
bool replace_file(const std::string& from, const std::string& to);

/// Removes a file that this process may still have open. May be called by a signal handler.
void remove_open_file(const char* name);

/// The program that runs, if the system says where it is.
std::optional<std::filesystem::path> running_program();

enum class FileKind { regular, folder, pipe, socket, device };

/// An open file. Functions that fail say why in errno.
class SystemFile {
 public:
  /// Opens a file to read it. Does not wait, not even for a pipe without a writer.
  static SystemFile to_read(const std::string& name);
  /// Opens a file to read it anywhere and to write at its end, and creates it if there is none. Does not wait either.
  static SystemFile to_append(const std::string& name);
  /// Creates a file, or empties it, to write it. remove_open_file() can remove it.
  static SystemFile to_write(const std::string& name);

  SystemFile() = default;
  ~SystemFile();
  SystemFile(const SystemFile&) = delete;
  SystemFile& operator=(const SystemFile&) = delete;
  SystemFile(SystemFile&& other) noexcept;
  SystemFile& operator=(SystemFile&& other) noexcept;

  bool is_open() const { return descriptor_ >= 0; }
  std::optional<FileKind> kind() const;
  /// Bytes of a regular file.
  std::optional<std::uint64_t> size() const;
  /// Keeps other processes from locking the file until this one closes it. False if one of them has it.
  bool lock();
  bool truncate(std::uint64_t bytes);
  /// How many bytes were read, 0 at the end; negative after an error.
  std::ptrdiff_t read_at(std::uint64_t offset, char* to, std::size_t most) const;
  /// Writes all of it, at the end of a file that is open to append.
  bool write(const char* from, std::size_t bytes);
  bool close();
  /// Hands the file over to a stream that reads it; nullptr, and the file stays open, after an error.
  std::FILE* to_stream();

 private:
  explicit SystemFile(int descriptor) : descriptor_(descriptor) {}

  int descriptor_ = -1;
};

/// A text in UTF-8, from an encoding of this name, such as CP1252 or UTF-16: with U+FFFD in place of what is not in it.
/// Nothing if the system does not know the encoding.
std::optional<std::string> decoded(const std::string& text, const std::string& encoding);

/// Standard output or standard error: is it a terminal?
bool is_terminal(std::FILE* stream);

/// Columns of the terminal that standard error goes to; 80 if that is not known.
std::size_t terminal_width();

/// For main(): makes the words of the command line UTF-8, and prepares the standard streams: bytes pass unchanged, and
/// a terminal takes UTF-8 and obeys escape sequences.
void start_program(int& argc, char**& argv);

}  // namespace taut::internal::io
