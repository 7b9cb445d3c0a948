#include "tests/vision/face/made_face.h"
#include "vision/face/face_lines.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

bool holds(const std::vector<PartLine>& lines, cv::Point2d p) {
    std::vector<cv::Point2f> ring;
    for (const PartLine& line : lines) {
        for (const EdgePoint& point : line.line.points) ring.emplace_back(point.at);
    }
    return cv::pointPolygonTest(ring, p, false) > 0.0;
}

TEST(PersonOutline, RunsRoundHeadAndShouldersOpenWhereThePartEnds) {
    const MadeFace face;
    const std::vector<PartLine> lines = person_outline(made_person(face, 1.4), face.mesh());
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].part, FacePart::person);
    EXPECT_FALSE(lines[0].line.is_closed);
    const cv::Rect part = head_and_shoulders(face.mesh(), made_picture);
    EXPECT_NEAR(lines[0].line.points.front().at.y, part.br().y, 10.0);
    EXPECT_NEAR(lines[0].line.points.back().at.y, part.br().y, 10.0);
    const cv::Rect2d box = box_of(face.mesh());
    const double top =
        std::ranges::min(lines[0].line.points, {}, [](const EdgePoint& p) { return p.at.y; }).at.y;
    EXPECT_NEAR(top, box.y - 0.2 * box.height, 5.0);
}

TEST(PersonOutline, AHeadByItselfIsClosed) {
    const MadeFace face;
    const cv::Rect part = head_and_shoulders(face.mesh(), made_picture);
    const std::vector<PartLine> lines =
        person_outline({cv::Mat1b(part.size(), uchar{0}), part}, face.mesh());
    ASSERT_EQ(lines.size(), 1U) << "the face itself is person";
    EXPECT_TRUE(lines[0].line.is_closed);
    for (const PartLine& line : face_lines(face.mesh())) {
        if (line.part == FacePart::face) continue;
        for (const EdgePoint& p : line.line.points) EXPECT_TRUE(holds(lines, p.at));
    }
}

TEST(PersonOutline, AProfileKeepsItsNose) {
    MadeFace face;
    face.turn_rad = 1.4;
    const cv::Rect part = head_and_shoulders(face.mesh(), made_picture);
    const std::vector<PartLine> lines =
        person_outline({cv::Mat1b(part.size(), uchar{0}), part}, face.mesh());
    ASSERT_EQ(lines.size(), 1U);
    const cv::Point2d before_tip = face.mesh()[4] - cv::Point2d(8.0, 0.0);
    EXPECT_TRUE(holds(lines, before_tip));
}

TEST(PersonOutline, AnotherPersonIsNotOutlined) {
    const MadeFace face;
    PersonMask person = made_person(face, 1.3);
    cv::circle(person.mask, {18, 60}, 14, cv::Scalar(255), cv::FILLED);
    const std::vector<PartLine> lines = person_outline(person, face.mesh());
    EXPECT_FALSE(holds(lines, person.part.tl() + cv::Point(18, 60)));
    EXPECT_EQ(lines.size(), 1U);
}

TEST(PersonOutline, WithoutAPlaceForTheFaceThereIsNone) {
    const MadeFace face;
    EXPECT_TRUE(person_outline({}, face.mesh()).empty());
    EXPECT_TRUE(person_outline({cv::Mat1b(64, 64, uchar{0}), {0, 0, 64, 64}}, face.mesh()).empty());
    EXPECT_TRUE(
        person_outline({cv::Mat1b(64, 64, uchar{255}), {0, 0, 640, 480}}, face.mesh()).empty())
        << "all of the part is person: nothing of it is an edge";
    MadeFace beside;
    beside.middle = {-5000.0, 0.0};
    EXPECT_TRUE(head_and_shoulders(beside.mesh(), made_picture).empty());
    for (const cv::Rect part :
         {cv::Rect(0, 0, 1, 1), cv::Rect(300, 0, 1, 480), cv::Rect(0, 200, 640, 1)}) {
        EXPECT_LE(person_outline({cv::Mat1b(256, 256, uchar{200}), part}, face.mesh()).size(), 9U);
    }
}

}  // namespace
}  // namespace touchline::testing
