#include "app/documents/decode/readers.h"

#include <new>
#include <utility>

#include <webp/decode.h>

namespace touchline::decode {
namespace {

std::string_view meaning(VP8StatusCode status) {
    switch (status) {
        case VP8_STATUS_UNSUPPORTED_FEATURE:
            return "it uses an unknown feature";
        case VP8_STATUS_NOT_ENOUGH_DATA:
            return "the file ends before the picture";
        default:
            return "its data make no sense";
    }
}

}  // namespace

Result<Stored> read_webp(Bytes bytes) {
    const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    WebPDecoderConfig config;
    if (WebPInitDecoderConfig(&config) == 0) return failure("libwebp is of another version");
    if (const auto status = WebPGetFeatures(data, bytes.size(), &config.input);
        status != VP8_STATUS_OK)
        return damaged("WebP", meaning(status));
    if (config.input.has_animation != 0)
        return failure("the WebP picture moves; save one frame of it as PNG or JPEG");
    if (auto fits = check_file_size("WebP", config.input.width, config.input.height); !fits)
        return tl::unexpected(fits.error());
    const auto width = static_cast<std::uint64_t>(config.input.width);
    const auto height = static_cast<std::uint64_t>(config.input.height);
    const unsigned by = reduction_for(width, height);
    Picture picture{static_cast<int>(reduced_side(width, by)),
                    static_cast<int>(reduced_side(height, by)),
                    {},
                    1.0 / by};
    const bool has_alpha = config.input.has_alpha != 0;
    const int channels = has_alpha ? 4 : 3;
    picture.bgr.resize(static_cast<std::size_t>(channels) * reduced_side(width, by) *
                       reduced_side(height, by));
    config.options.use_scaling = by > 1 ? 1 : 0;  // row by row, while it decodes
    config.options.scaled_width = picture.width;
    config.options.scaled_height = picture.height;
    config.output.colorspace = has_alpha ? MODE_BGRA : MODE_BGR;
    config.output.is_external_memory = 1;
    config.output.u.RGBA = {picture.bgr.data(), channels * picture.width, picture.bgr.size()};
    const auto status = WebPDecode(data, bytes.size(), &config);
    WebPFreeDecBuffer(&config.output);
    if (status == VP8_STATUS_OUT_OF_MEMORY) throw std::bad_alloc();
    if (status != VP8_STATUS_OK) return damaged("WebP", meaning(status));
    if (has_alpha) compose(picture.bgr);
    return Stored{std::move(picture)};
}

}  // namespace touchline::decode
