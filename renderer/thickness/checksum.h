// A 64-bit cyclic redundancy check: finds every flipped bit, every burst of up to 64 bits, and
// misses any other change once in 2^64.  Against accidents, not against malice.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace renderer::thickness {

/// CRC-64/XZ (polynomial of ECMA-182, reflected): of "123456789" it is 0x995dc9bbdf1939fa.
/// `before` continues a check: checksum(b, checksum(a)) is that of a followed by b.
std::uint64_t checksum(std::span<const std::byte> bytes, std::uint64_t before = 0);

} // namespace renderer::thickness
