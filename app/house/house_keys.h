// The keys that a kiosk keeps: the one of its house, which it trusts, and on the kiosk that makes
// bundles the secret one. Threads: any, each call by itself; calls wait for the disk.
#pragma once

#include "app/house/bundle.h"
#include "app/house/places.h"

#include <span>
#include <string>

namespace touchline {

/// The key that this kiosk trusts; fails with `no_key` if there is none.
[[nodiscard]] BundleResult<PublicKey> read_house_key(const HousePlaces& places);

/// Fails with `no_secret_key` on a kiosk that does not make bundles.
[[nodiscard]] BundleResult<SecretKey> read_secret_key(const HousePlaces& places);

/// The key that this kiosk trusts; where there is none, makes one and the secret one with it. So
/// only the first kiosk of a house makes a key.
[[nodiscard]] BundleResult<PublicKey> make_house_key(const HousePlaces& places);

/// The key in the bytes of a file, which may be any. `name` is the file's, for the line.
[[nodiscard]] BundleResult<PublicKey> house_key_in(std::span<const std::byte> bytes,
                                                   const std::string& name);

/// Trusts this key, and no other, from now on. A person must have compared its fingerprint. Fails
/// with `has_key` on a kiosk that signs with another one.
[[nodiscard]] BundleResult<void> trust_house_key(const HousePlaces& places, const PublicKey& key);

}  // namespace touchline
