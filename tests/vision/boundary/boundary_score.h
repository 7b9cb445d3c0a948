// How well an edge map agrees with boundaries that people (or a drawing program) have marked,
// counted as the Berkeley benchmark does (Martin, Fowlkes, Malik 2004; Arbelaez et al. 2011).
// Threads: values and pure functions.
#pragma once

#include <vector>

#include <opencv2/core.hpp>

namespace touchline::testing {

/// Counts summed over pictures. Recall is against every annotator, precision against any.
struct BoundaryCounts {
    double truth_hit = 0.0;
    double truth_all = 0.0;
    double edges_hit = 0.0;
    double edges_all = 0.0;

    [[nodiscard]] double precision() const;
    [[nodiscard]] double recall() const;
    [[nodiscard]] double f() const;  // harmonic mean; 0 if nothing was found
    BoundaryCounts& operator+=(const BoundaryCounts& more);
};

/// Counts one picture. Thins the pixels of `strength` (8-bit) that are at least `least` (1..255),
/// and matches as many of them as possible one to one with each annotator's pixels (non-zero)
/// within 0.0075 of the diagonal. All maps have one size. O(edges x pixels in reach), a few times.
[[nodiscard]] BoundaryCounts boundary_counts(const cv::Mat1b& strength, int least,
                                             const std::vector<cv::Mat1b>& annotators);

/// Sums over pictures at each threshold of a sweep, and the figures read from them.
struct BoundarySweep {
    static constexpr int automatic_level = 128;  // of the strength map: tracing keeps this
    std::vector<int> least{72, 96, 112, automatic_level, 144, 160};
    std::vector<BoundaryCounts> counts{least.size()};

    void add(const cv::Mat1b& strength, const std::vector<cv::Mat1b>& annotators);
    [[nodiscard]] BoundaryCounts automatic() const;  // at automatic_level
    [[nodiscard]] BoundaryCounts best() const;       // of the sweep, one threshold for all pictures
};

/// Returns lines of one pixel (255, else 0) from a binary map: Guo and Hall 1989, as in OpenCV's
/// ximgproc. Leaves the outermost rows and columns as they are.
[[nodiscard]] cv::Mat1b thinned(const cv::Mat1b& map);

}  // namespace touchline::testing
