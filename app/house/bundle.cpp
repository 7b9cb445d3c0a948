#include "app/house/bundle.h"

#include "app/documents/decode/one_line.h"
#include "audio-cues/words/language.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr std::string_view first_line = "Touchline bundle\n";
constexpr std::string_view format_line = "format 1\n";
constexpr std::size_t longest_head_bytes = 64 * 1024;
constexpr std::size_t longest_name = 60;
constexpr std::int64_t last_second = 253'402'300'799;  // of the year 9999

constexpr std::array<std::string_view, 4> part_words{"settings", "profile", "pack", "network"};

bool is_name(std::string_view name) {
    return !name.empty() && name.size() <= longest_name && std::ranges::all_of(name, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
    });
}

auto order_of(const BundleFile& file) {
    return std::tie(file.part, file.name);
}

std::string head_text(const Bundle& bundle) {
    std::string text =
        fmt::format("{}program {}\nmade {}\n", format_line, bundle.program, bundle.made_s);
    for (const BundleFile& file : bundle.files)
        text += fmt::format("file {} {} {} {}\n", part_words[static_cast<std::size_t>(file.part)],
                            file.name, file.bytes.size(), sha256_text(file.bytes));
    return text + "end\n";
}

/// Takes the text up to the next `end` out of `text`; nothing if there is no such letter.
std::optional<std::string_view> take_until_letter(char end, std::string_view& text) {
    const std::size_t length = text.find(end);
    if (length == std::string_view::npos) return std::nullopt;
    const std::string_view part = text.substr(0, length);
    text.remove_prefix(length + 1);
    return part;
}

/// Takes "WORD REST\n" out of `text` and gives REST.
std::optional<std::string_view> take_line_of(std::string_view word, std::string_view& text) {
    if (!text.starts_with(word) || !text.substr(word.size()).starts_with(' ')) return std::nullopt;
    text.remove_prefix(word.size() + 1);
    return take_until_letter('\n', text);
}

struct FileLine {
    BundlePart part = BundlePart::settings;
    std::string name;
    std::size_t bytes = 0;
};

/// The sum is compared with the rest of the head, when this is written anew.
std::optional<FileLine> file_line_in(std::string_view line) {
    const auto word = take_until_letter(' ', line);
    const auto name = take_until_letter(' ', line);
    const auto bytes = take_until_letter(' ', line);
    const auto part = std::ranges::find(part_words, word.value_or(""));
    const auto count = number_in<std::size_t>(bytes.value_or(""), 1, most_bundle_bytes);
    if (part == part_words.end() || !is_name(name.value_or("")) || !count) return std::nullopt;
    return FileLine{static_cast<BundlePart>(part - part_words.begin()), std::string(*name), *count};
}

/// What the signature covers, as a bundle; nothing if it was written in any other way.
std::optional<Bundle> bundle_of_signed(std::span<const std::byte> bytes) {
    std::string_view text = as_text(bytes.first(std::min(bytes.size(), longest_head_bytes)));
    const std::string_view all = text;
    if (!text.starts_with(format_line)) return std::nullopt;
    text.remove_prefix(format_line.size());
    const auto program = take_line_of("program", text);
    const auto made = take_line_of("made", text);
    const auto made_s = number_in<std::int64_t>(made.value_or(""), 0, last_second);
    if (!program || !made_s) return std::nullopt;
    std::vector<FileLine> lines;
    while (const auto line = take_line_of("file", text)) {
        const auto file = file_line_in(*line);
        if (!file || lines.size() == most_bundle_files) return std::nullopt;
        lines.push_back(*file);
    }
    if (!text.starts_with("end\n")) return std::nullopt;
    text.remove_prefix(4);
    const std::string_view head = all.substr(0, all.size() - text.size());
    std::span<const std::byte> rest = bytes.subspan(head.size());
    Bundle bundle{std::string(*program), *made_s, {}};
    for (FileLine& line : lines) {
        if (line.bytes > rest.size()) return std::nullopt;
        bundle.files.push_back({line.part, std::move(line.name), rest.first(line.bytes)});
        rest = rest.subspan(line.bytes);
    }
    const bool is_in_order =
        std::ranges::adjacent_find(bundle.files, [](const BundleFile& a, const BundleFile& b) {
            return order_of(a) >= order_of(b);
        }) == bundle.files.end();
    if (!rest.empty() || !is_in_order || head != head_text(bundle)) return std::nullopt;
    return bundle;
}

/// The bytes behind the lines of the signature; nothing if there are no such lines.
std::optional<std::size_t> place_after_signature(std::string_view text) {
    std::size_t at = first_line.size();
    for (int line = 0; line < signature_lines; ++line) {
        at = text.find('\n', at);
        if (at == std::string_view::npos) return std::nullopt;
        ++at;
    }
    return at;
}

bool is_of_newer_program(std::string_view text) {
    return text.starts_with("format ") && !text.starts_with(format_line);
}

}  // namespace

std::string sentence_of(BundleFault fault, const Language& language) {
    constexpr std::array<const char*, bundle_fault_count> sentences{
        "This kiosk has no house key. Install the house key first.",
        "This kiosk cannot sign bundles. Make them on the kiosk with the first house key.",
        "This kiosk has a house key of its own. Nothing was changed.",
        "This file is no bundle of Touchline.",
        "This file holds no house key.",
        "The bundle is damaged or was changed. Copy it to the USB stick again.",
        "The bundle is signed with another house key. Nothing was changed.",
        "The bundle was made by a newer Touchline. Update this kiosk first.",
        "A newer bundle was applied here before. Nothing was changed.",
        "Something in the bundle cannot be used here. The log says what.",
        "A pack of pictures is newer here than in the bundle. Make a new bundle.",
        "There is too much for one bundle. Remove packs of pictures. The manual says how.",
        "Something cannot be read or saved here. The log says what.",
        "There is no bundle to go back from.",
        "This kiosk was changed meanwhile. Choose the bundle once more.",
    };
    return language.text("bundle", sentences[static_cast<std::size_t>(fault)]);
}

BundleResult<std::vector<std::byte>> signed_bundle(Bundle bundle, const SecretKey& secret) {
    std::ranges::sort(bundle.files, {}, order_of);
    const std::string head = head_text(bundle);
    std::size_t count = head.size();
    for (const BundleFile& file : bundle.files) count += file.bytes.size();
    if (count > most_bundle_bytes - longest_head_bytes || head.size() > longest_head_bytes ||
        bundle.files.size() > most_bundle_files)
        return bundle_failure(
            BundleFault::too_large,
            fmt::format("a bundle holds {} MiB and {} files at most; take packs out of this kiosk",
                        most_bundle_bytes >> 20U, most_bundle_files));
    // Every signature is as long as this one; its place is left free, so that nothing is copied.
    const std::size_t top_bytes = first_line.size() + signature_text({}, secret).size();
    std::vector<std::byte> whole;
    whole.reserve(top_bytes + count);
    whole.resize(top_bytes);
    const auto add = [&whole](std::span<const std::byte> bytes) {
        whole.insert(whole.end(), bytes.begin(), bytes.end());
    };
    add(std::as_bytes(std::span(head)));
    for (const BundleFile& file : bundle.files) add(file.bytes);
    const std::string top =
        std::string(first_line) + signature_text(std::span(whole).subspan(top_bytes), secret);
    std::ranges::copy(std::as_bytes(std::span(top)), whole.begin());
    return whole;
}

BundleResult<Bundle> bundle_in(std::span<const std::byte> bytes, const PublicKey& key,
                               const std::string& name) {
    const auto refused = [&name](BundleFault fault, std::string_view why) {
        return bundle_failure(fault, fmt::format("{}: {}", one_line(name), why));
    };
    if (bytes.size() > most_bundle_bytes)
        return refused(BundleFault::too_large, "is larger than any bundle; make a new one");
    const std::string_view text = as_text(bytes.first(std::min(bytes.size(), longest_head_bytes)));
    if (!text.starts_with(first_line))
        return refused(BundleFault::no_bundle, "is no bundle of Touchline; name another file");
    const auto place = place_after_signature(text);
    if (!place) return refused(BundleFault::damaged, "the bundle is not whole; copy it here again");
    const auto covered = bytes.subspan(*place);
    switch (state_of(text.substr(first_line.size(), *place - first_line.size()), covered, key)) {
        case SignatureState::good:
            break;
        case SignatureState::other_key:
            return refused(BundleFault::other_key,
                           "is signed with another key than that of this house; make one there");
        case SignatureState::unreadable:
        case SignatureState::broken:
            return refused(BundleFault::damaged,
                           "the bundle was changed or is not whole; copy it here again");
    }
    if (is_of_newer_program(as_text(covered)))
        return refused(BundleFault::newer_program,
                       "is of a newer Touchline; update the program of this kiosk first");
    auto bundle = bundle_of_signed(covered);
    if (!bundle)
        return refused(BundleFault::bad_contents,
                       "its list of files contradicts its files; make a new bundle");
    return std::move(*bundle);
}

}  // namespace touchline
