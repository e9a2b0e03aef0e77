// Eight bytes at a time by eight tables, each one byte's step further than the one before.
#include "renderer/thickness/checksum.h"

#include <array>

namespace renderer::thickness {

namespace {

constexpr std::uint64_t reflected_polynomial = 0xc96c5795d7870f42u;

using Tables = std::array<std::array<std::uint64_t, 256>, 8>;

constexpr Tables make_tables() {
    Tables tables{};
    for (std::size_t byte = 0; byte < 256; ++byte) {
        std::uint64_t remainder = byte;
        for (int bit = 0; bit < 8; ++bit)
            remainder = (remainder >> 1) ^ ((remainder & 1) != 0 ? reflected_polynomial : 0);
        tables[0][byte] = remainder;
    }
    for (std::size_t step = 1; step < 8; ++step)
        for (std::size_t byte = 0; byte < 256; ++byte) {
            const std::uint64_t before = tables[step - 1][byte];
            tables[step][byte] = (before >> 8) ^ tables[0][before & 0xff];
        }
    return tables;
}

constexpr Tables tables = make_tables();

std::uint64_t eight_bytes(const std::byte* bytes) {
    std::uint64_t word = 0;
    for (int i = 7; i >= 0; --i)
        word = word << 8 | std::to_integer<std::uint64_t>(bytes[i]);
    return word;
}

} // namespace

std::uint64_t checksum(std::span<const std::byte> bytes, std::uint64_t before) {
    std::uint64_t remainder = ~before;
    for (; bytes.size() >= 8; bytes = bytes.subspan(8)) {
        const std::uint64_t word = remainder ^ eight_bytes(bytes.data());
        remainder = 0;
        for (std::size_t i = 0; i < 8; ++i)
            remainder ^= tables[7 - i][word >> (8 * i) & 0xff];
    }
    for (const std::byte byte : bytes)
        remainder =
            (remainder >> 8) ^ tables[0][(remainder ^ std::to_integer<std::uint64_t>(byte)) & 0xff];
    return ~remainder;
}

} // namespace renderer::thickness
