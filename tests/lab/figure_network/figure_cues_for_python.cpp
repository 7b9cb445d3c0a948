// The cues of vision/figure for the training of the small network, which is written in Python.
#include "vision/figure/figure_cues.h"

#include <cstddef>
#include <cstring>

/// Writes the cues of a square BGR picture, 8 bits, rows without gaps: one plane of side_px times
/// side_px floats after the other.
extern "C" void figure_cues_of(std::byte* bgr, int side_px, float* cues) {
    cv::setNumThreads(1);
    const cv::Mat3b picture(side_px, side_px, reinterpret_cast<cv::Vec3b*>(bgr));
    for (const cv::Mat1f& cue : touchline::figure_cues(picture)) {
        std::memcpy(cues, cue[0], cue.total() * sizeof(float));
        cues += cue.total();
    }
}
