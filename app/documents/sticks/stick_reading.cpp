#include "app/documents/sticks/stick_reading.h"

#include "app/isolation/sandbox/sandbox.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <utility>
#include <vector>

#include <dirent.h>
#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace touchline {
namespace {

int openat2(int folder, const char* name, int flags) {
    open_how how{};
    how.flags = static_cast<unsigned>(flags);
    how.resolve = RESOLVE_BENEATH | RESOLVE_NO_SYMLINKS | RESOLVE_NO_MAGICLINKS | RESOLVE_NO_XDEV;
    return static_cast<int>(::syscall(SYS_openat2, folder, name, &how, sizeof(how)));
}

constexpr std::size_t block_bytes = std::size_t{256} << 10U;

using Refused = tl::unexpected<StickRefusal>;

Refused refused_by_system() {
    return Refused(refusal_of(errno));
}

Result<std::size_t, StickRefusal> size_of(const Descriptor& file, std::size_t most_bytes) {
    FileStatus status{};
    if (::fstat(file.number(), &status) != 0) return refused_by_system();
    if (!S_ISREG(status.st_mode)) return Refused(StickRefusal::no_file);
    if (status.st_size <= 0) return Refused(StickRefusal::empty);
    if (static_cast<std::uint64_t>(status.st_size) > most_bytes)
        return Refused(StickRefusal::too_large);
    return static_cast<std::size_t>(status.st_size);
}

/// Examines it first without opening it for reading, which alone makes some devices act.
Result<Descriptor, StickRefusal> open_file(const Descriptor& folder, const std::string& name,
                                           std::size_t most_bytes) {
    const Descriptor seen = open_beneath(folder, name, O_PATH);
    if (!seen.is_open()) return refused_by_system();
    if (const auto size = size_of(seen, most_bytes); !size) return Refused(size.error());
    Descriptor file = open_beneath(folder, name, 0);
    if (!file.is_open()) return refused_by_system();
    return file;
}

Result<void, StickRefusal> copy_bytes(const Descriptor& file, std::size_t bytes,
                                      const Descriptor& output, const CopyLimits& limits) {
    std::vector<std::byte> block(block_bytes);
    std::size_t copied = 0;
    for (;;) {
        if (limits.is_time_up()) return Refused(StickRefusal::out_of_time);
        const ssize_t got = ::read(file.number(), block.data(), block.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return refused_by_system();
        copied += static_cast<std::size_t>(got);
        if (copied > bytes || (got == 0 && copied < bytes))
            return Refused(StickRefusal::unreadable);
        if (got == 0) return {};
        if (!write_all(output, std::span(block).first(static_cast<std::size_t>(got))))
            return Refused(StickRefusal::too_large);
    }
}

/// Keeps the first few of any number of names, in natural order.
class FirstNames {
  public:
    FirstNames(const NaturalOrder& order, std::size_t most) : order_(order), most_(most) {}

    void add(std::string_view name) {
        ++count_;
        if (most_ == 0) return;
        std::pair keyed{order_.key_of(name), std::string(name)};
        if (first_.size() == most_) {
            if (keyed.first >= first_.front().first) return;
            std::pop_heap(first_.begin(), first_.end());
            first_.pop_back();
        }
        first_.push_back(std::move(keyed));
        std::push_heap(first_.begin(), first_.end());
    }

    [[nodiscard]] std::size_t beyond() const { return count_ - first_.size(); }

    /// Takes the names in order. The object is empty then.
    std::vector<std::string> take() {
        std::sort_heap(first_.begin(), first_.end());
        std::vector<std::string> names;
        for (auto& [key, name] : first_) names.push_back(std::move(name));
        first_.clear();
        return names;
    }

  private:
    const NaturalOrder& order_;
    std::size_t most_;
    std::size_t count_ = 0;
    std::vector<std::pair<std::string, std::string>> first_;  // a heap of (key, name), last on top
};

enum class EntryType : std::uint8_t { file, folder, other };

EntryType type_of(const Descriptor& folder, const dirent64& entry) {
    if (entry.d_type == DT_REG) return EntryType::file;
    if (entry.d_type == DT_DIR) return EntryType::folder;
    if (entry.d_type != DT_UNKNOWN) return EntryType::other;

    const Descriptor seen = open_beneath(folder, entry.d_name, O_PATH);
    FileStatus status{};
    if (!seen.is_open() || ::fstat(seen.number(), &status) != 0) return EntryType::other;
    if (S_ISREG(status.st_mode)) return EntryType::file;
    return S_ISDIR(status.st_mode) ? EntryType::folder : EntryType::other;
}

class Scan {
  public:
    Scan(const NaturalOrder& order, const ScanLimits& limits, StickSearch search)
        : order_(order), limits_(limits), search_(search) {}

    Result<StickListing, StickRefusal> run(const Descriptor& root) {
        const auto error = walk(root, "", 0);
        if (error && listing_.entries.empty() && looked_into_ == 0)
            return tl::unexpected(refusal_of(*error));
        return std::move(listing_);
    }

  private:
    /// A folder's files, then the contents of its folders. Returns errno if it could not be opened,
    /// or if an error came before its end; what was read until then counts.
    std::optional<int> walk(const Descriptor& root, const std::string& path, std::size_t depth) {
        const bool has_folders = search_ == StickSearch::pictures;
        const bool is_deepest = depth == deepest_folder;
        FirstNames folders(order_, is_deepest ? 0 : limits_.most_folders - looked_into_);
        const auto error = read_folder(root, path, has_folders ? &folders : nullptr);
        if (error) listing_.rest.has_unreadable = true;
        if (folders.beyond() > 0)
            (is_deepest ? listing_.rest.has_deeper : listing_.rest.is_cut_short) = true;
        for (const std::string& name : folders.take()) {
            if (is_over()) break;
            if (looked_into_ == limits_.most_folders) {
                listing_.rest.is_cut_short = true;
                break;
            }
            ++looked_into_;
            (void)walk(root, path.empty() ? name : path + '/' + name, depth + 1);
        }
        return error;
    }

    /// Closes the folder again: a process with few descriptors goes eight folders deep.
    std::optional<int> read_folder(const Descriptor& root, const std::string& path,
                                   FirstNames* folders) {
        // The offset of the handed descriptor belongs to its owner, so this opens another one.
        const Descriptor folder = open_beneath(root, path.empty() ? "." : path, O_DIRECTORY);
        if (!folder.is_open()) return errno;
        FirstNames files(order_, most_listed - listing_.entries.size());
        const int error = read_names(folder, files, folders);
        listing_.rest.not_listed += static_cast<std::uint32_t>(files.beyond());
        for (std::string& file : files.take()) list(path, std::move(file));
        if (error != 0) return error;
        return std::nullopt;
    }

    void list(const std::string& path, std::string file) {
        const auto kind = kind_of(file);
        if (!kind) return;
        bytes_ += path.size() + file.size();
        if (bytes_ > most_listed_bytes)
            ++listing_.rest.not_listed;
        else
            listing_.entries.push_back({*kind, path, std::move(file)});
    }

    int read_names(const Descriptor& folder, FirstNames& files, FirstNames* folders) {
        alignas(dirent64) std::array<char, 32768> buffer{};
        while (!is_over()) {
            const ssize_t got = ::getdents64(folder.number(), buffer.data(), buffer.size());
            if (got <= 0) return got == 0 ? 0 : errno;
            for (std::size_t at = 0; at < static_cast<std::size_t>(got);) {
                const auto& entry = *reinterpret_cast<const dirent64*>(buffer.data() + at);
                at += entry.d_reclen;
                ++names_;
                add(folder, entry, files, folders);
            }
        }
        return 0;
    }

    [[nodiscard]] std::optional<StickFileKind> kind_of(std::string_view name) const {
        return search_ == StickSearch::operator_files ? operator_kind_of_name(name)
                                                      : kind_of_name(name);
    }

    void add(const Descriptor& folder, const dirent64& entry, FirstNames& files,
             FirstNames* folders) const {
        const std::string_view name = entry.d_name;
        if (is_left_out(name) || !is_file_name(name)) return;
        // Checks first what costs nothing: most names are neither.
        const bool may_be_file = kind_of(name).has_value();
        if (!may_be_file && folders == nullptr) return;
        const EntryType type = type_of(folder, entry);
        if (type == EntryType::file && may_be_file) files.add(name);
        if (type == EntryType::folder && folders != nullptr) folders->add(name);
    }

    bool is_over() {
        if (!is_over_ && (names_ > limits_.most_names || limits_.is_time_up())) {
            is_over_ = true;
            listing_.rest.is_cut_short = true;
        }
        return is_over_;
    }

    const NaturalOrder& order_;
    const ScanLimits& limits_;
    StickSearch search_;
    StickListing listing_;
    std::size_t names_ = 0;
    std::size_t looked_into_ = 0;  // folders
    std::size_t bytes_ = 0;        // of names and paths
    bool is_over_ = false;
};

}  // namespace

Result<void> shut_in(const Descriptor& root, std::size_t most_bytes) {
    constexpr std::size_t most_memory_bytes = std::size_t{256} << 20U;
    WorkerLimits limits;
    limits.address_space_bytes = most_memory_bytes;
    limits.cpu_s = 10;
    limits.file_bytes = most_bytes;
    return enter_sandbox_beneath(root, limits);
}

StickRefusal refusal_of(int error) {
    switch (error) {
        case ENOENT:
        case ENOTDIR:
        case ENAMETOOLONG:
            return StickRefusal::no_such_file;
        case ELOOP:  // a link
        case EXDEV:  // out of the stick
        case ENXIO:  // a socket
        case EISDIR:
            return StickRefusal::no_file;
        case EACCES:
        case EPERM:
            return StickRefusal::locked;
        case ENODEV:
        case ENOTCONN:  // a file system in user space has ended
        case ESHUTDOWN:
            return StickRefusal::gone;
        default:
            return StickRefusal::unreadable;
    }
}

Descriptor open_beneath(const Descriptor& folder, const std::string& name, int flags) {
    if ((flags & O_PATH) != 0)
        return Descriptor(openat2(folder.number(), name.c_str(), flags | O_CLOEXEC | O_NOFOLLOW));
    const int all = O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | flags;
    int number = openat2(folder.number(), name.c_str(), all | O_NOATIME);
    // Only a file's owner may keep its access time unchanged.
    if (number < 0 && errno == EPERM) number = openat2(folder.number(), name.c_str(), all);
    return Descriptor(number);
}

Result<void, StickRefusal> copy_from_stick(const Descriptor& root, const std::string& folder,
                                           const std::string& name, const Descriptor& output,
                                           const CopyLimits& limits) {
    if (!is_file_name(name) || !is_folder_path(folder)) return Refused(StickRefusal::no_such_file);
    const Descriptor open_folder =
        open_beneath(root, folder.empty() ? "." : folder, O_PATH | O_DIRECTORY);
    if (!open_folder.is_open()) return refused_by_system();
    const auto file = open_file(open_folder, name, limits.most_bytes);
    if (!file) return Refused(file.error());
    const auto bytes = size_of(*file, limits.most_bytes);
    if (!bytes) return Refused(bytes.error());
    return copy_bytes(*file, *bytes, output, limits);
}

Result<StickListing, StickRefusal> scan_stick(const Descriptor& root, const NaturalOrder& order,
                                              const ScanLimits& limits, StickSearch search) {
    return Scan(order, limits, search).run(root);
}

}  // namespace touchline
