#include "app/main/loading.h"

#include "app/cli/load.h"
#include "app/gallery/gallery.h"
#include "app/servo/scene_order.h"
#include "haptics/pantograph/profile.h"

#include <filesystem>

#include <fmt/format.h>

namespace touchline {

namespace {

// More pixels than any screen shows.
constexpr int longest_picture_px = 2000;

std::string title_of(const TactileMap& map, const std::string& path) {
    return map.title.empty() ? std::filesystem::path(path).stem().string() : map.title;
}

/// The name of a picture of the gallery; empty: it is a visitor's.
std::string gallery_file(const std::filesystem::path& path) {
    return path.parent_path() == gallery_folder() ? path.filename().string() : "";
}

}  // namespace

Result<LoadedScene> load_scene(const std::string& path, int detail, const DeviceProfile& profile) {
    auto loaded = load_picture(path, detail, Area{});
    if (!loaded) return tl::unexpected(loaded.error());
    const SceneOrder order = felt_order(profile, detail);
    auto scene = build_scene(loaded->map, order);
    if (!scene) return failure(fmt::format("{}: {}", path, scene.error().line));
    LoadedScene result;
    result.facts = {title_of(loaded->map, path), static_cast<int>(loaded->map.outlines.size()),
                    scene->curves.coarsest(), loaded->warning};
    result.shown.scene = std::make_shared<const Scene>(std::move(*scene));
    const RecordedMap recorded{loaded->map.version, gallery_file(path), detail,
                               hash_of(loaded->map)};
    result.felt = {result.shown.scene, std::make_shared<const TactileMap>(std::move(loaded->map)),
                   order, recorded};
    result.shown.picture =
        std::make_shared<const Canvas>(canvas_of(loaded->picture, longest_picture_px));
    return result;
}

}  // namespace touchline
