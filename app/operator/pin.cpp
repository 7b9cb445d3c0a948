#include "app/operator/pin.h"

#include "app/documents/decode/one_line.h"
#include "app/operator/private_files.h"
#include "app/operator/settings_files.h"
#include "config/types/pinned.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <string_view>

#include <crypt.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr int free_tries = 5;
constexpr double first_lock_s = 60.0;
constexpr double longest_lock_s = 3600.0;
constexpr int digits = 10;

constexpr std::string_view begin_words = "wrong PINs: ";
constexpr std::size_t longest_text = 64;

constexpr const char* yescrypt = "$y$";
constexpr std::size_t longest_hash = 512;

/// Wipes crypt's memory, so that its contents cannot be read back.
struct Wiped : private Pinned {
    crypt_data data{};

    ~Wiped() { ::explicit_bzero(&data, sizeof data); }
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
    return is_there(file);
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
    if (!is_there(file)) return 0;
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
