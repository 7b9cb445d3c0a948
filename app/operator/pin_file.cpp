#include "app/operator/pin_file.h"

#include "app/decode/one_line.h"
#include "app/operator/pin.h"
#include "app/operator/private_file.h"
#include "app/operator/settings_files.h"

#include <array>
#include <cstring>
#include <memory>

#include <crypt.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

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

}  // namespace touchline
