// arm64_hashes PHOTO: what the same lines, hands and pictures become here, as hashes of every bit,
// a row each. Another build computes the same if it prints the same. PHOTO holds the pixels of the
// photo; who comes first writes it, because OpenCV makes its clouds a little different on every
// kind of processor. Threads: one.
#include "haptics/collision/scene.h"
#include "haptics/contact/contact_machine.h"
#include "haptics/servo/recording.h"
#include "tests/haptics/contact/traces/trace.h"
#include "tests/lab/bench/instructions/pictures.h"
#include "vision/simplify/trace.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include <fmt/core.h>
#include <opencv2/core.hpp>

namespace touchline {
namespace {

/// Numbers as they lie in memory, one behind the other.
class Bits {
  public:
    template <class T>
    void add(T value) {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
        add(std::as_bytes(std::span(&value, 1)));
    }

    void add(Position p) {
        add(p.x);
        add(p.y);
    }

    void add(std::span<const std::byte> bytes) {
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }

    void print(const std::string& what) const {
        fmt::print("{:016x} {}\n", checksum_of(bytes_), what);
    }

  private:
    std::vector<std::byte> bytes_;
};

/// Every point of every level.
Bits curve_bits(const CurveSet& curves) {
    Bits bits;
    for (int piece = 0; piece < curves.piece_count(); ++piece) {
        for (int level = 0; level <= curves.piece(piece).coarsest; ++level) {
            for (const Position p : curves.points(piece, level)) bits.add(p);
        }
    }
    return bits;
}

/// Every box of every level.
Bits tree_bits(const Scene& scene) {
    Bits bits;
    for (int piece = 0; piece < scene.curves.piece_count(); ++piece) {
        for (int level = 0; level <= scene.curves.piece(piece).coarsest; ++level) {
            for (int j = 0; j < scene.curves.segment_count(piece, level); ++j) {
                for (const Position p : scene.tree.box(scene.curves, piece, level, j).corners) {
                    bits.add(p);
                }
            }
        }
    }
    return bits;
}

void add(Bits& bits, const ContactReport& report) {
    bits.add(report.force.x);
    bits.add(report.force.y);
    bits.add(report.stored_J);
    bits.add(report.p_WP);
    bits.add(report.state);
    bits.add(report.level);
    bits.add(report.piece);
    bits.add(report.parameter);
    bits.add(report.side);
    bits.add(report.carried_m);
    bits.add(report.boxes);
    bits.add(report.clear);
}

/// What the machine answers to the trace's hand, tick by tick.
Bits contact_bits(const Scene& scene, const traces::Trace& trace) {
    Bits bits;
    ContactMachine machine;
    ContactSettings settings = trace.settings;
    Budget budget;
    if (trace.boxes > 0) budget.boxes = trace.boxes;
    for (const traces::Row& row : traces::read_rows(trace.name)) {
        const auto given = [&row](traces::Column column) {
            return static_cast<double>(row[column]) / traces::columns[column].per_unit;
        };
        const Position handle{given(traces::handle_x), given(traces::handle_y)};
        settings.mode = static_cast<Mode>(row[traces::mode]);
        if (row[traces::starts] != 0) machine.reset(scene, handle, given(traces::level));
        add(bits, machine.step(handle, given(traces::level), settings, budget));
    }
    return bits;
}

void print_haptics() {
    std::set<std::string> done;  // lines
    for (const traces::Trace& trace : traces::read_traces()) {
        const Scene scene = traces::scene_of(traces::read_lines(trace.lines), trace);
        if (done.insert(trace.lines).second) {
            curve_bits(scene.curves).print("curve " + trace.lines);
            tree_bits(scene).print("tree " + trace.lines);
        }
        contact_bits(scene, trace).print("contact " + trace.name);
    }
}

cv::Mat photo_in(const std::string& path) {
    cv::Mat photo = bench::photo();
    const std::span pixels(reinterpret_cast<char*>(photo.data), photo.total() * photo.elemSize());
    std::fstream file;
    file.exceptions(std::ios::failbit | std::ios::badbit);
    if (std::filesystem::exists(path)) {
        file.open(path, std::ios::in | std::ios::binary);
        file.read(pixels.data(), std::ssize(pixels));
    } else {
        file.open(path, std::ios::out | std::ios::binary);
        file.write(pixels.data(), std::ssize(pixels));
    }
    return photo;
}

void print_picture(const std::string& name, const cv::Mat& picture) {
    Bits pixels;
    pixels.add(std::as_bytes(std::span(picture.data, picture.total() * picture.elemSize())));
    pixels.print("picture " + name);
    for (const int detail : {1, 3, 5}) {
        const Result<Trace> traced = trace_outlines(picture, {.area = {}, .detail = detail});
        fmt::print("{:016x} map {} {}\n", hash_of(traced.value().map), name, detail);
    }
}

}  // namespace
}  // namespace touchline

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: arm64_hashes PHOTO\n");
        return 2;
    }
    cv::setNumThreads(1);
    touchline::print_haptics();
    touchline::print_picture("drawing", touchline::bench::drawing());
    touchline::print_picture("photo", touchline::photo_in(argv[1]));
}
