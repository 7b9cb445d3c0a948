// A folder for temporary files that goes with its owner. Threads: one at a time.
#pragma once

#include "config/types/pinned.h"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace touchline {

class OwnFolder : private Pinned {
  public:
    /// Makes a folder that nobody else has, in the system's for temporary files.
    OwnFolder() : OwnFolder(temporary_folder()) {}

    /// The same in `parent`.
    explicit OwnFolder(const std::filesystem::path& parent) {
        std::string pattern = (parent / "touchline-XXXXXX").string();
        if (!parent.empty() && ::mkdtemp(pattern.data()) != nullptr) path_ = pattern;
    }

    ~OwnFolder() {
        std::error_code error;
        if (is_there()) std::filesystem::remove_all(path_, error);
    }

    /// False if none could be made: the disk is full, or its rights forbid it.
    [[nodiscard]] bool is_there() const { return !path_.empty(); }

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    /// Empty if the system has none.
    static std::filesystem::path temporary_folder() {
        std::error_code error;
        return std::filesystem::temp_directory_path(error);
    }

    std::filesystem::path path_;
};

}  // namespace touchline
