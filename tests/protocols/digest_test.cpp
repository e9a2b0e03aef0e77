#include "protocols/digest.h"

namespace {

using namespace protocols;

// FIPS 180-4 examples of NIST, and the empty message.
TEST(Sha256, GivesThePublishedDigests) {
    EXPECT_EQ(hexadecimal(sha256("")),
              "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(hexadecimal(sha256("abc")),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(hexadecimal(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(hexadecimal(sha256(std::string(1000000, 'a'))),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, OfATextIsWrittenInHexadecimalDigits) {
    EXPECT_EQ(sha256_hexadecimal("abc"), hexadecimal(sha256("abc")));
}

TEST(Sha256, ReadsPastAZeroByte) {
    using namespace std::string_view_literals;
    EXPECT_NE(sha256("a\0b"sv), sha256("a\0c"sv));
}

TEST(Sha256, OfBytesAndOfTextAgree) {
    const std::array<std::byte, 3> bytes{std::byte{'a'}, std::byte{'b'}, std::byte{'c'}};
    EXPECT_EQ(sha256(bytes), sha256("abc"));
}

TEST(Hexadecimal, KeepsLeadingZeros) {
    const std::array<std::uint8_t, 3> bytes{0, 10, 255};
    EXPECT_EQ(hexadecimal(bytes), "000aff");
}

} // namespace
