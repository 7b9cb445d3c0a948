#include "app/operator/pin.h"

#include "app/documents/decode/one_line.h"
#include "app/isolation/process/descriptor.h"
#include "app/operator/settings_files.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <string_view>

#include <crypt.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr int free_tries = 5;
constexpr double first_lock_s = 60.0;
constexpr double longest_lock_s = 3600.0;
constexpr int digits = 10;

// The files.

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

/// Without it, a name may come back or be gone after the plug was pulled.
bool flush_folder_of(const fs::path& file) {
    const Descriptor folder(::open(file.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    return folder.is_open() && ::fsync(folder.number()) == 0;
}

/// Writes with mode 0600, whole or not at all. The file is on the disk when the call returns, so
/// pulling the plug undoes nothing.
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
    if (!flush_folder_of(file)) return file_failure(file, "cannot be kept; its folder is broken");
    return {};
}

/// Reads at most `limit` bytes. Fails if it is missing, no file, or open to others.
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

/// True if anything is there. Counts what cannot be examined, and a link to nothing.
bool is_private_there(const fs::path& file) {
    std::error_code error;
    const bool is_there = fs::exists(fs::symlink_status(file, error));
    return is_there || (error && error != std::errc::no_such_file_or_directory);
}

/// Removes the file for good before the call returns. Succeeds if it does not exist.
Result<void> remove_private(const fs::path& file) {
    std::error_code error;
    if (!fs::remove(file, error) && !error) return {};
    if (error) return file_failure(file, "cannot be removed: " + error.message());
    if (!flush_folder_of(file)) return file_failure(file, "cannot be removed for good");
    return {};
}

// What is in them.

constexpr std::string_view begin_words = "wrong PINs: ";
constexpr std::size_t longest_text = 64;

constexpr const char* yescrypt = "$y$";
constexpr std::size_t longest_hash = 512;

/// Wipes crypt's memory, so that its contents cannot be read back.
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

/// Compares in constant time: the time tells nothing of how much was right.
bool are_equal(const std::string& a, const std::string& b) {
    if (a.size() != b.size()) return false;
    unsigned difference = 0;
    for (std::size_t i = 0; i < a.size(); ++i) difference |= static_cast<unsigned>(a[i] ^ b[i]);
    return difference == 0;
}

tl::unexpected<Error> is_no_pin(const fs::path& file) {
    return failure(one_line(file.string()) +
                   ": holds no PIN that this program wrote; remove it and choose a new one");
}

Result<std::string> read_hash(const fs::path& file) {
    auto text = read_private(file, longest_hash);
    if (!text) return text;
    if (text->ends_with('\n')) text->pop_back();
    if (!text->starts_with(yescrypt) || text->size() + 1 >= longest_hash) return is_no_pin(file);
    return text;
}

}  // namespace

PinEntry turned(PinEntry entry, bool is_up) {
    if (entry.digit)
        entry.digit = (*entry.digit + (is_up ? 1 : digits - 1)) % digits;
    else
        entry.digit = is_up ? 1 : 0;
    return entry;
}

PinEntry with_digit_taken(PinEntry entry) {
    if (entry.digit && entry.taken.size() < longest_pin)
        entry.taken += static_cast<char>('0' + *entry.digit);
    entry.digit.reset();
    return entry;
}

bool is_pin(const std::string& text) {
    return text.size() >= shortest_pin && text.size() <= longest_pin &&
           std::all_of(text.begin(), text.end(),
                       [](char letter) { return letter >= '0' && letter <= '9'; });
}

PinTries after_wrong_pin(PinTries tries, double now_s, bool is_noted) {
    const int wrong = std::min(tries.wrong + 1, most_wrong_pins);
    return tries_after_restart(is_noted ? wrong : std::max(wrong, free_tries), now_s);
}

PinTries tries_after_restart(int wrong, double now_s) {
    if (wrong < free_tries) return {wrong, 0.0};
    const double lock_s = first_lock_s * std::exp2(wrong - free_tries);
    return {wrong, now_s + std::min(lock_s, longest_lock_s)};
}

fs::path pin_file() {
    return settings_files().site.parent_path() / "operator.pin";
}

bool has_pin(const fs::path& file) {
    return is_private_there(file);
}

Result<void> keep_pin(const fs::path& file, const std::string& pin) {
    if (!is_pin(pin)) return failure("a PIN has 4 to 8 digits; choose another one");
    const std::string hash = hash_of(pin, new_setting());
    if (hash.empty())
        return failure("the system's library makes no yescrypt hash; install libcrypt1");
    return write_private(file, hash + '\n');
}

Result<bool> is_right_pin(const fs::path& file, const std::string& pin) {
    const auto kept = read_hash(file);
    if (!kept) return tl::unexpected(kept.error());
    const std::string hash = hash_of(pin, *kept);
    if (hash.empty()) return is_no_pin(file);
    return are_equal(hash, *kept);
}

fs::path pin_tries_file(const fs::path& pin) {
    return pin.parent_path() / "operator.tries";
}

Result<void> keep_pin_tries(const fs::path& file, int wrong) {
    if (wrong == 0) return remove_private(file);
    return write_private(
        file, std::string(begin_words) + std::to_string(std::min(wrong, most_wrong_pins)) + '\n');
}

Result<int> read_pin_tries(const fs::path& file) {
    if (!is_private_there(file)) return 0;
    const auto text = read_private(file, longest_text);
    if (!text) return tl::unexpected(text.error());
    const bool is_told = text->starts_with(begin_words) && text->ends_with('\n');
    const auto digits = is_told ? std::string_view(*text).substr(begin_words.size()) : "\n";
    const auto wrong = number_in(digits.substr(0, digits.size() - 1), 1, most_wrong_pins);
    if (!wrong)
        return failure(one_line(file.string()) +
                       ": does not say how many wrong PINs there were; the PIN waits as long as it "
                       "can, and the next right one mends it");
    return *wrong;
}

}  // namespace touchline
