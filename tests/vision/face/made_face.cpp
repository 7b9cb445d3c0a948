#include "tests/vision/face/made_face.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

constexpr double tall = 1.35;  // the face's height over its width

const std::vector<int> upper_lip{78, 191, 80, 81, 82, 13, 312, 311, 310, 415, 308};
const std::vector<int> lower_lip{78, 95, 88, 178, 87, 14, 317, 402, 318, 324, 308};

/// A place in half widths of the face; x to the right, y down, z towards the viewer.
using Place = cv::Vec3d;

Place on_skull(double x, double y, double out = 0.0) {
    const double inside = std::max(0.0, 1.0 - x * x - y * y / (tall * tall));
    return {x, y, 0.8 * std::sqrt(inside) + out};
}

using Places = std::array<Place, 468>;

void lay(Places& places, const std::vector<int>& points, const auto& at) {
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(points.size() - 1);
        places[static_cast<std::size_t>(points[k])] = at(share);
    }
}

/// An arc from one corner to the other that rises in its middle.
auto arc(double from, double to, double y, double rise, double out = 0.0) {
    return [=](double share) {
        return on_skull(from + share * (to - from), y - rise * 4.0 * share * (1.0 - share), out);
    };
}

void lay_oval(Places& places) {
    const std::vector<int> oval{10,  338, 297, 332, 284, 251, 389, 356, 454, 323, 361, 288,
                                397, 365, 379, 378, 400, 377, 152, 148, 176, 149, 150, 136,
                                172, 58,  132, 93,  234, 127, 162, 21,  54,  103, 67,  109};
    for (std::size_t k = 0; k < oval.size(); ++k) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / 36.0;
        places[static_cast<std::size_t>(oval[k])] = {std::sin(angle), -tall * std::cos(angle), 0.0};
    }
}

void lay_eyes(Places& places, double open) {
    const double lid = 0.07 * open;
    lay(places, {33, 246, 161, 160, 159, 158, 157, 173, 133}, arc(-0.62, -0.22, -0.3, lid));
    lay(places, {33, 7, 163, 144, 145, 153, 154, 155, 133}, arc(-0.62, -0.22, -0.3, -lid));
    lay(places, {362, 398, 384, 385, 386, 387, 388, 466, 263}, arc(0.22, 0.62, -0.3, lid));
    lay(places, {362, 382, 381, 380, 374, 373, 390, 249, 263}, arc(0.22, 0.62, -0.3, -lid));
    lay(places, {70, 63, 105, 66, 107}, arc(-0.7, -0.15, -0.52, 0.1));
    lay(places, {46, 53, 52, 65, 55}, arc(-0.7, -0.15, -0.46, 0.1));
    lay(places, {336, 296, 334, 293, 300}, arc(0.15, 0.7, -0.52, 0.1));
    lay(places, {285, 295, 282, 283, 276}, arc(0.15, 0.7, -0.46, 0.1));
}

void lay_nose_and_mouth(Places& places, double open) {
    const std::vector<int> profile{10, 151, 9, 8};
    lay(places, profile, [](double share) { return on_skull(0.0, -tall + 0.9 * share); });
    lay(places, {168, 6, 197, 195, 5, 4, 1, 19},
        [](double share) { return on_skull(0.0, -0.35 + 0.6 * share, 0.4 * share); });
    lay(places, {94, 2, 164, 0, 11, 12, 15, 16, 17, 18, 200, 199, 175, 152}, [](double share) {
        return on_skull(0.0, 0.32 + (tall - 0.32) * share, 0.1 * (1.0 - share));
    });
    lay(places, {129, 64, 98, 97, 2, 326, 327, 294, 358}, arc(-0.24, 0.24, 0.3, -0.07, 0.1));
    lay(places, upper_lip, arc(-0.38, 0.38, 0.72, 0.02 + 0.1 * open));
    lay(places, lower_lip, arc(-0.38, 0.38, 0.72, -0.02 * (1.0 - open) - 0.15 * open));
}

void paint_eye(cv::Mat3b& picture, const std::vector<cv::Point>& ring) {
    cv::fillPoly(picture, ring, cv::Scalar(225, 230, 230), cv::LINE_AA);
    const cv::Rect eye = cv::boundingRect(ring);
    cv::circle(picture, (eye.tl() + eye.br()) / 2, std::max(2, eye.height / 2),
               cv::Scalar(30, 40, 60), cv::FILLED, cv::LINE_AA);
}

void paint_part(cv::Mat3b& picture, const PartLine& part, double face_px) {
    std::vector<cv::Point> points;
    for (const EdgePoint& p : part.line.points) points.emplace_back(p.at);
    const auto draw = [&](const cv::Scalar& colour, double share) {
        cv::polylines(picture, points, false, colour, std::max(1, cvRound(share * face_px)),
                      cv::LINE_AA);
    };
    switch (part.part) {
        case FacePart::face:
            cv::fillPoly(picture, points, cv::Scalar(130, 160, 205), cv::LINE_AA);
            break;
        case FacePart::left_eye:
        case FacePart::right_eye:
            paint_eye(picture, points);
            draw({50, 60, 80}, 0.015);
            break;
        case FacePart::left_brow:
        case FacePart::right_brow:
            draw({30, 40, 50}, 0.045);
            break;
        case FacePart::nose:
            draw({140, 175, 220}, 0.08);
            break;
        case FacePart::nostrils:
            draw({70, 95, 140}, 0.025);
            break;
        case FacePart::mouth:
            draw({80, 80, 170}, 0.07);
            draw({50, 50, 90}, 0.015);
            break;
        case FacePart::person:
            break;
    }
}

}  // namespace

FaceMesh MadeFace::mesh() const {
    Places places;
    places.fill(Place(0.0, 0.0, 0.0));
    lay_eyes(places, eyes_open);
    lay_nose_and_mouth(places, mouth_open);
    lay_oval(places);
    const double c = std::cos(tilt_rad);
    const double s = std::sin(tilt_rad);
    FaceMesh mesh;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Place& p = places[i];
        const double x = std::cos(turn_rad) * p[0] + std::sin(turn_rad) * p[2];
        const double depth = std::cos(turn_rad) * p[2] - std::sin(turn_rad) * p[0];
        const double y = stretch * (std::cos(nod_rad) * p[1] + std::sin(nod_rad) * depth);
        const cv::Point2d skewed(x + skew * y, y);
        mesh[i] = middle + half_width_px * cv::Point2d(c * skewed.x - s * skewed.y,
                                                       s * skewed.x + c * skewed.y);
    }
    return mesh;
}

std::string MadeFace::words() const {
    return fmt::format(
        "turned {:.3f}, nodding {:.3f}, tilted {:.3f}, {:.1f} px, mouth {:.2f}, eyes "
        "{:.2f}, skew {:.2f}, stretch {:.2f}",
        turn_rad, nod_rad, tilt_rad, half_width_px, mouth_open, eyes_open, skew, stretch);
}

FaceMesh with_round_mouth(FaceMesh mesh) {
    constexpr double height_over_width = 0.65;  // its height over its width
    const cv::Point2d centre = 0.5 * (mesh[78] + mesh[308]);
    const cv::Point2d across = mesh[308] - centre;
    const cv::Point2d down = height_over_width * cv::Point2d(-across.y, across.x);
    for (const auto& [lip, side] : {std::pair(&upper_lip, -1.0), std::pair(&lower_lip, 1.0)}) {
        for (std::size_t k = 0; k < lip->size(); ++k) {
            const double angle = std::numbers::pi * static_cast<double>(k) / 10.0;
            mesh[static_cast<std::size_t>((*lip)[k])] =
                centre - std::cos(angle) * across + side * std::sin(angle) * down;
        }
    }
    return mesh;
}

cv::Mat3b portrait_of(const MadeFace& face) {
    const FaceMesh mesh = face.mesh();
    const cv::Rect2d box = box_of(mesh);
    cv::Mat3b picture(made_picture, cv::Vec3b(150, 140, 120));
    const cv::Point middle(centre_of(box));
    cv::ellipse(picture, middle - cv::Point(0, cvRound(0.1 * box.height)),
                cv::Size(cvRound(0.6 * box.width), cvRound(0.62 * box.height)), 0.0, 0.0, 360.0,
                cv::Scalar(25, 30, 40), cv::FILLED, cv::LINE_AA);
    for (const PartLine& part : face_lines(mesh)) paint_part(picture, part, box.width);
    cv::GaussianBlur(picture, picture, {}, 0.01 * box.width);
    return picture;
}

PersonMask made_person(const MadeFace& face, double hair) {
    const FaceMesh mesh = face.mesh();
    const cv::Rect part = head_and_shoulders(mesh, made_picture);
    cv::Mat1b mask(made_picture, uchar{0});
    const cv::Rect2d box = box_of(mesh);
    const cv::Point2d middle = centre_of(box);
    cv::ellipse(mask, cv::Point(middle),
                cv::Size(cvRound(0.5 * hair * box.width), cvRound(0.5 * hair * box.height)), 0.0,
                0.0, 360.0, cv::Scalar(255), cv::FILLED);
    cv::ellipse(mask, cv::Point(middle + cv::Point2d(0.0, 1.35 * box.height)),
                cv::Size(cvRound(1.2 * box.width), cvRound(0.75 * box.height)), 0.0, 0.0, 360.0,
                cv::Scalar(255), cv::FILLED);
    return {mask(part).clone(), part};
}

}  // namespace touchline::testing
