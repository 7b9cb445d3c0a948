// touchline-figure [X Y]: what networks that lie before a photograph see in it, or at a place of
// it.
#include "app/decode/answer_parts.h"
#include "app/decode/worker_program.h"
#include "app/trace/page_pixels.h"
#include "app/trace/picture_seen.h"
#include "haptics/servo/processors.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/utility.hpp>
#include <sched.h>
#include <sys/resource.h>

namespace {

using namespace touchline;

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
                            return seen_in(input, place);
                        }});
}
