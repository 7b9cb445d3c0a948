// The key of a house, and its signatures under bundles: Ed25519 in the form of minisign, which can
// check one by hand. Threads: pure functions, except for new_secret_key(), which asks the system
// for random bytes.
#pragma once

#include "config/types/result.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// What tells keys apart in their files; chance alone makes it unique.
using KeyNumber = std::array<std::uint8_t, 8>;

struct PublicKey {
    KeyNumber number{};
    std::array<std::uint8_t, 32> key{};

    friend bool operator==(const PublicKey&, const PublicKey&) = default;
};

/// Whoever has it can sign for the house. It is wiped with its owner.
struct SecretKey {
    KeyNumber number{};
    std::array<std::uint8_t, 32> seed{};

    SecretKey() = default;
    SecretKey(const SecretKey&) = default;
    SecretKey& operator=(const SecretKey&) = default;
    ~SecretKey();
};

[[nodiscard]] SecretKey new_secret_key();

[[nodiscard]] PublicKey public_key_of(const SecretKey& secret);

/// Two lines, as minisign writes and reads them.
[[nodiscard]] std::string key_text(const PublicKey& key);

/// Nothing if the text is no public key of minisign.
[[nodiscard]] std::optional<PublicKey> public_key_in(std::string_view text);

/// Two lines, for a file that only the kiosk's user reads.
[[nodiscard]] std::string key_text(const SecretKey& secret);

/// Nothing if the text is no secret key of this program.
[[nodiscard]] std::optional<SecretKey> secret_key_in(std::string_view text);

/// Six groups of four digits, "4815 1623 ...", of number and key, by which two people make sure
/// that they mean the same key. Finding another key with the same digits takes 10^24 tries.
[[nodiscard]] std::string fingerprint_of(const PublicKey& key);

/// The SHA-256 of the bytes in 64 small hexadecimal digits. O(bytes).
[[nodiscard]] std::string sha256_text(std::span<const std::byte> bytes);

/// Four lines, as in a file of minisign. O(bytes).
[[nodiscard]] std::string signature_text(std::span<const std::byte> bytes, const SecretKey& secret);

/// What a signature was found to be. unreadable: no signature of minisign. other_key: of another
/// key. broken: not of these bytes.
enum class SignatureState : std::uint8_t { good, unreadable, other_key, broken };

/// `text`: four lines, of any bytes. O(bytes).
[[nodiscard]] SignatureState state_of(std::string_view text, std::span<const std::byte> bytes,
                                      const PublicKey& key);

/// The lines of a signature.
inline constexpr int signature_lines = 4;

}  // namespace touchline
