// A folder that stands for a stick; it is removed with its owner. Threads: one.
#pragma once

#include "app/isolation/process/descriptor.h"
#include "config/types/pinned.h"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <unistd.h>

namespace touchline {

class StickFolder : private Pinned {
  public:
    explicit StickFolder(
        const std::filesystem::path& parent = std::filesystem::temp_directory_path()) {
        std::string pattern = (parent / "stick-XXXXXX").string();
        path_ = ::mkdtemp(pattern.data());
        std::filesystem::permissions(path_, std::filesystem::perms(0755));
    }

    ~StickFolder() { std::filesystem::remove_all(path_); }

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    [[nodiscard]] std::string root() const { return path_.string(); }

    [[nodiscard]] Descriptor open() const {
        return Descriptor(::open(path_.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    }

    void folder(const std::string& name) const {
        std::filesystem::create_directories(path_ / name);
    }

    void file(const std::string& name, std::string_view bytes = "x") const {
        std::ofstream(path_ / name, std::ios::binary) << bytes;
    }

    /// Quickly makes `count` empty files "NAME0.png" ...
    void files(const std::string& name, std::size_t count) const {
        const Descriptor here = open();
        for (std::size_t i = 0; i < count; ++i) {
            const std::string one = name + std::to_string(i) + ".png";
            (void)Descriptor(::openat(here.number(), one.c_str(), O_CREAT | O_WRONLY, 0644));
        }
    }

  private:
    std::filesystem::path path_;
};

}  // namespace touchline
