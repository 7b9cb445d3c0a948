// Tests the files behind the choices of a visit, and the camera's way to one.
#include "app/kiosk/pictures.h"

#include "app/documents/gallery/gallery.h"
#include "app/kiosk/photo_capture.h"

#include <filesystem>
#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <unistd.h>

namespace touchline {
namespace {

FilePtr file_named(const std::string& name) {
    return std::make_shared<const PictureFile>(PictureFile{name, name, "", true, {}});
}

TEST(Pictures, TheGalleryIsReadInEveryLanguage) {
    std::vector<Language> languages(1);
    languages.push_back(Language::load(TOUCHLINE_CATALOGUES, "de").value());
    const auto gallery =
        read_gallery(TOUCHLINE_SOURCE_DIR "/app/documents/gallery/pictures", "", languages);
    ASSERT_TRUE(gallery.has_value()) << gallery.error().line;
    ASSERT_EQ(gallery->titles.size(), 2U);
    ASSERT_EQ(gallery->titles[0].size(), gallery->titles[1].size());
    ASSERT_EQ(gallery->files[1].size(), gallery->titles[1].size());
    EXPECT_NE(gallery->titles[0][5].title, gallery->titles[1][5].title);
    ASSERT_NE(gallery->circle, nullptr);
    ASSERT_NE(gallery->square, nullptr);
    EXPECT_NE(gallery->circle, gallery->square);
}

TEST(Pictures, ThatCannotBeReadAreOneLine) {
    const auto gallery = read_gallery("/nowhere", "", std::vector<Language>(1));
    ASSERT_FALSE(gallery.has_value());
    EXPECT_NE(gallery.error().line.find("/nowhere"), std::string::npos);
}

TEST(Pictures, OneThatCannotBeOpenedIsToldByItsTitle) {
    namespace fs = std::filesystem;
    const fs::path folder =
        fs::path(testing::TempDir()) / ("touchline-gallery-" + std::to_string(getpid()));
    fs::copy(TOUCHLINE_SOURCE_DIR "/app/documents/gallery/pictures", folder);
    const auto gallery = read_gallery(folder, "", std::vector<Language>(1));
    fs::remove_all(folder);
    ASSERT_TRUE(gallery.has_value()) << gallery.error().line;
    const FilePtr picture = gallery->files.front().front();
    const auto page = picture->open({});
    ASSERT_FALSE(page.has_value());
    EXPECT_TRUE(page.error().line.starts_with(picture->name + ": ")) << page.error().line;
    EXPECT_EQ(page.error().line.find(folder.string()), std::string::npos) << page.error().line;
}

TEST(Pictures, TheLinesOfWhatWasFeltAreOfItsListAlone) {
    Pictures pictures(Gallery{});
    TactileMap map;
    map.outlines.push_back({{{0.0, 0.0}, {0.01, 0.0}}, false, "a", "", 1.0, 1});
    const auto has = [&pictures](PictureSource source) {
        return pictures.lines_of(source, "A fish", 0) != nullptr;
    };
    pictures.keep_lines(PictureSource::stick, "A fish", map);
    pictures.keep_lines(PictureSource::gallery, "A fish", map);
    EXPECT_TRUE(has(PictureSource::stick));
    EXPECT_TRUE(has(PictureSource::gallery));
    EXPECT_EQ(pictures.lines_of(PictureSource::stick, "A house", 0), nullptr);
    pictures.put_stick({file_named("stick")});
    EXPECT_FALSE(has(PictureSource::stick)) << "another stick may have another fish";
    EXPECT_TRUE(has(PictureSource::gallery));
    pictures.forget();
    EXPECT_FALSE(has(PictureSource::gallery));
}

TEST(Pictures, AChoiceIsAFileOrNothing) {
    Gallery gallery;
    gallery.files = {{file_named("a"), file_named("b")}};
    gallery.circle = file_named("circle");
    gallery.square = file_named("square");
    Pictures pictures(gallery);
    const auto of = [&pictures](PictureSource source, std::size_t index) {
        LoadPicture order;
        order.source = source;
        order.index = index;
        const FilePtr file = pictures.of(order);
        return file ? file->name : "nothing";
    };
    EXPECT_EQ(of(PictureSource::practice, 0), "circle");
    EXPECT_EQ(of(PictureSource::practice, 1), "square");
    EXPECT_EQ(of(PictureSource::gallery, 1), "b");
    EXPECT_EQ(of(PictureSource::gallery, 2), "nothing");
    EXPECT_EQ(of(PictureSource::stick, 0), "nothing");
    EXPECT_EQ(of(PictureSource::camera, 0), "nothing");
    pictures.put_stick({file_named("stick")});
    pictures.put_photo(file_named("photo"));
    EXPECT_EQ(of(PictureSource::stick, 0), "stick");
    EXPECT_EQ(of(PictureSource::camera, 0), "photo");
    pictures.give({file_named("given")});
    EXPECT_EQ(of(PictureSource::stick, 0), "stick");
    pictures.forget();
    EXPECT_EQ(of(PictureSource::stick, 0), "given") << "for the next visitor too";
    EXPECT_EQ(of(PictureSource::camera, 0), "nothing");
    EXPECT_EQ(of(PictureSource::gallery, 0), "a");
}

/// Gives a preview at every step, and a still after one was asked for.
class MadeUpCamera final : public Camera {
  public:
    struct State {
        CameraCondition condition = CameraCondition::ready;
        bool is_broken = false;
        cv::Mat scene;
    };

    explicit MadeUpCamera(std::shared_ptr<State> state) : state_(std::move(state)) {}

    [[nodiscard]] std::vector<CameraName> list() override { return {}; }

    void choose(const std::string&) override {}

    [[nodiscard]] std::optional<CameraAbilities> abilities() const override { return {}; }

    void want_still() override { is_wanted_ = true; }

    [[nodiscard]] CameraView step(double) override {
        CameraView view;
        view.condition = state_->condition;
        view.preview = cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(128));
        if (!std::exchange(is_wanted_, false)) return view;
        view.has_given_up = state_->is_broken;
        if (!state_->is_broken) view.still = still();
        return view;
    }

  private:
    [[nodiscard]] Still still() const {
        const cv::Mat& bgr = state_->scene;
        Still still;
        still.frame = {PixelFormat::bgr, bgr.size(), 3U * static_cast<std::size_t>(bgr.cols),
                       std::vector<std::uint8_t>(bgr.data, bgr.data + 3 * bgr.total())};
        return still;
    }

    std::shared_ptr<State> state_;
    bool is_wanted_ = false;
};

/// A dark toy on a grey table, without any paper.
cv::Mat toy() {
    cv::Mat scene(600, 800, CV_8UC3, cv::Scalar::all(190));
    cv::circle(scene, {400, 300}, 150, cv::Scalar::all(70), cv::FILLED);
    return scene;
}

/// A page on a dark table.
cv::Mat page_on_table() {
    cv::Mat scene(900, 1200, CV_8UC3, cv::Scalar::all(45));
    cv::rectangle(scene, {250, 100}, {950, 800}, cv::Scalar::all(235), cv::FILLED);
    cv::circle(scene, {600, 450}, 120, cv::Scalar::all(30), 8);
    return scene;
}

class PhotoCaptureTest : public testing::Test {
  protected:
    PhotoCaptureTest() { state_->scene = toy(); }

    std::shared_ptr<MadeUpCamera::State> state_ = std::make_shared<MadeUpCamera::State>();
    PhotoCapture desk_{std::make_unique<MadeUpCamera>(state_)};
};

TEST_F(PhotoCaptureTest, APreviewIsThereWhileItIsWantedOnly) {
    (void)desk_.step(0.0);
    EXPECT_EQ(desk_.preview(), nullptr);
    desk_.show(true);
    (void)desk_.step(0.1);
    ASSERT_NE(desk_.preview(), nullptr);
    EXPECT_EQ(desk_.preview()->width(), 640);
    desk_.forget();
    EXPECT_EQ(desk_.preview(), nullptr);
}

TEST_F(PhotoCaptureTest, TI5_NothingIsTakenWithoutBeingAskedFor) {
    desk_.show(true);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(desk_.step(0.1 * i).photo, nullptr);
    desk_.take();
    const PhotoNews news = desk_.step(11.0);
    ASSERT_NE(news.photo, nullptr);
    EXPECT_TRUE(news.photo->is_private) << "no log may name it";
    EXPECT_EQ(desk_.step(11.1).photo, nullptr) << "once";
}

TEST_F(PhotoCaptureTest, AThingOnATableIsThePictureItself) {
    desk_.take();
    const auto page = desk_.step(0.0).photo->open({});
    ASSERT_TRUE(page.has_value()) << page.error().line;
    EXPECT_EQ(page->picture.width, 800);
    EXPECT_EQ(page->picture.height, 600);
}

TEST_F(PhotoCaptureTest, APageOnATableIsThePage) {
    state_->scene = page_on_table();
    desk_.take();
    const auto page = desk_.step(0.0).photo->open({});
    ASSERT_TRUE(page.has_value()) << page.error().line;
    EXPECT_NEAR(page->picture.width, page->picture.height, 30) << "the page is square";
    EXPECT_GT(page->picture.bgr[0], 200) << "and its corner is paper";
}

TEST_F(PhotoCaptureTest, WhatTheOperatorCutsOffIsInNoPicture) {
    desk_.set({10.0, 20.0, 0.0, 50.0 / 3.0});
    desk_.show(true);
    desk_.take();
    const auto page = desk_.step(0.0).photo->open({});
    ASSERT_TRUE(page.has_value()) << page.error().line;
    EXPECT_EQ(page->picture.width, 560);
    EXPECT_EQ(page->picture.height, 500);
    EXPECT_EQ(desk_.preview()->width(), 448);
    desk_.set({std::numeric_limits<double>::quiet_NaN(), 400.0, -1.0, 0.0});
    desk_.take();
    EXPECT_EQ(desk_.step(0.0).photo->open({})->picture.width, 800);
}

TEST_F(PhotoCaptureTest, InTheDarkOneSentenceSaysWhatToDo) {
    state_->scene = cv::Mat(600, 800, CV_8UC3, cv::Scalar::all(3));
    desk_.take();
    const auto page = desk_.step(0.0).photo->open({});
    ASSERT_FALSE(page.has_value());
    EXPECT_EQ(page.error().line, "It is too dark here. Ask the staff for more light.");
}

TEST_F(PhotoCaptureTest, APhotographOfAVisitorWhoIsGoneIsNobodys) {
    desk_.take();
    desk_.forget();
    EXPECT_EQ(desk_.step(0.0).photo, nullptr);
    desk_.take();
    EXPECT_NE(desk_.step(0.1).photo, nullptr) << "the next visitor's own";
}

TEST_F(PhotoCaptureTest, AStillThatDoesNotComeIsTold) {
    state_->is_broken = true;
    desk_.take();
    const PhotoNews news = desk_.step(0.0);
    EXPECT_TRUE(news.has_given_up);
    EXPECT_EQ(news.photo, nullptr);
}

}  // namespace
}  // namespace touchline
