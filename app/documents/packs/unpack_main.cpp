// touchline-unpack: the kiosk starts it for one piece of a picture pack. It closes its sandbox, and
// only then reads the first byte.
#include "app/documents/decode/one_line.h"
#include "app/documents/decode/worker_program.h"
#include "app/documents/packs/pack.h"
#include "app/documents/packs/unpack_work.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace touchline {
namespace {

UnpackAnswer refusing(const PackFinding& finding) {
    return {0, {finding}, {}};
}

UnpackAnswer unzipped(std::span<const std::byte> bytes) {
    auto files = files_in_zip(bytes);
    if (!files) return refusing(files.error());
    return {0, {}, std::move(*files)};
}

UnpackAnswer heard(std::span<const std::byte> bytes) {
    auto sound = read_sound(bytes);
    if (!sound) return refusing(sound.error());
    const auto samples = std::as_bytes(std::span(sound->samples));
    return {0, std::move(sound->findings), {{sound_entry, {samples.begin(), samples.end()}}}};
}

UnpackAnswer zipped(std::span<const std::byte> bytes) {
    const auto order = unpack_answer_of(bytes);
    if (!order) return refusing({FindingKind::harmful});
    auto zip = zip_with(order->entries);
    if (!zip) return refusing(zip.error());
    return {0, {}, {{zip_entry, std::move(*zip)}}};
}

/// zip | files | sound | picture LANGUAGE... | layers LANGUAGE
bool is_unpack_work(const std::vector<std::string>& words) {
    if (words.size() == 1) return words[0] == "zip" || words[0] == "files" || words[0] == "sound";
    const bool is_known = words.size() >= 2 && words.size() <= 1 + pack_limits.languages &&
                          (words[0] == "picture" || (words[0] == "layers" && words.size() == 2));
    return is_known && std::all_of(words.begin() + 1, words.end(), is_language_tag);
}

/// `words` as above. The bytes may be anything.
UnpackAnswer done(const std::vector<std::string>& words, std::span<const std::byte> bytes) {
    if (words[0] == "zip") return unzipped(bytes);
    if (words[0] == "files") return zipped(bytes);
    if (words[0] == "sound") return heard(bytes);
    if (words[0] == "layers") return picture_in_layers(as_text(bytes), words[1]);
    return check_picture(as_text(bytes), {words.begin() + 1, words.end()});
}

}  // namespace
}  // namespace touchline

int main(int argc, char** argv) {
    using namespace touchline;
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (!is_unpack_work(words)) refuse_to_run(argv[0]);
    run_worker_program({WorkerKind::pack, {}, [&words](std::span<const std::byte> bytes) {
                            return Result<std::vector<std::byte>>(bytes_of(done(words, bytes)));
                        }});
}
