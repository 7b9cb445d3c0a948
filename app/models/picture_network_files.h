// Reads the installed networks that look at a photograph.
// Threads: any, each call by itself.
#pragma once

#include "app/trace/picture_networks.h"
#include "config/types/result.h"

#include <cstddef>
#include <vector>

namespace touchline {

struct PictureNetworkFiles {
    std::vector<std::byte> figure;  // empty: not installed
    std::vector<std::byte> names;
    std::vector<std::byte> faces;
    std::vector<std::byte> meshes;
    std::vector<std::byte> persons;

    /// The bytes stay in this object.
    [[nodiscard]] PictureNetworks networks() const {
        return {figure, names, faces, meshes, persons};
    }
};

/// Fails with one line that says what to do if one that ships is missing, or any is damaged. Takes
/// 0.3 s.
[[nodiscard]] Result<PictureNetworkFiles> read_picture_networks();

}  // namespace touchline
