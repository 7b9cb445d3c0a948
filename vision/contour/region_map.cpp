#include "vision/contour/region_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace touchline {
namespace {

constexpr int colour_bins = 32;              // along each axis
constexpr float bin_levels = 8.0F;           // grey levels
constexpr float same_colour_levels = 16.0F;  // colours nearer than this are one
constexpr std::size_t most_peaks = 64;
// A colour this near to a common one may be a ripple of it.
constexpr float near_colour_levels = 45.0F;
constexpr double least_over_near = 0.006;  // of the common colour's pixels
constexpr double least_running = 0.25;     // of its own pixels; a ripple's are spots
constexpr double least_ink_part = 0.0005;  // of the picture
constexpr float flat_levels = 6.0F;        // grey levels across two pixels

struct Bin {
    cv::Vec3f sum;
    int count = 0;
    int running = 0;  // of these, as far as asked, pixels from which it goes on to both sides
};

int cell(float value, float low, float size, int n) {
    return static_cast<int>(std::clamp((value - low) / size, 0.0F, static_cast<float>(n - 1)));
}

float squared(const cv::Vec3f& d) {
    return d.dot(d);
}

std::size_t bin_of(const cv::Vec3f& lab) {
    return static_cast<std::size_t>((cell(lab[0], 0.0F, bin_levels, colour_bins) * colour_bins +
                                     cell(lab[1], -128.0F, bin_levels, colour_bins)) *
                                        colour_bins +
                                    cell(lab[2], -128.0F, bin_levels, colour_bins));
}

/// Returns whether a pixel is not a mixture along an axis: both sides of it are alike, as in the
/// middle of a line, or it and one beside it are, as in a line of two pixels.
bool is_plain(const LabPicture& lab, const cv::Point& at, const cv::Point& along, float flat) {
    const auto alike = [&](int i, int j) {
        return squared(lab(at + i * along) - lab(at + j * along)) < flat * flat;
    };
    return alike(-1, 1) || (alike(0, 1) && alike(-1, 2)) || (alike(0, -1) && alike(1, -2));
}

/// Returns whether a pixel is part of an area or of a line along one of four directions.
bool runs_on(const LabPicture& lab, const cv::Point& at, float flat) {
    constexpr std::array<std::array<int, 2>, 4> ways{{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
    return std::ranges::any_of(ways, [&](const std::array<int, 2>& way) {
        const cv::Point along(way[0], way[1]);
        return squared(lab(at + along) - lab(at)) < flat * flat &&
               squared(lab(at - along) - lab(at)) < flat * flat;
    });
}

/// Counts the colours of pixels that are not mixtures.
std::vector<Bin> histogram(const LabPicture& lab, double noise) {
    std::vector<Bin> bins(static_cast<std::size_t>(colour_bins * colour_bins * colour_bins));
    const float flat = flat_levels + 3.0F * static_cast<float>(noise);
    for (int y = 2; y + 2 < lab.rows; ++y) {
        for (int x = 2; x + 2 < lab.cols; ++x) {
            if (is_plain(lab, {x, y}, {1, 0}, flat) && is_plain(lab, {x, y}, {0, 1}, flat)) {
                Bin& bin = bins[bin_of(lab(y, x))];
                bin.sum += lab(y, x);
                ++bin.count;
                if (3 * bin.running < bin.count && runs_on(lab, {x, y}, flat)) ++bin.running;
            }
        }
    }
    return bins;
}

/// Returns the mean of all filled bins within reach of `colour`.
Bin around(const std::vector<Bin>& filled, const cv::Vec3f& colour) {
    Bin all;
    for (const Bin& bin : filled) {
        if (squared(bin.sum * (1.0F / static_cast<float>(bin.count)) - colour) <
            same_colour_levels * same_colour_levels) {
            all.sum += bin.sum;
            all.count += bin.count;
            all.running += bin.running;
        }
    }
    return all;
}

cv::Vec3f mean_of(const Bin& bin) {
    return bin.sum * (1.0F / static_cast<float>(bin.count));
}

/// Returns whether a colour is what blur or compression makes of one that is known: near to a much
/// commoner one, or near to it and in spots.
bool is_ripple(const Bin& peak, const std::vector<Bin>& found) {
    return std::ranges::any_of(found, [&](const Bin& common) {
        return squared(mean_of(peak) - mean_of(common)) < near_colour_levels * near_colour_levels &&
               (peak.count < least_over_near * common.count ||
                peak.running < least_running * peak.count);
    });
}

std::size_t first_of(std::vector<Run>& runs, std::size_t i) {
    while (runs[i].region != i) {
        runs[i].region = runs[runs[i].region].region;
        i = runs[i].region;
    }
    return i;
}

constexpr int pure_reach_px = 3;  // how far away to look for the pure colours beside an edge
constexpr float mixture = 14.0F;  // grey levels off the line between two colours
constexpr float mixture_over_step = 0.12F;

/// Returns the pixels whose neighbours all have the same colour.
cv::Mat1b uniform_pixels(const cv::Mat1b& colours) {
    cv::Mat1b uniform(colours.size(), uchar{0});
    for (int y = 1; y + 1 < colours.rows; ++y) {
        for (int x = 1; x + 1 < colours.cols; ++x) {
            const uchar c = colours(y, x);
            bool same = true;
            for (int j = -1; j <= 1 && same; ++j) {
                same = colours(y + j, x - 1) == c && colours(y + j, x) == c &&
                       colours(y + j, x + 1) == c;
            }
            uniform(y, x) = same ? 255 : 0;
        }
    }
    return uniform;
}

bool is_solid(const cv::Mat1b& colours, const cv::Mat1b& uniform, int y, int x) {
    for (int v = std::max(0, y - 1); v <= std::min(colours.rows - 1, y + 1); ++v) {
        for (int u = std::max(0, x - 1); u <= std::min(colours.cols - 1, x + 1); ++u) {
            if (uniform(v, u) != 0 && colours(v, u) == colours(y, x)) return true;
        }
    }
    return false;
}

/// Undoes the false colours along edges.
class Mixtures {
  public:
    Mixtures(const LabPicture& lab, const std::vector<cv::Vec3f>& palette, const cv::Mat1b& colours)
        : lab_(lab), palette_(palette), colours_(colours), uniform_(uniform_pixels(colours)) {}

    [[nodiscard]] cv::Mat1b undone() const {
        cv::Mat1b map = colours_.clone();
        for (int y = 0; y < map.rows; ++y) {
            for (int x = 0; x < map.cols; ++x) {
                if (uniform_(y, x) == 0 && !is_solid(colours_, uniform_, y, x)) {
                    map(y, x) = true_colour(y, x);
                }
            }
        }
        return map;
    }

  private:
    /// Looks at the colours nearby, each with how well a pixel there shows it.
    [[nodiscard]] uchar true_colour(int y, int x) const {
        std::array<uchar, 8> near{};
        std::size_t n = 0;
        const uchar own = colours_(y, x);
        for (int v = std::max(0, y - pure_reach_px);
             v <= std::min(lab_.rows - 1, y + pure_reach_px); ++v) {
            for (int u = std::max(0, x - pure_reach_px);
                 u <= std::min(lab_.cols - 1, x + pure_reach_px); ++u) {
                const uchar c = colours_(v, u);
                const bool is_new =
                    c != own && std::find(near.begin(), near.begin() + n, c) == near.begin() + n;
                if (is_new && n < near.size() && is_pure(v, u)) near[n++] = c;
            }
        }
        return best_mixture(lab_(y, x), own, {near.begin(), near.begin() + n});
    }

    [[nodiscard]] bool is_pure(int y, int x) const {
        const cv::Vec3f d = lab_(y, x) - palette_[colours_(y, x)];
        return uniform_(y, x) != 0 || d.dot(d) < mixture * mixture;
    }

    [[nodiscard]] uchar best_mixture(const cv::Vec3f& colour, uchar own,
                                     const std::vector<uchar>& near) const {
        uchar best = own;
        float least = std::numeric_limits<float>::infinity();
        for (std::size_t i = 0; i < near.size(); ++i) {
            for (std::size_t j = i + 1; j < near.size(); ++j) {
                const cv::Vec3f& a = palette_[near[i]];
                const cv::Vec3f step = palette_[near[j]] - a;
                const float t = (colour - a).dot(step) / step.dot(step);
                const cv::Vec3f off = colour - a - std::clamp(t, 0.0F, 1.0F) * step;
                const float limit =
                    std::max(mixture, mixture_over_step * std::sqrt(step.dot(step)));
                if (off.dot(off) < std::min(limit * limit, least)) {
                    least = off.dot(off);
                    best = near[t < 0.5F ? i : j];
                }
            }
        }
        return best;
    }

    const LabPicture& lab_;
    const std::vector<cv::Vec3f>& palette_;
    const cv::Mat1b& colours_;
    cv::Mat1b uniform_;
};

/// Returns the runs of regions below `least_px`; none if there are no others.
std::vector<Run> small_regions(const cv::Mat1b& map, int least_px) {
    const std::vector<Run> runs = runs_of(map);
    std::vector<int> area_px(runs.size(), 0);
    for (const Run& run : runs) area_px[run.region] += run.to - run.from;
    std::vector<Run> small;
    std::ranges::copy_if(runs, std::back_inserter(small),
                         [&](const Run& run) { return area_px[run.region] < least_px; });
    return small.size() < runs.size() ? small : std::vector<Run>();
}

std::array<cv::Point, 4> beside(const cv::Point& p) {
    return {cv::Point(p.x, p.y - 1), {p.x - 1, p.y}, {p.x + 1, p.y}, {p.x, p.y + 1}};
}

}  // namespace

std::vector<cv::Vec3f> palette_of(const LabPicture& lab, double noise) {
    std::vector<Bin> filled = histogram(lab, noise);
    std::erase_if(filled, [](const Bin& bin) { return bin.count == 0; });
    if (filled.empty()) return {lab(lab.rows / 2, lab.cols / 2)};
    std::ranges::stable_sort(filled, std::greater<>(), &Bin::count);
    const double least = least_ink_part * static_cast<double>(lab.total());
    std::vector<Bin> found;
    while (!filled.empty() && found.size() < most_peaks) {
        Bin peak = around(filled, mean_of(filled.front()));
        peak = around(filled, mean_of(peak));  // one step uphill
        const double enough = found.empty() ? 1.0 : std::max(1.0, least);
        if (peak.count < enough || is_ripple(peak, found)) {
            filled.erase(filled.begin());
            if (filled.empty() || filled.front().count < least / 16.0) break;
            continue;
        }
        const cv::Vec3f colour = mean_of(peak);
        found.push_back(peak);
        std::erase_if(filled, [&](const Bin& bin) {
            return squared(mean_of(bin) - colour) < same_colour_levels * same_colour_levels;
        });
    }
    std::vector<cv::Vec3f> palette;
    std::ranges::transform(found, std::back_inserter(palette), mean_of);
    return palette;
}

cv::Mat1b nearest_colours(const LabPicture& lab, const std::vector<cv::Vec3f>& palette) {
    constexpr int fine_cells = 64;     // cells along each axis: a table of the nearest, made as
    constexpr float fine_size = 4.0F;  // asked for
    constexpr uchar unknown = 255;
    std::vector<uchar> table(static_cast<std::size_t>(fine_cells * fine_cells * fine_cells),
                             unknown);
    cv::Mat1b nearest(lab.size());
    for (int y = 0; y < lab.rows; ++y) {
        for (int x = 0; x < lab.cols; ++x) {
            const cv::Vec3f& colour = lab(y, x);
            const int l = cell(colour[0], 0.0F, fine_size, fine_cells);
            const int a = cell(colour[1], -128.0F, fine_size, fine_cells);
            const int b = cell(colour[2], -128.0F, fine_size, fine_cells);
            uchar& known = table[static_cast<std::size_t>((l * fine_cells + a) * fine_cells + b)];
            if (known == unknown) {
                const cv::Vec3f centre((static_cast<float>(l) + 0.5F) * fine_size,
                                       (static_cast<float>(a) + 0.5F) * fine_size - 128.0F,
                                       (static_cast<float>(b) + 0.5F) * fine_size - 128.0F);
                const auto best = std::ranges::min_element(
                    palette, {}, [&](const cv::Vec3f& c) { return squared(c - centre); });
                known = static_cast<uchar>(best - palette.begin());
            }
            nearest(y, x) = known;
        }
    }
    return nearest;
}

std::vector<Run> runs_of(const cv::Mat1b& map) {
    std::vector<Run> runs;
    std::size_t above = 0;  // first run of the row above that may touch
    for (int y = 0; y < map.rows; ++y) {
        const uchar* colours = map[y];
        const std::size_t row_start = runs.size();
        for (int from = 0, to = 0; from < map.cols; from = to) {
            while (to < map.cols && colours[to] == colours[from]) ++to;
            runs.push_back({y, from, to, runs.size()});
            while (above < row_start && runs[above].to <= from) ++above;
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
    for (std::size_t i = 0; i < runs.size(); ++i) runs[i].region = first_of(runs, i);
    return runs;
}

cv::Mat1b region_map(const LabPicture& lab, const std::vector<cv::Vec3f>& palette) {
    return Mixtures(lab, palette, nearest_colours(lab, palette)).undone();
}

uchar ground_of(const cv::Mat1b& map) {
    std::array<int, most_colours> counts{};
    for (const uchar colour : map) ++counts[colour];
    return static_cast<uchar>(std::ranges::max_element(counts) - counts.begin());
}

double strongest_contrast(const std::vector<cv::Vec3f>& palette, uchar ground) {
    double strongest = 0.0;
    for (const cv::Vec3f& colour : palette) {
        strongest = std::max(strongest, cv::norm(colour - palette[ground]));
    }
    return strongest;
}

void overgrow_specks(cv::Mat1b& map, int least_px) {
    cv::Mat1b gone(map.size(), uchar{0});
    for (const Run& run : small_regions(map, least_px)) {
        gone(cv::Rect(run.from, run.row, run.to - run.from, 1)) = 255;
    }
    overgrow(map, gone);
}

void overgrow(cv::Mat1b& map, const cv::Mat1b& mask) {
    cv::Mat1b gone = mask.clone();
    const cv::Rect frame({}, map.size());
    std::vector<cv::Point> front;
    for (int y = 0; y < map.rows; ++y) {
        for (int x = 0; x < map.cols; ++x) {
            const auto is_left = [&](const cv::Point& q) {
                return frame.contains(q) && gone(q) == 0;
            };
            if (gone(y, x) != 0) {
                std::ranges::copy_if(beside({x, y}), std::back_inserter(front), is_left);
            }
        }
    }
    for (std::size_t i = 0; i < front.size(); ++i) {
        const cv::Point p = front[i];
        for (const cv::Point& q : beside(p)) {
            if (frame.contains(q) && gone(q) != 0) {
                gone(q) = 0;
                map(q) = map(p);
                front.push_back(q);
            }
        }
    }
}

}  // namespace touchline
