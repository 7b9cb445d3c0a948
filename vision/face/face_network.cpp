#include "vision/face/face_network.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr std::size_t most_boxes = 16;
constexpr double least_likelihood = 0.5;
constexpr double shared = 0.3;  // of a box: then it is the same face again
constexpr double least_box_px = 4.0;

cv::Point2d anchor(int row) {
    struct Level {
        int first, stride_px, at_each_place;
    };

    const Level level = row < 512 ? Level{0, 16, 2} : Level{512, 32, 6};
    const int place = (row - level.first) / level.at_each_place;
    const int across = face_input_px / level.stride_px;
    return {(place % across + 0.5) * level.stride_px, (place / across + 0.5) * level.stride_px};
}

bool is_box_of_the_input(const FaceBox& found) {
    const cv::Rect2d& box = found.box;
    const cv::Point2d centre = centre_of(box);
    const cv::Rect2d input(0.0, 0.0, face_input_px, face_input_px);
    const double reach_px = 1.5 * std::max(box.width, box.height);
    return box.width >= least_box_px && box.height >= least_box_px &&
           std::max(box.width, box.height) <= 1.5 * face_input_px && input.contains(centre) &&
           cv::norm(found.left_eye - centre) <= reach_px &&
           cv::norm(found.right_eye - centre) <= reach_px && found.left_eye != found.right_eye;
}

FaceBox box_at(const cv::Mat1f& places, int row) {
    const cv::Point2d from = anchor(row);
    const auto point = [&](int k) {
        return from + cv::Point2d(static_cast<double>(places(row, k)),
                                  static_cast<double>(places(row, k + 1)));
    };
    const cv::Point2d size = point(2) - from;
    const cv::Point2d corner = point(0) - 0.5 * size;
    return {{corner.x, corner.y, size.x, size.y}, point(4), point(6), 0.0};
}

bool is_apart(const FaceBox& box, const std::vector<FaceBox>& others) {
    return std::ranges::none_of(others, [&](const FaceBox& other) {
        return (box.box & other.box).area() >= shared * box.box.area();
    });
}

constexpr int mesh_input_px = 192;  // side of its input
// The side of what the mesh's network sees, in sides of the face.
constexpr double window_over_face = 1.5;
constexpr double least_sure = 0.9;  // measured: tests/lab/bench/vision/faces_and_names.md
constexpr std::size_t most_persons = 8;
constexpr std::size_t most_faces = 8;

/// An upright square in which a face lies as if it were upright itself.
struct Window {
    cv::Point2d centre;  // pixels of the picture
    double side_px = 0.0;
    double tilt_rad = 0.0;
};

/// Returns where the network of the mesh looks, from a box and the eyes in it.
Window window_of(const FaceBox& found) {
    const cv::Point2d across = found.right_eye - found.left_eye;
    const cv::Rect2d& box = found.box;
    return {centre_of(box), window_over_face * std::max(box.width, box.height),
            std::atan2(across.y, across.x)};
}

/// The same from a mesh that lies roughly right.
Window window_of(const FaceMesh& mesh) {
    const double tilt_rad = tilt_of(mesh);
    const double c = std::cos(tilt_rad);
    const double s = std::sin(tilt_rad);
    FaceMesh upright = mesh;
    for (cv::Point2d& p : upright) p = {c * p.x + s * p.y, c * p.y - s * p.x};
    const cv::Rect2d box = box_of(upright);
    const cv::Point2d centre = centre_of(box);
    return {{c * centre.x - s * centre.y, s * centre.x + c * centre.y},
            window_over_face * std::max(box.width, box.height),
            tilt_rad};
}

/// Maps pixels of the window's square to pixels of the picture.
cv::Matx23d from_window(const Window& window) {
    const double scale = window.side_px / mesh_input_px;
    const double c = scale * std::cos(window.tilt_rad);
    const double s = scale * std::sin(window.tilt_rad);
    const double half = 0.5 * mesh_input_px;
    return {c, -s, window.centre.x - c * half + s * half,
            s, c,  window.centre.y - s * half - c * half};
}

/// Returns what lies in the window; beyond the picture, its rim continues. A picture much finer
/// than the window's square is first reduced by averaging. Empty if the window lies beside the
/// picture.
cv::Mat3b seen_in(const cv::Mat3b& picture, const Window& window) {
    constexpr double reach_over_side = 0.75;  // of the side: half of the diagonal, and a little
    const cv::Point2d reach(reach_over_side * window.side_px, reach_over_side * window.side_px);
    const cv::Rect part =
        part_within({window.centre - reach, window.centre + reach}, picture.size());
    if (part.empty()) return {};
    const double scale = std::min(1.0, 2.0 * mesh_input_px / window.side_px);
    cv::Mat3b reduced = picture(part);
    const cv::Size size(std::max(1, cvRound(scale * part.width)),
                        std::max(1, cvRound(scale * part.height)));
    if (scale < 1.0) cv::resize(picture(part), reduced, size, 0.0, 0.0, cv::INTER_AREA);
    cv::Matx23d way = from_window(window);
    for (int k = 0; k < 3; ++k) {
        way(0, k) = (way(0, k) - (k == 2 ? part.x : 0)) * reduced.cols / part.width;
        way(1, k) = (way(1, k) - (k == 2 ? part.y : 0)) * reduced.rows / part.height;
    }
    cv::Mat3b seen;
    cv::warpAffine(reduced, seen, way, {mesh_input_px, mesh_input_px},
                   cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_REPLICATE);
    return seen;
}

/// Returns the mesh in the picture; nothing if its points lie nowhere near the window, or all in
/// one place.
std::optional<FaceMesh> mesh_of(const cv::Mat1f& answer, const Window& window) {
    constexpr double least_mesh = 0.1;  // of the window's side
    const cv::Matx23d way = from_window(window);
    FaceMesh mesh;
    for (std::size_t i = 0; i < mesh.size(); ++i) {
        const auto k = static_cast<int>(3 * i);  // the third is a depth
        const double x = static_cast<double>(answer(0, k));
        const double y = static_cast<double>(answer(0, k + 1));
        if (!(std::max(std::abs(x), std::abs(y)) <= 2.0 * mesh_input_px)) return std::nullopt;
        mesh[i] = way * cv::Vec3d(x, y, 1.0);
    }
    const cv::Rect2d box = box_of(mesh);
    if (!(std::min(box.width, box.height) >= least_mesh * window.side_px)) return std::nullopt;
    return mesh;
}

/// Returns whether a face is the head of one of the persons, and wide enough.
bool counts(const FaceMesh& mesh, std::span<const cv::Rect2d> persons) {
    constexpr double widest = 1.2;  // in widths of the person: boxes of heads are tight
    const cv::Rect2d face = box_of(mesh);
    if (!(face.width >= least_face_px)) return false;
    return std::ranges::any_of(persons, [&](const cv::Rect2d& person) {
        return person.contains(centre_of(face)) && face.width <= widest * person.width;
    });
}

/// Returns the first boxes, as far as they lie in the picture; those outside it are left out.
std::vector<cv::Rect2d> boxes_within(std::span<const cv::Rect2d> boxes, cv::Size picture) {
    std::vector<cv::Rect2d> within;
    for (const cv::Rect2d& box : boxes.first(std::min(boxes.size(), most_persons))) {
        const cv::Rect2d part = box_within(box, picture);
        if (!part.empty()) within.push_back(part);
    }
    return within;
}

/// Returns the upper end of a person, where the head is.
cv::Rect head_part(const cv::Rect2d& person, cv::Size picture) {
    constexpr double least_part_px = 40.0;
    constexpr double side = 0.9;       // of the person's width
    constexpr double above_box = 0.1;  // of the side: hair above the box
    const double side_px = std::max(least_part_px, side * person.width);
    return part_within({person.x + 0.5 * (person.width - side_px), person.y - above_box * side_px,
                        side_px, side_px},
                       picture);
}

void add_unless_there(const FaceMesh& mesh, std::vector<FaceMesh>& faces) {
    constexpr double same_face = 0.4;  // of the smaller box, if both are the same face
    const cv::Rect2d box = box_of(mesh);
    const bool is_there = std::ranges::any_of(faces, [&](const FaceMesh& other) {
        return (box & box_of(other)).area() >=
               same_face * std::min(box.area(), box_of(other).area());
    });
    if (!is_there) faces.push_back(mesh);
}

}  // namespace

void add_apart(const std::vector<FaceBox>& more, std::vector<FaceBox>& boxes) {
    for (const FaceBox& box : more) {
        if (is_apart(box, boxes)) boxes.push_back(box);
    }
}

std::vector<FaceBox> face_boxes(const cv::Mat1f& scores, const cv::Mat1f& places) {
    std::vector<FaceBox> all;
    for (int row = 0; row < scores.rows; ++row) {
        const double likelihood = 1.0 / (1.0 + std::exp(-static_cast<double>(scores(row, 0))));
        if (!(likelihood >= least_likelihood)) continue;
        FaceBox box = box_at(places, row);
        box.likelihood = likelihood;
        if (is_box_of_the_input(box)) all.push_back(box);
    }
    std::ranges::stable_sort(all, std::ranges::greater{}, &FaceBox::likelihood);
    std::vector<FaceBox> kept;
    add_apart(all, kept);
    if (kept.size() > most_boxes) kept.resize(most_boxes);
    return kept;
}

Result<FaceNetwork> FaceNetwork::from_onnx(std::span<const std::byte> finder,
                                           std::span<const std::byte> mesh) {
    auto finds = TrainedNetwork::from_onnx(finder, "finds faces");
    if (!finds) return tl::unexpected(finds.error());
    auto lays = TrainedNetwork::from_onnx(mesh, "finds the parts of a face");
    if (!lays) return tl::unexpected(lays.error());
    return FaceNetwork(std::move(*finds), std::move(*lays));
}

/// The part lies in the upper left of the input, as large as fits; the rest is black.
Result<std::vector<FaceBox>> FaceNetwork::boxes_in(const cv::Mat3b& picture, cv::Rect part) {
    const double scale = static_cast<double>(face_input_px) / std::max(part.width, part.height);
    const cv::Size size(std::clamp(cvRound(scale * part.width), 1, face_input_px),
                        std::clamp(cvRound(scale * part.height), 1, face_input_px));
    cv::Mat3b square(face_input_px, face_input_px, cv::Vec3b(0, 0, 0));
    stretched(picture(part), size).copyTo(square(cv::Rect({}, size)));
    const cv::Mat input =
        cv::dnn::blobFromImage(square, 1.0 / 127.5, {}, cv::Scalar::all(127.5), true, false);
    const std::array<std::vector<int>, 4> shapes{
        {{1, 512, 1}, {1, 384, 1}, {1, 512, 16}, {1, 384, 16}}};
    const auto found = finder_.outputs(input, shapes);
    if (!found) return tl::unexpected(found.error());
    cv::Mat1f scores;
    cv::Mat1f places;
    cv::vconcat((*found)[0], (*found)[1], scores);
    cv::vconcat((*found)[2], (*found)[3], places);
    std::vector<FaceBox> boxes = face_boxes(scores, places);
    const auto in_picture = [&](cv::Point2d p) {
        return cv::Point2d(part.tl()) + p * (1.0 / scale);
    };
    for (FaceBox& box : boxes) {
        box = {{in_picture(box.box.tl()), in_picture(box.box.br())},
               in_picture(box.left_eye),
               in_picture(box.right_eye),
               box.likelihood};
    }
    return boxes;
}

/// Lays the mesh twice: the second time where the first one lies.
Result<std::optional<FaceNetwork::Laid>> FaceNetwork::laid_on(const cv::Mat3b& picture,
                                                              const FaceBox& box) {
    const std::array<std::vector<int>, 2> shapes{{{1, 1404}, {1, 1}}};
    Window window = window_of(box);
    std::optional<Laid> laid;
    for (int pass = 0; pass < 2; ++pass) {
        const cv::Mat3b seen = seen_in(picture, window);
        if (seen.empty()) return std::optional<Laid>();
        const auto answer =
            mesh_.outputs(cv::dnn::blobFromImage(seen, 1.0 / 255.0, {}, {}, true, false), shapes);
        if (!answer) return tl::unexpected(answer.error());
        const auto mesh = mesh_of((*answer)[0], window);
        if (!mesh) return std::optional<Laid>();
        laid = Laid{*mesh, static_cast<double>((*answer)[1](0, 0))};
        window = window_of(*mesh);
    }
    return laid;
}

Result<std::vector<FaceMesh>> FaceNetwork::faces(const cv::Mat3b& picture,
                                                 std::span<const cv::Rect2d> persons) {
    const std::vector<cv::Rect2d> within = boxes_within(persons, picture.size());
    std::vector<FaceMesh> faces;
    if (within.empty()) return faces;
    std::vector<cv::Rect> parts{cv::Rect({}, picture.size())};
    for (const cv::Rect2d& person : within) parts.push_back(head_part(person, picture.size()));
    std::vector<FaceBox> boxes;
    for (const cv::Rect& part : parts) {
        if (part.empty()) continue;
        const auto more = boxes_in(picture, part);
        if (!more) return tl::unexpected(more.error());
        add_apart(*more, boxes);
    }
    for (const FaceBox& box : boxes) {
        const auto laid = laid_on(picture, box);
        if (!laid) return tl::unexpected(laid.error());
        if (*laid && (*laid)->sure > least_sure && counts((*laid)->mesh, within))
            add_unless_there((*laid)->mesh, faces);
    }
    std::ranges::stable_sort(faces, std::ranges::greater{},
                             [](const FaceMesh& mesh) { return box_of(mesh).width; });
    if (faces.size() > most_faces) faces.resize(most_faces);
    return faces;
}

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
