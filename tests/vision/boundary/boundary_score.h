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
    [[nodiscard]] double f() const;  // harmonic mean; 0 where nothing was found
    BoundaryCounts& operator+=(const BoundaryCounts& more);
};

/// One picture: the pixels of `strength` (8-bit) that are at least `least` (1..255), thinned,
/// matched one to one with each annotator's pixels (non-zero) within 0.0075 of the diagonal: as
/// many pairs as possible. All maps have one size. O(edges x pixels in reach), a few times.
[[nodiscard]] BoundaryCounts boundary_counts(const cv::Mat1b& strength, int least,
                                             const std::vector<cv::Mat1b>& annotators);

/// Sums over pictures at each threshold of a sweep, and what is read from them.
struct BoundarySweep {
    static constexpr int kAutomatic = 128;  // of the strength map: what tracing keeps
    std::vector<int> least{72, 96, 112, kAutomatic, 144, 160};
    std::vector<BoundaryCounts> counts{least.size()};

    void add(const cv::Mat1b& strength, const std::vector<cv::Mat1b>& annotators);
    [[nodiscard]] BoundaryCounts automatic() const;  // at kAutomatic
    [[nodiscard]] BoundaryCounts best() const;       // of the sweep, one threshold for all pictures
};

/// Lines of one pixel (255, else 0) from a binary map: Guo and Hall 1989, as in OpenCV's ximgproc.
/// The outermost rows and columns stay as they are.
[[nodiscard]] cv::Mat1b thinned(const cv::Mat1b& map);

}  // namespace touchline::testing
