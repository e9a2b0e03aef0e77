#include "renderer/thickness/checksum.h"

#include <string_view>
#include <vector>

namespace {

using renderer::thickness::checksum;

std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text));
}

TEST(Checksum, OfTheNineDigitsIsThePublishedOne) {
    EXPECT_EQ(checksum(bytes_of("123456789")), 0x995dc9bbdf1939fau);
    EXPECT_EQ(checksum({}), 0u);
}

TEST(Checksum, ContinuesWhereItStopped) {
    const std::string_view text = "between a vertex and the light";
    for (std::size_t cut = 0; cut <= text.size(); ++cut)
        EXPECT_EQ(checksum(bytes_of(text.substr(cut)), checksum(bytes_of(text.substr(0, cut)))),
                  checksum(bytes_of(text)))
            << cut;
}

TEST(Checksum, FindsEveryFlippedBit) {
    std::vector<std::byte> bytes(100, std::byte{0x5a});
    const auto right = checksum(bytes);
    for (auto& byte : bytes)
        for (int bit = 0; bit < 8; ++bit) {
            byte ^= std::byte{1} << bit;
            EXPECT_NE(checksum(bytes), right);
            byte ^= std::byte{1} << bit;
        }
}

} // namespace
