#include "app/packs/unpack_program.h"

#include "app/packs/pack_limits.h"
#include "app/packs/pack_toml.h"
#include "app/packs/picture_check.h"
#include "app/packs/sound_reader.h"
#include "app/packs/zip_reader.h"

#include <algorithm>
#include <string_view>

namespace touchline {
namespace {

UnpackAnswer refused(const PackFinding& finding) {
    return {0, {finding}, {}};
}

UnpackAnswer unzipped(std::span<const std::byte> bytes) {
    auto files = files_in_zip(bytes);
    if (!files) return refused(files.error());
    return {0, {}, std::move(*files)};
}

UnpackAnswer heard(std::span<const std::byte> bytes) {
    auto sound = read_sound(bytes);
    if (!sound) return refused(sound.error());
    const auto samples = std::as_bytes(std::span(sound->samples));
    return {0, std::move(sound->findings), {{sound_entry, {samples.begin(), samples.end()}}}};
}

}  // namespace

bool is_unpack_work(const std::vector<std::string>& words) {
    if (words.size() == 1) return words[0] == "zip" || words[0] == "sound";
    const bool is_known = words.size() >= 2 && words.size() <= 1 + pack_limits.languages &&
                          (words[0] == "picture" || (words[0] == "layers" && words.size() == 2));
    return is_known && std::all_of(words.begin() + 1, words.end(), is_language_tag);
}

std::vector<std::byte> unpack_work(const std::vector<std::string>& words,
                                   std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (words[0] == "zip") return bytes_of(unzipped(bytes));
    if (words[0] == "sound") return bytes_of(heard(bytes));
    if (words[0] == "layers") return bytes_of(picture_in_layers(text, words[1]));
    return bytes_of(check_picture(text, {words.begin() + 1, words.end()}));
}

}  // namespace touchline
