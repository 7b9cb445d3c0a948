#include "app/documents/decode/files.h"

#include "app/documents/decode/one_line.h"
#include "app/isolation/process/descriptor.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace touchline {
namespace {

tl::unexpected<Error> file_failure(const std::string& path, std::string_view what) {
    const std::string why = std::generic_category().message(errno);
    return failure(fmt::format("{}: {}: {}", one_line(path), what, why));
}

Result<void> write_straight(const std::string& path, std::span<const std::byte> bytes) {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (!file.is_open()) return file_failure(path, "cannot be opened for writing");
    if (!write_all(file, bytes)) return file_failure(path, "cannot be written");
    return {};
}

/// Makes a new file beside the target, named after it; puts its name into `temporary`.
int create_beside(const std::string& target, std::string& temporary) {
    constexpr int max_leftovers = 1000;  // left by runs that were killed while writing
    int descriptor = -1;
    for (int i = 0; i < max_leftovers && descriptor < 0; ++i) {
        temporary = fmt::format("{}.{}-{}.part", target, ::getpid(), i);
        descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor < 0 && errno != EEXIST) break;
    }
    return descriptor;
}

Result<void> write_beside_and_rename(const std::string& path, const std::string& target,
                                     std::span<const std::byte> bytes) {
    std::string temporary;
    Descriptor file(create_beside(target, temporary));
    if (!file.is_open()) return file_failure(path, "cannot be created; choose another folder");
    const bool is_whole = write_all(file, bytes) && ::fsync(file.number()) == 0 && file.close() &&
                          ::rename(temporary.c_str(), target.c_str()) == 0;
    if (!is_whole) {
        const auto error = file_failure(path, "cannot be written; is the disk full?");
        ::unlink(temporary.c_str());
        return error;
    }
    const auto folder = std::filesystem::path(target).parent_path();
    flush_folder(folder.empty() ? "." : folder);
    return {};
}

}  // namespace

Result<std::vector<std::byte>> read_file(const std::string& path) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.is_open()) return file_failure(path, "cannot be opened");
    FileStatus status{};
    if (::fstat(file.number(), &status) != 0) return file_failure(path, "cannot be read");
    if (S_ISDIR(status.st_mode)) {
        return failure(one_line(path) + ": is a folder; name a file in it");
    }
    const auto too_large = [&] {
        return failure(fmt::format("{}: is larger than {} MiB; make it smaller", one_line(path),
                                   max_file_bytes >> 20U));
    };
    if (status.st_size > static_cast<off_t>(max_file_bytes)) return too_large();

    // One byte more than the file's size, so that the end shows without growing. Pipes have size 0.
    std::vector<std::byte> bytes(static_cast<std::size_t>(status.st_size) + 1);
    std::size_t filled = 0;
    while (true) {
        const ssize_t got = ::read(file.number(), bytes.data() + filled, bytes.size() - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return file_failure(path, "cannot be read");
        if (got == 0) break;
        filled += static_cast<std::size_t>(got);
        if (filled > max_file_bytes) return too_large();
        if (filled == bytes.size()) bytes.resize(2 * bytes.size() + 4096);
    }
    bytes.resize(filled);
    return bytes;
}

Result<std::string> read_text(const std::string& path) {
    return read_file(path).map(
        [](const std::vector<std::byte>& bytes) { return std::string(as_text(bytes)); });
}

bool flush_folder(const std::filesystem::path& folder) {
    const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    return opened.is_open() && ::fsync(opened.number()) == 0;
}

bool is_there(const std::filesystem::path& path) {
    std::error_code error;
    return std::filesystem::symlink_status(path, error).type() !=
           std::filesystem::file_type::not_found;
}

Result<void> write_whole_file(const std::string& path, std::span<const std::byte> bytes) {
    FileStatus status{};
    const bool exists = ::stat(path.c_str(), &status) == 0;
    if (exists && S_ISDIR(status.st_mode)) {
        return failure(one_line(path) + ": is a folder; name a file in it");
    }
    if (exists && !S_ISREG(status.st_mode)) return write_straight(path, bytes);
    std::error_code error;
    const auto linked_to = std::filesystem::canonical(path, error);
    return write_beside_and_rename(path, error ? path : linked_to.string(), bytes);
}

Result<void> write_whole_file(const std::string& path, const std::string& text) {
    return write_whole_file(path, std::as_bytes(std::span(text)));
}

}  // namespace touchline
