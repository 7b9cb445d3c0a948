#include "app/cli/commands.h"
#include "app/cli/load.h"
#include "app/documents/decode/files.h"
#include "app/documents/decode/map_svg.h"
#include "app/documents/decode/one_line.h"
#include "haptics/collision/scene.h"
#include "haptics/curve/level_error.h"
#include "haptics/pantograph/profile.h"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace touchline {
namespace {

std::vector<Position> rendered_points(const CurveSet& curves, int piece, double level) {
    const bool is_closed = curves.pieces()[static_cast<std::size_t>(piece)].is_closed;
    const int count = curves.rendered_count(piece, level) + (is_closed ? 0 : 1);
    std::vector<Position> points;
    points.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) points.push_back(curves.rendered_point(piece, level, i));
    return points;
}

/// The boxes of the nodes that hold the rendered curve.
void write_boxes(std::back_insert_iterator<fmt::memory_buffer> to, const Scene& scene, double level,
                 const ViewBox& box) {
    const CurveSet& curves = scene.curves;
    fmt::format_to(to,
                   "<g class=\"boxes\" fill=\"none\" stroke=\"#d07000\" stroke-width=\"0.1\">\n");
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        const auto node_level = static_cast<int>(std::ceil(curves.rendered_level(piece, level)));
        for (int j = 0; j < curves.segment_count(piece, node_level); ++j) {
            const ErrorBox node = scene.tree.box(curves, piece, node_level, j);
            fmt::format_to(to,
                           "<path class=\"box\" data-piece=\"{}\" data-level=\"{}\" d=\"{}\"/>\n",
                           piece, node_level, path_data(node.corners, true, box));
        }
    }
    fmt::format_to(to, "</g>\n");
}

std::string svg(const TactileMap& map, const Scene& scene, const CurveCommandOptions& options) {
    const CurveSet& curves = scene.curves;
    const ViewBox box = view_box_of(map.area);
    fmt::memory_buffer out;
    auto to = std::back_inserter(out);
    fmt::format_to(
        to,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}mm\" "
        "height=\"{1}mm\">\n<g fill=\"none\" stroke=\"black\" stroke-width=\"0.3\">\n",
        box.width_mm, box.height_mm);
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        const Piece& of = curves.pieces()[static_cast<std::size_t>(piece)];
        fmt::format_to(to,
                       "<path data-outline=\"{}\" data-piece=\"{}\" data-level=\"{}\" d=\"{}\"/>\n",
                       of.outline, piece, curves.rendered_level(piece, options.level),
                       path_data(rendered_points(curves, piece, options.level), of.is_closed, box));
    }
    fmt::format_to(to, "</g>\n");
    if (options.with_boxes) write_boxes(to, scene, options.level, box);
    fmt::format_to(to, "</svg>\n");
    return fmt::to_string(out);
}

std::string level_report(const CurveSet& curves, int outline, int level) {
    const LevelError error = level_error(curves, outline, level);
    return fmt::format(
        "{{\"level\": {}, \"points\": {}, \"rms_m\": {}, \"hausdorff_m\": {}, \"slope_rms_rad\": "
        "{}, "
        "\"slope_max_rad\": {}}}",
        level, error.points, json_number(error.rms_m), json_number(error.hausdorff_m),
        json_number(error.slope_rms_rad), json_number(error.slope_max_rad));
}

std::string outline_report(const TactileMap& map, const CurveSet& curves, std::size_t outline) {
    const OutlineReport& kept = curves.reports()[outline];
    std::string levels;
    for (int level = 0; level <= curves.coarsest(); ++level) {
        levels +=
            (level > 0 ? ",\n      " : "") + level_report(curves, static_cast<int>(outline), level);
    }
    return fmt::format(
        "    {{\"outline\": {}, \"id\": {}, \"points_in\": {}, \"points_kept\": {}, \"why\": {},\n"
        "     \"spacing_m\": {}, \"shrunk_rms_m\": {}, \"shrunk_max_m\": {},\n"
        "     \"levels\": [\n      {}]}}",
        outline, json_string(map.outlines[outline].id), kept.points_in, kept.points_kept,
        json_string(kept.reason), json_number(kept.spacing_m), json_number(kept.shrunk_rms_m),
        json_number(kept.shrunk_max_m), levels);
}

std::string report(const TactileMap& map, const CurveSet& curves, double level) {
    std::string outlines;
    for (std::size_t i = 0; i < map.outlines.size(); ++i) {
        outlines += (i > 0 ? ",\n" : "") + outline_report(map, curves, i);
    }
    return fmt::format(
        "{{\n  \"level\": {}, \"coarsest_level\": {}, \"pieces\": {},\n  \"outlines\": [\n{}\n  "
        "]\n}}\n",
        json_number(level), curves.coarsest(), curves.pieces().size(), outlines);
}

}  // namespace

Result<void> run_curve(const CurveCommandOptions& options) {
    const Result<TactileMap> map = load_map(options.input, options.as_picture);
    if (!map) return tl::unexpected(map.error());
    CurveOptions wanted = options.curves;
    wanted.device_step_m = encoder_step_m(default_profile());  // the default of `feel`
    const Result<Scene> scene = build_scene(*map, wanted, 0.0);
    if (!scene) return tl::unexpected(scene.error());
    Result<void> drawn = write_whole_file(options.output, svg(*map, *scene, options));
    if (!drawn || options.report.empty()) return drawn;
    return write_whole_file(options.report, report(*map, scene->curves, options.level));
}

}  // namespace touchline
