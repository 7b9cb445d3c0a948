#include "app/house/seen.h"

#include "app/documents/decode/files.h"
#include "app/house/signing.h"

#include <span>

namespace touchline {
namespace {

std::string sum_of(const Pack& pack) {
    std::string sums;
    for (const PackFile& file : pack.files) sums += sha256_text(file.bytes) + file.name + '\n';
    return sha256_text(std::as_bytes(std::span(sums)));
}

}  // namespace

SeenThing seen_pack(const std::string& name, const PackResult<Pack>& pack) {
    return {HouseRoot::packs, name, pack ? sum_of(*pack) : std::string()};
}

SeenThing see(const HousePlaces& places, HouseRoot root, const std::string& name) {
    const std::string path = (places.folder_of(root) / name).string();
    if (root == HouseRoot::packs) return seen_pack(name, read_pack(path));
    const auto bytes = read_file(path);
    return {root, name, bytes ? sha256_text(*bytes) : std::string()};
}

bool is_as_seen(const HousePlaces& places, const SeenThing& thing) {
    return see(places, thing.root, thing.name).sum == thing.sum;
}

}  // namespace touchline
