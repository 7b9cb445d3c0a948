// Tests the file of a bundle: what is written, what is believed, and that nothing else is.
#include "app/house/bundle.h"

#include "app/documents/decode/one_line.h"
#include "audio-cues/words/language.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

using Bytes = std::vector<std::byte>;

SecretKey key_of(std::uint8_t first) {
    SecretKey secret;
    secret.number.fill(first);
    secret.seed.fill(first);
    return secret;
}

std::span<const std::byte> bytes_in(std::string_view text) {
    return std::as_bytes(std::span(text));
}

Bundle small_bundle() {
    return {"1.2.3",
            1796069692,
            {{BundlePart::settings, "kiosk", bytes_in("[feel]\nfriction = 0.2\n")},
             {BundlePart::profile, "school", bytes_in("[feel]\nfriction = 0.1\n")},
             {BundlePart::pack, "boats", bytes_in("a zip file")}}};
}

Bytes small_bytes() {
    auto bytes = signed_bundle(small_bundle(), key_of(1));
    EXPECT_TRUE(bytes.has_value());
    return bytes.value_or(Bytes{});
}

/// What the house never wrote, with its signature.
Bytes signed_text(const std::string& covered) {
    const std::string text =
        "Touchline bundle\n" + signature_text(bytes_in(covered), key_of(1)) + covered;
    const auto bytes = bytes_in(text);
    return {bytes.begin(), bytes.end()};
}

BundleResult<Bundle> read_with(const Bytes& bytes, const SecretKey& secret) {
    return bundle_in(bytes, public_key_of(secret), "x.touchline-bundle");
}

std::optional<BundleFault> fault_of(const Bytes& bytes) {
    const auto bundle = read_with(bytes, key_of(1));
    if (bundle) return std::nullopt;
    EXPECT_EQ(bundle.error().line.find('\n'), std::string::npos);
    EXPECT_TRUE(bundle.error().line.starts_with("x.touchline-bundle: ")) << bundle.error().line;
    return bundle.error().fault;
}

TEST(HouseKey, IsReadBackFromItsText) {
    const SecretKey secret = key_of(3);
    const PublicKey key = public_key_of(secret);
    EXPECT_EQ(public_key_in(key_text(key)), key);
    const auto again = secret_key_in(key_text(secret));
    ASSERT_TRUE(again.has_value());
    EXPECT_EQ(public_key_of(*again), key);
    EXPECT_FALSE(public_key_in(key_text(secret) + "\n").has_value());
    EXPECT_FALSE(secret_key_in(key_text(key)).has_value());
}

TEST(HouseKey, IsNewEachTimeAndToldByDigits) {
    const PublicKey one = public_key_of(new_secret_key());
    const PublicKey other = public_key_of(new_secret_key());
    EXPECT_NE(fingerprint_of(one), fingerprint_of(other));
    const std::string digits = fingerprint_of(one);
    EXPECT_EQ(digits.size(), 29U);
    EXPECT_EQ(std::ranges::count(digits, ' '), 5);
}

/// A key with another number checks no bundle of the house, so it has other digits too.
TEST(HouseKey, IsToldByItsNumberToo) {
    const PublicKey key = public_key_of(key_of(3));
    for (std::size_t at = 0; at < key.number.size(); ++at) {
        PublicKey other = key;
        other.number[at] ^= 1U;
        EXPECT_NE(fingerprint_of(other), fingerprint_of(key)) << at;
    }
}

TEST(HouseKey, OfAnyTextIsOneOrNone) {
    for (const char* text : {"", "\n", "untrusted comment: a\n", "untrusted comment: a\nRWQ=\n",
                             "RWQ\nRWQ\n", "untrusted comment: a\n\xff\xff\n"})
        EXPECT_FALSE(public_key_in(text).has_value()) << text;
}

/// A key and a signature that minisign 0.11 made (-G -W, -S).
TEST(Signature, OfMinisignIsGood) {
    const auto key = public_key_in(
        "untrusted comment: minisign public key 3826A94220A7FB3\n"
        "RWSzfwoilGqCA5qtnZdfSLL7kCfaG8W4QfzoMAZ1kLayxT7UoPthmmSv\n");
    ASSERT_TRUE(key.has_value());
    const std::string signature =
        "untrusted comment: signature from minisign secret key\n"
        "RUSzfwoilGqCA79F5dBT62jEABIc9gowknlKp5xuCnGK27wKBzSmGLh5pYhNC6pTj0JPNdJbpwqAJnJIlxUiUvAB5T"
        "OOliHhXwQ=\n"
        "trusted comment: made by hand\n"
        "Ca37V/"
        "TIM+uN3n084pEZStBRKiwd8nXJOmiTzOQUvo9rn22iRVp5+94Eyf37KvoVwhzebqYnEGOMjig9XyNnBA==\n";
    EXPECT_EQ(state_of(signature, bytes_in("a house of kiosks\n"), *key), SignatureState::good);
    EXPECT_EQ(state_of(signature, bytes_in("a house of kiosk\n"), *key), SignatureState::broken);
}

TEST(Bundle, IsReadBackAsItWasMade) {
    const Bytes bytes = small_bytes();
    const auto bundle = read_with(bytes, key_of(1));
    ASSERT_TRUE(bundle.has_value()) << bundle.error().line;
    EXPECT_EQ(bundle->program, "1.2.3");
    EXPECT_EQ(bundle->made_s, 1796069692);
    ASSERT_EQ(bundle->files.size(), 3U);
    EXPECT_EQ(bundle->files[2].name, "boats");
    EXPECT_EQ(as_text(bundle->files[2].bytes), "a zip file");
}

TEST(Bundle, OfAnotherHouseIsRefused) {
    const auto bundle = read_with(small_bytes(), key_of(2));
    ASSERT_FALSE(bundle.has_value());
    EXPECT_EQ(bundle.error().fault, BundleFault::other_key);
}

TEST(Bundle, WithAnyBitFlippedIsRefused) {
    const Bytes whole = small_bytes();
    const std::size_t comment_end = as_text(whole).find('\n', 17);
    for (std::size_t at = 0; at < whole.size(); ++at) {
        // The first comment of a signature of minisign is not signed, and means nothing.
        if (at >= std::string_view("Touchline bundle\nuntrusted comment: ").size() &&
            at < comment_end)
            continue;
        for (unsigned bit = 0; bit < 8; ++bit) {
            Bytes bytes = whole;
            bytes[at] ^= std::byte{1} << bit;
            EXPECT_TRUE(fault_of(bytes).has_value()) << at << ", bit " << bit;
        }
    }
}

TEST(Bundle, CutOffAnywhereIsRefused) {
    const Bytes whole = small_bytes();
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_TRUE(fault_of({whole.begin(), whole.begin() + static_cast<long>(size)}).has_value())
            << size;
    Bytes longer = whole;
    longer.push_back(std::byte{0});
    EXPECT_EQ(fault_of(longer), BundleFault::damaged);
}

TEST(Bundle, OfNoTouchlineIsNamedSo) {
    EXPECT_EQ(fault_of({}), BundleFault::no_bundle);
    EXPECT_EQ(fault_of(Bytes(300, std::byte{'P'})), BundleFault::no_bundle);
}

TEST(Bundle, OfALaterFormatAsksForANewerTouchline) {
    EXPECT_EQ(fault_of(signed_text("format 2\nanything\n")), BundleFault::newer_program);
}

/// Signed by the house, and yet not what this program writes: each is refused as a whole.
TEST(Bundle, ThatContradictsItselfIsRefused) {
    const std::string hash = sha256_text(bytes_in("ab"));
    const std::string head = "format 1\nprogram 1\nmade 5\n";
    EXPECT_EQ(fault_of(signed_text(head + "file pack a 2 " + hash + "\nend\nab")), std::nullopt);
    const std::vector<std::string> lies{
        head + "file pack a 3 " + hash + "\nend\nab",
        head + "file pack a 1 " + hash + "\nend\nab",
        head + "file pack a 2 " + hash + "\nend\nabc",
        head + "file pack a 2 " + hash + "\nend\nac",
        head + "file pack a 18446744073709551615 " + hash + "\nend\nab",
        head + "file pack a -2 " + hash + "\nend\nab",
        head + "file pack a 02 " + hash + "\nend\nab",
        head + "file pack a 0 " + hash + "\nend\n",
        head + "file pack ../a 2 " + hash + "\nend\nab",
        head + "file pack a/b 2 " + hash + "\nend\nab",
        head + "file pack .. 2 " + hash + "\nend\nab",
        head + "file pack A 2 " + hash + "\nend\nab",
        head + "file pack  2 " + hash + "\nend\nab",
        head + "file word a 2 " + hash + "\nend\nab",
        head + "file pack a 2 " + hash + "\nfile pack a 2 " + hash + "\nend\nabab",
        head + "file pack b 2 " + hash + "\nfile pack a 2 " + hash + "\nend\nabab",
        head + "file pack a 2 " + hash + "\nfile profile a 2 " + hash + "\nend\nabab",
        head + "file pack a 2 " + hash + " \nend\nab",
        head + "file pack a 2 " + hash + "\nab",
        "format 1\nprogram 1\nmade -5\nend\n",
        "format 1\nprogram 1\nmade 5 \nend\n",
        "format 1\nmade 5\nprogram 1\nend\n",
        "format 1\n",
    };
    for (const std::string& lie : lies)
        EXPECT_EQ(fault_of(signed_text(lie)), BundleFault::bad_contents) << lie;
}

TEST(Bundle, HoldsNoMoreThanItMay) {
    Bundle many{"1", 1, {}};
    for (std::size_t i = 0; i <= most_bundle_files; ++i)
        many.files.push_back({BundlePart::pack, "p" + std::to_string(i), bytes_in("a")});
    const auto bytes = signed_bundle(many, key_of(1));
    ASSERT_FALSE(bytes.has_value());
    EXPECT_EQ(bytes.error().fault, BundleFault::too_large);
}

TEST(Bundle, EachFaultHasASentence) {
    std::vector<std::string> sentences;
    for (int i = 0; i < bundle_fault_count; ++i)
        sentences.push_back(sentence_of(static_cast<BundleFault>(i), Language()));
    std::ranges::sort(sentences);
    EXPECT_EQ(std::ranges::adjacent_find(sentences), sentences.end());
}

/// Bytes of a bundle are changed, doubled and removed: it is refused, or it is what was signed.
RC_GTEST_PROP(Bundle, OfAnyBytesIsWhatWasSignedOrOneLine, ()) {
    std::string text(as_text(small_bytes()));
    const int changes = *rc::gen::inRange(1, 4);
    for (int i = 0; i < changes; ++i) {
        const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
        const int what = *rc::gen::inRange(0, 3);
        if (what == 0) text[at] = *rc::gen::arbitrary<char>();
        if (what == 1) text.erase(at, *rc::gen::inRange<std::size_t>(1, 40));
        if (what == 2) text.insert(at, text.substr(at, 20));
        if (text.empty()) return;
    }
    const auto bytes = bytes_in(text);
    const std::vector<std::byte> held(bytes.begin(), bytes.end());  // A bundle views its bytes.
    const auto bundle = read_with(held, key_of(1));
    if (bundle) RC_ASSERT(as_text(bundle->files.back().bytes) == "a zip file");
}

}  // namespace
}  // namespace touchline
