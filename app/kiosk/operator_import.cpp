#include "app/kiosk/operator_import.h"

#include "app/documents/models/networks.h"
#include "app/documents/packs/pack.h"
#include "app/documents/packs/pack_library.h"
#include "app/visit/told_lines.h"

#include <span>
#include <utility>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr const char* no_file = "The file cannot be saved. Make room on the disk.";

Outcome import_pictures(std::span<const std::byte> bytes, const std::string& name,
                        const fs::path& library, const Language& language) {
    auto pack = read_pack(bytes);
    if (!pack && pack.error().file.empty()) pack.error().file = name;
    if (!pack) return {sentence_of(pack.error(), language), ""};
    const auto folder = import_pack(*pack, library.string());
    if (!folder) return {sentence_of(folder.error(), language), ""};
    return {language.text("operator", "The pictures will be there when the kiosk next starts."),
            ""};
}

Outcome import_network(std::span<const std::byte> bytes, const std::string& name,
                       const Language& language) {
    const Network* const network = network_of(bytes);
    if (network == nullptr)
        return {language.text("operator",
                              "{0} is damaged, or made for another version of Touchline. Copy it "
                              "to the USB stick again.",
                              {name}),
                ""};
    return outcome_of(
        install_network(*network, bytes),
        language.text("operator", "Main things of photographs are found from now on."), no_file,
        language);
}

}  // namespace

StickFileReader reader_of(const OperatorStick& stick, std::size_t file, const Language& language) {
    return [read = stick.reader_of(file), language]() -> Result<Mapping, Outcome> {
        auto bytes = read();
        if (bytes) return std::move(*bytes);
        const std::string why = sentence_of(bytes.error(), "");
        return tl::unexpected(
            Outcome{told_of_file(why, stick_trouble, language, ToldTo::staff), why});
    };
}

Outcome imported(const Brought& file, const fs::path& library, const Language& language) {
    const auto bytes = file.read();
    if (!bytes) return bytes.error();
    return file.kind == StickFileKind::network
               ? import_network(bytes->bytes(), file.name, language)
               : import_pictures(bytes->bytes(), file.name, library, language);
}

}  // namespace touchline
