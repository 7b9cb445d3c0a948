#include "vision/face/person_network.h"

#include "vision/face/face_mesh.h"
#include "vision/face/person_outline.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int person_input_px = 256;
constexpr int most_people = 5;
constexpr double least_person_share = 1.0 / 80.0;  // of the picture
constexpr double seen_beyond = 0.12;   // of a box's longer side: what the network sees round it
constexpr double taken_beyond = 0.04;  // and how much of that counts

cv::Rect grown(const cv::Rect2d& box, double share, cv::Size picture) {
    const double by = share * std::max(box.width, box.height);
    return part_within({box.x - by, box.y - by, box.width + 2.0 * by, box.height + 2.0 * by},
                       picture);
}

/// Also false for a box without width or height, and for one with NaN.
bool is_large(const cv::Rect2d& box, cv::Size picture) {
    return box.width > 0.0 && box.height > 0.0 &&
           box.width * box.height >= least_person_share * picture.width * picture.height;
}

}  // namespace

Result<PersonNetwork> PersonNetwork::from_onnx(std::span<const std::byte> model) {
    return TrainedNetwork::from_onnx(model, "tells persons from the rest")
        .map([](TrainedNetwork&& network) { return PersonNetwork(std::move(network)); });
}

Result<cv::Mat1b> PersonNetwork::mask_of(const cv::Mat3b& picture, const cv::Rect& part) {
    const cv::Mat input =
        cv::dnn::blobFromImage(stretched(picture(part), {person_input_px, person_input_px}),
                               1.0 / 255.0, {}, {}, true, false);
    return network_.likelihoods(input, {1, person_input_px, person_input_px, 1})
        .map([](const cv::Mat1f& found) {
            cv::Mat1b mask;
            found.reshape(1, person_input_px).convertTo(mask, CV_8U, 255.0);
            return mask;
        });
}

Result<cv::Mat1f> people_likelihood(const cv::Mat3b& picture, std::span<const cv::Rect2d> people,
                                    PersonNetwork& network) {
    cv::Mat1f likelihood(picture.size(), 0.0F);
    int seen = 0;
    for (const cv::Rect2d& box : people) {
        const cv::Rect part = grown(box, seen_beyond, picture.size());
        const cv::Rect taken = grown(box, taken_beyond, picture.size()) & part;
        if (!is_large(box, picture.size()) || taken.empty()) continue;
        if (++seen > most_people) break;
        const auto mask = network.mask_of(picture, part);
        if (!mask) return tl::unexpected(mask.error());
        cv::Mat1f here;
        mask->convertTo(here, CV_32F, 1.0 / 255.0);
        cv::resize(here, here, part.size(), 0.0, 0.0, cv::INTER_LINEAR);
        cv::Mat whole = likelihood(taken);
        cv::max(whole, cv::Mat(here(taken - part.tl())), whole);
    }
    return likelihood;
}

Result<FaceMap> drawn_face(const cv::Mat3b& picture, const FaceMesh& mesh, PersonNetwork& persons) {
    const cv::Rect part = head_and_shoulders(mesh, picture.size());
    return persons.mask_of(picture, part).map([&](const cv::Mat1b& mask) {
        std::vector<PartLine> lines = face_lines(mesh, shows_eyes(picture, mesh));
        std::ranges::move(person_outline({mask, part}, mesh), std::back_inserter(lines));
        return face_map(box_of(mesh), lines, Area{});
    });
}

}  // namespace touchline
