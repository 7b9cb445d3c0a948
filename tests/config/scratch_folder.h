// A folder of its own for a test, removed with its owner. Threads: one.
#pragma once

#include "app/isolation/process/own_folder.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace touchline {

/// Returns a folder in memory where there is one, for tests that write hundreds of times and wait
/// for each: on a disk a write is only done once it lies there.
[[nodiscard]] inline std::filesystem::path fast_folder() {
    return std::filesystem::exists("/dev/shm") ? std::filesystem::path("/dev/shm")
                                               : std::filesystem::temp_directory_path();
}

class ScratchFolder : public OwnFolder {
  public:
    using OwnFolder::OwnFolder;

    [[nodiscard]] std::string path_of(const std::string& name) const {
        return (path() / name).string();
    }

    /// Makes the folders above the file too. Returns its path.
    std::string write(const std::string& name, std::string_view bytes) const {
        const std::filesystem::path file = path() / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << bytes;
        return file.string();
    }
};

}  // namespace touchline
