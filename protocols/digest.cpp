// The one door to OpenSSL's libcrypto.
#include "protocols/digest.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <stdexcept>

namespace protocols {

Digest sha256(std::span<const std::byte> bytes) {
    Digest digest;
    unsigned length = 0;
    const auto done =
        EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr);
    if (done != 1 || length != digest.size())
        throw std::runtime_error("libcrypto cannot compute SHA-256 on this machine");
    return digest;
}

Digest sha256(std::string_view text) {
    return sha256(std::as_bytes(std::span(text)));
}

std::string hexadecimal(std::span<const std::uint8_t> bytes) {
    std::string text;
    text.reserve(2 * bytes.size());
    for (const auto byte : bytes)
        fmt::format_to(std::back_inserter(text), "{:02x}", byte);
    return text;
}

std::string sha256_hexadecimal(std::string_view text) {
    return hexadecimal(sha256(text));
}

} // namespace protocols
