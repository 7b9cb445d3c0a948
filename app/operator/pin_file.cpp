#include "app/operator/pin_file.h"

#include "app/operator/pin.h"
#include "app/operator/settings_files.h"

#include <array>
#include <cstring>
#include <memory>

#include <crypt.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr const char* yescrypt = "$y$";
constexpr std::size_t longest_hash = 512;

/// Closes what it opened.
class OpenFile {
  public:
    OpenFile(const fs::path& file, int flags, mode_t mode)
        : descriptor_(::open(file.c_str(), flags | O_CLOEXEC | O_NOFOLLOW, mode)) {}

    ~OpenFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }

    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    [[nodiscard]] int get() const { return descriptor_; }

  private:
    int descriptor_;
};

/// What is written cannot be read back from memory that crypt left behind.
struct Wiped {
    crypt_data data{};

    Wiped() = default;

    ~Wiped() { ::explicit_bzero(&data, sizeof data); }

    Wiped(const Wiped&) = delete;
    Wiped& operator=(const Wiped&) = delete;
};

std::string hash_of(const std::string& pin, const std::string& setting) {
    const auto work = std::make_unique<Wiped>();
    const char* const hash = ::crypt_r(pin.c_str(), setting.c_str(), &work->data);
    const bool is_hash = hash != nullptr && hash[0] == '$';
    return is_hash ? hash : "";
}

std::string new_setting() {
    std::array<char, CRYPT_GENSALT_OUTPUT_SIZE> setting{};
    const char* const made = ::crypt_gensalt_rn(yescrypt, 0, nullptr, 0, setting.data(),
                                                static_cast<int>(setting.size()));
    return made != nullptr ? made : "";
}

bool write_all(int descriptor, const std::string& text) {
    return ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
           ::fsync(descriptor) == 0;
}

/// As long as the other would need: how long it took tells nothing of how much was right.
bool are_equal(const std::string& a, const std::string& b) {
    if (a.size() != b.size()) return false;
    unsigned difference = 0;
    for (std::size_t i = 0; i < a.size(); ++i) difference |= static_cast<unsigned>(a[i] ^ b[i]);
    return difference == 0;
}

Result<std::string> read_hash(const fs::path& file) {
    const OpenFile open(file, O_RDONLY, 0);

    struct stat state {};

    if (open.get() < 0 || ::fstat(open.get(), &state) != 0)
        return failure(file.string() +
                       ": the PIN's file cannot be read; its owner must be the "
                       "kiosk's user");
    constexpr mode_t others = S_IRWXG | S_IRWXO;
    if (!S_ISREG(state.st_mode) || (state.st_mode & others) != 0)
        return failure(file.string() + ": others could read the PIN's file; set its mode to 600");
    std::string text(longest_hash, '\0');
    const ssize_t count = ::read(open.get(), text.data(), text.size());
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    if (text.ends_with('\n')) text.pop_back();
    if (!text.starts_with(yescrypt) || text.size() + 1 >= longest_hash)
        return failure(file.string() +
                       ": holds no PIN that this program wrote; remove it and choose a new one");
    return text;
}

}  // namespace

fs::path pin_file() {
    return settings_files().site.parent_path() / "operator.pin";
}

bool has_pin(const fs::path& file) {
    std::error_code error;
    const bool is_there = fs::exists(fs::symlink_status(file, error));
    return is_there || (error && error != std::errc::no_such_file_or_directory);
}

Result<void> keep_pin(const fs::path& file, const std::string& pin) {
    if (!is_pin(pin)) return failure("a PIN has 4 to 8 digits; choose another one");
    const std::string hash = hash_of(pin, new_setting());
    if (hash.empty())
        return failure("the system's library makes no yescrypt hash; install libcrypt1");
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    const fs::path part = fs::path(file).concat(".part");
    fs::remove(part, error);
    {
        const OpenFile open(part, O_WRONLY | O_CREAT | O_EXCL, S_IRUSR | S_IWUSR);
        if (open.get() < 0 || !write_all(open.get(), hash + '\n')) {
            fs::remove(part, error);
            return failure(file.string() +
                           ": the PIN cannot be kept; its folder takes no files or is full");
        }
    }
    fs::rename(part, file, error);
    if (error) return failure(file.string() + ": the PIN cannot be kept: " + error.message());
    return {};
}

Result<bool> is_right_pin(const fs::path& file, const std::string& pin) {
    const auto kept = read_hash(file);
    if (!kept) return tl::unexpected(kept.error());
    const std::string hash = hash_of(pin, *kept);
    if (hash.empty())
        return failure(file.string() +
                       ": holds no PIN that this program wrote; remove it and choose a new one");
    return are_equal(hash, *kept);
}

}  // namespace touchline
