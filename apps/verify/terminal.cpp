#include "terminal.hpp"

#include <cstdio>

#include "io/text.hpp"

namespace taut::cli {
using namespace internal;
namespace {

void print_message(const std::string& program, const std::string& safe) {
  std::fflush(stdout);
  const std::string line = program + ": " + safe + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace

void print_text(const std::string& text) {
  const std::string safe = io::for_terminal(text);
  std::fwrite(safe.data(), 1, safe.size(), stdout);
}

void print_error(const std::string& program, const InputError& error) {
  print_message(program, io::for_terminal(error));
}

void print_error(const std::string& program, const std::string& message) {
  print_message(program, io::for_terminal(message));
}

int flushed(const std::string& program, int code) {
  constexpr int bad_input = 2;
  if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return code;
  print_error(program, "cannot write to standard output");
  return bad_input;
}

}  // namespace taut::cli
