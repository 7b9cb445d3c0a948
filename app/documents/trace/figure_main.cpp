// touchline-figure [X Y]: runs the networks before it on a photograph, for all of it or for the
// thing at a place.
#include "app/documents/decode/page.h"
#include "app/documents/decode/worker_program.h"
#include "app/documents/trace/finding_things.h"
#include "app/documents/trace/page_lines.h"
#include "app/documents/trace/trace_work.h"
#include "app/documents/trace/traced.h"
#include "config/types/result.h"
#include "haptics/servo/real_time.h"
#include "vision/contour/gradient.h"
#include "vision/face/face_network.h"
#include "vision/figure/figure_network.h"
#include "vision/figure/small_figure_network.h"
#include "vision/name/name_network.h"
#include "vision/name/names.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core/utility.hpp>
#include <sched.h>
#include <sys/resource.h>

namespace {

using namespace touchline;

// Measured at several sizes: tests/lab/bench/vision/photographs.md.
constexpr int network_side_px = 768;
constexpr double most_pixels = 1e6;

/// The likelihood that each place of a part of the picture belongs to a thing.
using Likelihood = std::function<Result<cv::Mat1f>(const cv::Rect& part)>;

/// The thing at a place of the picture. Looks in half of it; if that cuts the thing or shows none
/// clearly, in all of it, then in a quarter.
Result<Figures> thing_at(const PlaceInPicture& place, cv::Size picture,
                         const Likelihood& likelihood) {
    const cv::Point at(std::min(picture.width - 1, static_cast<int>(place.x * picture.width)),
                       std::min(picture.height - 1, static_cast<int>(place.y * picture.height)));
    Figures found;
    for (const double share : {0.5, 1.0, 0.25}) {
        const cv::Rect part = part_around(picture, at, share);
        const auto likely = likelihood(part);
        if (!likely) return tl::unexpected(likely.error());
        found = figure_at(*likely, part, picture, at);
        if (found.is_sure) break;
    }
    return found;
}

Result<Figures> figures_by(const Likelihood& likelihood, cv::Size picture,
                           const std::optional<PlaceInPicture>& place) {
    if (place) return thing_at(*place, picture, likelihood);
    return likelihood({{}, picture}).map([picture](const cv::Mat1f& likely) {
        return figures_of(likely, picture);
    });
}

/// The figures of the small network of the figure.
Result<Figures> figures_of_small(const cv::Mat3b& picture, const PictureNetworks& networks,
                                 const std::optional<PlaceInPicture>& place) {
    auto network = SmallFigureNetwork::from_onnx(networks.small_figure);
    if (!network) return tl::unexpected(network.error());
    const Likelihood likelihood = [&](const cv::Rect& part) {
        return network->likelihood(reduced(picture(part), most_pixels));
    };
    return figures_by(likelihood, picture.size(), place);
}

/// The figures of the figure's network, which sees the picture at its own size; without it, those
/// of the small one.
Result<Figures> figures_in(const cv::Mat3b& picture, const PictureNetworks& networks,
                           const std::optional<PlaceInPicture>& place) {
    if (networks.figure.empty()) return figures_of_small(picture, networks, place);
    auto network = FigureNetwork::from_onnx(networks.figure);
    if (!network) return tl::unexpected(network.error());
    const Likelihood likelihood = [&](const cv::Rect& part) {
        return network->likelihood(reduced(picture(part), most_pixels), network_side_px);
    };
    return figures_by(likelihood, picture.size(), place);
}

std::vector<cv::Rect2d> in_pixels(const std::vector<ThingBox>& boxes, cv::Size picture) {
    std::vector<cv::Rect2d> pixels;
    for (const ThingBox& box : boxes) {
        const cv::Point2d from(box.left * picture.width, box.top * picture.height);
        pixels.emplace_back(from,
                            cv::Point2d(box.right * picture.width, box.bottom * picture.height));
    }
    return pixels;
}

ThingBox in_shares(const cv::Rect2d& part, cv::Size picture) {
    return {part.x / picture.width, part.y / picture.height, part.br().x / picture.width,
            part.br().y / picture.height};
}

DrawnFace named_parts(FaceMap face, cv::Size picture) {
    for (std::size_t i = 0; i < face.parts.size(); ++i)
        face.map.outlines[i].label = id_of(face.parts[i]);
    return {in_shares(face.shown, picture), std::move(face.map)};
}

Result<std::vector<DrawnFace>> faces_in(const cv::Mat3b& picture,
                                        const std::vector<cv::Rect2d>& people,
                                        const PictureNetworks& networks, PersonNetwork& persons) {
    auto network = FaceNetwork::from_onnx(networks.faces, networks.meshes);
    if (!network) return tl::unexpected(network.error());
    const auto meshes = network->faces(picture, people);
    if (!meshes) return tl::unexpected(meshes.error());
    std::vector<DrawnFace> faces;
    for (const FaceMesh& mesh : *meshes) {
        auto drawn = drawn_face(picture, mesh, persons);
        if (!drawn) return tl::unexpected(drawn.error());
        DrawnFace face = named_parts(std::move(*drawn), picture.size());
        if (!face.map.outlines.empty() && can_be_shown(face.part)) faces.push_back(std::move(face));
    }
    return faces;
}

/// The same part of a smaller picture, at least one pixel.
cv::Rect scaled(const cv::Rect& part, cv::Size from, cv::Size to) {
    const auto place = [](int at, int size, int smaller) {
        return std::min(static_cast<int>(std::int64_t{at} * smaller / size), smaller - 1);
    };
    const cv::Point corner(place(part.x, from.width, to.width),
                           place(part.y, from.height, to.height));
    const cv::Point last(place(part.br().x - 1, from.width, to.width),
                         place(part.br().y - 1, from.height, to.height));
    return {corner, last + cv::Point(1, 1)};
}

/// The named people as main things. `small` is the picture, reduced; `picture` is its full size.
Result<Figures> people_seen(const cv::Mat3b& small, cv::Size picture,
                            const std::vector<NamedThing>& names,
                            const std::optional<PlaceInPicture>& place, PersonNetwork& persons) {
    std::vector<ThingBox> people;
    for (const NamedThing& thing : names)
        if (thing.name == ThingName::person) people.push_back(thing.box);
    const auto likely = people_likelihood(small, in_pixels(people, small.size()), persons);
    if (!likely) return tl::unexpected(likely.error());
    return figures_by(
        [&](const cv::Rect& part) -> Result<cv::Mat1f> {
            return (*likely)(scaled(part, picture, small.size())).clone();
        },
        picture, place);
}

/// Looks at an 8-bit BGR picture, at all of it or for the thing at a place. Without the figure's
/// network, or if that is not sure, the named people are its main things. Fails with one line if a
/// network cannot be used. Takes some seconds.
Result<MainThings> things_seen(const cv::Mat3b& picture, const PictureNetworks& networks,
                               const std::optional<PlaceInPicture>& place) {
    auto namer = NameNetwork::from_onnx(networks.names);
    if (!namer) return tl::unexpected(namer.error());
    auto persons = PersonNetwork::from_onnx(networks.persons);
    if (!persons) return tl::unexpected(persons.error());
    const cv::Mat3b small = reduced(picture, most_pixels);
    const auto found = namer->detections(small);
    if (!found) return tl::unexpected(found.error());
    const std::vector<NamedThing> names = names_of(*found);
    auto figures = figures_in(picture, networks, place);
    if (figures && !figures->is_sure) {
        auto people = people_seen(small, picture.size(), names, place, *persons);
        if (!people || people->is_sure) figures = std::move(people);
    }
    if (!figures) return tl::unexpected(figures.error());
    MainThings things = main_things_of(*figures);
    things.names = names;
    if (place) return things;
    auto faces = faces_in(small, in_pixels(people_in(*found), small.size()), networks, *persons);
    if (!faces) return tl::unexpected(faces.error());
    things.faces = std::move(*faces);
    return things;
}

constexpr int most_threads = 8;  // each has a stack of its own

Result<cv::Mat3b> picture_of(std::span<const std::byte> page) {
    const auto parts = decode::parts_of(page);
    if (!parts) return tl::unexpected(parts.error());
    if (parts->header.kind != decode::AnswerKind::page)
        return failure("there is no picture to look at");
    return cv::Mat3b(view_of(*parts));
}

Result<std::vector<std::byte>> seen_in(std::span<const std::byte> input,
                                       const std::optional<PlaceInPicture>& place) {
    const ThingsInBytes parts = parted(input, picture_network_count + 1);
    if (parts.empty()) return failure("there is no picture to look at");
    return picture_of(parts.back())
        .and_then([&](const cv::Mat3b& picture) {
            return things_seen(picture, networks_in(parts), place);
        })
        .and_then([](const MainThings& things) { return bytes_of(things); });
}

/// Lets everything else go first, because nobody may feel this long work, and leaves the servo's
/// processor alone if there is another. The system may refuse both; then this is slower, or slows
/// others.
void step_back() {
    constexpr int least_priority = 19;
    (void)setpriority(PRIO_PROCESS, 0, least_priority);
    cpu_set_t allowed;
    if (sched_getaffinity(0, sizeof allowed, &allowed) != 0 || CPU_COUNT(&allowed) < 2) return;
    CPU_CLR(servos_processor(allowed), &allowed);
    (void)sched_setaffinity(0, sizeof allowed, &allowed);
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    const auto place = place_of(words);
    if (!words.empty() && !place) refuse_to_run(argv[0]);
    step_back();
    cv::setNumThreads(std::min(cv::getNumberOfCPUs(), most_threads));
    run_worker_program({WorkerKind::figure, nullptr, [&place](std::span<const std::byte> input) {
                            return seen_in(input, place);
                        }});
}
