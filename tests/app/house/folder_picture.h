// All files below a folder, by path and content, so that a test sees what has changed.
// Threads: waits for the disk.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

namespace touchline {

using FolderPicture = std::map<std::string, std::string>;

/// Leaves out what begins with a dot, the lock, and the copy of the last good settings: they are
/// nobody's to see.
[[nodiscard]] inline FolderPicture picture_of_folder(const std::filesystem::path& folder) {
    namespace fs = std::filesystem;
    FolderPicture picture;
    std::error_code error;
    fs::recursive_directory_iterator it(folder, error);
    for (const fs::recursive_directory_iterator end; it != end; it.increment(error)) {
        const std::string name = it->path().filename().string();
        if (name.starts_with('.')) it.disable_recursion_pending();
        if (name.starts_with('.') || name == "lock" || name.ends_with(".good")) continue;
        if (!it->is_regular_file(error)) continue;
        std::ifstream file(it->path(), std::ios::binary);
        picture[it->path().lexically_relative(folder).string()] =
            std::string(std::istreambuf_iterator<char>(file), {});
    }
    return picture;
}

}  // namespace touchline
