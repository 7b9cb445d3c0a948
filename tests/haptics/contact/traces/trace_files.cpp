#include "tests/haptics/contact/traces/trace.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

namespace touchline::traces {
namespace {

constexpr const char* traces_head =
    "name,lines,stiffness_N_per_m,friction,radius_m,capture_m,pop_through_N,pop_through_s,boxes";
constexpr const char* lines_head = "lines,outline,is_closed,x,y";

std::string path_of(const std::string& file) {
    return std::string(TOUCHLINE_SOURCE_DIR) + "/tests/haptics/contact/traces/" + file + ".csv";
}

/// Returns the lines of a file that begin with `key`, without it, with blanks for commas; for an
/// empty key all lines but the head.
std::vector<std::istringstream> lines_of(const std::string& name, const std::string& key = {}) {
    std::ifstream file(path_of(name));
    const std::string begin = key.empty() ? "" : key + ",";
    std::vector<std::istringstream> found;
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        if (!line.starts_with(begin)) continue;
        line.erase(0, begin.size());
        std::ranges::replace(line, ',', ' ');
        found.emplace_back(line);
    }
    if (found.empty()) throw std::runtime_error(path_of(name) + " has nothing of " + key);
    return found;
}

std::ofstream opened(const std::string& name) {
    std::ofstream file(path_of(name));
    file.exceptions(std::ios::failbit | std::ios::badbit);
    return file;
}

void check(const std::istringstream& line, const std::string& name) {
    if (line.fail()) throw std::runtime_error(path_of(name) + " has a line that cannot be read");
}

}  // namespace

std::vector<Trace> read_traces() {
    std::vector<Trace> found;
    for (std::istringstream& line : lines_of("traces")) {
        Trace& t = found.emplace_back();
        line >> t.name >> t.lines >> t.settings.stiffness_N_per_m >> t.settings.friction >>
            t.settings.radius_m >> t.settings.capture_m >> t.settings.pop_through_N >>
            t.settings.pop_through_s >> t.boxes;
        check(line, "traces");
    }
    return found;
}

TactileMap read_lines(const std::string& name) {
    TactileMap map;
    for (std::istringstream& line : lines_of("lines", name)) {
        std::size_t outline = 0;
        bool is_closed = false;
        double x = 0.0;
        double y = 0.0;
        line >> outline >> is_closed >> x >> y;
        check(line, name);
        map.outlines.resize(outline + 1);
        map.outlines.back().is_closed = is_closed;
        map.outlines.back().points.push_back({x / per_m, y / per_m});
    }
    return map;
}

std::vector<Row> read_rows(const std::string& name) {
    std::vector<Row> rows;
    for (std::istringstream& line : lines_of("ticks", name)) {
        for (std::int64_t& value : rows.emplace_back()) line >> value;
        check(line, name);
    }
    return rows;
}

void write_traces(std::span<const Trace> traces) {
    std::ofstream file = opened("traces");
    file << traces_head << '\n';
    for (const Trace& t : traces) {
        const ContactSettings& s = t.settings;
        file << fmt::format("{},{},{},{},{},{},{},{},{}\n", t.name, t.lines, s.stiffness_N_per_m,
                            s.friction, s.radius_m, s.capture_m, s.pop_through_N, s.pop_through_s,
                            t.boxes);
    }
}

void write_lines(const std::map<std::string, TactileMap>& maps) {
    std::ofstream file = opened("lines");
    file << lines_head << '\n';
    for (const auto& [name, map] : maps) {
        for (std::size_t i = 0; i < map.outlines.size(); ++i) {
            for (const Position& p : map.outlines[i].points) {
                file << name << ',' << i << ',' << map.outlines[i].is_closed << ','
                     << std::llround(p.x * per_m) << ',' << std::llround(p.y * per_m) << '\n';
            }
        }
    }
}

void write_ticks(const std::vector<std::pair<std::string, std::vector<Row>>>& runs) {
    std::ofstream file = opened("ticks");
    file << "trace";
    for (const ColumnKind& column : columns) file << ',' << column.name;
    file << '\n';
    for (const auto& [name, rows] : runs) {
        for (const Row& row : rows) {
            file << name;
            for (const std::int64_t value : row) file << ',' << value;
            file << '\n';
        }
    }
}

}  // namespace touchline::traces
