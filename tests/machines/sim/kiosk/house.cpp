#include "tests/machines/sim/kiosk/house.h"

#include "app/documents/decode/map_svg.h"
#include "app/isolation/process/places.h"
#include "config/settings/setting_rows.h"
#include "config/settings/settings.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

namespace touchline {
namespace {

namespace fs = std::filesystem;

const fs::path pictures = TOUCHLINE_SOURCE_DIR "/app/documents/gallery/pictures";

constexpr int blank_px = 64;
constexpr std::uint8_t white = 255;

Page blank_page(TactileMap told) {
    Page page;
    page.picture.width = blank_px;
    page.picture.height =
        static_cast<int>(std::lround(blank_px * told.area.height_m / told.area.width_m));
    page.picture.bgr.assign(static_cast<std::size_t>(3 * blank_px * page.picture.height), white);
    page.told = std::move(told);
    return page;
}

/// Returns the same file of the list with a page that was read beforehand.
FilePtr read_beforehand(const FilePtr& file, const Language& language) {
    auto map = read_map_svg((pictures / file->gallery_file).string(), {language.code()});
    const auto page = std::make_shared<const Page>(blank_page(std::move(map).value()));
    PictureFile copy = *file;
    copy.open = [page](const PageOrder&) { return *page; };
    return std::make_shared<const PictureFile>(std::move(copy));
}

Gallery read_without_workers() {
    const std::vector<Language> languages = all_languages();
    Gallery gallery = whole_gallery(languages);
    for (std::size_t i = 0; i < languages.size(); ++i)
        for (FilePtr& file : gallery.files[i]) file = read_beforehand(file, languages[i]);
    gallery.circle = read_beforehand(gallery.circle, languages.front());
    gallery.square = read_beforehand(gallery.square, languages.front());
    return gallery;
}

}  // namespace

std::vector<Language> all_languages() {
    std::vector<Language> languages;
    const auto codes = languages_in_text(Settings{}.languages).value();
    for (const std::string& code : codes)
        languages.push_back(Language::load(TOUCHLINE_CATALOGUES, code).value());
    return languages;
}

Gallery whole_gallery(const std::vector<Language>& languages) {
    return read_gallery(pictures.string(), "", languages).value();
}

const Gallery& gallery_without_workers() {
    static const Gallery gallery = read_without_workers();
    return gallery;
}

OperatorFiles site_files_in(const fs::path& folder) {
    fs::create_directories(folder);
    return {{folder / "kiosk.toml", folder / "kiosk.toml.good"},
            folder / "operator.pin",
            folder / "counters.csv",
            folder / "keys.toml",
            folder / "sound.toml",
            TOUCHLINE_SOURCE_DIR "/config/defaults/profiles",
            folder / "copies",
            folder / "packs",
            companion("touchline-import"),
            {folder / "house",
             {folder / "kiosk.toml", folder / "kiosk.toml.good"},
             folder / "profiles",
             TOUCHLINE_SOURCE_DIR "/config/defaults/profiles",
             folder / "packs",
             folder / "networks"}};
}

std::string Heard::text_since(std::size_t first) const {
    std::string text;
    for (std::size_t i = first; i < things.size(); ++i)
        if (!things[i].text.empty()) text += things[i].text + '\n';
    return text;
}

std::string Heard::last_text() const {
    for (auto at = things.rbegin(); at != things.rend(); ++at)
        if (!at->text.empty()) return at->text;
    return {};
}

bool Heard::was_said(const std::string& part, std::size_t first) const {
    return text_since(first).find(part) != std::string::npos;
}

void HeardSound::say(const Utterance& utterance) {
    heard_->things.push_back({heard_->now_s, utterance.language, utterance.text, {}});
}

void HeardSound::give(ScreenEvent event) {
    heard_->things.push_back({heard_->now_s, "", "", event});
}

void HeardSound::play_side(bool is_left) {
    heard_->things.push_back({heard_->now_s, "", is_left ? "left" : "right", {}});
}

void HeardSound::forget() {
    ++heard_->forgotten;
}

}  // namespace touchline
