// The kind of a picture, which decides how its lines are found.
// Threads: pure functions.
#pragma once

#include <string>

#include <opencv2/core.hpp>

namespace touchline {

enum class PictureClass {
    photo,      // edges, ranked (contour/edge_lines)
    diagram,    // flat colours: lines between regions (contour/regions)
    line_art,   // drawing, handwriting, map: centre lines of strokes (contour/strokes)
    text_page,  // boxes of text and figures (text_boxes); its letters are not felt
};

/// Measurements, on a copy of at most 0.2 megapixels.
struct PictureFeatures {
    double noise = 0.0;          // standard deviation, grey levels
    double open_part = 0.0;      // part of the picture that is away from the edges of shapes
    double texture = 0.0;        // of that, the part that changes faster than a lamp's shade
    double changing_part = 0.0;  // of everything, the part that changes so
    double painted_part = 0.0;   // of the texture, as a program paints it: even shades, pale lines
    double ruled_part = 0.0;     // of the texture, the part along level or upright lines
    double paper_part = 0.0;     // part of the places that show the commonest colour
    double ink_part = 0.0;       // part of the pixels that stand out from it
    double thin_part = 0.0;      // of the ink, the part no wider than a pen's stroke
    double clearness = 0.0;      // contrast of the ink over that of the paper's own spots
    double text_part = 0.0;      // of the ink, the part in lines of text
    int text_lines = 0;
    int letters = 0;
};

struct ClassDecision {
    PictureClass picture_class = PictureClass::photo;
    /// One sentence for speech: "This looks like a drawing: thin lines on paper."
    std::string reason;
    PictureFeatures features;
};

/// Decides for any 8-bit picture, BGR or grey, at least 1 x 1. The caller may override it: nothing
/// downstream asks again. Deterministic; about 25 ms whatever the size up to a megapixel.
[[nodiscard]] ClassDecision class_of(const cv::Mat& picture);

/// Returns the spoken word: "photo", "diagram", "drawing", "text page".
[[nodiscard]] std::string name_of(PictureClass picture_class);

}  // namespace touchline
