#include "app/documents/decode/map_svg.h"
#include "haptics/pantograph/profile.h"
#include "tests/haptics/curve/uniform_points.h"
#include "tests/lab/bench/curve/outlines.h"
#include "tests/lab/bench/curve/report.h"

#include <algorithm>
#include <filesystem>

#include <fmt/core.h>

namespace touchline::bench {
namespace {

struct Row {
    std::string picture;
    std::size_t data = 0;
    std::size_t kept = 0;
    std::size_t fewest = 0;
    std::size_t bisected = 0;
    double spacing_mm = 0.0;
    std::string reason;

    [[nodiscard]] double ratio() const {
        return static_cast<double>(kept) / static_cast<double>(fewest);
    }
};

/// Returns the word before the colon of the reason that sets the picture's spacing.
std::string reason_of(const CurveSet& curves) {
    std::string reason = "scene";
    for (const OutlineReport& report : curves.reports()) {
        const std::string word = report.reason.substr(0, report.reason.find(':'));
        if (word == "device" || (word == "data" && reason != "device")) reason = word;
    }
    return reason;
}

Result<Row> row_of(const GalleryEntry& entry) {
    const auto map = read_map_svg(entry.path);
    if (!map) return tl::unexpected(map.error());
    const CurveOptions options{.resample = true,
                               .device_step_m = encoder_step_m(default_profile())};
    const auto curves = CurveSet::build(*map, options);
    if (!curves) return tl::unexpected(curves.error());
    const auto lines = uniform::lines_of(*map);
    Row row{std::filesystem::path(entry.path).stem().string(),
            0,
            uniform::segments_of(*curves),
            uniform::fewest_segments(lines),
            uniform::bisected_segments(lines),
            1e3 * curves->reports()[0].spacing_m,
            reason_of(*curves)};
    for (const OutlineReport& report : curves->reports()) row.data += report.points_in;
    return row;
}

std::string words(const std::vector<Row>& rows, const Table& table) {
    const auto worst = std::max_element(
        rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.ratio() < b.ratio(); });
    double kept = 0.0;
    double fewest = 0.0;
    std::string lucky;
    for (const Row& row : rows) {
        kept += static_cast<double>(row.kept);
        fewest += static_cast<double>(row.fewest);
        if (row.ratio() <= 1.1) continue;
        lucky += fmt::format(
            " {} is over 1.1: there one spacing happens to put points on corners under 45 degrees, "
            "which are not "
            "pinned, and no m 2^L does so; a bisection misses that spacing and ends at {} "
            "segments.",
            row.picture, row.bisected);
    }
    return fmt::format(
        "Resampled for the {}, whose encoders tell {:.3f} mm. The gallery's first {} pictures keep "
        "{:.0f} segments "
        "in all, {:.2f} times "
        "the fewest uniform ones that stay within 0.05 mm of the data; the largest ratio is that "
        "of {}, {:.2f}. Below 1: "
        "pieces that are nearly straight take the next lower count, which one uniform spacing "
        "cannot.{}\n\n{}",
        default_profile().name, 1e3 * encoder_step_m(default_profile()), rows.size(), kept,
        kept / fewest, worst->picture, worst->ratio(), lucky, table.markdown());
}

}  // namespace

Result<void> measure_points(const Folders& folders) {
    const auto entries = measured_pictures();
    if (!entries) return tl::unexpected(entries.error());
    std::vector<Row> rows;
    Table table{{"picture", "points in the map", "segments kept", "fewest uniform", "by bisection",
                 "ratio", "spacing mm", "limit"},
                {}};
    for (const GalleryEntry& entry : *entries) {
        const auto row = row_of(entry);
        if (!row) return tl::unexpected(row.error());
        table.rows.push_back({row->picture, fmt::format("{}", row->data),
                              fmt::format("{}", row->kept), fmt::format("{}", row->fewest),
                              fmt::format("{}", row->bisected), fmt::format("{:.2f}", row->ratio()),
                              fmt::format("{:.2f}", row->spacing_mm), row->reason});
        rows.push_back(*row);
    }
    return write_csv(folders, "curve_points", table).and_then([&] {
        return write_words(folders, "points", words(rows, table));
    });
}

}  // namespace touchline::bench
