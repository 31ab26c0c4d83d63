// taut-verify: checks a proof log, with none of the code that writes such logs.
#include <exception>

#include "io/platform.hpp"
#include "taut/error.hpp"
#include "terminal.hpp"
#include "verify_report.hpp"

int main(int argc, char** argv) {
  taut::internal::io::start_program(argc, argv);
  const char* const program = "taut-verify";
  taut::cli::Program app("taut-verify: check a proof, and say what it proves", program);
  taut::cli::VerifyArguments arguments;
  taut::cli::add_verify_options(app.command(), arguments, "taut-verify scene.json scene.proof");
  try {
    if (!app.parse(argc, argv)) return 0;
    return taut::cli::flushed(program, taut::cli::verify_and_report(arguments));
  } catch (const taut::cli::UsageError& error) {
    taut::cli::print_error(program, error.text_with_hint("see `taut-verify --help`"));
    return 2;
  } catch (const taut::InputError& error) {
    taut::cli::print_error(program, error);
    return 2;
  } catch (const std::exception& error) {
    taut::cli::print_error(program, std::string("internal error: ") + error.what());
    return 4;
  }
}
