#include "tests/lab/bench/vision/pictures.h"

#include "app/documents/decode/files.h"
#include "app/documents/decode/picture.h"
#include "tests/vision/boundary/glyphs.h"

#include <algorithm>
#include <filesystem>

#include <opencv2/imgproc.hpp>

namespace touchline::bench {
namespace {

namespace fs = std::filesystem;

Result<cv::Mat1b> read_grey(const std::string& path) {
    return pixels_of(path).map([](const cv::Mat& picture) {
        cv::Mat1b grey;
        cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
        return grey;
    });
}

std::vector<fs::path> photos_in(const std::string& folder) {
    std::vector<fs::path> photos;
    std::error_code trouble;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, trouble)) {
        if (entry.path().extension() == ".jpg") photos.push_back(entry.path());
    }
    std::ranges::sort(photos);
    return photos;
}

Result<MarkedPicture> marked_picture(const fs::path& photo) {
    const Result<cv::Mat> picture = pixels_of(photo.string());
    if (!picture) return tl::unexpected(picture.error());
    MarkedPicture marked{*picture, {}};
    for (int k = 1;; ++k) {
        const fs::path human =
            photo.parent_path() / (photo.stem().string() + "-human" + std::to_string(k) + ".png");
        if (!fs::exists(human)) break;
        const Result<cv::Mat1b> boundary = read_grey(human.string());
        if (!boundary) return tl::unexpected(boundary.error());
        marked.annotators.push_back(*boundary);
    }
    if (marked.annotators.empty())
        return failure(photo.string() + ": nobody has marked its boundaries; " +
                       photo.stem().string() + "-human1.png is expected beside it");
    return marked;
}

}  // namespace

Result<cv::Mat> pixels_of(const std::string& path) {
    return read_picture(path).map([](const Picture& picture) {
        cv::Mat bgr(picture.height, picture.width, CV_8UC3);
        std::copy(picture.bgr.begin(), picture.bgr.end(), bgr.ptr());
        return bgr;
    });
}

std::vector<MarkedPicture> made_pictures() {
    std::vector<MarkedPicture> made;
    for (int i = 0; i < 48; ++i) {
        const testing::TruthScene scene = testing::pictogram_scene(i, {480, 320});
        made.push_back({scene.picture, {scene.boundary}});
    }
    return made;
}

Result<std::vector<MarkedPicture>> pictures_in(const std::string& folder) {
    std::vector<MarkedPicture> pictures;
    for (const fs::path& photo : photos_in(folder)) {
        auto marked = marked_picture(photo);
        if (!marked) return tl::unexpected(marked.error());
        pictures.push_back(std::move(*marked));
    }
    if (pictures.empty()) return failure(folder + ": there are no .jpg pictures in it");
    return pictures;
}

Result<std::vector<FigurePicture>> pictures_in(const std::string& folder,
                                               const std::string& truths) {
    std::vector<FigurePicture> pictures;
    for (const fs::path& photo : photos_in(folder)) {
        const fs::path truth = fs::path(truths) / (photo.stem().string() + ".png");
        if (!fs::exists(truth)) continue;
        auto marked = marked_picture(photo);
        if (!marked) return tl::unexpected(marked.error());
        auto mask = read_grey(truth.string());
        if (!mask) return tl::unexpected(mask.error());
        pictures.push_back({photo.stem().string(), std::move(*marked), std::move(*mask)});
    }
    if (pictures.empty()) return failure(truths + ": there is no mask of a picture in it");
    return pictures;
}

Result<std::vector<cv::Mat>> bare_pictures_in(const std::string& folder) {
    std::vector<cv::Mat> pictures;
    for (const fs::path& photo : photos_in(folder)) {
        const Result<cv::Mat> picture = pixels_of(photo.string());
        if (!picture) return tl::unexpected(picture.error());
        pictures.push_back(*picture);
    }
    if (pictures.empty()) return failure(folder + ": there are no .jpg pictures in it");
    return pictures;
}

}  // namespace touchline::bench
