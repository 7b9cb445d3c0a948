// The networks that look at a photograph, read from where they are installed.
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

    /// They stay where they are.
    [[nodiscard]] PictureNetworks networks() const {
        return {figure, names, faces, meshes, persons};
    }
};

/// Fails, with one line that says what to do, where one that ships is absent, or any is damaged.
/// 0.3 s.
[[nodiscard]] Result<PictureNetworkFiles> read_picture_networks();

}  // namespace touchline
