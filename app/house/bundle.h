// A bundle: what several kiosks of one house have alike, in one file that the house has signed.
//
//     Touchline bundle                                     one line
//     untrusted comment: ... to the second signature       four lines, as minisign writes them
//     format 1, program VERSION, made SECONDS              three lines; from here on all is signed
//     file PART NAME BYTES SHA-256                         a line for each file
//     end                                                  then the files, one after the other
//
// Nothing behind the signature is looked at before it was found to be good.
// Threads: values and pure functions.
#pragma once

#include "app/documents/decode/files.h"
#include "app/house/signing.h"
#include "config/types/result.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace touchline {

class Language;

/// Why a bundle or a key is not taken, or cannot be made.
enum class BundleFault : std::uint8_t {
    no_key,           // this kiosk knows no key of a house
    no_secret_key,    // this kiosk cannot sign for the house
    has_key,          // this kiosk makes bundles with another key
    no_bundle,        // the file is none
    no_key_file,      // the file holds no key
    damaged,          // it, or its signature, was changed or cut off
    other_key,        // of another house
    newer_program,    // it needs a newer Touchline
    older,            // a newer one was applied here
    bad_contents,     // it is sound, but holds what no kiosk can use
    older_pack,       // this kiosk has a newer version of a pack
    too_large,        // more than a bundle may hold
    disk,             // something cannot be read or written here
    nothing_to_undo,  // no bundle was applied, or what was before is gone
    changed_since,    // the kiosk is not any more as it was when the bundle was looked at
};

inline constexpr int bundle_fault_count = 15;

struct BundleError {
    BundleFault fault = BundleFault::damaged;
    std::string line;  // of English, with names of files: for a terminal and a log
};

template <class T>
using BundleResult = Result<T, BundleError>;

[[nodiscard]] inline tl::unexpected<BundleError> bundle_failure(BundleFault fault,
                                                                std::string line) {
    return tl::unexpected<BundleError>(BundleError{fault, std::move(line)});
}

/// One or two sentences for the operator: what is wrong, and what to do.
[[nodiscard]] std::string sentence_of(BundleFault fault, const Language& language);

/// settings: TOML. profile: TOML. pack: a zip file. network: one that Touchline knows.
enum class BundlePart : std::uint8_t { settings, profile, pack, network };

struct BundleFile {
    BundlePart part = BundlePart::settings;
    std::string name;                       // small letters, digits and "-"; at most 60
    std::span<const std::byte> bytes = {};  // somebody else's
};

struct Bundle {
    std::string program;            // the version of Touchline that made it
    std::int64_t made_s = 0;        // since 1970; a later bundle of a house has a larger number
    std::vector<BundleFile> files;  // by part, then by name; no two are the same
};

inline constexpr std::size_t most_bundle_bytes = max_file_bytes;
inline constexpr std::size_t most_bundle_files = 200;

/// Fails if it is larger than a bundle may be. O(bytes).
[[nodiscard]] BundleResult<std::vector<std::byte>> signed_bundle(Bundle bundle,
                                                                 const SecretKey& secret);

/// The bundle in these bytes, which its files share; they may be any. `name` is the file's, for the
/// line. Fails unless `key` signed them and they are exactly what signed_bundle() writes.
/// O(bytes).
[[nodiscard]] BundleResult<Bundle> bundle_in(std::span<const std::byte> bytes, const PublicKey& key,
                                             const std::string& name);

}  // namespace touchline
