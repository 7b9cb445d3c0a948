#include "app/operator/pin_tries_file.h"

#include "app/decode/one_line.h"
#include "app/operator/pin.h"
#include "app/operator/private_file.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view begin_words = "wrong PINs: ";
constexpr std::size_t longest_text = 64;

}  // namespace

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
    int wrong = 0;
    const std::string_view digits =
        std::string_view(*text).substr(std::min(text->size(), begin_words.size()));
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), wrong);
    const bool is_whole = text->starts_with(begin_words) && error == std::errc() &&
                          end + 1 == digits.data() + digits.size() && *end == '\n';
    if (!is_whole || wrong < 1 || wrong > most_wrong_pins)
        return failure(one_line(file.string()) +
                       ": does not say how many wrong PINs there were; the PIN waits as long as it "
                       "can, and the next right one mends it");
    return wrong;
}

}  // namespace touchline
