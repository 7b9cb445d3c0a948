// Reference traces: what the contact machine did with a given hand on given lines, tick by tick, in
// whole numbers, so that any other implementation can be compared with it. README.md explains the
// columns.
#pragma once

#include "config/types/tactile_map.h"
#include "haptics/collision/scene.h"
#include "haptics/contact/contact_machine.h"

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace touchline::traces {

/// The first five are inputs, the others are results.
enum Column : std::size_t {
    starts,
    mode,
    level,
    handle_x,
    handle_y,
    state,
    trail,
    outline,
    piece,
    side,
    parameter,
    is_at_end,
    has_popped,
    proxy_x,
    proxy_y,
    force_x,
    force_y,
    stored,
    rendered_level,
    felt_level,
    path,
    carried,
    clear,
    boxes,
    told,
    told_outline,
    column_count
};

/// Value = whole number / `per_unit`; two numbers up to `tolerance` apart count as the same.
struct ColumnKind {
    std::string_view name;
    double per_unit = 1.0;
    int tolerance = 0;
};

extern const std::array<ColumnKind, column_count> columns;

using Row = std::array<std::int64_t, column_count>;

/// A row of traces.csv.
struct Trace {
    std::string name;   // of its rows in ticks.csv
    std::string lines;  // of its rows in lines.csv
    ContactSettings settings;
    int boxes = 0;  // of the collision tree that a tick may open; 0: any number
};

inline constexpr double per_m = 1e9;  // for every length

[[nodiscard]] Scene scene_of(const TactileMap& map, const Trace& trace);

/// Returns the rows with their results; reads only the given columns of `hand`.
[[nodiscard]] std::vector<Row> follow(const Scene& scene, const Trace& trace,
                                      std::span<const Row> hand);

/// Read and write files; throw an exception on failure.
[[nodiscard]] std::vector<Trace> read_traces();
[[nodiscard]] TactileMap read_lines(const std::string& name);
[[nodiscard]] std::vector<Row> read_rows(const std::string& name);
void write_traces(std::span<const Trace> traces);
void write_lines(const std::map<std::string, TactileMap>& maps);
void write_ticks(const std::vector<std::pair<std::string, std::vector<Row>>>& runs);

}  // namespace touchline::traces
