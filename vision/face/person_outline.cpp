#include "vision/contour/chain.h"
#include "vision/contour/rings.h"
#include "vision/face/face_lines.h"

#include <algorithm>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int working_side_px = 320;  // longer side of the mask at working size
constexpr float outline_level = 127.5F;
constexpr double along_rim_px = 2.0;  // a line this near to the part's side runs along it
constexpr double shortest_outline_px = 12.0;

/// Maps pixels of the picture to those of the mask at working size.
class Working {
  public:
    explicit Working(const PersonMask& person)
        : scale_(static_cast<double>(working_side_px) /
                 std::max(person.part.width, person.part.height)),
          corner_(person.part.tl()),
          size_(std::max(8, cvRound(scale_ * person.part.width)),
                std::max(8, cvRound(scale_ * person.part.height))) {}

    [[nodiscard]] cv::Size size() const { return size_; }

    [[nodiscard]] double scale() const { return scale_; }

    [[nodiscard]] cv::Point2d of_picture(cv::Point2d p) const {
        return (p - corner_) * scale_ - cv::Point2d(0.5, 0.5);
    }

    [[nodiscard]] cv::Point2d in_picture(cv::Point2d p) const {
        return (p + cv::Point2d(0.5, 0.5)) * (1.0 / scale_) + corner_;
    }

  private:
    double scale_;
    cv::Point2d corner_;
    cv::Size size_;
};

/// Returns the mask without notches and tongues that are too narrow for a finger when the face is
/// felt as large as it fits. All of the face counts as person.
cv::Mat1f soft_mask(const PersonMask& person, const FaceMesh& mesh, const Working& working) {
    constexpr double narrow = 0.03;     // of the face's height, to either side
    constexpr double smoothing = 0.02;  // likewise
    cv::Mat1f soft;
    person.mask.convertTo(soft, CV_32F);
    cv::resize(soft, soft, working.size(), 0.0, 0.0, cv::INTER_LINEAR);
    for (const std::vector<cv::Point2d>& half : face_halves(mesh)) {
        std::vector<cv::Point> points;
        for (const cv::Point2d& p : half) points.emplace_back(working.of_picture(p));
        cv::fillPoly(soft, points, cv::Scalar(255.0));
    }
    const double face_px =
        std::clamp(working.scale() * box_of(mesh).height, 1.0, double{working_side_px});
    const int narrow_px = std::max(1, cvRound(narrow * face_px));
    const cv::Mat disc =
        cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * narrow_px + 1, 2 * narrow_px + 1});
    const int rim_px = 2 * narrow_px;  // so that the sides of the part change nothing
    cv::Mat1f wide;
    cv::copyMakeBorder(soft, wide, rim_px, rim_px, rim_px, rim_px, cv::BORDER_REPLICATE);
    for (const int change : {cv::MORPH_CLOSE, cv::MORPH_OPEN}) {
        cv::morphologyEx(wide, wide, change, disc);
    }
    soft = wide(cv::Rect({rim_px, rim_px}, soft.size())).clone();
    const double sigma_px = std::max(1.0, smoothing * face_px);
    cv::GaussianBlur(soft, soft, {}, sigma_px, sigma_px, cv::BORDER_REPLICATE);
    return soft;
}

}  // namespace

cv::Rect head_and_shoulders(const FaceMesh& mesh, cv::Size picture) {
    constexpr double above_face = 0.9;  // of the face's height
    constexpr double below_face = 1.1;
    constexpr double beside = 1.4;  // of its greater side, from its middle
    const cv::Rect2d face = box_of(mesh);
    const cv::Point2d middle = centre_of(face);
    const double beside_px = beside * std::max(face.width, face.height);
    const cv::Rect2d part(middle.x - beside_px, face.y - above_face * face.height, 2.0 * beside_px,
                          (1.0 + above_face + below_face) * face.height);
    return part_within(part, picture);
}

std::vector<PartLine> person_outline(const PersonMask& person, const FaceMesh& mesh) {
    if (person.mask.empty() || person.part.empty()) return {};
    const Working working(person);
    const cv::Mat1f soft = soft_mask(person, mesh, working);
    const cv::Rect2d face = box_of(mesh);
    const cv::Point2d middle = working.of_picture(centre_of(face));
    const auto is_on_rim = [&](const EdgePoint& p) {
        return p.at.x < along_rim_px || p.at.y < along_rim_px ||
               p.at.x > soft.cols - 1 - along_rim_px || p.at.y > soft.rows - 1 - along_rim_px;
    };
    std::vector<PartLine> lines;
    for (const Chain& ring : iso_rings(soft, outline_level)) {
        if (area_within(ring) < 0.0 || !holds(ring, middle)) continue;
        cut_by_place(ring, is_on_rim, [&](Chain part, bool is_rim) {
            if (is_rim || length_of(part) < shortest_outline_px) return;
            Chain line = resampled(part, 1.0);
            for (EdgePoint& p : line.points) p.at = working.in_picture(p.at);
            lines.push_back({FacePart::person, std::move(line)});
        });
    }
    return lines;
}

}  // namespace touchline
