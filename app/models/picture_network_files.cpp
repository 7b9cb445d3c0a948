#include "app/models/picture_network_files.h"

#include "app/models/networks.h"

#include <string_view>
#include <utility>

namespace touchline {

Result<PictureNetworkFiles> read_picture_networks() {
    using Bytes = std::vector<std::byte>;
    constexpr std::pair<std::string_view, Bytes PictureNetworkFiles::*> places[] = {
        {"figure", &PictureNetworkFiles::figure},
        {"nanodet", &PictureNetworkFiles::names},
        {"blazeface", &PictureNetworkFiles::faces},
        {"facemesh", &PictureNetworkFiles::meshes},
        {"selfie", &PictureNetworkFiles::persons}};
    PictureNetworkFiles files;
    for (const auto& [name, place] : places) {
        const Network& network = *network_named(name);
        if (!network.ships && !is_installed(network)) continue;
        auto bytes = read_network(network);
        if (!bytes) return tl::unexpected(bytes.error());
        files.*place = std::move(*bytes);
    }
    return files;
}

}  // namespace touchline
