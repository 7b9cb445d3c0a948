#include "vision/contour/region_runs.h"

#include <algorithm>

namespace touchline {
namespace {

std::size_t first_of(std::vector<Run>& runs, std::size_t i) {
    while (runs[i].region != i) {
        runs[i].region = runs[runs[i].region].region;
        i = runs[i].region;
    }
    return i;
}

}  // namespace

std::vector<Run> runs_of(const cv::Mat1b& map) {
    std::vector<Run> runs;
    std::size_t above = 0;  // first run of the row above that may touch
    for (int y = 0; y < map.rows; ++y) {
        const uchar* colours = map[y];
        const std::size_t row_start = runs.size();
        for (int from = 0, to = 0; from < map.cols; from = to) {
            while (to < map.cols && colours[to] == colours[from]) {
                ++to;
            }
            runs.push_back({y, from, to, runs.size()});
            while (above < row_start && runs[above].to <= from) {
                ++above;
            }
            for (std::size_t i = above; i < row_start && runs[i].from < to; ++i) {
                if (map(y - 1, runs[i].from) == colours[from]) {
                    const std::size_t a = first_of(runs, i);
                    const std::size_t b = first_of(runs, runs.size() - 1);
                    runs[std::max(a, b)].region = std::min(a, b);
                }
            }
        }
        above = row_start;
    }
    for (std::size_t i = 0; i < runs.size(); ++i) {
        runs[i].region = first_of(runs, i);
    }
    return runs;
}

}  // namespace touchline
