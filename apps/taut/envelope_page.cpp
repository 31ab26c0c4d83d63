#include "envelope_page.hpp"

#include "draw/world_shapes.hpp"
#include "io/joint_reader.hpp"
#include "io/json_writer.hpp"
#include "taut/io.hpp"
#include "viewer_page.hpp"

namespace taut::cli {
using namespace internal;
namespace {

std::string page_text(const Linkage& linkage, const Envelope& answer, const EnvelopePageOptions& options) {
  std::string s = "{" + (options.title.empty() ? std::string() : "\"title\":" + io::string_text(options.title) + ",");
  s += "\"envelope\":" + envelope_json(linkage, answer, options.tolerance, true);
  s += ",\"bodies\":" + io::linked_bodies_json(linkage) + ",\"colours\":[";
  for (std::size_t k = 0; k < io::body_styles; ++k) s += (k ? "," : "") + io::string_text(io::body_style(k).fill);
  return s + "]}";
}

}  // namespace

void write_envelope_page(const Linkage& linkage, const Envelope& answer, const EnvelopePageOptions& options,
                         const std::string& output) {
  write_page("envelope.html", options.template_path, page_text(linkage, answer, options), output);
}

}  // namespace taut::cli
