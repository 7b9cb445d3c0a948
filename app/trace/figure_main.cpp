// touchline-figure [X Y]: the main things of a photograph, or the thing at a place of it, by a
// network that lies before the picture.
#include "app/decode/answer_parts.h"
#include "app/decode/worker_program.h"
#include "app/trace/main_things.h"
#include "app/trace/page_pixels.h"
#include "app/trace/place_in_picture.h"
#include "app/trace/two_parts.h"
#include "haptics/servo/processors.h"
#include "vision/contour/gradient.h"
#include "vision/figure/figure_network.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/utility.hpp>
#include <sched.h>
#include <sys/resource.h>

namespace {

using namespace touchline;

// Measured at several sizes: tests/bench/vision/photographs.md.
constexpr int network_side_px = 768;
constexpr double most_pixels = 1e6;
constexpr int most_threads = 8;  // each has a stack of its own

Result<cv::Mat3b> picture_of(std::span<const std::byte> page) {
    const auto parts = decode::parts_of(page);
    if (!parts) return tl::unexpected(parts.error());
    if (parts->header.kind != AnswerKind::page) return failure("there is no picture to look at");
    return cv::Mat3b(view_of(*parts));
}

/// The thing at a place of the picture: in half of it; where that cuts it or shows none clearly, in
/// all of it, and in a quarter.
Result<Figures> thing_at(const PlaceInPicture& place, const cv::Mat3b& picture,
                         FigureNetwork& network) {
    const cv::Point at(std::min(picture.cols - 1, static_cast<int>(place.x * picture.cols)),
                       std::min(picture.rows - 1, static_cast<int>(place.y * picture.rows)));
    Figures found;
    for (const double share : {0.5, 1.0, 0.25}) {
        const cv::Rect part = part_around(picture.size(), at, share);
        const auto likelihood =
            network.likelihood(reduced(picture(part), most_pixels), network_side_px);
        if (!likelihood) return tl::unexpected(likelihood.error());
        found = figure_at(*likelihood, part, picture.size(), at);
        if (found.is_sure) break;
    }
    return found;
}

Result<Figures> things_in(const cv::Mat3b& picture, FigureNetwork& network) {
    return network.likelihood(reduced(picture, most_pixels), network_side_px)
        .map([&](const cv::Mat1f& likelihood) { return figures_of(likelihood, picture.size()); });
}

Result<std::vector<std::byte>> main_things(std::span<const std::byte> input,
                                           const std::optional<PlaceInPicture>& place) {
    const TwoParts parts = two_parts_of(input);
    const auto picture = picture_of(parts.second);
    if (!picture) return tl::unexpected(picture.error());
    auto network = FigureNetwork::from_onnx(parts.first);
    if (!network) return tl::unexpected(network.error());
    const auto figures =
        place ? thing_at(*place, *picture, *network) : things_in(*picture, *network);
    return figures.map([](const Figures& found) { return bytes_of(main_things_of(found)); });
}

/// Long work that nobody may feel: everything else comes first, and the servo's processor is left
/// alone where there is another. Both may be refused; then it is slower, or in somebody's way.
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
                            return main_things(input, place);
                        }});
}
