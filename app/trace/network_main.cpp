// touchline-trace-network: the same with a network of the user's own, which lies before the
// picture.
#include "app/trace/network_input.h"
#include "app/trace/trace_program.h"
#include "vision/contour/edge_model.h"

#include <memory>
#include <utility>

namespace {

touchline::Result<touchline::TraceInput> with_network(std::span<const std::byte> bytes) {
    using namespace touchline;
    const NetworkInput parts = network_input_of(bytes);
    return EdgeModel::from_onnx(parts.network).map([&parts](EdgeModel model) {
        const auto kept = std::make_shared<EdgeModel>(std::move(model));
        return TraceInput{[kept](const cv::Mat& picture) { return kept->boundaries(picture); },
                          parts.picture};
    });
}

}  // namespace

int main(int argc, char** argv) {
    touchline::run_trace_program({touchline::WorkerKind::network, with_network}, argc, argv);
}
