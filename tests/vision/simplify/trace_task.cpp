#include "tests/vision/simplify/trace_task.h"

#include "config/types/map_bytes.h"
#include "tests/config/map_samples.h"
#include "tests/vision/simplify/touch_rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace touchline::testing {
namespace {

using Faults = std::vector<std::string>;

/// Judges what a visitor hears: a sentence that says what to do, and nothing of the program's
/// internals.
void judge_line(const std::string& line, Faults& faults) {
    const auto is_control = [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) == 0x7f;
    };
    if (line.empty() || std::ranges::any_of(line, is_control)) {
        faults.push_back("not one line: " + line);
    }
    constexpr std::array<std::string_view, 8> program_words{
        "OpenCV", "error", ".cpp", "std::", "(-", "()", "Assertion", "program"};
    for (const std::string_view word : program_words) {
        if (line.find(word) != std::string::npos)
            faults.push_back("nothing for a visitor: " + line);
    }
    const auto todo = line.find("; ");
    if (todo == std::string::npos || todo + 2 >= line.size()) {
        faults.push_back("does not say what to do: " + line);
    }
}

bool is_in_area(const Position& p, const Area& area) {
    constexpr double rounding_m = 1e-9;
    return std::abs(p.x) <= 0.5 * area.width_m + rounding_m &&
           std::abs(p.y) <= 0.5 * area.height_m + rounding_m;
}

void judge_points(const TactileMap& map, Faults& faults) {
    for (const Outline& outline : map.outlines) {
        const std::size_t n = outline.points.size();
        if (n < (outline.is_closed ? 3U : 2U)) {
            faults.push_back(fmt::format("{} has {} points", outline.id, n));
        }
        for (std::size_t i = 0; i < n; ++i) {
            const Position& p = outline.points[i];
            if (!std::isfinite(p.x) || !std::isfinite(p.y) || !is_in_area(p, map.area)) {
                faults.push_back(
                    fmt::format("{} is at {}, {} mm", outline.id, 1e3 * p.x, 1e3 * p.y));
                return;
            }
            const bool has_next = outline.is_closed || i + 1 < n;
            if (has_next && n > 1 && p == outline.points[(i + 1) % n]) {
                faults.push_back(
                    fmt::format("{} stands still at point {} of {}", outline.id, i, n));
                return;
            }
        }
    }
}

void judge_crossing_over(const TactileMap& map, Faults& faults) {
    const auto bytes = bytes_of(map);
    if (!bytes) {
        faults.push_back("cannot be sent: " + bytes.error().line);
        return;
    }
    const auto back = map_of(*bytes);
    if (!back || !is_same_map(*back, map)) faults.push_back("comes back as another map");
}

void judge_touch(const TactileMap& map, int detail, Faults& faults) {
    TouchRules rules = touch_rules(detail, map.area);
    // Both ends of a sliver may be led to one line. Each bridge begins a gap and two and a half
    // steps, of 0.2 to 0.5 mm, before it.
    rules.bridge_mm = 2.5 * std::clamp(rules.gap_mm / 16.0, 0.2, 0.5);
    // If no line is long enough by itself, the tracer halves the least length until one is: the
    // first, with nothing else in its way. Others beside it may then be longer, because it changes
    // where they are cut, and they are led to it.
    const double first_mm = length_of(map.outlines.front());
    constexpr int most_halvings = 9;
    for (int i = 0; i < most_halvings && first_mm < rules.stroke_mm; ++i) {
        rules.stroke_mm *= 0.5;
    }
    std::ranges::move(faults_of(map, rules), std::back_inserter(faults));
}

void judge_report(const Trace& trace, int detail, Faults& faults) {
    for (const Outline& outline : trace.map.outlines) {
        if (outline.detail > detail) faults.push_back(outline.id + " belongs to a higher detail");
        if (outline.label.empty()) faults.push_back(outline.id + " has no name");
    }
    const TraceReport& report = trace.report;
    if (report.outlines != static_cast<int>(trace.map.outlines.size()) || report.outlines == 0) {
        faults.push_back(fmt::format("tells of {} outlines", report.outlines));
    }
    const SimplifyReport& simplified = report.simplified;
    if (!std::isfinite(simplified.line_mm) || simplified.left_out < 0 || simplified.words.empty() ||
        simplified.words.find('\n') != std::string::npos) {
        faults.push_back("an unsound report: " + simplified.words);
    }
}

void judge_map(const Trace& trace, int detail, Faults& faults) {
    if (!is_sound(trace.map)) faults.push_back("the map is unsound");
    judge_report(trace, detail, faults);
    judge_crossing_over(trace.map, faults);
    judge_points(trace.map, faults);
    if (faults.empty()) judge_touch(trace.map, detail, faults);
}

}  // namespace

TraceTask task_of(std::span<const std::uint8_t> bytes) {
    constexpr std::array<Area, 4> areas{Area{}, Area{}, Area{0.180, 0.120}, Area{0.05, 0.09}};
    ByteReader reader(bytes);
    TraceTask task;
    const int picture_class = reader.choice(5);
    if (picture_class > 0)
        task.options.picture_class = static_cast<PictureClass>(picture_class - 1);
    const int detail = reader.choice(8);
    task.details = {detail};
    if (detail == 0 || detail > most_detail) task.details = {1, 2, 3, 4, 5};
    task.options.area = areas[static_cast<std::size_t>(reader.choice(4))];
    const int zoom = reader.byte();  // magnifies one time in four
    const double right = reader.share() - 0.5;
    const double up = reader.share() - 0.5;
    if (zoom >= 192) {
        task.options.zoom = {{right * task.options.area.width_m, up * task.options.area.height_m},
                             1.0 + 15.0 * (zoom - 192) / 63.0};
    }
    task.picture = odd_picture(reader);
    return task;
}

std::string words_for(const TraceTask& task) {
    const TraceOptions& options = task.options;
    return fmt::format("{} x {}, {} channels, {}, detail {}, zoom {:.2f}, area {} mm",
                       task.picture.cols, task.picture.rows, task.picture.channels(),
                       options.picture_class ? name_of(*options.picture_class) : "any class",
                       task.details.size() > 1 ? "all" : fmt::to_string(task.details.front()),
                       options.zoom.factor, 1e3 * options.area.width_m);
}

std::vector<std::string> faults_of(const TraceTask& task, TraceTally& tally) {
    Faults faults;
    ++tally.tasks;
    const Result<Found> found = find_lines(task.picture, task.options);
    if (!found) {
        ++tally.lines;
        judge_line(found.error().line, faults);
        return faults;
    }
    for (const int detail : task.details) {
        TraceOptions options = task.options;
        options.detail = detail;
        const Result<Trace> trace = trace_lines(*found, options);
        if (trace) {
            ++tally.maps;
            judge_map(*trace, detail, faults);
        } else {
            ++tally.lines;
            judge_line(trace.error().line, faults);
        }
    }
    return faults;
}

}  // namespace touchline::testing
