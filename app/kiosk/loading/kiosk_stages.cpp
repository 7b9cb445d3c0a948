#include "app/kiosk/loading/kiosk_stages.h"

#include "app/documents/decode/one_line.h"
#include "app/documents/decode/opening.h"
#include "app/documents/gallery/gallery.h"
#include "app/documents/models/networks.h"
#include "app/documents/trace/finding_things.h"
#include "app/documents/trace/page_views.h"
#include "app/force/servo/scene_order.h"
#include "app/screen/canvas.h"
#include "app/screen/layout.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <utility>

namespace touchline {
namespace {

// More pixels than any screen shows.
constexpr int longest_picture_px = 2000;
constexpr double longest_enlarged_px = 1200.0;

constexpr std::size_t most_things = 50;  // a list that nobody goes through

std::uint64_t next_version() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

/// Says which page it is that has nothing to feel.
Error of_page(const PictureFile& file, const PagePlace& place, const Error& error) {
    const std::string page =
        place.page_count > 1 ? ", page " + std::to_string(place.page) : std::string();
    return {file.name + page + ": " + error.line};
}

std::size_t bytes_in(const FoundView& found) {
    return bytes_of(*found.view) + bytes_of(found.recordings) +
           (found.lines ? found.lines->bytes : 0) +
           static_cast<std::size_t>(found.picture->stride()) *
               static_cast<std::size_t>(found.picture->height());
}

TraceOptions options_for(const FeltPart& part) {
    return {Area{}, part.detail, part.zoom};
}

Result<FoundPtr> found_in(PagePtr view, const PagePlace& place, const FeltPart& part,
                          PictureRecordingsPtr recordings) {
    FoundView found;
    found.recordings = std::move(recordings);
    if (!is_own_map(*view)) {
        auto traced = find_page_lines(*view, {options_for(part)});
        if (!traced) return tl::unexpected(traced.error());
        found.lines = std::move(traced->lines);
        found.is_photo = place.view_count == 1 && traced->map && traced->map->is_photo;
        found.first = TracedPart{part, std::move(traced->map)};
    }
    found.picture = std::make_shared<const Canvas>(canvas_of(view->picture, longest_picture_px));
    found.place = place;
    found.view = std::move(view);
    found.bytes = bytes_in(found);
    return std::make_shared<const FoundView>(std::move(found));
}

/// The page, drawn as finely as the view needs; the page itself if that fails.
PagePtr fine_page(const PictureFile& file, const PagePtr& page, int view) {
    auto finer = finer_page(*page, view, file.open);
    return finer ? std::make_shared<const Page>(std::move(*finer)) : page;
}

/// What is felt at a detail, and one sentence that may be worth telling.
struct FeltMap {
    TactileMap map;
    std::string warning;
};

Result<TracedMap> traced_map(const FoundView& found, const FeltPart& part) {
    if (found.first && found.first->part == part) return found.first->map;
    return trace_page_lines(*found.view, *found.lines, options_for(part));
}

Result<FeltMap> felt_map(const FoundView& found, const FeltPart& part) {
    if (found.lines)
        return traced_map(found, part).map([](TracedMap traced) {
            return FeltMap{std::move(traced.map), std::move(traced.warning)};
        });
    auto whole = shown_at(found.view->told, part.detail);
    if (!whole) return tl::unexpected(whole.error());
    TactileMap map = enlarged(*whole, part.zoom);
    if (map.outlines.empty())
        return failure("there is no line in this part; choose another part, or the whole picture");
    return FeltMap{std::move(map), {}};
}

/// The part of the picture that is felt, for the screen: over the whole drawing area.
std::shared_ptr<const Canvas> enlarged_picture(const std::shared_ptr<const Canvas>& picture,
                                               const Area& area, const Zoom& zoom) {
    if (zoom.factor == 1.0) return picture;
    const double px_per_m = longest_enlarged_px / std::max(area.width_m, area.height_m);
    const Area lies = fitted(area, picture->width(), picture->height());
    const double scale = zoom.factor * px_per_m * lies.width_m / picture->width();
    Canvas canvas(static_cast<int>(std::lround(px_per_m * area.width_m)),
                  static_cast<int>(std::lround(px_per_m * area.height_m)));
    cairo_t* const cr = canvas.context();
    cairo_translate(cr, 0.5 * canvas.width() - zoom.factor * px_per_m * zoom.centre.x,
                    0.5 * canvas.height() + zoom.factor * px_per_m * zoom.centre.y);
    cairo_scale(cr, scale, scale);
    cairo_set_source_surface(cr, picture->surface(), -0.5 * picture->width(),
                             -0.5 * picture->height());
    cairo_paint(cr);
    cairo_surface_flush(canvas.surface());
    return std::make_shared<const Canvas>(std::move(canvas));
}

}  // namespace

PageReader page_reader(std::shared_ptr<const std::atomic<WrittenLanguage>> language) {
    return [language = std::move(language)](const Page& page) -> std::optional<Page> {
        if (!needs_reading(page)) return std::nullopt;
        const auto found = read_words(page.picture, {{language->load()}});
        if (!found || found->labels.empty()) return std::nullopt;
        return with_words(page, *found);
    };
}

ThingFinder thing_finder() {
    return [](const Page& page,
              const std::optional<PlaceInPicture>& place) -> Result<std::optional<Page>> {
        if (place && page.figures.size() >= most_things) return std::nullopt;
        const auto files = read_picture_networks();
        if (!files) return tl::unexpected(files.error());
        const auto networks = with_room(files->networks());
        if (!networks) return tl::unexpected(networks.error());
        auto things =
            place ? find_thing_at(*place, page, *networks) : find_main_things(page, *networks);
        if (!things) return tl::unexpected(things.error());
        if (place && !things->is_sure) return std::nullopt;
        if (place) return with_further_thing(page, std::move(*things));
        Page seen = with_main_things(page, std::move(*things));
        seen.was_searched = !networks->figure.empty();
        return seen;
    };
}

KioskStages::KioskStages(DeviceProfile profile, PageReader reader, ThingFinder finder)
    : profile_(std::move(profile)), reader_(std::move(reader)), finder_(std::move(finder)) {}

Result<PagePtr> KioskStages::open(const PictureFile& file, int page) const {
    auto opened = file.open({page, PageOrder{}.dpi});
    if (!opened) return tl::unexpected(opened.error());
    if (opened->number != page)
        return failure(file.name + ": this page could not be opened; choose another one");
    return std::make_shared<const Page>(std::move(*opened));
}

Result<FoundPtr> KioskStages::find(const PictureFile& file, const PagePtr& page, int view,
                                   const FeltPart& part) const {
    const int views = view_count(*page);
    const PagePtr fine = fine_page(file, page, view);
    const PagePtr cut = view < views ? std::make_shared<const Page>(view_of(*fine, view)) : fine;
    const PagePlace place = place_of(*page, view);
    return found_in(cut, place, part, file.recordings ? file.recordings(cut->told) : nullptr)
        .map_error([&](const Error& error) { return of_page(file, place, error); });
}

Result<LoadedScene> KioskStages::build(const PictureFile& file, const FoundView& found,
                                       const FeltPart& part) const {
    auto felt = felt_map(found, part);
    if (!felt) return tl::unexpected(of_page(file, found.place, felt.error()));
    TactileMap& map = felt->map;
    map.version = next_version();
    const SceneOrder order = felt_order(profile_, part.detail);
    auto scene = build_scene(map, order);
    if (!scene) return tl::unexpected(of_page(file, found.place, scene.error()));
    LoadedScene result;
    result.facts = {map.title.empty() ? file.title : map.title,
                    static_cast<int>(map.outlines.size()), std::move(felt->warning), found.place};
    result.facts.recordings = found.recordings;
    if (found.is_photo)
        result.facts.place.things = finder_ ? ThingSearch::under_way : ThingSearch::impossible;
    result.shown = {std::make_shared<const Scene>(std::move(*scene)),
                    enlarged_picture(found.picture, map.area, part.zoom)};
    const bool is_whole = part.zoom == Zoom{};
    const RecordedMap recorded{map.version, is_whole ? file.gallery_file : "", part.detail,
                               hash_of(map)};
    result.felt = {result.shown.scene, std::make_shared<const TactileMap>(std::move(map)), order,
                   recorded};
    return result;
}

Result<PagePtr> KioskStages::look(const PagePtr& page) const {
    return seen(page, std::nullopt).map([&page](PagePtr looked_at) {
        return looked_at ? std::move(looked_at) : page;
    });
}

Result<PagePtr> KioskStages::look_at(const PagePtr& page, int view, const Position& place) const {
    return seen(page, place_in_page(*page, view, place));
}

Result<PagePtr> KioskStages::seen(const PagePtr& page,
                                  const std::optional<PlaceInPicture>& place) const {
    return finder_(*page, place).map([](std::optional<Page> seen) {
        return seen ? std::make_shared<const Page>(std::move(*seen)) : PagePtr();
    });
}

FoundPtr KioskStages::reread(const FoundView& found) const {
    auto read = reader_(*found.view);
    if (!read) return nullptr;
    const FeltPart part = found.first ? found.first->part : FeltPart{};
    return found_in(std::make_shared<const Page>(std::move(*read)), found.place, part,
                    found.recordings)
        .value_or(nullptr);
}

Result<LoadedScene> scene_of_drawing(TactileMap drawing, const DeviceProfile& profile) {
    drawing.version = next_version();
    const SceneOrder order = felt_order(profile);
    auto scene = build_scene(drawing, order);
    if (!scene) return tl::unexpected(scene.error());
    LoadedScene result;
    result.facts.title = drawing.title;
    result.facts.outline_count = static_cast<int>(drawing.outlines.size());
    result.shown.scene = std::make_shared<const Scene>(std::move(*scene));
    const RecordedMap recorded{drawing.version, "", 0, hash_of(drawing)};
    result.felt = {result.shown.scene, std::make_shared<const TactileMap>(std::move(drawing)),
                   order, recorded};
    return result;
}

FeltPicture nothing_to_feel(const DeviceProfile& profile) {
    auto nothing = scene_of_drawing({}, profile);
    assert(nothing && "an empty map is a sound one");
    return std::move(nothing->felt);
}

FilePtr file_at(const std::string& path) {
    const std::filesystem::path name(path);
    const bool is_of_gallery = name.parent_path() == gallery_folder();
    return std::make_shared<const PictureFile>(
        PictureFile{one_line(path), one_line(name.stem().string()),
                    is_of_gallery ? name.filename().string() : "", false,
                    [path](const PageOrder& order) { return open_page_of(path, order); },
                    name.filename().string()});
}

}  // namespace touchline
