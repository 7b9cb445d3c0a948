// Every picture of the gallery as a trial: trace it in time, and identify it by the path.
// Threads: plain values and pure functions, except for the files read.
#pragma once

#include "config/types/result.h"
#include "haptics/collision/scene.h"
#include "tests/lab/bench/tracing/score.h"
#include "tests/lab/bench/tracing/trace.h"

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace touchline::bench {

inline constexpr double limit_speed_m_per_s = 0.04;
inline constexpr double limit_times = 3.0;
inline constexpr double most_p90_m = 0.002;
inline constexpr double least_covered = 0.9;

inline constexpr std::array<std::pair<Tracing, const char*>, 4> tracings{
    {{Tracing::groove, "groove"},
     {Tracing::forces_off, "off"},
     {Tracing::wall, "wall"},
     {Tracing::tour, "tour"}}};

struct Trial {
    std::string name;  // the file's, without its extension
    std::shared_ptr<const Scene> scene;
    double length_m = 0.0;
    double limit_s = 0.0;  // 3 * length / 40 mm/s
    Position start;        // anywhere in the drawing area, by the picture's number
};

struct Gallery {
    std::vector<Trial> trials;
    std::vector<std::vector<Position>> on_outlines;  // of each picture
    std::vector<DistanceField> fields;               // of each picture
};

[[nodiscard]] Result<Gallery> read_trials(const std::string& folder);

struct TrialResult {
    Traced traced;
    Score score;
    bool is_traced = false;  // within 2 mm for nine tenths of path and outline
    bool is_named = false;   // the path is most like this picture
};

[[nodiscard]] TrialResult attempt(const Gallery& gallery, std::size_t index, Tracing tracing);

}  // namespace touchline::bench
