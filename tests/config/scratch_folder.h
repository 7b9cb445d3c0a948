// A folder of its own for a test, removed with its owner. Threads: one.
#pragma once

#include "config/types/pinned.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace touchline {

class ScratchFolder : Pinned {
  public:
    explicit ScratchFolder(
        const std::filesystem::path& parent = std::filesystem::temp_directory_path()) {
        std::string pattern = (parent / "touchline-XXXXXX").string();
        path_ = ::mkdtemp(pattern.data());
    }

    ~ScratchFolder() {
        std::error_code error;
        std::filesystem::remove_all(path_, error);
    }

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    [[nodiscard]] std::string path_of(const std::string& name) const {
        return (path_ / name).string();
    }

    /// Makes the folders above the file too. Returns its path.
    std::string write(const std::string& name, std::string_view bytes) const {
        const std::filesystem::path file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << bytes;
        return file.string();
    }

  private:
    std::filesystem::path path_;
};

}  // namespace touchline
