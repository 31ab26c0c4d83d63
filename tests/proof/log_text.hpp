// A proof log in parts that can be taken out, exchanged, and put together again.
#pragma once

#include <string>
#include <vector>

#include "taut/proof.hpp"

namespace taut::testing {

/// What every log ends with.
inline constexpr std::size_t checksum_size = 8;

struct LogParts {
  std::string header;                ///< up to the first record: magic number, fingerprint, touch, shapes, tiling
  std::vector<std::string> records;  ///< each with its first byte
};

/// Cuts a valid log into parts; the checksum is left out.
LogParts take_apart(const std::string& log, std::uint32_t vertices);
/// The log of these parts, with the right checksum.
std::string put_together(const LogParts& parts);
/// The same for bytes without their checksum.
std::string sealed(const std::string& bytes);

/// The answer of the kinetic engine, and its log.
struct Proved {
  Answer answer;
  std::string log;
};
Proved prove_in_memory(const Scene& scene, Touch touch, std::uint64_t max_events = UINT64_MAX);

}  // namespace taut::testing
