// Any bytes that a house has signed give one line, or a bundle that is exactly what this program
// would have written.
#include "app/house/bundle.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace touchline;
    const SecretKey secret;
    const auto covered = std::as_bytes(std::span(data, size));
    const std::string top = "Touchline bundle\n" + signature_text(covered, secret);
    const auto top_bytes = std::as_bytes(std::span(top));
    std::vector<std::byte> bytes(top_bytes.begin(), top_bytes.end());
    bytes.insert(bytes.end(), covered.begin(), covered.end());
    const auto bundle = bundle_in(bytes, public_key_of(secret), "a");
    if (!bundle) {
        if (bundle.error().line.find('\n') != std::string::npos) abort();
        return 0;
    }
    const auto back = signed_bundle(*bundle, secret);
    if (!back || !std::ranges::equal(*back, bytes)) abort();
    return 0;
}
