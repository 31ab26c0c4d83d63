// fmt, compiled once: taut links nothing, so somebody has to, and in every file it takes three seconds.
//
// Elsewhere its functions are only declared. Here it is header-only: what the table below names, and all that needs, is
// then compiled as inline functions, so that programs that link fmt themselves have no second definition in their way.
#define FMT_HEADER_ONLY
#include <fmt/format.h>

#include <cstdio>
#include <string>

namespace taut::internal {
namespace {

/// What fmt::format() and fmt::print() call. A table that counts as used keeps them.
struct FormatLibrary {
  std::string (*format)(fmt::string_view, fmt::format_args);
  void (*print)(fmt::string_view, fmt::format_args);
  void (*print_to)(std::FILE*, fmt::string_view, fmt::format_args);
#if FMT_VERSION >= 110000
  void (*print_buffered)(std::FILE*, fmt::string_view, fmt::format_args);
#endif
};

[[gnu::used]] const FormatLibrary format_library = {
    fmt::vformat,
    fmt::vprint,
    fmt::vprint,
#if FMT_VERSION >= 110000
    fmt::vprint_buffered,
#endif
};

}  // namespace
}  // namespace taut::internal
