#include "app/packs/unpack_answer.h"

#include "app/decode/one_line.h"
#include "app/packs/pack_limits.h"
#include "app/packs/plain_names.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <set>
#include <string_view>

#include <zlib.h>

namespace touchline {
namespace {

constexpr std::uint32_t magic = 0x4b'50'4c'54;  // "TLPK"
constexpr std::uint8_t layout = 1;
constexpr int most_lines = 100'000'000;

static_assert(std::endian::native == std::endian::little);

std::uint32_t checksum(std::span<const std::byte> header) {
    const auto* const first = reinterpret_cast<const Bytef*>(header.data());
    return static_cast<std::uint32_t>(::crc32(0, first, unpack_checksum_at));
}

class Writer {
  public:
    template <class Number>
    void number(Number value) {
        raw(std::as_bytes(std::span(&value, 1)));
    }

    void raw(std::span<const std::byte> more) {
        bytes.insert(bytes.end(), more.begin(), more.end());
    }

    void raw(std::string_view more) { raw(std::as_bytes(std::span(more))); }

    std::vector<std::byte> bytes;
};

/// Runs dry instead of past the end.
class Taker {
  public:
    explicit Taker(std::span<const std::byte> bytes) : bytes_(bytes) {}

    template <class Number>
    Number number() {
        Number value{};
        const auto from = raw(sizeof value);
        if (is_good_) std::memcpy(&value, from.data(), sizeof value);
        return value;
    }

    std::span<const std::byte> raw(std::size_t count) {
        if (count > bytes_.size()) is_good_ = false;
        if (!is_good_) return {};
        const auto taken = bytes_.first(count);
        bytes_ = bytes_.subspan(count);
        return taken;
    }

    std::string text(std::size_t count) {
        const auto taken = raw(count);
        return {reinterpret_cast<const char*>(taken.data()), taken.size()};
    }

    [[nodiscard]] bool is_good() const { return is_good_; }

    [[nodiscard]] bool is_at_end() const { return is_good_ && bytes_.empty(); }

  private:
    std::span<const std::byte> bytes_;
    bool is_good_ = true;
};

std::string fit_for_a_line(const std::string& text) {
    return one_spaced(utf8_of(text), most_finding_text_bytes - 3);
}

void put(Writer& writer, const PackFinding& finding) {
    const std::string file = fit_for_a_line(finding.file);
    const std::string what = fit_for_a_line(finding.what);
    writer.number(static_cast<std::uint8_t>(finding.kind));
    writer.number(static_cast<std::int32_t>(finding.line));
    writer.number(finding.value);
    writer.number(static_cast<std::uint16_t>(file.size()));
    writer.number(static_cast<std::uint16_t>(what.size()));
    writer.raw(file);
    writer.raw(what);
}

void put(Writer& writer, const PackFile& entry) {
    writer.number(static_cast<std::uint16_t>(entry.name.size()));
    writer.number(static_cast<std::uint32_t>(entry.bytes.size()));
    writer.raw(entry.name);
    writer.raw(entry.bytes);
}

/// As put() makes them: what a line cannot hold comes from nobody honest.
bool is_fit(const std::string& text) {
    return text.size() <= most_finding_text_bytes && is_utf8(text) &&
           one_spaced(text, most_finding_text_bytes) == text;
}

std::optional<PackFinding> take_finding(Taker& taker) {
    PackFinding finding;
    const auto kind = taker.number<std::uint8_t>();
    finding.line = taker.number<std::int32_t>();
    finding.value = taker.number<double>();
    const auto file_bytes = taker.number<std::uint16_t>();
    const auto what_bytes = taker.number<std::uint16_t>();
    finding.file = taker.text(file_bytes);
    finding.what = taker.text(what_bytes);
    const bool is_sound = taker.is_good() && kind < finding_kind_count && finding.line >= 0 &&
                          finding.line <= most_lines && std::abs(finding.value) < 1e12 &&
                          is_fit(finding.file) && is_fit(finding.what);
    if (!is_sound) return std::nullopt;
    finding.kind = static_cast<FindingKind>(kind);
    return finding;
}

std::optional<PackFile> take_entry(Taker& taker) {
    const auto name_bytes = taker.number<std::uint16_t>();
    const auto bytes = taker.number<std::uint32_t>();
    PackFile entry{taker.text(name_bytes), {}};
    const auto raw = taker.raw(bytes);
    if (!taker.is_good() || trouble_with_name(entry.name)) return std::nullopt;
    entry.bytes.assign(raw.begin(), raw.end());
    return entry;
}

}  // namespace

std::vector<std::byte> bytes_of(const UnpackAnswer& answer) {
    const std::size_t findings = std::min(answer.findings.size(), most_findings);
    Writer body;
    for (std::size_t i = 0; i < findings; ++i) put(body, answer.findings[i]);
    for (const PackFile& entry : answer.entries) put(body, entry);
    Writer whole;
    whole.number(magic);
    whole.number(layout);
    whole.number(static_cast<std::uint8_t>(answer.difficulty));
    whole.number(std::uint16_t{0});
    whole.number(static_cast<std::uint16_t>(findings));
    whole.number(static_cast<std::uint16_t>(answer.entries.size()));
    whole.number(static_cast<std::uint64_t>(unpack_header_bytes + body.bytes.size()));
    whole.number(checksum(whole.bytes));
    whole.raw(body.bytes);
    return std::move(whole.bytes);
}

Result<UnpackAnswer> unpack_answer_of(std::span<const std::byte> bytes) {
    const auto wrong = failure("the answer of touchline-unpack cannot be understood");
    Taker taker(bytes);
    const bool is_ours =
        taker.number<std::uint32_t>() == magic && taker.number<std::uint8_t>() == layout;
    UnpackAnswer answer;
    answer.difficulty = taker.number<std::uint8_t>();
    const auto zeros = taker.number<std::uint16_t>();
    const auto findings = taker.number<std::uint16_t>();
    const auto entries = taker.number<std::uint16_t>();
    const auto size = taker.number<std::uint64_t>();
    const auto sum = taker.number<std::uint32_t>();
    if (!is_ours || !taker.is_good() || zeros != 0 || size != bytes.size() ||
        sum != checksum(bytes) || answer.difficulty > 5 || findings > most_findings ||
        entries > pack_limits.files)
        return wrong;
    for (int i = 0; i < findings; ++i) {
        auto finding = take_finding(taker);
        if (!finding) return wrong;
        answer.findings.push_back(std::move(*finding));
    }
    std::set<std::string> names;
    for (int i = 0; i < entries; ++i) {
        auto entry = take_entry(taker);
        if (!entry || !names.insert(folded(entry->name)).second) return wrong;
        answer.entries.push_back(std::move(*entry));
    }
    if (!taker.is_at_end()) return wrong;
    return answer;
}

}  // namespace touchline
