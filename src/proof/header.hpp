// What every log begins with.
#pragma once

#include "proof/bytes.hpp"
#include "proof/format.hpp"

namespace taut::internal::proof {

struct Header {
  char version = of_tilings;
  Fingerprint fingerprint{};
  Touch touch = Touch::open;
  std::uint8_t kind = 0;  ///< of a log of tilings, its shapes; of separations, its claim
};

/// Throws ProofError unless it is the header of a log about this scene.
Header read_header(ByteReader& in, const Scene& scene);
void write_header(ByteWriter& out, const Header& header);

}  // namespace taut::internal::proof
