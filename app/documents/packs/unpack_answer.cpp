#include "app/documents/decode/one_line.h"
#include "app/documents/packs/plain_names.h"
#include "app/documents/packs/unpack_work.h"
#include "config/types/fields.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace touchline {
namespace {

constexpr std::uint32_t magic = 0x4b'50'4c'54;  // "TLPK"
constexpr std::uint8_t layout = 2;
constexpr int most_lines = 100'000'000;

std::string fit_for_a_line(const std::string& text) {
    return one_spaced(utf8_of(text), most_finding_text_bytes - 3);
}

template <class Fields, class Finding>
void fields(Fields& f, Finding& finding) {
    f.choice(finding.kind, static_cast<FindingKind>(finding_kind_count - 1));
    f.number(finding.line, 0, most_lines);
    f.number(finding.value, -1e12, 1e12);
    f.template text<std::uint16_t>(finding.file);
    f.template text<std::uint16_t>(finding.what);
}

/// True for text that fits a line; no honest worker sends any other.
bool is_fit(const std::string& text) {
    return text.size() <= most_finding_text_bytes && is_utf8(text) &&
           one_spaced(text, most_finding_text_bytes) == text;
}

std::optional<PackFinding> take_finding(ByteReader& bytes) {
    PackFinding finding;
    const bool is_sound =
        read_checked(bytes, finding, [](auto& f, auto& found) { fields(f, found); }) &&
        is_fit(finding.file) && is_fit(finding.what);
    return is_sound ? std::optional(std::move(finding)) : std::nullopt;
}

std::optional<PackFile> take_entry(ByteReader& bytes) {
    PackFile entry;
    bytes.text<std::uint16_t>(entry.name);
    const auto raw = bytes.raw(bytes.number<std::uint32_t>());
    if (!bytes.is_good() || trouble_with_name(entry.name)) return std::nullopt;
    entry.bytes.assign(raw.begin(), raw.end());
    return entry;
}

}  // namespace

std::vector<std::byte> bytes_of(const UnpackAnswer& answer) {
    const std::size_t findings = std::min(answer.findings.size(), most_findings);
    ByteWriter bytes;
    bytes.number(magic);
    bytes.number(layout);
    bytes.number(static_cast<std::uint8_t>(answer.difficulty));
    bytes.number(static_cast<std::uint16_t>(findings));
    bytes.number(static_cast<std::uint16_t>(answer.entries.size()));
    for (std::size_t i = 0; i < findings; ++i) {
        PackFinding finding = answer.findings[i];
        finding.file = fit_for_a_line(finding.file);
        finding.what = fit_for_a_line(finding.what);
        fields(bytes, finding);
    }
    for (const PackFile& entry : answer.entries) {
        bytes.text<std::uint16_t>(entry.name);
        bytes.count(entry.bytes.size());
        bytes.raw(entry.bytes);
    }
    return bytes.take();
}

Result<UnpackAnswer> unpack_answer_of(std::span<const std::byte> all) {
    const auto wrong = failure("the answer of touchline-unpack cannot be understood");
    ByteReader bytes(all);
    const bool is_ours =
        bytes.number<std::uint32_t>() == magic && bytes.number<std::uint8_t>() == layout;
    UnpackAnswer answer;
    answer.difficulty = bytes.number<std::uint8_t>();
    const auto findings = bytes.number<std::uint16_t>();
    const auto entries = bytes.number<std::uint16_t>();
    if (!is_ours || !bytes.is_good() || answer.difficulty > 5 || findings > most_findings ||
        entries > pack_limits.files)
        return wrong;
    for (int i = 0; i < findings; ++i) {
        auto finding = take_finding(bytes);
        if (!finding) return wrong;
        answer.findings.push_back(std::move(*finding));
    }
    std::set<std::string> names;
    for (int i = 0; i < entries; ++i) {
        auto entry = take_entry(bytes);
        if (!entry || !names.insert(in_small_letters(entry->name)).second) return wrong;
        answer.entries.push_back(std::move(*entry));
    }
    if (!bytes.is_at_end()) return wrong;
    return answer;
}

}  // namespace touchline
