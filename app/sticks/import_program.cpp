#include "app/sticks/import_program.h"

#include "app/sandbox/sandbox.h"
#include "app/sticks/stick_reading.h"
#include "config/types/steady_clock.h"

#include <cerrno>
#include <charconv>
#include <cstdint>
#include <optional>

#include <fcntl.h>

namespace touchline {
namespace {

/// A listing that takes longer is sent as far as it got: visitors hear the first page within two
/// seconds.
constexpr std::int64_t list_time_ns = 1'500'000'000;

constexpr int wrong_words = 2;

int status_of(StickRefusal refusal) {
    return first_refusal_status + static_cast<int>(refusal);
}

std::optional<std::size_t> number_of(const std::string& word) {
    std::size_t value = 0;
    const char* const end = word.data() + word.size();
    const auto [at, error] = std::from_chars(word.data(), end, value);
    if (error != std::errc() || at != end) return std::nullopt;
    return value;
}

int list(const Descriptor& root, const Descriptor& output, StickSearch search) {
    const NaturalOrder order;
    if (!shut_in(root, most_listing_bytes)) return status_of(StickRefusal::not_started);
    ScanLimits limits;
    limits.is_time_up = [end_ns = steady_now_ns() + list_time_ns] {
        return steady_now_ns() > end_ns;
    };
    const auto listing = scan_stick(root, order, limits, search);
    if (!listing) return status_of(listing.error());
    return write_all(output, bytes_of(*listing)) ? 0 : status_of(StickRefusal::unreadable);
}

int read(const Descriptor& root, const Descriptor& output, const std::vector<std::string>& words) {
    const auto most_bytes = number_of(words[4]);
    if (!most_bytes) return wrong_words;
    if (!shut_in(root, *most_bytes)) return status_of(StickRefusal::not_started);
    const auto copied = copy_from_stick(root, words[2], words[3], output, {*most_bytes});
    return copied ? 0 : status_of(copied.error());
}

}  // namespace

Result<void> shut_in(const Descriptor& root, std::size_t most_bytes) {
    constexpr std::size_t most_memory_bytes = std::size_t{256} << 20U;
    WorkerLimits limits;
    limits.address_space_bytes = most_memory_bytes;
    limits.cpu_s = 10;
    limits.file_bytes = most_bytes;
    return enter_sandbox_beneath(root, limits);
}

int run_import(const std::vector<std::string>& words) {
    const bool is_list = words.size() == 2 && (words[0] == "list" || words[0] == "operator");
    const bool is_read = words.size() == 5 && words[0] == "read";
    if (!is_list && !is_read) return wrong_words;
    const Descriptor output(import_output);
    const Descriptor root(::open(words[1].c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    if (!root.is_open()) return status_of(errno == ENOENT ? StickRefusal::gone : refusal_of(errno));
    if (is_read) return read(root, output, words);
    const bool is_operators = words[0] == "operator";
    return list(root, output, is_operators ? StickSearch::operator_files : StickSearch::pictures);
}

}  // namespace touchline
