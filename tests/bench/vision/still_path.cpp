// From a 12-megapixel JPEG still to a map, stage by stage:
//   still_path [--runs N] [PICTURE.jpg ...]
// Prints a table: milliseconds of one core's time (a busy machine does not add to them), least and
// median of the runs. Without a picture one is generated:
// shapes in front of a rough background, 4000 x 3000, quality 90, as a USB camera sends it.
#include "vision/contour/gradient.h"
#include "vision/contour/main_shape.h"
#include "vision/contour/photo_lines.h"
#include "vision/prepare/picture_class.h"
#include "vision/simplify/trace.h"

#include <algorithm>
#include <cstdio>  // jpeglib.h needs FILE
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <jpeglib.h>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

using Bytes = std::vector<unsigned char>;

cv::Mat3b generated() {
    cv::RNG random(3);
    cv::Mat3b coarse(60, 80);
    random.fill(coarse, cv::RNG::NORMAL, 150.0, 25.0);
    cv::Mat3b picture;
    cv::resize(coarse, picture, {4000, 3000}, 0.0, 0.0, cv::INTER_CUBIC);
    for (int i = 0; i < 25; ++i) {
        const cv::Point centre(random.uniform(300, 3700), random.uniform(300, 2700));
        const cv::Size size(random.uniform(80, 900), random.uniform(80, 700));
        cv::ellipse(
            picture, centre, size, random.uniform(0.0, 180.0), 0.0, 360.0,
            cv::Scalar(random.uniform(0, 256), random.uniform(0, 256), random.uniform(0, 256)),
            cv::FILLED, cv::LINE_AA);
    }
    cv::GaussianBlur(picture, picture, {}, 2.0);
    cv::Mat3s noise(picture.size());
    random.fill(noise, cv::RNG::NORMAL, 0.0, 6.0);
    cv::add(picture, noise, picture, cv::noArray(), CV_8U);
    return picture;
}

Bytes encoded(cv::Mat3b picture) {
    jpeg_compress_struct encoder{};
    jpeg_error_mgr errors{};
    encoder.err = jpeg_std_error(&errors);
    jpeg_create_compress(&encoder);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&encoder, &bytes, &size);
    encoder.image_width = static_cast<unsigned>(picture.cols);
    encoder.image_height = static_cast<unsigned>(picture.rows);
    encoder.input_components = 3;
    encoder.in_color_space = JCS_EXT_BGR;
    jpeg_set_defaults(&encoder);
    jpeg_set_quality(&encoder, 90, TRUE);
    jpeg_start_compress(&encoder, TRUE);
    while (encoder.next_scanline < encoder.image_height) {
        unsigned char* row = picture.ptr(static_cast<int>(encoder.next_scanline));
        jpeg_write_scanlines(&encoder, &row, 1);
    }
    jpeg_finish_compress(&encoder);
    Bytes result(bytes, bytes + size);
    jpeg_destroy_compress(&encoder);
    std::free(bytes);  // NOLINT(cppcoreguidelines-no-malloc): libjpeg's
    return result;
}

/// Decoded at the least eighths of its size that keep a megapixel.
cv::Mat3b decoded(const Bytes& bytes) {
    jpeg_decompress_struct decoder{};
    jpeg_error_mgr errors{};
    decoder.err = jpeg_std_error(&errors);
    jpeg_create_decompress(&decoder);
    jpeg_mem_src(&decoder, bytes.data(), bytes.size());
    jpeg_read_header(&decoder, TRUE);
    decoder.out_color_space = JCS_EXT_BGR;
    decoder.scale_denom = 8;
    decoder.scale_num = 1;
    while (decoder.scale_num < 8 && 1.0 * decoder.image_width * decoder.image_height *
                                            decoder.scale_num * decoder.scale_num <
                                        64e6) {
        ++decoder.scale_num;
    }
    decoder.dct_method = JDCT_ISLOW;
    jpeg_start_decompress(&decoder);
    cv::Mat3b picture(static_cast<int>(decoder.output_height),
                      static_cast<int>(decoder.output_width));
    while (decoder.output_scanline < decoder.output_height) {
        unsigned char* row = picture.ptr(static_cast<int>(decoder.output_scanline));
        jpeg_read_scanlines(&decoder, &row, 1);
    }
    jpeg_finish_decompress(&decoder);
    jpeg_destroy_decompress(&decoder);
    return picture;
}

/// Milliseconds of each stage of each run.
class Clock {
  public:
    template <class Stage>
    auto time(const std::string& name, const Stage& stage) {
        const std::clock_t start = std::clock();
        auto result = stage();
        const double passed_ms =
            1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        if (times_.find(name) == times_.end()) {
            order_.push_back(name);
        }
        times_[name].push_back(passed_ms);
        return result;
    }

    void print(const std::string& title) {
        fmt::print("| {} | least ms | median ms |\n|---|---|---|\n", title);
        for (const std::string& name : order_) {
            std::vector<double>& runs = times_[name];
            std::ranges::sort(runs);
            fmt::print("| {} | {:.1f} | {:.1f} |\n", name, runs.front(), runs[runs.size() / 2]);
        }
        fmt::print("\n");
    }

  private:
    std::vector<std::string> order_;
    std::map<std::string, std::vector<double>> times_;
};

void measure(const std::string& title, const Bytes& still, int runs) {
    Clock clock;
    for (int run = 0; run < runs; ++run) {
        const cv::Mat3b large = clock.time("JPEG, decoded reduced", [&] { return decoded(still); });
        const cv::Mat small = clock.time("to a megapixel", [&] { return reduced(large, 1e6); });
        clock.time("class", [&] { return class_of(small); });
        clock.time("a photo's lines", [&] { return photo_lines(small, 112.0); });
        clock.time("a photo's main shape", [&] { return main_shape(small, std::nullopt); });
        const Result<Found> found = find_lines(small, {});
        if (!found) {
            fmt::print("{}: {}\n", title, found.error().line);
            return;
        }
        for (int detail = 1; detail <= 5; ++detail) {
            clock.time(fmt::format("simplified, detail {}", detail),
                       [&] { return trace_lines(*found, {.area = {}, .detail = detail}); });
        }
        clock.time("all, JPEG to map, detail 3",
                   [&] { return trace_outlines(decoded(still), {}); });
    }
    clock.print(title);
}

int run(const std::vector<std::string>& arguments) {
    int runs = 9;
    std::vector<std::string> files;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (arguments[i] == "--runs" && i + 1 < arguments.size()) {
            runs = std::max(1, std::atoi(arguments[++i].c_str()));
        } else {
            files.push_back(arguments[i]);
        }
    }
    cv::setNumThreads(1);
    for (const std::string& file : files) {
        std::ifstream in(file, std::ios::binary);
        measure(file, Bytes(std::istreambuf_iterator<char>(in), {}), runs);
    }
    if (files.empty()) {
        measure("generated, 4000 x 3000", encoded(generated()), runs);
    }
    return 0;
}

}  // namespace
}  // namespace touchline

int main(int count, char** values) {
    return touchline::run({values + 1, values + count});
}
