#include "app/documents/packs/unpacking.h"

#include "app/documents/packs/plain_names.h"
#include "app/documents/packs/unpack_work.h"
#include "app/isolation/process/memory.h"
#include "app/isolation/process/places.h"
#include "app/isolation/sandbox/worker.h"
#include "config/types/map_bytes.h"

#include <algorithm>
#include <cstring>

namespace touchline {
namespace {

constexpr SaidOfEnds<FindingKind> found_at_ends{FindingKind::no_worker, FindingKind::too_slow,
                                                FindingKind::no_memory, FindingKind::harmful};

bool is_refused(const UnpackAnswer& answer) {
    return !answer.findings.empty() &&
           severity_of(answer.findings.front().kind) == FindingSeverity::refusal;
}

/// The worker's answer about the bytes; the worker's own refusal is a finding.
PackResult<UnpackAnswer> worked(const std::vector<std::string>& words,
                                std::span<const std::byte> bytes) {
    if (bytes.empty()) return refusal({FindingKind::empty});
    const auto input = sealed_copy(bytes);
    if (!input) return refusal({FindingKind::no_memory});
    const auto mapped =
        call_worker({companion("touchline-unpack"), words, WorkerKind::pack}, *input);
    if (!mapped) return refusal({found_at_ends[mapped.error()]});
    auto answer = unpack_answer_of(mapped->bytes());
    if (!answer) return refusal({FindingKind::harmful});
    if (is_refused(*answer)) return refusal(answer->findings.front());
    return std::move(*answer);
}

const PackFile* only_entry(const UnpackAnswer& answer, std::string_view name) {
    const bool is_it = answer.entries.size() == 1 && answer.entries.front().name == name;
    return is_it ? &answer.entries.front() : nullptr;
}

void name_file(std::vector<PackFinding>& findings, const std::string& file) {
    for (PackFinding& finding : findings) finding.file = file;
}

tl::unexpected<PackFinding> of_file(PackFinding finding, const PackFile& file) {
    finding.file = file.name;
    return refusal(std::move(finding));
}

}  // namespace

PackResult<std::vector<PackFile>> unpack_zip(std::span<const std::byte> zip) {
    if (zip.size() > pack_limits.zip_bytes) return refused(FindingKind::zip_too_large);
    auto answer = worked({"zip"}, zip);
    if (!answer) return refusal(answer.error());
    std::ranges::sort(answer->entries, {}, &PackFile::name);
    return std::move(answer->entries);
}

PackResult<std::vector<std::byte>> zip_of(const Pack& pack) {
    const std::vector<std::byte> files = bytes_of(UnpackAnswer{0, {}, pack.files});
    if (files.size() > pack_limits.zip_bytes) return refused(FindingKind::zip_too_large);
    auto answer = worked({"files"}, files);
    if (!answer) return refusal(answer.error());
    const PackFile* const zip = only_entry(*answer, zip_entry);
    if (zip == nullptr) return refusal({FindingKind::harmful});
    if (zip->bytes.size() > pack_limits.zip_bytes) return refused(FindingKind::zip_too_large);
    return zip->bytes;
}

PackResult<PackSoundLook> open_sound(const PackFile& file) {
    auto answer = worked({"sound"}, file.bytes);
    if (!answer) return of_file(answer.error(), file);
    const PackFile* pcm = only_entry(*answer, sound_entry);
    const std::size_t count = pcm == nullptr ? 0 : pcm->bytes.size() / sizeof(std::int16_t);
    constexpr std::size_t most = 48000 * static_cast<std::size_t>(pack_limits.sound_s);
    if (count == 0 || count > most || pcm->bytes.size() % sizeof(std::int16_t) != 0)
        return of_file({FindingKind::sound_broken}, file);
    std::vector<std::int16_t> samples(count);
    std::memcpy(samples.data(), pcm->bytes.data(), pcm->bytes.size());
    PackSoundLook look{recording_of(std::move(samples)), std::move(answer->findings)};
    name_file(look.findings, file.name);
    return look;
}

PackResult<PackPictureLook> open_picture(const PackFile& file,
                                         const std::vector<std::string>& languages) {
    std::vector<std::string> words{"picture"};
    words.insert(words.end(), languages.begin(), languages.end());
    auto answer = worked(words, file.bytes);
    if (!answer) return of_file(answer.error(), file);
    const PackFile* map_bytes = only_entry(*answer, map_entry);
    auto map =
        map_bytes == nullptr ? Result<TactileMap>(failure("no map")) : map_of(map_bytes->bytes);
    if (!map) return of_file({FindingKind::harmful}, file);
    PackPictureLook look{std::move(*map), std::nullopt, std::move(answer->findings)};
    if (answer->difficulty > 0) look.difficulty = answer->difficulty;
    name_file(look.findings, file.name);
    return look;
}

PackResult<PackFile> as_image_layers(const PackFile& file, const std::string& language) {
    auto answer = worked({"layers", language}, file.bytes);
    if (!answer) return of_file(answer.error(), file);
    const PackFile* made = only_entry(*answer, picture_entry);
    if (made == nullptr) return of_file({FindingKind::harmful}, file);
    return PackFile{file.name, made->bytes};
}

}  // namespace touchline
