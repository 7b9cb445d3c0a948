// A folder that stands for a stick. Threads: one.
#pragma once

#include "app/isolation/process/descriptor.h"
#include "tests/config/scratch_folder.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <unistd.h>

namespace touchline {

class StickFolder : public ScratchFolder {
  public:
    explicit StickFolder(
        const std::filesystem::path& parent = std::filesystem::temp_directory_path())
        : ScratchFolder(parent) {
        std::filesystem::permissions(path(), std::filesystem::perms(0755));
    }

    [[nodiscard]] std::string root() const { return path().string(); }

    [[nodiscard]] Descriptor open() const {
        return Descriptor(::open(path().c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    }

    void folder(const std::string& name) const {
        std::filesystem::create_directories(path() / name);
    }

    void file(const std::string& name, std::string_view bytes = "x") const { write(name, bytes); }

    /// Quickly makes `count` empty files "NAME0.png" ...
    void files(const std::string& name, std::size_t count) const {
        const Descriptor here = open();
        for (std::size_t i = 0; i < count; ++i) {
            const std::string one = name + std::to_string(i) + ".png";
            (void)Descriptor(::openat(here.number(), one.c_str(), O_CREAT | O_WRONLY, 0644));
        }
    }
};

}  // namespace touchline
