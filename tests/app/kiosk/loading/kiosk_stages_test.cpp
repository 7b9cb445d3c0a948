// Tests the stages on real files with real workers.
#include "app/kiosk/loading/kiosk_stages.h"

#include "app/documents/decode/files.h"
#include "app/documents/decode/opening.h"
#include "app/documents/gallery/gallery.h"
#include "app/documents/trace/page_views.h"
#include "config/types/map_bytes.h"
#include "tests/app/documents/decode/files_of_formats.h"
#include "tests/app/documents/decode/pdf_writer.h"

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// A document in memory that a worker opens; counts the openings and keeps the last resolution.
struct Document {
    explicit Document(encoders::Bytes bytes)
        : file(std::make_shared<const PictureFile>(
              PictureFile{"a.pdf", "a", "", false, [this, bytes](const PageOrder& order) {
                              ++opened;
                              dpi = order.dpi;
                              return open_page(bytes, order);
                          }})) {}

    std::atomic<int> opened{0};
    std::atomic<int> dpi{0};
    FilePtr file;
};

LoadedScene felt(const KioskStages& stages, const Document& document, int page, int view) {
    const auto opened = stages.open(*document.file, page);
    EXPECT_TRUE(opened.has_value()) << opened.error().line;
    const auto found = stages.find(*document.file, *opened, view, {3});
    EXPECT_TRUE(found.has_value()) << found.error().line;
    auto scene = stages.build(*document.file, **found, {3});
    EXPECT_TRUE(scene.has_value()) << scene.error().line;
    return std::move(*scene);
}

const encoders::Bytes& two_pages() {
    static const encoders::Bytes pdf =
        drawn_pdf({{{100, 500, 400, 200}, {100, 100, 100, 100}}, {{0, 0, 500, 500}}});
    return pdf;
}

TEST(KioskStages, AFigureFillsTheAreaOfTheHand) {
    const KioskStages stages(default_profile());
    const Document document(two_pages());
    const LoadedScene scene = felt(stages, document, 1, 1);
    const PagePlace place{1, 2, 1, 3};
    EXPECT_EQ(scene.facts.place, place);
    EXPECT_EQ(scene.facts.title, "a");
    EXPECT_EQ(document.opened, 1);
    ASSERT_FALSE(scene.felt.map->outlines.empty());
    // The dark square is half as wide as its picture, which is twice as wide as high: 116 mm.
    double left_m = 1.0;
    double right_m = -1.0;
    for (const Outline& outline : scene.felt.map->outlines) {
        for (const Position p : outline.points) {
            left_m = std::min(left_m, p.x);
            right_m = std::max(right_m, p.x);
        }
    }
    EXPECT_NEAR(right_m - left_m, 0.058, 0.003);
    EXPECT_NEAR(right_m + left_m, 0.0, 0.003);
}

TEST(KioskStages, ASmallFigureIsDrawnAgainFiner) {
    const KioskStages stages(default_profile());
    const Document document(two_pages());
    const auto page = stages.open(*document.file, 1);
    const auto found = stages.find(*document.file, *page, 2, {3});
    ASSERT_TRUE(found.has_value()) << found.error().line;
    EXPECT_EQ(document.opened, 2);
    // The figure has 100 points, which was 209 pixels, rounded up, at 150 dpi.
    EXPECT_NEAR(document.dpi, 432, 3);
    EXPECT_NEAR((*found)->view->picture.width, 600, 5);
}

TEST(KioskStages, ThePageAsAWholeComesLast) {
    const KioskStages stages(default_profile());
    const Document document(two_pages());
    const LoadedScene scene = felt(stages, document, 1, 3);
    EXPECT_EQ(scene.facts.place.view, 3);
    EXPECT_GE(scene.facts.outline_count, 2);
}

TEST(KioskStages, EveryPageOfALongDocumentIsFelt) {
    const KioskStages stages(default_profile());
    const Document document(
        written_pdf(std::vector<WrittenPage>(300, {"4 w 100 300 400 200 re S"})));
    for (const int page : {1, 201, 300}) {
        const PagePlace place{page, 300, 1, 1};
        EXPECT_EQ(felt(stages, document, page, 1).facts.place, place);
    }
}

TEST(KioskStages, ADetailCostsNoWorker) {
    const KioskStages stages(default_profile());
    const Document document(two_pages());
    const auto page = stages.open(*document.file, 2);
    const auto found = stages.find(*document.file, *page, 1, {3});
    const int opened = document.opened;
    for (int detail = 1; detail <= 5; ++detail) {
        const auto scene = stages.build(*document.file, **found, {detail});
        ASSERT_TRUE(scene.has_value());
        EXPECT_EQ(scene->felt.recorded.detail, detail);
    }
    EXPECT_EQ(document.opened, opened);
}

TEST(KioskStages, AGalleryPictureIsFeltByItsOwnLines) {
    const KioskStages stages(default_profile());
    const FilePtr fish = file_at(gallery_folder() + "/06-fish.svg");
    EXPECT_EQ(fish->gallery_file, "06-fish.svg");
    const auto page = stages.open(*fish, 1);
    ASSERT_TRUE(page.has_value()) << page.error().line;
    const auto found = stages.find(*fish, *page, 1, {3});
    ASSERT_TRUE(found.has_value()) << found.error().line;
    EXPECT_FALSE((*found)->lines.has_value());
    const auto first = stages.build(*fish, **found, {3});
    const auto second = stages.build(*fish, **found, {3});
    ASSERT_TRUE(first.has_value() && second.has_value());
    EXPECT_EQ(first->felt.recorded.hash, second->felt.recorded.hash);
    EXPECT_NE(first->felt.map->version, second->felt.map->version);
}

TEST(KioskStages, APartIsFeltEnlargedAndShownSo) {
    const KioskStages stages(default_profile());
    const FilePtr fish = file_at(gallery_folder() + "/06-fish.svg");
    const auto page = stages.open(*fish, 1);
    const auto found = stages.find(*fish, *page, 1, {3});
    const auto whole = stages.build(*fish, **found, {3});
    const auto part = stages.build(*fish, **found, {3, {{-0.02, 0.0}, 2.0}});
    ASSERT_TRUE(whole.has_value() && part.has_value());
    EXPECT_NE(part->felt.recorded.hash, whole->felt.recorded.hash);
    EXPECT_TRUE(part->felt.recorded.gallery_file.empty()) << "no file of the gallery is felt so";
    EXPECT_NE(part->shown.picture, whole->shown.picture);
    const auto nothing = stages.build(*fish, **found, {3, {{0.058, 0.042}, 16.0}});
    ASSERT_FALSE(nothing.has_value());
    EXPECT_NE(nothing.error().line.find("choose another part"), std::string::npos);
}

TEST(KioskStages, NothingToFeelIsAnEmptySoundMap) {
    const FeltPicture nothing = nothing_to_feel(default_profile());
    EXPECT_TRUE(nothing.map->outlines.empty());
    EXPECT_TRUE(touchline::bytes_of(*nothing.map).has_value()) << "it crosses to the servo";
}

TEST(KioskStages, AMissingFileIsOneLineThatNamesIt) {
    const KioskStages stages(default_profile());
    const auto page = stages.open(*file_at("/nowhere/none.png"), 1);
    ASSERT_FALSE(page.has_value());
    EXPECT_EQ(page.error().line.find("/nowhere/none.png: "), 0U) << page.error().line;
}

TEST(KioskStages, APageWithNothingToFeelSaysWhichOneItIs) {
    const KioskStages stages(default_profile());
    const Document document(drawn_pdf({{{100, 100, 200, 200}}, {}}));
    const auto page = stages.open(*document.file, 2);
    ASSERT_TRUE(page.has_value()) << page.error().line;
    const auto found = stages.find(*document.file, *page, 1, {3});
    ASSERT_FALSE(found.has_value());
    EXPECT_EQ(found.error().line.find("a.pdf, page 2: "), 0U) << found.error().line;
}

TEST(KioskStages, WhatAWorkerSaysOfThePageNumberIsNotTakenForIt) {
    const KioskStages stages(default_profile());
    Page lie;
    lie.number = 2;
    lie.count = 3;
    const PictureFile file{"a.pdf", "a", "", false, [lie](const PageOrder&) { return lie; }};
    EXPECT_FALSE(stages.open(file, 1).has_value());
    EXPECT_TRUE(stages.open(file, 2).has_value());
}

TEST(KioskStages, WordsThatWereReadAreHeardAndNotFelt) {
    const PageReader reader = [](const Page& page) -> std::optional<Page> {
        Page read = page;
        read.told.labels.push_back({"dark", {0.0, 0.0}});
        return read;
    };
    const KioskStages stages(default_profile(), reader);
    EXPECT_TRUE(stages.has_reading());
    EXPECT_FALSE(KioskStages(default_profile()).has_reading());
    const Document document(two_pages());
    const auto page = stages.open(*document.file, 1);
    const auto found = stages.find(*document.file, *page, 1, {3});
    const FoundPtr better = stages.reread(**found);
    ASSERT_NE(better, nullptr);
    EXPECT_EQ(better->place, (*found)->place);
    const auto scene = stages.build(*document.file, *better, {3});
    ASSERT_TRUE(scene.has_value());
    ASSERT_EQ(scene->felt.map->labels.size(), 1U);
    EXPECT_EQ(scene->felt.map->labels[0].text, "dark");
}

/// A scan: its words are pixels until they are read; afterwards they are no lines for the hand.
TEST(KioskStages, WordsInPixelsAreHeardAndNoLongerFelt) {
    const auto language = std::make_shared<std::atomic<WrittenLanguage>>(WrittenLanguage::english);
    const KioskStages stages(default_profile(), page_reader(language));
    ASSERT_TRUE(stages.has_reading());
    const std::string drawing =
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1600 1160'><rect width='1600' "
        "height='1160' fill='white'/><rect x='200' y='500' width='900' height='500' fill='none' "
        "stroke='black' stroke-width='12'/><text x='250' y='300' font-family='DejaVu Sans' "
        "font-size='60'>Westport Harbour</text></svg>";
    const auto drawn = open_page(encoders::bytes_of(drawing));
    ASSERT_TRUE(drawn.has_value()) << drawn.error().line;
    const Document scan(encoders::png(drawn->picture));
    const auto page = stages.open(*scan.file, 1);
    ASSERT_TRUE(page.has_value()) << page.error().line;
    const auto first = stages.find(*scan.file, *page, 1, {3});
    ASSERT_TRUE(first.has_value()) << first.error().line;
    const FoundPtr better = stages.reread(**first);
    ASSERT_NE(better, nullptr);
    const auto before = stages.build(*scan.file, **first, {5});
    const auto after = stages.build(*scan.file, *better, {5});
    ASSERT_TRUE(before.has_value() && after.has_value());
    EXPECT_TRUE(before->felt.map->labels.empty());
    ASSERT_EQ(after->felt.map->labels.size(), 1U);
    EXPECT_EQ(after->felt.map->labels[0].text, "Westport Harbour");
    EXPECT_LT(after->felt.map->outlines.size(), before->felt.map->outlines.size());
    EXPECT_EQ(stages.reread(*better), nullptr) << "what was read is not read again";
}

}  // namespace
}  // namespace touchline
