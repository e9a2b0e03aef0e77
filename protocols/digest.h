// SHA-256: names seeds and files by what is in them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace protocols {

using Digest = std::array<std::uint8_t, 32>;

/// The digest of bytes, or of a text's bytes as they are.
Digest sha256(std::span<const std::byte> bytes);
Digest sha256(std::string_view text);

/// Two lower-case hexadecimal digits a byte.
std::string hexadecimal(std::span<const std::uint8_t> bytes);

/// SHA-256 of a text or of a file's bytes, as 64 hexadecimal digits.
std::string sha256_hexadecimal(std::string_view text);

} // namespace protocols
