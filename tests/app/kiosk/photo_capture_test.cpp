#include "app/kiosk/photo_capture.h"

#include <limits>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

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
    EXPECT_TRUE(desk_.step(0.1).has_a_preview);
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
