// Tests the list of the shipped pictures, and what a hand needs of the lines of every one
// (app/documents/gallery/README.md).
#include "app/documents/gallery/gallery.h"

#include "app/documents/decode/files.h"
#include "app/documents/decode/map_svg.h"
#include "tests/app/documents/gallery/pictures.h"
#include "tests/config/scratch_folder.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <set>

#include <gtest/gtest.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

const std::string pictures_folder = TOUCHLINE_SOURCE_DIR "/app/documents/gallery/pictures";

class GalleryFolder : public testing::Test {
  protected:
    ~GalleryFolder() override {
        ::unsetenv("TOUCHLINE_GALLERY");  // NOLINT(concurrency-mt-unsafe): one thread
    }

    [[nodiscard]] std::string folder() const { return folder_.path(); }

    void put(const std::string& name, const std::string& text) const { folder_.write(name, text); }

  private:
    ScratchFolder folder_;
};

constexpr auto smallest = "<svg viewBox='0 0 9 9'><title>T</title><path d='M1 1L2 2'/></svg>";

TEST_F(GalleryFolder, MapsAreListedByFileNameAndOtherFilesAreNot) {
    put("20-b.svg", smallest);
    put("10-c.svg", smallest);
    put("05-notes.txt", "no map");
    const auto entries = list_gallery(folder());
    ASSERT_TRUE(entries) << entries.error().line;
    ASSERT_EQ(entries->size(), 2U);
    EXPECT_EQ(entries->at(0).path, folder() + "/10-c.svg");
    EXPECT_EQ(entries->at(1).path, folder() + "/20-b.svg");
    EXPECT_EQ(entries->at(0).title, "T");
}

TEST_F(GalleryFolder, MissingEmptyAndBrokenAreOneLine) {
    const auto missing = list_gallery(folder() + "/none");
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().line.find("No such file or directory"), std::string::npos);
    const auto empty = list_gallery(folder());
    ASSERT_FALSE(empty);
    EXPECT_NE(empty.error().line.find("holds no .svg file"), std::string::npos);
    put("01-broken.svg", "<svg");
    const auto broken = list_gallery(folder());
    ASSERT_FALSE(broken);
    EXPECT_TRUE(broken.error().line.starts_with(folder() + "/01-broken.svg: "));
}

TEST_F(GalleryFolder, SpeaksTheLanguageAndKnowsTheDifficulty) {
    put("1.svg",
        "<svg viewBox='0 0 9 9' data-difficulty='4'><title>Sea</title><title "
        "xml:lang='fr'>Mer</title>"
        "<path d='M1 1L2 2'/></svg>");
    put("2.svg", smallest);
    const auto entries = list_gallery(folder(), {"fr"}).value();
    EXPECT_EQ(entries[0].title, "Mer");
    EXPECT_EQ(entries[0].difficulty, 4);
    EXPECT_EQ(entries[1].title, "T");
    EXPECT_EQ(entries[1].difficulty, std::nullopt);
    EXPECT_EQ(list_gallery(folder()).value()[0].title, "Sea");
    put("3.svg", "<svg viewBox='0 0 9 9' data-difficulty='9'><path d='M1 1L2 2'/></svg>");
    const auto broken = list_gallery(folder());
    ASSERT_FALSE(broken);
    EXPECT_TRUE(broken.error().line.starts_with(folder() + "/3.svg: ")) << broken.error().line;
}

TEST_F(GalleryFolder, TheEnvironmentChoosesAnother) {
    EXPECT_EQ(gallery_folder(), pictures_folder);
    ::setenv("TOUCHLINE_GALLERY", folder().c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
    EXPECT_EQ(gallery_folder(), folder());
    ::setenv("TOUCHLINE_GALLERY", "", 1);  // NOLINT(concurrency-mt-unsafe)
    EXPECT_EQ(gallery_folder(), pictures_folder);
}

constexpr double least_gap_m = 0.003;
constexpr double rim_m = 0.003;
constexpr double touching_m = 0.00002;      // two flattened curves that meet may each be 0.01 mm
                                            // off
constexpr double junction_reach_m = 0.008;  // around a junction, lines are bound to be near

/// Returns points along an outline, half a millimetre apart or less.
std::vector<Position> sampled(const Outline& outline) {
    std::vector<Position> points;
    const std::size_t n = outline.points.size();
    for (std::size_t i = 0; i + (outline.is_closed ? 0 : 1) < n; ++i) {
        const Position from = outline.points[i];
        const Position step = outline.points[(i + 1) % n] - from;
        const int parts = 1 + static_cast<int>(norm(step) / 0.0005);
        for (int k = 0; k < parts; ++k) points.push_back(from + (1.0 * k / parts) * step);
    }
    if (!outline.is_closed) points.push_back(outline.points.back());
    return points;
}

Position nearest_on(const Outline& outline, Position p) {
    Position best = outline.points.front();
    const std::size_t n = outline.points.size();
    for (std::size_t i = 0; i + (outline.is_closed ? 0 : 1) < n; ++i) {
        const Position from = outline.points[i];
        const Position along = outline.points[(i + 1) % n] - from;
        const double t = std::clamp(dot(p - from, along) / dot(along, along), 0.0, 1.0);
        const Position foot = from + t * along;
        if (norm(p - foot) < norm(p - best)) best = foot;
    }
    return best;
}

/// Returns where two outlines meet: crossings of their segments, and ends of one on the other.
std::vector<Position> junctions(const Outline& a, const Outline& b) {
    std::vector<Position> found;
    const auto cut = [](const Outline& outline, std::size_t i) {
        return outline.points[(i + 1) % outline.points.size()] - outline.points[i];
    };
    const auto segments = [](const Outline& outline) {
        return outline.points.size() - (outline.is_closed ? 0U : 1U);
    };
    for (std::size_t i = 0; i < segments(a); ++i) {
        for (std::size_t j = 0; j < segments(b); ++j) {
            const Position u = cut(a, i);
            const Position v = cut(b, j);
            const Position w = b.points[j] - a.points[i];
            const double area = cross(u, v);
            if (area == 0.0) continue;
            const double s = cross(w, v) / area;
            const double t = cross(w, u) / area;
            if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) {
                found.push_back(a.points[i] + s * u);
            }
        }
    }
    for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
        for (const Position end : {one->points.front(), one->points.back()}) {
            if (norm(end - nearest_on(*other, end)) <= touching_m) found.push_back(end);
        }
    }
    return found;
}

/// Returns the least distance of a to b, away from where they meet.
double gap_between(const Outline& a, const Outline& b) {
    const auto met = junctions(a, b);
    double least = std::numeric_limits<double>::infinity();
    for (const Position p : sampled(a)) {
        const bool is_junction = std::any_of(met.begin(), met.end(), [&](Position junction) {
            return norm(p - junction) < junction_reach_m;
        });
        if (!is_junction) least = std::min(least, norm(p - nearest_on(b, p)));
    }
    return least;
}

/// Returns the least distance between two places of one outline that are far apart along it.
double gap_within(const Outline& outline) {
    const auto points = sampled(outline);
    std::vector<double> at{0.0};
    for (std::size_t i = 1; i < points.size(); ++i) {
        at.push_back(at.back() + norm(points[i] - points[i - 1]));
    }
    const double around =
        at.back() + (outline.is_closed ? norm(points.front() - points.back()) : 0.0);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double along = at[i] - at[j];
            const double apart = outline.is_closed ? std::min(along, around - along) : along;
            if (apart > 2.0 * junction_reach_m)
                least = std::min(least, norm(points[i] - points[j]));
        }
    }
    return least;
}

TEST(PictureLines, EveryPartHasItsNameAndTheSilhouetteComesFirst) {
    for (const auto& [name, text, map] : shipped_pictures()) {
        SCOPED_TRACE(name);
        std::set<std::string> ids;
        for (const Outline& outline : map.outlines) {
            EXPECT_FALSE(outline.label.empty()) << outline.id;
            EXPECT_FALSE(outline.id.empty()) << outline.label;
            EXPECT_TRUE(ids.insert(outline.id).second) << outline.id;
        }
        EXPECT_EQ(map.outlines.front().detail, 1);
    }
}

TEST(PictureLines, EverythingLiesInsideTheRim) {
    for (const auto& [name, text, map] : shipped_pictures()) {
        for (const Outline& outline : map.outlines) {
            for (const Position p : outline.points) {
                ASSERT_LE(std::abs(p.x), map.area.width_m / 2.0 - rim_m) << name << outline.id;
                ASSERT_LE(std::abs(p.y), map.area.height_m / 2.0 - rim_m) << name << outline.id;
            }
        }
        for (const Label& label : map.labels) {
            EXPECT_LE(std::abs(label.place.x), map.area.width_m / 2.0) << name << label.text;
            EXPECT_LE(std::abs(label.place.y), map.area.height_m / 2.0) << name << label.text;
        }
    }
}

TEST(PictureLines, LinesTouchOrAreThreeMillimetresApart) {
    for (const auto& [name, text, map] : shipped_pictures()) {
        for (const Outline& a : map.outlines) {
            EXPECT_GE(gap_within(a), least_gap_m) << name << ": " << a.id;
            for (const Outline& b : map.outlines) {
                if (&a == &b) continue;
                EXPECT_GE(gap_between(a, b), least_gap_m) << name << ": " << a.id << ", " << b.id;
            }
        }
    }
}

TEST(PictureLines, WrittenAgainTheyAreTheSameMaps) {
    for (const auto& [name, text, map] : shipped_pictures()) {
        const auto again = parse_map_svg(format_map_svg(map));
        ASSERT_TRUE(again) << again.error().line;
        ASSERT_EQ(again->outlines.size(), map.outlines.size());
        for (std::size_t i = 0; i < map.outlines.size(); ++i) {
            EXPECT_EQ(again->outlines[i].points, map.outlines[i].points) << name;
        }
    }
}

}  // namespace
}  // namespace touchline
