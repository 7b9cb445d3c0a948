#include "app/house/house_keys.h"

#include "app/documents/decode/files.h"
#include "app/documents/decode/one_line.h"
#include "app/documents/sticks/listing.h"
#include "app/operator/private_files.h"
#include "app/operator/settings_files.h"

#include <system_error>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr const char* public_name = "house.touchline-key";
constexpr const char* secret_name = "secret-key";
constexpr std::size_t most_secret_bytes = 512;

tl::unexpected<BundleError> disk_failure(const Error& error) {
    return bundle_failure(BundleFault::disk, error.line);
}

}  // namespace

BundleResult<PublicKey> read_house_key(const HousePlaces& places) {
    const fs::path file = places.house / public_name;
    std::error_code error;
    if (!fs::exists(file, error))
        return bundle_failure(BundleFault::no_key,
                              "this kiosk knows no key of a house; install it with 'touchline "
                              "bundle key FILE'");
    const auto bytes = read_file(file.string());
    if (!bytes) return disk_failure(bytes.error());
    return house_key_in(*bytes, file.string());
}

BundleResult<SecretKey> read_secret_key(const HousePlaces& places) {
    const fs::path file = places.house / secret_name;
    std::error_code error;
    if (!is_there(file))
        return bundle_failure(
            BundleFault::no_secret_key,
            fs::exists(places.house / public_name, error)
                ? "this kiosk takes bundles and cannot sign them; make them on the first kiosk, or "
                  "if that is gone remove the folder 'house' on all kiosks and begin anew"
                : "this kiosk cannot sign for a house; make its key with 'touchline bundle key'");
    const auto text = read_private(file, most_secret_bytes);
    if (!text) return disk_failure(text.error());
    const auto secret = secret_key_in(*text);
    if (!secret)
        return bundle_failure(BundleFault::disk,
                              one_line(file.string()) +
                                  ": is no secret key; bring it back from a copy, or remove it");
    return *secret;
}

BundleResult<PublicKey> make_house_key(const HousePlaces& places) {
    auto secret = read_secret_key(places);
    if (!secret && secret.error().fault != BundleFault::no_secret_key)
        return tl::unexpected(secret.error());
    if (!secret) {
        // Whoever makes a key of its own here would no longer take the bundles of its house.
        if (const auto trusted = read_house_key(places);
            trusted || trusted.error().fault != BundleFault::no_key)
            return trusted;
        secret = new_secret_key();
        const auto kept = write_private(places.house / secret_name, key_text(*secret));
        if (!kept) return disk_failure(kept.error());
    }
    const PublicKey key = public_key_of(*secret);
    return trust_house_key(places, key).map([&key] { return key; });
}

BundleResult<PublicKey> house_key_in(std::span<const std::byte> bytes, const std::string& name) {
    const auto key =
        bytes.size() <= most_house_key_bytes ? public_key_in(as_text(bytes)) : std::nullopt;
    if (key) return *key;
    return bundle_failure(BundleFault::no_key_file,
                          one_line(name) + ": holds no key of a house; copy it here again");
}

BundleResult<void> trust_house_key(const HousePlaces& places, const PublicKey& key) {
    const auto secret = read_secret_key(places);
    if (!secret && secret.error().fault != BundleFault::no_secret_key)
        return tl::unexpected(secret.error());
    const bool signs_otherwise = secret && public_key_of(*secret) != key;
    if (signs_otherwise)
        return bundle_failure(BundleFault::has_key,
                              "this kiosk signs bundles with another key; install the key on the "
                              "other kiosks only");
    const auto kept = keep_text(places.house / public_name, key_text(key));
    if (!kept) return disk_failure(kept.error());
    return {};
}

}  // namespace touchline
