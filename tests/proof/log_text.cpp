#include "log_text.hpp"

#include <sstream>
#include <stdexcept>

#include "proof/bytes.hpp"
#include "proof/format.hpp"

namespace taut::testing {
using namespace internal;
namespace {

constexpr std::size_t fixed_header = 8 + 32 + 1 + 1;

std::uint32_t u32(const std::string& s, std::size_t at) {
  std::uint32_t x = 0;
  for (std::size_t i = 0; i < 4; ++i)
    x |= static_cast<std::uint32_t>(static_cast<std::uint8_t>(s.at(at + i))) << (8 * i);
  return x;
}

std::size_t record_size(std::uint8_t kind) {
  switch (static_cast<proof::Record>(kind)) {
    case proof::Record::next_segment:
    case proof::Record::free:
      return 1;
    case proof::Record::free_until:
    case proof::Record::touching:
      return 9;
    default:
      return 13;
  }
}

}  // namespace

LogParts take_apart(const std::string& log, std::uint32_t vertices) {
  std::size_t at = fixed_header;
  const std::uint32_t halfedges = u32(log, at);
  at += 4 + 4 * (halfedges - 2 * static_cast<std::size_t>(vertices)) + 4 * static_cast<std::size_t>(halfedges);
  at += 4 + 4 * static_cast<std::size_t>(u32(log, at));
  LogParts parts;
  parts.header = log.substr(0, at);
  while (at < log.size() - 8) {
    const std::size_t size = record_size(static_cast<std::uint8_t>(log.at(at)));
    parts.records.push_back(log.substr(at, size));
    at += size;
  }
  if (at != log.size() - 8) throw std::runtime_error("a log that ends within a record");
  return parts;
}

std::string sealed(const std::string& bytes) {
  proof::Checksum sum;
  for (const char c : bytes) sum.add(static_cast<std::uint8_t>(c));
  std::string log = bytes;
  for (int i = 0; i < 8; ++i) log.push_back(static_cast<char>(sum.value() >> (8 * i)));
  return log;
}

std::string put_together(const LogParts& parts) {
  std::string bytes = parts.header;
  for (const std::string& record : parts.records) bytes += record;
  return sealed(bytes);
}

Proved prove_in_memory(const Scene& scene, Touch touch, std::uint64_t max_events) {
  CheckOptions options;
  options.touch = touch;
  options.max_events = max_events;
  options.engine = EngineChoice::kinetic;
  std::ostringstream out;
  Proved p;
  p.answer = prove(scene, out, options);
  p.log = out.str();
  return p;
}

}  // namespace taut::testing
