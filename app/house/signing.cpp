#include "app/house/signing.h"

#include "app/documents/decode/one_line.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>
#include <sodium.h>

namespace touchline {
namespace {

// minisign: two letters for the way of signing, the key's number, then the key or the signature.
// "ED" signs the BLAKE2b of the bytes, "Ed" the bytes themselves; keys are "Ed".
constexpr std::string_view way_of_keys = "Ed";
constexpr std::string_view way_of_signatures = "ED";
constexpr std::string_view comment_mark = "untrusted comment: ";
constexpr std::string_view signed_comment_mark = "trusted comment: ";
constexpr std::string_view signed_comment = "a bundle of Touchline";
constexpr std::string_view secret_comment =
    "the secret key of a house of Touchline: show it to nobody";
constexpr std::size_t longest_comment = 1024;

using Signature = std::array<std::uint8_t, crypto_sign_BYTES>;

static_assert(crypto_sign_PUBLICKEYBYTES == 32 && crypto_sign_SEEDBYTES == 32);

const auto* octets(std::span<const std::byte> bytes) {
    return reinterpret_cast<const unsigned char*>(bytes.data());
}

/// Every call of the library for a key, a signature or a hash comes after this.
void start_sodium() {
    if (sodium_init() < 0) std::abort();  // the system gives no random bytes: a broken installation
}

std::string base64_of(std::span<const std::uint8_t> bytes) {
    std::string text(sodium_base64_encoded_len(bytes.size(), sodium_base64_VARIANT_ORIGINAL), '\0');
    sodium_bin2base64(text.data(), text.size(), bytes.data(), bytes.size(),
                      sodium_base64_VARIANT_ORIGINAL);
    text.pop_back();  // its zero
    return text;
}

/// Nothing unless the text is exactly this many bytes.
template <std::size_t count>
std::optional<std::array<std::uint8_t, count>> bytes_in(std::string_view text) {
    std::array<std::uint8_t, count> bytes{};
    std::size_t got = 0;
    const bool is_whole =
        sodium_base642bin(bytes.data(), bytes.size(), text.data(), text.size(), nullptr, &got,
                          nullptr, sodium_base64_VARIANT_ORIGINAL) == 0;
    // The library takes some bytes beyond ASCII for '+' and '/'; one text, and no other, is right.
    const bool is_only = is_whole && got == count && base64_of(bytes) == text;
    return is_only ? std::optional(bytes) : std::nullopt;
}

/// Way, number and what is theirs, in one line.
template <std::size_t count>
std::string record_text(std::string_view way, const KeyNumber& number,
                        const std::array<std::uint8_t, count>& rest) {
    std::array<std::uint8_t, 2 + sizeof(KeyNumber) + count> record{};
    std::ranges::copy(way, record.begin());
    std::ranges::copy(number, record.begin() + 2);
    std::ranges::copy(rest, record.begin() + 2 + sizeof(KeyNumber));
    std::string text = base64_of(record);
    sodium_memzero(record.data(), record.size());
    return text;
}

template <std::size_t count>
struct Record {
    KeyNumber number{};
    std::array<std::uint8_t, count> rest{};
};

template <std::size_t count>
std::optional<Record<count>> record_in(std::string_view way, std::string_view text) {
    auto bytes = bytes_in<2 + sizeof(KeyNumber) + count>(text);
    if (!bytes || !std::equal(way.begin(), way.end(), bytes->begin())) return std::nullopt;
    Record<count> record;
    std::copy_n(bytes->begin() + 2, record.number.size(), record.number.begin());
    std::copy_n(bytes->begin() + 2 + sizeof(KeyNumber), count, record.rest.begin());
    sodium_memzero(bytes->data(), bytes->size());
    return record;
}

/// Takes the next line out of the text; nothing if it does not end.
std::optional<std::string_view> take_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return std::nullopt;
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);  // a file that went through Windows
    return line;
}

/// The second of two lines, the first of which is a comment.
std::optional<std::string_view> commented_line(std::string_view& text) {
    const auto comment = take_line(text);
    if (!comment || !comment->starts_with(comment_mark) || comment->size() > longest_comment)
        return std::nullopt;
    return take_line(text);
}

std::string with_comment(std::string_view comment, const std::string& line) {
    return fmt::format("{}{}\n{}\n", comment_mark, comment, line);
}

std::array<std::uint8_t, crypto_generichash_BYTES_MAX> blake2b_of(std::span<const std::byte> all) {
    start_sodium();
    std::array<std::uint8_t, crypto_generichash_BYTES_MAX> hash{};
    crypto_generichash(hash.data(), hash.size(), octets(all), all.size(), nullptr, 0);
    return hash;
}

/// What the second signature signs: the first one, and the comment behind it.
std::vector<std::uint8_t> with_signature(const Signature& signature, std::string_view comment) {
    std::vector<std::uint8_t> both(signature.begin(), signature.end());
    both.insert(both.end(), comment.begin(), comment.end());
    return both;
}

Signature signed_by(const std::array<std::uint8_t, crypto_sign_SECRETKEYBYTES>& secret,
                    std::span<const std::uint8_t> bytes) {
    Signature signature{};
    crypto_sign_detached(signature.data(), nullptr, bytes.data(), bytes.size(), secret.data());
    return signature;
}

bool is_signed(std::span<const std::uint8_t> bytes, const Signature& signature,
               const PublicKey& key) {
    return crypto_sign_verify_detached(signature.data(), bytes.data(), bytes.size(),
                                       key.key.data()) == 0;
}

}  // namespace

SecretKey::~SecretKey() {
    sodium_memzero(seed.data(), seed.size());
}

SecretKey new_secret_key() {
    start_sodium();
    SecretKey secret;
    randombytes_buf(secret.number.data(), secret.number.size());
    randombytes_buf(secret.seed.data(), secret.seed.size());
    return secret;
}

PublicKey public_key_of(const SecretKey& secret) {
    start_sodium();
    PublicKey key{secret.number, {}};
    std::array<std::uint8_t, crypto_sign_SECRETKEYBYTES> whole{};
    crypto_sign_seed_keypair(key.key.data(), whole.data(), secret.seed.data());
    sodium_memzero(whole.data(), whole.size());
    return key;
}

std::string key_text(const PublicKey& key) {
    return with_comment("the key of a house of Touchline, " + fingerprint_of(key),
                        record_text(way_of_keys, key.number, key.key));
}

std::optional<PublicKey> public_key_in(std::string_view text) {
    const auto line = commented_line(text);
    if (!line || !text.empty()) return std::nullopt;
    const auto record = record_in<sizeof(PublicKey::key)>(way_of_keys, *line);
    return record ? std::optional(PublicKey{record->number, record->rest}) : std::nullopt;
}

std::string key_text(const SecretKey& secret) {
    return with_comment(secret_comment, record_text(way_of_keys, secret.number, secret.seed));
}

std::optional<SecretKey> secret_key_in(std::string_view text) {
    if (!text.starts_with(fmt::format("{}{}\n", comment_mark, secret_comment))) return std::nullopt;
    const auto line = commented_line(text);
    if (!line || !text.empty()) return std::nullopt;
    const auto record = record_in<sizeof(SecretKey::seed)>(way_of_keys, *line);
    if (!record) return std::nullopt;
    SecretKey secret;
    secret.number = record->number;
    secret.seed = record->rest;
    return secret;
}

std::string fingerprint_of(const PublicKey& key) {
    constexpr std::uint32_t groups_of = 10'000;
    std::array<std::uint8_t, sizeof(KeyNumber) + sizeof(PublicKey::key)> whole{};
    std::ranges::copy(key.number, whole.begin());
    std::ranges::copy(key.key, whole.begin() + sizeof(KeyNumber));
    const auto hash = blake2b_of(std::as_bytes(std::span(whole)));
    std::string text;
    for (std::size_t group = 0; group < 6; ++group) {
        std::uint32_t number = 0;
        std::memcpy(&number, &hash[group * sizeof number], sizeof number);
        text += fmt::format("{}{:04}", group == 0 ? "" : " ", number % groups_of);
    }
    return text;
}

std::string sha256_text(std::span<const std::byte> bytes) {
    start_sodium();
    std::array<unsigned char, crypto_hash_sha256_BYTES> hash{};
    crypto_hash_sha256(hash.data(), octets(bytes), bytes.size());
    std::string text;
    for (const unsigned char byte : hash) text += fmt::format("{:02x}", byte);
    return text;
}

std::string signature_text(std::span<const std::byte> bytes, const SecretKey& secret) {
    start_sodium();
    PublicKey key;
    std::array<std::uint8_t, crypto_sign_SECRETKEYBYTES> whole{};
    crypto_sign_seed_keypair(key.key.data(), whole.data(), secret.seed.data());
    const Signature signature = signed_by(whole, blake2b_of(bytes));
    const Signature second = signed_by(whole, with_signature(signature, signed_comment));
    sodium_memzero(whole.data(), whole.size());
    return with_comment("signature of a bundle of Touchline",
                        record_text(way_of_signatures, secret.number, signature)) +
           fmt::format("{}{}\n{}\n", signed_comment_mark, signed_comment, base64_of(second));
}

SignatureState state_of(std::string_view text, std::span<const std::byte> bytes,
                        const PublicKey& key) {
    start_sodium();
    const auto line = commented_line(text);
    const auto record =
        line ? record_in<crypto_sign_BYTES>(way_of_signatures, *line) : std::nullopt;
    const auto comment = take_line(text);
    const auto second_line = take_line(text);
    const auto second = second_line ? bytes_in<crypto_sign_BYTES>(*second_line) : std::nullopt;
    if (!record || !second || !text.empty() || !comment->starts_with(signed_comment_mark) ||
        comment->size() > longest_comment)
        return SignatureState::unreadable;
    if (record->number != key.number) return SignatureState::other_key;
    const auto about = with_signature(record->rest, comment->substr(signed_comment_mark.size()));
    const bool is_good =
        is_signed(blake2b_of(bytes), record->rest, key) && is_signed(about, *second, key);
    return is_good ? SignatureState::good : SignatureState::broken;
}

}  // namespace touchline
