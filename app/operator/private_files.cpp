#include "app/operator/private_files.h"

#include "app/documents/decode/files.h"
#include "app/documents/decode/one_line.h"
#include "app/isolation/process/descriptor.h"

#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> file_failure(const fs::path& file, const std::string& what) {
    return failure(one_line(file.string()) + ": " + what);
}

Descriptor open_file(const fs::path& file, int flags) {
    return Descriptor(::open(file.c_str(), flags | O_CLOEXEC | O_NOFOLLOW, S_IRUSR | S_IWUSR));
}

bool write_text(const Descriptor& open, const std::string& text) {
    return ::write(open.number(), text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
           ::fsync(open.number()) == 0;
}

}  // namespace

Result<void> write_private(const fs::path& file, const std::string& text) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    const fs::path part = fs::path(file).concat(".part");
    fs::remove(part, error);
    {
        const Descriptor open = open_file(part, O_WRONLY | O_CREAT | O_EXCL);
        if (!open.is_open() || !write_text(open, text)) {
            fs::remove(part, error);
            return file_failure(file, "cannot be kept; its folder takes no files or is full");
        }
    }
    fs::rename(part, file, error);
    if (error) return file_failure(file, "cannot be kept: " + error.message());
    if (!flush_folder(file.parent_path()))
        return file_failure(file, "cannot be kept; its folder is broken");
    return {};
}

Result<std::string> read_private(const fs::path& file, std::size_t limit) {
    const Descriptor open = open_file(file, O_RDONLY);

    struct stat state {};

    if (!open.is_open() || ::fstat(open.number(), &state) != 0)
        return file_failure(file, "cannot be read; its owner must be the kiosk's user");
    constexpr mode_t others = S_IRWXG | S_IRWXO;
    if (!S_ISREG(state.st_mode) || (state.st_mode & others) != 0)
        return file_failure(file, "others could read it; set its mode to 600");
    std::string text(limit, '\0');
    const ssize_t count = ::read(open.number(), text.data(), text.size());
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return text;
}

Result<void> remove_private(const fs::path& file) {
    std::error_code error;
    if (!fs::remove(file, error) && !error) return {};
    if (error) return file_failure(file, "cannot be removed: " + error.message());
    if (!flush_folder(file.parent_path())) return file_failure(file, "cannot be removed for good");
    return {};
}

}  // namespace touchline
