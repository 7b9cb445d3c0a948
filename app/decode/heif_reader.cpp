// HEIC (telephones) and AVIF, through libheif, which turns them upright itself.
#include "app/decode/formats.h"

#include <memory>

#include <libheif/heif.h>

namespace touchline::decode {
namespace {

struct Release {
    void operator()(heif_context* context) const { heif_context_free(context); }

    void operator()(heif_image_handle* handle) const { heif_image_handle_release(handle); }

    void operator()(heif_image* image) const { heif_image_release(image); }

    void operator()(heif_decoding_options* options) const { heif_decoding_options_free(options); }
};

template <class T>
using Owned = std::unique_ptr<T, Release>;

tl::unexpected<Error> broken(const heif_error& error) {
    return damaged("HEIC", error.message != nullptr ? error.message : "");
}

Result<void> check_handle(const heif_image_handle* handle) {
    const int width = heif_image_handle_get_width(handle);
    const int height = heif_image_handle_get_height(handle);
    if (width < 1 || height < 1) return damaged("HEIC", "it has no pixels");
    return check_size("HEIC", static_cast<std::uint64_t>(width),
                      static_cast<std::uint64_t>(height));
}

/// Rows of red, green, blue and perhaps alpha.
Result<Picture> picture_of(const heif_image* image, std::size_t channels) {
    const int width = heif_image_get_width(image, heif_channel_interleaved);
    const int height = heif_image_get_height(image, heif_channel_interleaved);
    int stride = 0;
    const std::uint8_t* row =
        heif_image_get_plane_readonly(image, heif_channel_interleaved, &stride);
    if (row == nullptr || width < 1 || height < 1) return damaged("HEIC", "");
    if (auto fits = check_size("HEIC", static_cast<std::uint64_t>(width),
                               static_cast<std::uint64_t>(height));
        !fits)
        return tl::unexpected(fits.error());
    Picture picture{width, height, {}};
    picture.bgr.resize(channels * static_cast<std::size_t>(width) *
                       static_cast<std::size_t>(height));
    std::uint8_t* to = picture.bgr.data();
    for (int y = 0; y < height; ++y, row += stride) {
        const std::uint8_t* from = row;
        for (int x = 0; x < width; ++x, from += channels, to += channels) {
            to[0] = from[2];
            to[1] = from[1];
            to[2] = from[0];
            if (channels == 4) to[3] = from[3];
        }
    }
    if (channels == 4) compose(picture.bgr);
    return picture;
}

Result<Owned<heif_image_handle>> primary_image(heif_context* context, Bytes bytes) {
    heif_context_set_max_decoding_threads(context, 0);
    heif_context_set_maximum_image_size_limit(context, static_cast<int>(max_picture_side_px));
    heif_error error =
        heif_context_read_from_memory_without_copy(context, bytes.data(), bytes.size(), nullptr);
    if (error.code != heif_error_Ok) return broken(error);
    heif_image_handle* handle = nullptr;
    error = heif_context_get_primary_image_handle(context, &handle);
    if (error.code != heif_error_Ok) return broken(error);
    return Owned<heif_image_handle>(handle);
}

}  // namespace

Result<Picture> read_heif(Bytes bytes) {
    const Owned<heif_context> context(heif_context_alloc());
    if (context == nullptr) throw std::bad_alloc();
    const auto handle = primary_image(context.get(), bytes);
    if (!handle) return tl::unexpected(handle.error());
    if (auto fits = check_handle(handle->get()); !fits) return tl::unexpected(fits.error());
    const bool has_alpha = heif_image_handle_has_alpha_channel(handle->get()) != 0;
    const Owned<heif_decoding_options> options(heif_decoding_options_alloc());
    options->convert_hdr_to_8bit = 1;
    heif_image* decoded = nullptr;
    const heif_error error = heif_decode_image(
        handle->get(), &decoded, heif_colorspace_RGB,
        has_alpha ? heif_chroma_interleaved_RGBA : heif_chroma_interleaved_RGB, options.get());
    if (error.code != heif_error_Ok) return broken(error);
    const Owned<heif_image> image(decoded);
    return picture_of(image.get(), has_alpha ? 4 : 3);
}

}  // namespace touchline::decode
