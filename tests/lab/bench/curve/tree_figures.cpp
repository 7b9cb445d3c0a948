#include "app/cli/load.h"
#include "app/documents/decode/files.h"
#include "app/documents/decode/picture.h"
#include "app/documents/gallery/gallery.h"
#include "app/screen/paint.h"
#include "app/screen/text.h"
#include "haptics/collision/scene.h"
#include "haptics/curve/spacing.h"
#include "tests/lab/bench/curve/report.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

namespace touchline::bench {
namespace {

constexpr std::array approaches_m{0.02, 0.004, 0.001, 0.0001};  // from handle to outline
constexpr std::array<int, 4> box_levels{2, 3, 4, 5};
constexpr double level_0_points = 512.0;

/// Returns a scene of a map's longest outline alone, with about 512 points at level 0.
Result<Scene> scene_of_longest(const TactileMap& map) {
    const auto length_m = [](const Outline& outline) { return polyline_length_m(outline.points); };
    const auto longest = std::max_element(
        map.outlines.begin(), map.outlines.end(),
        [&](const Outline& a, const Outline& b) { return length_m(a) < length_m(b); });
    TactileMap alone;
    alone.area = map.area;
    alone.outlines.push_back(*longest);
    return build_scene(alone, {.resample = true, .spacing_m = length_m(*longest) / level_0_points},
                       0.0);
}

std::string box_lines(const ErrorBox& box) {
    std::string text;
    for (std::size_t i = 0; i <= box.corners.size(); ++i) {
        const Position p = box.corners[i % box.corners.size()];
        text += fmt::format("{:.4f} {:.4f}\n", 1e3 * p.x, 1e3 * p.y);
    }
    return text + "\n";
}

std::string curve_lines(const CurveSet& curves) {
    std::string text;
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        for (int j = 0; j < curves.segment_count(piece, 0); ++j) {
            const Segment s = curves.rendered_segment(piece, 0.0, j);
            text += fmt::format("{:.4f} {:.4f}\n{:.4f} {:.4f}\n\n", 1e3 * s.a.x, 1e3 * s.a.y,
                                1e3 * s.b.x, 1e3 * s.b.y);
        }
    }
    return text + "\n\n";
}

/// Returns the curve's point farthest to the upper left.
Position upper_left(const CurveSet& curves) {
    Position best;
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        for (const Position p : curves.points(piece, 0)) {
            if (p.y - p.x > best.y - best.x) best = p;
        }
    }
    return best;
}

/// Paints the error boxes of one level over the pieces.
void paint_level(cairo_t* cr, const View& view, const Scene& scene, int level) {
    const CurveSet& curves = scene.curves;
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        const int own = std::min(level, curves.pieces()[static_cast<std::size_t>(piece)].coarsest);
        for (int j = 0; j < curves.segment_count(piece, own); ++j) {
            const auto corners = scene.tree.box(curves, piece, own, j).corners;
            const std::array<Position, 5> around{corners[0], corners[1], corners[2], corners[3],
                                                 corners[0]};
            paint_path(cr, view, around, 1.5, {white_on_black.box});
        }
    }
    paint_outlines(cr, view, curves, level, 1.5, {white_on_black.outline});
}

/// Returns the mean half-width of the boxes of a level (m).
double half_width_m(const Scene& scene, int level) {
    double sum = 0.0;
    int count = 0;
    for (int piece = 0; piece < static_cast<int>(scene.curves.pieces().size()); ++piece) {
        const int own =
            std::min(level, scene.curves.pieces()[static_cast<std::size_t>(piece)].coarsest);
        for (int j = 0; j < scene.curves.segment_count(piece, own); ++j) {
            const auto corners = scene.tree.box(scene.curves, piece, own, j).corners;
            sum += 0.5 * std::min(norm(corners[1] - corners[0]), norm(corners[2] - corners[1]));
            ++count;
        }
    }
    return count > 0 ? sum / count : 0.0;
}

Result<void> write_sections(const Folders& folders, const Scene& scene) {
    const Position target = upper_left(scene.curves);
    const Direction inward = direction_of(Position{1.0, -1.0});
    std::string text = curve_lines(scene.curves);
    std::string counts;
    for (const double away_m : approaches_m) {
        const Position handle = target + along<Position>(inward, away_m);
        std::vector<ErrorBox> section;
        scene.tree.boundary_section(scene.curves, handle, 0, section);
        int finest = scene.curves.coarsest();
        for (const ErrorBox& box : section) {
            text += box_lines(box);
            finest = std::min(finest, box.level);
        }
        text += fmt::format("\n{:.4f} {:.4f}\n\n\n", 1e3 * handle.x, 1e3 * handle.y);
        counts += fmt::format("{}{} boxes, the finest of level {}, at {:.1f} mm",
                              counts.empty() ? "" : "; ", section.size(), finest, 1e3 * away_m);
    }
    return write_whole_file(folders.work + "/fig4.dat", text).and_then([&] {
        return write_words(
            folders, "fig-sections",
            fmt::format(
                "Fig. 4, boundary sections as the handle comes from inside to the upper left of "
                "the coast of an island: {}. Far away the coarsest boxes are enough; near by only "
                "those that hold the handle are split, and the rest of the coast stays coarse.",
                counts));
    });
}

}  // namespace

Result<void> plot_sections(const Folders& folders) {
    return load_map(gallery_folder() + "/08-island.svg", false)
        .and_then(scene_of_longest)
        .and_then([&](const Scene& scene) { return write_sections(folders, scene); });
}

Result<void> paint_boxes(const Folders& folders) {
    const std::string path = gallery_folder() + "/06-fish.svg";
    const auto map = load_map(path, false);
    if (!map) return tl::unexpected(map.error());
    const auto picture = read_picture(path);
    if (!picture) return tl::unexpected(picture.error());
    const auto scene = build_scene(*map, {.resample = true, .spacing_m = 5e-4}, 0.0);
    if (!scene) return tl::unexpected(scene.error());
    constexpr double width_px = 640.0;
    constexpr double height_px = 470.0;
    constexpr double cap_px = 14.0;
    Canvas canvas(static_cast<int>(2.0 * width_px), static_cast<int>(2.0 * height_px));
    cairo_t* const cr = canvas.context();
    fill(cr, {0.0, 0.0, 2.0 * width_px, 2.0 * height_px}, {white_on_black.background});
    const Canvas behind = canvas_of(*picture, 1000);
    std::string widths;
    for (std::size_t i = 0; i < box_levels.size(); ++i) {
        const Rect rect{width_px * static_cast<double>(i % 2),
                        height_px * static_cast<double>(i / 2), width_px, height_px};
        const View view = view_of(scene->area, rect);
        paint_picture(cr, view, scene->area, behind);
        paint_level(cr, view, *scene, box_levels[i]);
        const std::string name = fmt::format("level {}", box_levels[i]);
        const std::array<TextRun, 1> run{TextRun{name}};
        paint_text(cr, {rect.x + cap_px, rect.y + cap_px}, width_px, cap_px, run);
        widths += fmt::format("{}{:.2f} mm at level {}", i > 0 ? ", " : "",
                              1e3 * half_width_m(*scene, box_levels[i]), box_levels[i]);
    }
    return write_png(folders.results + "/fig7.png", picture_of(canvas)).and_then([&] {
        return write_words(
            folders, "fig-boxes",
            fmt::format("Fig. 7, curve (yellow) and error boxes (blue) of levels 2 to 5 over the "
                        "picture of a fish, resampled at 0.5 mm. Mean half-width of the boxes: {}. "
                        "Corners are pinned and stay sharp at every level.",
                        widths));
    });
}

}  // namespace touchline::bench
