#include "vision/face/face_map.h"

#include "config/types/map_bytes.h"
#include "tests/vision/face/made_face.h"
#include "tests/vision/simplify/touch_rules.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include <gtest/gtest.h>

namespace touchline::testing {
namespace {

const SpacingScale eye_scale{{116.0, 84.0}, 3.2, 0.25};

/// An eye between two corners, with sides this far apart in the middle.
Chain eye(double width_mm, double opening_mm) {
    constexpr int side_parts = 40;
    Chain ring{{}, true};
    const auto add = [&](int i, double side) {
        const double x = static_cast<double>(i) / side_parts;
        const double y = side * 2.0 * opening_mm * x * (1.0 - x);
        ring.points.push_back({{50.0 + x * width_mm, 40.0 + y}, 0.0, i == 0 || i == side_parts});
    };
    for (int i = 0; i <= side_parts; ++i) add(i, -1.0);
    for (int i = side_parts - 1; i > 0; --i) add(i, 1.0);
    return ring;
}

double height_of(const Chain& line) {
    const auto [low, high] =
        std::ranges::minmax(line.points, {}, [](const EdgePoint& p) { return p.at.y; });
    return high.at.y - low.at.y;
}

TEST(SlitRings, ANarrowRingIsOpenedAndKeepsItsCorners) {
    for (const double opening_mm : {0.2, 1.0, 3.0}) {
        const Chain opened = opened_for_finger(eye(14.0, opening_mm), eye_scale);
        EXPECT_TRUE(opened.is_closed);
        EXPECT_GE(height_of(opened), 3.6 - 1e-6) << opening_mm;
        EXPECT_LE(height_of(opened), 6.0 + eye_scale.step_mm) << opening_mm;
        EXPECT_EQ(std::ranges::count(opened.points, true, &EdgePoint::is_fixed), 2);
        EXPECT_LT(distance(opened.points.front().at, {50.0, 40.0}), 1e-9);
    }
}

TEST(SlitRings, AWideRingStaysAsWideAsItIs) {
    EXPECT_NEAR(height_of(opened_for_finger(eye(30.0, 12.0), eye_scale)), 12.0, 0.1);
}

TEST(SlitRings, TheMiddleRunsFromCornerToCorner) {
    const Chain middle = middle_of(eye(14.0, 5.0));
    EXPECT_FALSE(middle.is_closed);
    EXPECT_LT(distance(middle.points.front().at, {50.0, 40.0}), 1e-9);
    EXPECT_LT(distance(middle.points.back().at, {64.0, 40.0}), 1e-9);
    EXPECT_LT(height_of(middle), 1e-6);
}

TEST(SlitRings, WhereTheRingBeginsDoesNotMatter) {
    Chain ring = eye(14.0, 2.0);
    std::ranges::rotate(ring.points, ring.points.begin() + 17);
    EXPECT_FALSE(middle_of(ring).is_closed);
    EXPECT_NEAR(height_of(opened_for_finger(ring, eye_scale)),
                height_of(opened_for_finger(eye(14.0, 2.0), eye_scale)), 1e-6);
}

TEST(SlitRings, WhatHasNoTwoCornersOrNoWidthStaysAsItIs) {
    Chain round = eye(14.0, 2.0);
    for (EdgePoint& p : round.points) p.is_fixed = false;
    Chain cornered = eye(14.0, 2.0);
    cornered.points[5].is_fixed = true;
    Chain open = eye(14.0, 2.0);
    open.is_closed = false;
    for (const Chain& line : {round, cornered, open, Chain{}, Chain{{}, true}}) {
        for (const Chain& same : {opened_for_finger(line, eye_scale), middle_of(line)}) {
            EXPECT_EQ(same.is_closed, line.is_closed);
            EXPECT_EQ(same.points.size(), line.points.size());
        }
    }
    EXPECT_LT(height_of(opened_for_finger(eye(14.0, 0.0), eye_scale)), 1e-9);
}

/// Lines are as far apart as a finger can tell; number and length are free.
constexpr TouchRules face_rules{60, 1e9, 3.9, 3.2};

/// The map has no outline of the person if `hair` is 0.
FaceMap map_of(const MadeFace& face, double hair, const Area& area = {}) {
    const FaceMesh mesh = face.mesh();
    std::vector<PartLine> lines = face_lines(mesh);
    if (hair > 0.0)
        std::ranges::move(person_outline(made_person(face, hair), mesh), std::back_inserter(lines));
    return face_map(box_of(mesh), lines, area);
}

/// Returns the middle of a part's outlines in millimetres, y away from the user.
std::optional<Position> middle_of(const FaceMap& face, FacePart part) {
    Position sum;
    double points = 0.0;
    for (std::size_t i = 0; i < face.parts.size(); ++i) {
        if (face.parts[i] != part) continue;
        for (const Position& p : face.map.outlines[i].points) sum += 1000.0 * p;
        points += static_cast<double>(face.map.outlines[i].points.size());
    }
    if (points == 0.0) return std::nullopt;
    return (1.0 / points) * sum;
}

std::size_t count(const FaceMap& face, FacePart part) {
    return static_cast<std::size_t>(std::ranges::count(face.parts, part));
}

/// Returns the map's first outline of a part.
const Outline& outline_of(const FaceMap& face, FacePart part) {
    const auto at = std::ranges::find(face.parts, part) - face.parts.begin();
    return face.map.outlines[static_cast<std::size_t>(at)];
}

TEST(FaceMap, AFaceFromTheFrontHasAllItsPartsInTheirPlaces) {
    const FaceMap face = map_of({}, 1.3);
    ASSERT_EQ(face.parts.size(), face.map.outlines.size());
    for (std::size_t number = 0; number < face_part_ids.size(); ++number) {
        EXPECT_EQ(count(face, static_cast<FacePart>(number)), 1U) << face_part_ids[number];
    }
    const auto at = [&](FacePart part) { return *middle_of(face, part); };
    EXPECT_LT(at(FacePart::left_eye).x, at(FacePart::nose).x);
    EXPECT_LT(at(FacePart::nose).x, at(FacePart::right_eye).x);
    EXPECT_GT(at(FacePart::left_brow).y, at(FacePart::left_eye).y);
    EXPECT_GT(at(FacePart::right_brow).y, at(FacePart::right_eye).y);
    EXPECT_GT(at(FacePart::left_eye).y, at(FacePart::nostrils).y);
    EXPECT_GT(at(FacePart::nostrils).y, at(FacePart::mouth).y);
}

TEST(FaceMap, WhatAHandNeedsFirstComesFirst) {
    const FaceMap face = map_of({}, 1.3);
    int before = 1;
    double weight = 2.0;
    for (std::size_t i = 0; i < face.parts.size(); ++i) {
        const Outline& outline = face.map.outlines[i];
        EXPECT_GE(outline.detail, before);
        EXPECT_LT(outline.weight, weight);
        before = outline.detail;
        weight = outline.weight;
        const bool is_silhouette =
            face.parts[i] == FacePart::person || face.parts[i] == FacePart::face;
        EXPECT_EQ(outline.detail == 1, is_silhouette);
    }
}

TEST(FaceMap, TheHeadFillsTheHeightOfTheArea) {
    for (const double hair : {1.15, 1.6}) {
        const FaceMap face = map_of({}, hair);
        double low_mm = 84.0;
        double high_mm = -84.0;
        for (const Outline& outline : face.map.outlines) {
            for (const Position& p : outline.points) {
                low_mm = std::min(low_mm, 1000.0 * p.y);
                high_mm = std::max(high_mm, 1000.0 * p.y);
            }
        }
        EXPECT_GT(high_mm - low_mm, 70.0) << hair;
        EXPECT_LT(high_mm, 42.0 - 1.0) << "a finger goes round the head";
    }
}

TEST(FaceMap, EveryPoseKeepsTheSpacingTheAreaAndTheOrder) {
    std::mt19937 random(7);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    int eyes = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const MadeFace made{between(-1.5, 1.5),
                            between(-0.6, 0.6),
                            between(-0.8, 0.8),
                            between(12.0, 90.0),
                            {between(150.0, 490.0), between(100.0, 380.0)},
                            trial % 2 == 0 ? 0.0 : between(0.0, 1.0),
                            trial % 7 == 0 ? 0.0 : between(0.3, 1.0),
                            between(-0.2, 0.2),
                            between(0.8, 1.3)};
        const Area area = trial % 5 == 0 ? Area{0.2, 0.15} : Area{};
        const double hair = trial % 9 == 0 ? 0.0 : between(0.9, 1.8);
        const FaceMap face = map_of(made, hair, area);
        SCOPED_TRACE(made.words());
        EXPECT_EQ(fault_of(face.map), "");
        EXPECT_EQ(faults_of(face.map, face_rules), std::vector<std::string>{});
        for (const Outline& outline : face.map.outlines) {
            for (const Position& p : outline.points) {
                EXPECT_LE(std::abs(p.x), 0.5 * area.width_m + 1e-9);
                EXPECT_LE(std::abs(p.y), 0.5 * area.height_m + 1e-9);
            }
        }
        const Position up{std::sin(made.tilt_rad), std::cos(made.tilt_rad)};
        const Position right{up.y, -up.x};
        const auto left_eye = middle_of(face, FacePart::left_eye);
        const auto right_eye = middle_of(face, FacePart::right_eye);
        const auto mouth = middle_of(face, FacePart::mouth);
        const bool is_profile = std::abs(made.turn_rad) > 1.2;  // the eyes overlap
        if (left_eye && right_eye && !is_profile) {
            EXPECT_LT(dot(right, *left_eye), dot(right, *right_eye));
            ++eyes;
        }
        for (const auto& eye : {left_eye, right_eye}) {
            const bool is_judged = eye && mouth && std::abs(made.skew) < 0.1 && !is_profile;
            EXPECT_TRUE(!is_judged || dot(up, *eye) > dot(up, *mouth));
        }
        if (HasFailure()) break;
    }
    EXPECT_GT(eyes, 100);
}

TEST(FaceMap, ATurnedPictureGivesATurnedMap) {
    MadeFace made;
    made.turn_rad = 0.3;
    const FaceMap upright = map_of(made, 0.0);
    made.tilt_rad = 0.5;
    const FaceMap tilted = map_of(made, 0.0);
    ASSERT_EQ(upright.parts, tilted.parts);
    const auto way = [](const FaceMap& face) {
        const Position across =
            *middle_of(face, FacePart::right_eye) - *middle_of(face, FacePart::left_eye);
        return std::atan2(across.y, across.x);
    };
    EXPECT_NEAR(way(upright) - way(tilted), 0.5, 0.05);
}

TEST(FaceMap, AnOpenEyeIsWideEnoughForAFinger) {
    MadeFace made;
    made.eyes_open = 0.5;
    const FaceMap face = map_of(made, 1.3);
    ASSERT_EQ(count(face, FacePart::left_eye), 1U);
    const Outline& eye = outline_of(face, FacePart::left_eye);
    const auto [low, high] = std::ranges::minmax(eye.points, {}, &Position::y);
    EXPECT_GT(1000.0 * (high.y - low.y), 3.2);
    EXPECT_TRUE(eye.is_closed);
}

/// The lines of a face with a round mouth and, close below it, a line that leaves its ring no room.
std::vector<PartLine> crowded(const FaceMesh& mesh) {
    std::vector<PartLine> lines = face_lines(mesh);
    const cv::Point2d below = mesh[14] + cv::Point2d(0.0, 6.0);
    Chain scarf;
    for (double x = -80.0; x <= 80.0; x += 2.0) {
        scarf.points.push_back({below + cv::Point2d(x, 0.0)});
    }
    lines.push_back({FacePart::person, scarf});
    return lines;
}

TEST(FaceMap, ARoundMouthIsARingAndWithoutRoomOneLine) {
    const FaceMesh mesh = with_round_mouth(MadeFace().mesh());
    const FaceMap free = face_map(box_of(mesh), face_lines(mesh), {});
    ASSERT_EQ(count(free, FacePart::mouth), 1U);
    EXPECT_TRUE(outline_of(free, FacePart::mouth).is_closed);
    const FaceMap face = face_map(box_of(mesh), crowded(mesh), {});
    ASSERT_EQ(count(face, FacePart::mouth), 1U);
    const Outline& mouth = outline_of(face, FacePart::mouth);
    EXPECT_FALSE(mouth.is_closed);
    const auto [low, high] = std::ranges::minmax(mouth.points, {}, &Position::y);
    EXPECT_LT(1000.0 * (high.y - low.y), 0.2 * length_of(mouth)) << "it is no hook";
}

TEST(FaceMap, ARingWithoutCornersAndRoomIsLeftOut) {
    const FaceMesh mesh = with_round_mouth(MadeFace().mesh());
    std::vector<PartLine> lines = crowded(mesh);
    const auto mouth = std::ranges::find(lines, FacePart::mouth, &PartLine::part);
    for (EdgePoint& p : mouth->line.points) p.is_fixed = false;
    EXPECT_EQ(count(face_map(box_of(mesh), lines, {}), FacePart::mouth), 0U);
}

TEST(FaceMap, TheOvalGivesWayToTheOutlineWhereTheyRunTogether) {
    const FaceMap bald = map_of({}, 1.02);
    EXPECT_EQ(count(bald, FacePart::person), 1U);
    double oval_mm = 0.0;
    for (std::size_t i = 0; i < bald.parts.size(); ++i) {
        if (bald.parts[i] == FacePart::face) oval_mm += length_of(bald.map.outlines[i]);
    }
    EXPECT_LT(oval_mm, 60.0) << "but for the chin between the shoulders";
}

TEST(FaceMap, WhatIsNoFaceGivesNoOutlinesAndDoesNoHarm) {
    EXPECT_TRUE(face_map({}, {}, {}).map.outlines.empty());
    EXPECT_TRUE(face_map({0.0, 0.0, -5.0, 10.0}, {}, {}).map.outlines.empty());
    std::mt19937 random(11);
    std::uniform_real_distribution<double> anywhere(-900.0, 1500.0);
    for (int trial = 0; trial < 200; ++trial) {
        FaceMesh mesh;
        for (cv::Point2d& p : mesh) {
            p = trial % 10 == 0 ? cv::Point2d(7.0, 7.0)
                                : cv::Point2d(anywhere(random), anywhere(random));
        }
        const FaceMap face = face_map(box_of(mesh), face_lines(mesh), {});
        EXPECT_EQ(fault_of(face.map), "");
    }
}

}  // namespace
}  // namespace touchline::testing
