#include "tests/lab/bench/tracing/gallery_trial.h"

#include "app/documents/decode/map_svg.h"
#include "app/documents/gallery/gallery.h"
#include "app/force/servo/scene_order.h"

#include <filesystem>
#include <random>

namespace touchline::bench {
namespace {

/// Returns a place anywhere, but not too near the edge.
Position start_in(const Area& area, unsigned seed) {
    std::mt19937 random(seed);
    const auto share = [&] { return 0.9 * (static_cast<double>(random()) / 4294967296.0 - 0.5); };
    const double x_m = share() * area.width_m;
    return {x_m, share() * area.height_m};
}

}  // namespace

Result<Gallery> read_trials(const std::string& folder) {
    const auto entries = list_gallery(folder);
    if (!entries) return tl::unexpected(entries.error());
    Gallery gallery;
    for (const GalleryEntry& entry : *entries) {
        auto map = read_map_svg(entry.path);
        if (!map) return tl::unexpected(map.error());
        map->version = gallery.trials.size() + 1;
        auto scene = build_scene(*map, felt_order(default_profile()));
        if (!scene) return tl::unexpected(scene.error());
        const double length_m = length_of(*map);
        gallery.trials.push_back(
            {std::filesystem::path(entry.path).stem().string(),
             std::make_shared<const Scene>(std::move(*scene)), length_m,
             limit_times * length_m / limit_speed_m_per_s,
             start_in(map->area, static_cast<unsigned>(gallery.trials.size()))});
        gallery.on_outlines.push_back(places_on(*map));
        gallery.fields.emplace_back(gallery.on_outlines.back());
    }
    return gallery;
}

TrialResult attempt(const Gallery& gallery, std::size_t index, Tracing tracing) {
    const Trial& trial = gallery.trials[index];
    TrialResult result;
    result.traced = trace(*trial.scene, tracing, trial.start, trial.limit_s);
    const auto& path = result.traced.path;
    result.score = score(gallery.fields[index], gallery.on_outlines[index], path);
    result.is_traced = result.score.p90_m <= most_p90_m && result.score.covered >= least_covered;
    result.is_named =
        most_like(gallery.fields, gallery.on_outlines, path) == static_cast<int>(index);
    return result;
}

}  // namespace touchline::bench
