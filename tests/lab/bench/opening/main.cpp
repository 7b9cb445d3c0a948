// Stages from the bytes of a file to what is felt, the least and the median of some runs:
//
//   opening_bench RUNS FILE...
#include "app/documents/decode/files.h"
#include "app/documents/decode/opening.h"
#include "app/documents/trace/tracing.h"
#include "app/force/servo/scene_order.h"
#include "config/types/steady_clock.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include <fmt/chrono.h>
#include <sys/mman.h>

namespace touchline {
namespace {

class Stage {
  public:
    template <class Work>
    auto time(const Work& work) {
        const auto start_ns = steady_now_ns();
        auto result = work();
        times_ms_.push_back(1e-6 * static_cast<double>(steady_now_ns() - start_ns));
        return result;
    }

    std::string words() {
        if (times_ms_.empty()) return "-";
        std::sort(times_ms_.begin(), times_ms_.end());
        return fmt::format("{:.1f} ({:.1f})", times_ms_.front(), times_ms_[times_ms_.size() / 2]);
    }

  private:
    std::vector<double> times_ms_;
};

/// Returns what a worker takes that finds nothing to do.
std::string start_of(int runs) {
    Stage start;
    const std::vector<std::byte> nothing(1);
    for (int i = 0; i < runs; ++i) (void)start.time([&] { return open_page(nothing); });
    return start.words();
}

/// Returns what the kernel takes to give a process a page that it has not touched before. All pages
/// of a worker are fresh, so its times follow this figure, which differs much from machine to
/// machine.
double fresh_page_us() {
    constexpr std::size_t pages = 4096;
    constexpr std::size_t page_bytes = 4096;
    void* fresh = mmap(nullptr, pages * page_bytes, PROT_READ | PROT_WRITE,
                       MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (fresh == MAP_FAILED) return 0.0;
    (void)madvise(fresh, pages * page_bytes, MADV_NOHUGEPAGE);
    auto* bytes = static_cast<volatile std::uint8_t*>(fresh);
    const auto start_ns = steady_now_ns();
    for (std::size_t i = 0; i < pages; ++i) bytes[i * page_bytes] = 1;
    const auto took_ns = steady_now_ns() - start_ns;
    (void)munmap(fresh, pages * page_bytes);
    return 1e-3 * static_cast<double>(took_ns) / static_cast<double>(pages);
}

/// Finds lines without a worker: the difference is what a worker costs.
Result<Trace> traced_here(const Picture& picture) {
    const cv::Mat bgr(picture.height, picture.width, CV_8UC3,
                      const_cast<std::uint8_t*>(picture.bgr.data()));
    return trace_outlines(bgr, {});
}

bool measure(const std::string& path, int runs) {
    const auto bytes = read_file(path);
    if (!bytes) return false;
    Stage open;
    Stage trace;
    Stage here;
    Stage scene;
    Stage read;
    std::size_t labels = 0;
    int width = 0;
    int height = 0;
    for (int i = 0; i < runs; ++i) {
        const auto page = open.time([&] { return open_page(*bytes); });
        if (!page) return false;
        width = page->picture.width;
        height = page->picture.height;
        if (needs_reading(*page)) {
            const auto found = read.time([&] { return read_words(page->picture); });
            if (found) labels = found->labels.size();
        }
        const auto traced = trace.time([&] { return trace_page(*page, {}); });
        if (!traced) continue;
        (void)here.time([&] { return traced_here(page->picture); });
        (void)scene.time([&] { return build_scene(traced->map, felt_order(default_profile())); });
    }
    fmt::print("| {} | {} x {} | {} | {} | {} | {} | {} | {} |\n", path.substr(path.rfind('/') + 1),
               width, height, open.words(), trace.words(), here.words(), scene.words(),
               read.words(), labels);
    return true;
}

}  // namespace
}  // namespace touchline

int main(int argc, char** argv) {
    if (argc < 3) return 2;
    const int runs = std::atoi(argv[1]);
    double load = 0.0;
    (void)getloadavg(&load, 1);
    const std::string start = touchline::start_of(10 * runs);
    fmt::print(
        "Least of {} runs (median), load {:.2f}, a fresh page of memory {:.2f} us, {:%F}:\n\n",
        runs, load, touchline::fresh_page_us(), fmt::localtime(std::time(nullptr)));
    fmt::print(
        "| file | pixels | opened, ms | traced, ms | without a worker, ms | scene, ms | read, ms | "
        "labels |\n|---|---|---|---|---|---|---|---|\n");
    bool is_done = true;
    for (int i = 2; i < argc; ++i) is_done = touchline::measure(argv[i], runs) && is_done;
    fmt::print("\nA worker's start, to a refusal: {} ms.\n", start);
    return is_done ? 0 : 1;
}
