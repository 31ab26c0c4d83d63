// What commands print for people: nothing in it that a terminal would obey.
#pragma once

#include <string>

#include "taut/error.hpp"

namespace taut::cli {

/// To standard output: a report, whose lines are its own.
void print_text(const std::string& text);

/// To standard error, after what was printed before: "program: message".
void print_error(const std::string& program, const InputError& error);
void print_error(const std::string& program, const std::string& message);

/// The exit code, or that of bad input, with a message, if standard output could not be written: output that was cut
/// short (a full disk) must not look like success.
int flushed(const std::string& program, int code);

}  // namespace taut::cli
