#include "vision/network/trained_network.h"

#include "config/types/pinned.h"

#include <algorithm>
#include <new>
#include <utility>

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

/// Returns the first line of OpenCV's message, without its file and line number.
std::string reason(const cv::Exception& e) {
    return e.err.substr(0, e.err.find('\n'));
}

/// Lack of memory is not the network's fault.
void no_lack_of_memory(const cv::Exception& e) {
    if (e.code == cv::Error::StsNoMem) throw std::bad_alloc();
}

/// OpenCV's importer also reports its errors to stderr; they come back as exceptions.
class Quiet : Pinned {
  public:
    Quiet() : before_(cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT)) {}

    ~Quiet() { cv::utils::logging::setLogLevel(before_); }

  private:
    cv::utils::logging::LogLevel before_;
};

bool has_shape(const cv::Mat& output, const std::vector<int>& shape) {
    return output.type() == CV_32F &&
           std::equal(shape.begin(), shape.end(), output.size.p, output.size.p + output.dims);
}

}  // namespace

struct TrainedNetwork::Run {
    std::string job;
    cv::dnn::Net net;
};

TrainedNetwork::TrainedNetwork(std::unique_ptr<Run> run) : run_(std::move(run)) {}

TrainedNetwork::TrainedNetwork(TrainedNetwork&&) noexcept = default;
TrainedNetwork& TrainedNetwork::operator=(TrainedNetwork&&) noexcept = default;
TrainedNetwork::~TrainedNetwork() = default;

tl::unexpected<Error> TrainedNetwork::unusable(const std::string& why) const {
    return failure("the network that " + run_->job + " cannot be used, because " + why +
                   "; get it anew");
}

Result<TrainedNetwork> TrainedNetwork::from_onnx(std::span<const std::byte> model,
                                                 std::string job) {
    const Quiet quiet;
    TrainedNetwork network(std::make_unique<Run>(Run{std::move(job), {}}));
    try {
        network.run_->net =
            cv::dnn::readNetFromONNX(reinterpret_cast<const char*>(model.data()), model.size());
    } catch (const cv::Exception& e) {
        no_lack_of_memory(e);
        return network.unusable("it cannot be built (" + reason(e) + ")");
    }
    return network;
}

Result<std::vector<cv::Mat1f>> TrainedNetwork::outputs(const cv::Mat& input,
                                                       std::span<const std::vector<int>> shapes) {
    const Quiet quiet;
    std::vector<cv::Mat> all;
    try {
        run_->net.setInput(input);
        run_->net.forward(all, run_->net.getUnconnectedOutLayersNames());
    } catch (const cv::Exception& e) {
        no_lack_of_memory(e);
        return unusable("it cannot be run (" + reason(e) + ")");
    }
    std::vector<cv::Mat1f> found;
    for (const std::vector<int>& shape : shapes) {
        const auto at = std::ranges::find_if(
            all, [&shape](const cv::Mat& output) { return has_shape(output, shape); });
        if (at == all.end()) return unusable("it answers in another form");
        if (!cv::checkRange(*at)) return unusable("its answer is no number");
        const int rows = static_cast<int>(at->total()) / shape.back();
        found.emplace_back(at->reshape(1, rows).clone());
    }
    return found;
}

Result<cv::Mat1f> TrainedNetwork::likelihoods(const cv::Mat& input, const std::vector<int>& shape) {
    const auto found = outputs(input, {&shape, 1});
    if (!found) return tl::unexpected(found.error());
    if (!are_likelihoods(found->front())) return unusable("its output is no likelihood");
    return found->front();
}

cv::Mat3b stretched(const cv::Mat3b& picture, cv::Size size) {
    const bool shrinks = std::max(picture.cols, picture.rows) > std::max(size.width, size.height);
    cv::Mat3b other;
    cv::resize(picture, other, size, 0.0, 0.0, shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
    return other;
}

bool are_likelihoods(const cv::Mat1f& values) {
    return cv::checkRange(values, true, nullptr, 0.0, 1.0 + 1e-6);
}

}  // namespace touchline
