#include "vision/figure/figure_network.h"

#include <algorithm>
#include <new>
#include <string>
#include <utility>

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

tl::unexpected<Error> unusable(const std::string& why) {
    return failure("the network that finds the main thing cannot be used, because " + why +
                   "; get it anew");
}

/// The first line of what OpenCV says, without its file and line number.
std::string reason(const cv::Exception& e) {
    return e.err.substr(0, e.err.find('\n'));
}

/// Lack of memory is no fault of the network's.
void no_lack_of_memory(const cv::Exception& e) {
    if (e.code == cv::Error::StsNoMem) throw std::bad_alloc();
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

/// Shrinking takes the mean of what becomes one pixel; enlarging goes smoothly from one to the
/// next.
cv::Mat3b stretched(const cv::Mat3b& picture, int side_px) {
    const bool shrinks = std::max(picture.cols, picture.rows) > side_px;
    cv::Mat3b square;
    cv::resize(picture, square, {side_px, side_px}, 0.0, 0.0,
               shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
    return square;
}

bool is_map(const cv::Mat& output, int side_px) {
    return output.dims == 4 && output.type() == CV_32F && output.size[0] == 1 &&
           output.size[1] == 1 && output.size[2] == side_px && output.size[3] == side_px;
}

}  // namespace

struct FigureNetwork::Network {
    cv::dnn::Net net;
};

FigureNetwork::FigureNetwork(std::unique_ptr<Network> network) : network_(std::move(network)) {}

FigureNetwork::FigureNetwork(FigureNetwork&&) noexcept = default;
FigureNetwork& FigureNetwork::operator=(FigureNetwork&&) noexcept = default;
FigureNetwork::~FigureNetwork() = default;

Result<FigureNetwork> FigureNetwork::from_onnx(std::span<const std::byte> model) {
    const Quiet quiet;
    auto network = std::make_unique<Network>();
    try {
        network->net =
            cv::dnn::readNetFromONNX(reinterpret_cast<const char*>(model.data()), model.size());
    } catch (const cv::Exception& e) {
        no_lack_of_memory(e);
        return unusable("it cannot be built (" + reason(e) + ")");
    }
    return FigureNetwork(std::move(network));
}

Result<cv::Mat1f> FigureNetwork::likelihood(const cv::Mat3b& picture, int side_px) {
    const Quiet quiet;
    try {
        network_->net.setInput(cv::dnn::blobFromImage(stretched(picture, side_px), 1.0 / 256.0, {},
                                                      cv::Scalar::all(128.0), true, false));
        const cv::Mat output = network_->net.forward();
        if (!is_map(output, side_px)) return unusable("its output is no map of the picture");
        cv::Mat1f map(side_px, side_px);
        std::copy_n(output.ptr<float>(), map.total(), map.begin());
        if (!cv::checkRange(map, true, nullptr, 0.0, 1.0 + 1e-6))
            return unusable("its output is no likelihood");
        return map;
    } catch (const cv::Exception& e) {
        no_lack_of_memory(e);
        return unusable("it cannot be run (" + reason(e) + ")");
    }
}

}  // namespace touchline
