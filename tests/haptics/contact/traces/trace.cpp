#include "tests/haptics/contact/traces/trace.h"

#include "haptics/contact/event_detector.h"

#include <cmath>

namespace touchline::traces {

const std::array<ColumnKind, column_count> columns{{
    {"starts"},
    {"mode"},
    {"level", 1e3},
    {"handle_x", per_m},
    {"handle_y", per_m},
    {"state"},
    {"trail"},
    {"outline"},
    {"piece"},
    {"side"},
    {"parameter", 1e6, 50},
    {"is_at_end"},
    {"has_popped"},
    {"proxy_x", per_m, 2},
    {"proxy_y", per_m, 2},
    {"force_x", 1e6, 2},
    {"force_y", 1e6, 2},
    {"stored", 1e9, 2},
    {"rendered_level", 1e6, 2},
    {"felt_level", 1e6, 2},
    {"path", per_m, 4},
    {"carried", per_m, 2},
    {"clear", 1e6, 2},
    {"boxes"},
    {"told"},
    {"told_outline"},
}};

namespace {

double given(const Row& row, Column column) {
    return static_cast<double>(row[column]) / columns[column].per_unit;
}

void put(Row& row, Column column, double value) {
    row[column] = std::llround(value * columns[column].per_unit);
}

double length_m(const std::vector<Position>& way) {
    double sum_m = 0.0;
    for (std::size_t i = 1; i < way.size(); ++i) sum_m += norm(way[i] - way[i - 1]);
    return sum_m;
}

/// Returns the states as digits, the first in front.
double digits_of(const StateTrail& states) {
    double digits = 1.0;
    for (int i = 0; i < states.size(); ++i) digits = 10.0 * digits + static_cast<double>(states[i]);
    return digits;
}

void put(Row& row, const ContactReport& report) {
    put(row, state, static_cast<double>(report.state));
    put(row, trail, digits_of(report.transitions));
    put(row, outline, report.outline);
    put(row, piece, report.piece);
    put(row, side, report.outline < 0 ? 0.0 : static_cast<double>(report.side));
    put(row, parameter, report.parameter);
    put(row, is_at_end, report.is_at_end ? 1.0 : 0.0);
    put(row, has_popped, report.has_popped ? 1.0 : 0.0);
    put(row, proxy_x, report.p_WP.x);
    put(row, proxy_y, report.p_WP.y);
    put(row, force_x, report.force.x);
    put(row, force_y, report.force.y);
    put(row, stored, report.stored_J);
    put(row, felt_level, report.level);
    put(row, carried, report.carried_m);
    put(row, clear, report.clear);
    put(row, boxes, report.boxes);
}

void put(Row& row, const TickEvents& events) {
    row[told] = 0;
    row[told_outline] = -1;
    for (const ContactEvent& event : events.all()) {
        row[told] += std::int64_t{1} << static_cast<int>(event.kind);
        row[told_outline] = event.outline;
    }
}

}  // namespace

Scene scene_of(const TactileMap& map, const Trace& trace) {
    return build_scene(map, {}, trace.settings.radius_m).value();
}

std::vector<Row> follow(const Scene& scene, const Trace& trace, std::span<const Row> hand) {
    std::vector<Position> way;
    ContactMachine machine;
    EventDetector detector;
    ContactSettings settings = trace.settings;
    Budget budget;
    if (trace.boxes > 0) budget.boxes = trace.boxes;
    machine.record_path(&way);
    std::vector<Row> rows(hand.begin(), hand.end());
    double time_s = 0.0;
    for (Row& row : rows) {
        const Position handle{given(row, handle_x), given(row, handle_y)};
        settings.mode = static_cast<Mode>(row[mode]);
        if (row[starts] != 0) {
            machine.reset(scene, handle, given(row, level));
            detector.reset();
        }
        const ContactReport report = machine.step(handle, given(row, level), settings, budget);
        put(row, report);
        put(row, rendered_level, machine.rendered_level());
        put(row, path, length_m(way));
        put(row, detector.step(
                     {time_s, handle, settings.mode, report, machine.rendered_level(), &scene}));
        time_s += 1e-3;
    }
    return rows;
}

}  // namespace touchline::traces
