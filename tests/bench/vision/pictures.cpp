#include "tests/bench/vision/pictures.h"

#include "app/decode/files.h"
#include "app/decode/picture.h"
#include "tests/vision/boundary/glyphs.h"

#include <algorithm>
#include <filesystem>

#include <opencv2/imgproc.hpp>

namespace touchline::bench {
namespace {

namespace fs = std::filesystem;

Result<cv::Mat> read(const std::string& path) {
    return read_picture(path).map([](const Picture& picture) {
        cv::Mat bgr(picture.height, picture.width, CV_8UC3);
        std::copy(picture.bgr.begin(), picture.bgr.end(), bgr.ptr());
        return bgr;
    });
}

}  // namespace

std::vector<MarkedPicture> made_pictures() {
    std::vector<MarkedPicture> made;
    for (int i = 0; i < 48; ++i) {
        const testing::TruthScene scene = testing::pictogram_scene(i, {480, 320});
        made.push_back({scene.picture, {scene.boundary}});
    }
    return made;
}

Result<std::vector<MarkedPicture>> pictures_in(const std::string& folder) {
    std::vector<fs::path> photos;
    std::error_code trouble;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, trouble)) {
        if (entry.path().extension() == ".jpg") {
            photos.push_back(entry.path());
        }
    }
    std::ranges::sort(photos);
    std::vector<MarkedPicture> pictures;
    for (const fs::path& photo : photos) {
        const Result<cv::Mat> picture = read(photo.string());
        if (!picture) return tl::unexpected(picture.error());
        MarkedPicture& marked = pictures.emplace_back(MarkedPicture{*picture, {}});
        for (int k = 1;; ++k) {
            const std::string human = (photo.parent_path() / (photo.stem().string() + "-human" +
                                                              std::to_string(k) + ".png"))
                                          .string();
            if (!fs::exists(human)) break;
            const Result<cv::Mat> boundary = read(human);
            if (!boundary) return tl::unexpected(boundary.error());
            cv::Mat1b grey;
            cv::cvtColor(*boundary, grey, cv::COLOR_BGR2GRAY);
            marked.annotators.push_back(grey);
        }
        if (marked.annotators.empty()) {
            return failure(photo.string() + ": nobody has marked its boundaries; " +
                           photo.stem().string() + "-human1.png is expected beside it");
        }
    }
    if (pictures.empty()) {
        return failure(folder + ": there are no .jpg pictures in it");
    }
    return pictures;
}

}  // namespace touchline::bench
