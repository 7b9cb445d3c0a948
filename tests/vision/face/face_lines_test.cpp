#include "vision/face/face_lines.h"

#include "tests/vision/face/made_face.h"

#include <cmath>
#include <optional>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

std::optional<PartLine> part_of(const std::vector<PartLine>& lines, FacePart part) {
    const auto found = std::ranges::find(lines, part, &PartLine::part);
    return found == lines.end() ? std::nullopt : std::optional(*found);
}

bool has(const std::vector<PartLine>& lines, FacePart part) {
    return part_of(lines, part).has_value();
}

MadeFace turned(double radians) {
    MadeFace face;
    face.turn_rad = radians;
    return face;
}

TEST(FaceLines, TurningTheHeadTakesTheFarSideAway) {
    EXPECT_NEAR(turn_of(turned(0.0).mesh()).narrower_share, 0.5, 0.01);
    EXPECT_FALSE(turn_of(turned(0.3).mesh()).is_left_narrower) << "it looks to the right";
    EXPECT_TRUE(turn_of(turned(-0.3).mesh()).is_left_narrower);
    double before = 0.6;
    for (double radians = 0.0; radians < 1.25; radians += 0.1) {
        const double share = turn_of(turned(radians).mesh()).narrower_share;
        EXPECT_LT(share, before) << radians;
        before = share;
    }
    EXPECT_LT(before, -0.02);
}

TEST(FaceLines, OfAFaceTurnedAwayTheFarEyeAndBrowGo) {
    for (const double side : {1.0, -1.0}) {
        const std::vector<PartLine> lines = face_lines(turned(0.55 * side).mesh());
        EXPECT_LT(turn_of(turned(0.55 * side).mesh()).narrower_share, 0.15);
        EXPECT_EQ(has(lines, FacePart::left_eye), side > 0.0);
        EXPECT_EQ(has(lines, FacePart::right_eye), side < 0.0);
        EXPECT_EQ(has(lines, FacePart::left_brow), side > 0.0);
        EXPECT_EQ(has(lines, FacePart::right_brow), side < 0.0);
        EXPECT_TRUE(has(lines, FacePart::face));
        EXPECT_TRUE(has(lines, FacePart::nose));
    }
}

TEST(FaceLines, AProfileHasWhatTheOutlineOfTheHeadHasNot) {
    const std::vector<PartLine> lines = face_lines(turned(1.3).mesh());
    EXPECT_FALSE(has(lines, FacePart::face));
    EXPECT_FALSE(has(lines, FacePart::nose));
    EXPECT_FALSE(has(lines, FacePart::nostrils));
    EXPECT_FALSE(has(lines, FacePart::right_eye));
    EXPECT_TRUE(has(lines, FacePart::left_eye));
    EXPECT_FALSE(part_of(lines, FacePart::mouth)->line.is_closed);
}

TEST(FaceLines, AClosedMouthAndAClosedEyeAreOneLine) {
    MadeFace face;
    const auto line = [&](FacePart part) { return part_of(face_lines(face.mesh()), part)->line; };
    EXPECT_FALSE(line(FacePart::mouth).is_closed);
    EXPECT_TRUE(line(FacePart::left_eye).is_closed);
    face.mouth_open = 0.5;
    face.eyes_open = 0.1;
    EXPECT_TRUE(line(FacePart::mouth).is_closed);
    EXPECT_FALSE(line(FacePart::left_eye).is_closed);
}

TEST(FaceLines, ARoundMouthKeepsItsCornersAndBeginsInTheLeftOne) {
    for (const double tilt_rad : {0.0, 0.9, -2.0}) {
        MadeFace face;
        face.tilt_rad = tilt_rad;
        const FaceMesh mesh = with_round_mouth(face.mesh());
        const Chain mouth = part_of(face_lines(mesh), FacePart::mouth)->line;
        EXPECT_TRUE(mouth.is_closed);
        EXPECT_EQ(std::ranges::count(mouth.points, true, &EdgePoint::is_fixed), 2) << tilt_rad;
        EXPECT_TRUE(mouth.points.front().is_fixed);
        EXPECT_LT(distance(mouth.points.front().at, mesh[78]), 3.0) << tilt_rad;
    }
}

TEST(FaceLines, ATurnedPictureTurnsEveryLine) {
    MadeFace face = turned(0.25);
    face.mouth_open = 0.4;
    const std::vector<PartLine> upright = face_lines(face.mesh());
    face.tilt_rad = 0.7;
    const std::vector<PartLine> tilted = face_lines(face.mesh());
    ASSERT_EQ(upright.size(), tilted.size());
    const double c = std::cos(0.7);
    const double s = std::sin(0.7);
    for (std::size_t i = 0; i < upright.size(); ++i) {
        EXPECT_EQ(upright[i].part, tilted[i].part);
        ASSERT_EQ(upright[i].line.points.size(), tilted[i].line.points.size());
        for (std::size_t k = 0; k < upright[i].line.points.size(); ++k) {
            const cv::Point2d p = upright[i].line.points[k].at - face.middle;
            const cv::Point2d there =
                face.middle + cv::Point2d(c * p.x - s * p.y, s * p.x + c * p.y);
            EXPECT_LT(distance(there, tilted[i].line.points[k].at), 1e-6);
        }
    }
}

TEST(FaceLines, NoLineTurnsSharplyButInTheCornersOfEyesAndMouth) {
    MadeFace face;
    face.mouth_open = 0.6;
    for (const PartLine& part : face_lines(face.mesh())) {
        const std::vector<EdgePoint>& points = part.line.points;
        int corners = 0;
        for (std::size_t i = 1; i + 1 < points.size(); ++i) {
            const cv::Point2d in = points[i].at - points[i - 1].at;
            const cv::Point2d out = points[i + 1].at - points[i].at;
            const bool is_sharp = std::abs(std::atan2(in.cross(out), in.dot(out))) > 0.5;
            corners += is_sharp ? 1 : 0;
            EXPECT_TRUE(!is_sharp || points[i].is_fixed) << static_cast<int>(part.part);
        }
        EXPECT_LE(corners, part.line.is_closed ? 2 : 0);
    }
}

/// Paints skin with eyes in it, or with lenses before them.
cv::Mat3b painted(const MadeFace& face, bool has_glasses) {
    cv::Mat3b picture(480, 640, cv::Vec3b(120, 150, 190));
    for (const PartLine& part : face_lines(face.mesh())) {
        if (part.part != FacePart::left_eye && part.part != FacePart::right_eye) continue;
        std::vector<cv::Point> ring;
        for (const EdgePoint& p : part.line.points) ring.emplace_back(p.at);
        const cv::Rect box = cv::boundingRect(ring);
        const cv::Point middle = (box.tl() + box.br()) / 2;
        if (has_glasses) {
            cv::circle(picture, middle, 3 * box.width / 4, cv::Scalar(35, 30, 30), cv::FILLED);
        } else {
            cv::fillPoly(picture, ring, cv::Scalar(225, 225, 225));
            cv::circle(picture, middle, box.height / 2, cv::Scalar(20, 30, 40), cv::FILLED);
        }
    }
    return picture;
}

TEST(FaceLines, EyesBehindSunglassesAreNotShown) {
    for (const double radians : {0.0, 0.3, -0.6}) {
        const MadeFace face = turned(radians);
        EXPECT_TRUE(shows_eyes(painted(face, false), face.mesh())) << radians;
        EXPECT_FALSE(shows_eyes(painted(face, true), face.mesh())) << radians;
    }
    const std::vector<PartLine> lines = face_lines(MadeFace().mesh(), false);
    EXPECT_FALSE(has(lines, FacePart::left_eye));
    EXPECT_TRUE(has(lines, FacePart::left_brow));
}

TEST(FaceLines, AFaceBesideThePictureIsAskedWithoutHarm) {
    MadeFace face;
    for (const cv::Point2d middle :
         {cv::Point2d(-900.0, 10.0), cv::Point2d(0.0, 0.0), cv::Point2d(1e6, 1e6)}) {
        face.middle = middle;
        EXPECT_TRUE(shows_eyes(cv::Mat3b(40, 40, cv::Vec3b(9, 9, 9)), face.mesh()));
    }
}

}  // namespace
}  // namespace touchline::testing
