// All combinations of joint values as one HTML file, with the linkage at the one under the pointer.
#pragma once

#include <string>

#include "taut/envelope.hpp"

namespace taut::cli {

struct EnvelopePageOptions {
  double tolerance = 1e-3;    ///< that the answer was found with
  std::string title;          ///< empty: the scene's file is not named
  std::string template_path;  ///< empty: look next to the executable
};

/// Writes a self-contained page to `output`, or to standard output if it is "-". The same answer and template give the
/// same bytes. Throws InputError.
void write_envelope_page(const Linkage& linkage, const Envelope& answer, const EnvelopePageOptions& options,
                         const std::string& output);

}  // namespace taut::cli
