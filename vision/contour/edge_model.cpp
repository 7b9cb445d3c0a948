#include "vision/contour/edge_model.h"

#include "vision/contour/onnx_input.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int kMultiple_px = 32;  // of free sizes: networks halve the picture up to five times
constexpr std::int64_t kLargest_px = 4096;

tl::unexpected<Error> unusable(const std::string& why) {
    return failure(std::string(unusable_edge_model) + ", because " + why +
                   "; it must be an ONNX network from 1 x 3 x height x width to 1 x 1 x height x "
                   "width");
}

/// The first line of what OpenCV says, without its file and line number.
std::string reason(const cv::Exception& e) {
    return e.err.substr(0, e.err.find('\n'));
}

/// OpenCV's importer tells its troubles to stderr as well; they come back as exceptions.
class Quiet {
  public:
    Quiet() : before_(cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT)) {}

    ~Quiet() { cv::utils::logging::setLogLevel(before_); }

    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;

  private:
    cv::utils::logging::LogLevel before_;
};

int rounded_up(int pixels) {
    return (pixels + kMultiple_px - 1) / kMultiple_px * kMultiple_px;
}

/// Logits to probabilities, where there are any.
void to_probability(cv::Mat1f& values) {
    double least = 0.0;
    double greatest = 0.0;
    cv::minMaxLoc(values, &least, &greatest);
    if (least < 0.0 || greatest > 1.0) {
        for (float& v : values) {
            v = 1.0F / (1.0F + std::exp(-v));
        }
    }
}

/// The size that the network insists on; 0 where it is free.
Result<cv::Size> size_of(const std::vector<OnnxInput>& inputs) {
    if (inputs.size() != 1) {
        return unusable("it has " + std::to_string(inputs.size()) + " inputs");
    }
    const std::vector<std::int64_t>& shape = inputs[0].shape;
    const auto is_one_of = [&](std::size_t i, std::int64_t wanted) {
        return shape[i] == wanted || shape[i] == 0;
    };
    const auto is_size = [](std::int64_t n) { return n >= 0 && n <= kLargest_px; };
    if (shape.size() != 4 || !is_one_of(0, 1) || !is_one_of(1, 3) || !is_size(shape[2]) ||
        !is_size(shape[3])) {
        return unusable("its input is no picture of three colours");
    }
    return cv::Size(static_cast<int>(shape[3]), static_cast<int>(shape[2]));
}

}  // namespace

struct EdgeModel::Network {
    cv::dnn::Net net;
    cv::Size fixed;  // 0: free

    /// 8-bit BGR of the network's size to its last output, as it is.
    cv::Mat1f run(const cv::Mat& bgr) {
        net.setInput(cv::dnn::blobFromImage(bgr, 1.0 / 255.0, {}, {}, true, false));
        std::vector<cv::Mat> outputs;
        net.forward(outputs, net.getUnconnectedOutLayersNames());
        const cv::Mat& last = outputs.back();
        const bool is_map =
            last.dims == 4 && last.size[0] == 1 && last.size[1] == 1 && last.type() == CV_32F;
        return is_map ? cv::Mat1f(last.size[2], last.size[3], const_cast<float*>(last.ptr<float>()))
                            .clone()
                      : cv::Mat1f();
    }

    Result<cv::Mat1f> boundaries(const cv::Mat& bgr) {
        cv::Mat fitted;
        const cv::Size size(fixed.width > 0 ? fixed.width : rounded_up(bgr.cols),
                            fixed.height > 0 ? fixed.height : rounded_up(bgr.rows));
        if (fixed.width > 0 || fixed.height > 0) {
            cv::resize(bgr, fitted, size, 0.0, 0.0, cv::INTER_AREA);
        } else {
            cv::copyMakeBorder(bgr, fitted, 0, size.height - bgr.rows, 0, size.width - bgr.cols,
                               cv::BORDER_REPLICATE);
        }
        cv::Mat1f values = run(fitted);
        if (values.empty()) {
            return unusable("its output is no map of one value a pixel");
        }
        if (!cv::checkRange(values)) {
            return unusable("its output is not finite");
        }
        to_probability(values);
        const bool is_padded = fixed.width == 0 && fixed.height == 0;
        cv::resize(values, values, is_padded ? size : bgr.size());
        return is_padded ? cv::Mat1f(values(cv::Rect({}, bgr.size())).clone()) : values;
    }
};

EdgeModel::EdgeModel(std::unique_ptr<Network> network) : network_(std::move(network)) {}

EdgeModel::EdgeModel(EdgeModel&&) noexcept = default;
EdgeModel& EdgeModel::operator=(EdgeModel&&) noexcept = default;
EdgeModel::~EdgeModel() = default;

Result<EdgeModel> EdgeModel::from_onnx(std::span<const std::byte> model) {
    const Result<std::vector<OnnxInput>> inputs = onnx_inputs(model);
    if (!inputs) {
        return unusable(inputs.error().line);
    }
    const Result<cv::Size> size = size_of(*inputs);
    if (!size) {
        return tl::unexpected(size.error());
    }
    auto network = std::make_unique<Network>();
    network->fixed = *size;
    const Quiet quiet;
    try {
        network->net =
            cv::dnn::readNetFromONNX(reinterpret_cast<const char*>(model.data()), model.size());
    } catch (const cv::Exception& e) {
        return unusable("OpenCV cannot build it (" + reason(e) + ")");
    }
    EdgeModel built(std::move(network));
    return built.boundaries(cv::Mat3b(2 * kMultiple_px, 2 * kMultiple_px, cv::Vec3b()))
        .map([&](const cv::Mat1f&) { return std::move(built); });
}

Result<cv::Mat1f> EdgeModel::boundaries(const cv::Mat& picture) {
    const Quiet quiet;
    try {
        cv::Mat bgr = picture;
        if (picture.channels() == 1) {
            cv::cvtColor(picture, bgr, cv::COLOR_GRAY2BGR);
        }
        return network_->boundaries(bgr);
    } catch (const cv::Exception& e) {
        return unusable("it cannot be run (" + reason(e) + ")");
    }
}

}  // namespace touchline
