// HEIC (telephones) and AVIF, through libheif. It turns pictures upright itself, and decodes the
// whole picture at once, so a large one is made smaller afterwards.
#include "app/documents/decode/one_line.h"
#include "app/documents/decode/readers.h"
#include "app/documents/decode/worker_program.h"
#include "app/isolation/process/descriptor.h"

#include <algorithm>
#include <array>
#include <new>
#include <utility>

#include <libheif/heif.h>
#if LIBHEIF_HAVE_VERSION(1, 16, 0)
#include <libheif/heif_properties.h>
#endif

namespace touchline::decode {
namespace {

using HeifHandle = Owned<heif_image_handle, heif_image_handle_release>;

/// The first box names it.
std::string_view name_of(Bytes bytes) {
    return as_text(bytes).substr(0, 12).ends_with("avif") ? "AVIF" : "HEIC";
}

tl::unexpected<Error> broken(const heif_error& error, std::string_view name) {
    if (error.code == heif_error_Memory_allocation_error &&
        error.subcode != heif_suberror_Security_limit_exceeded)
        throw std::bad_alloc();
    return damaged(name, error.message != nullptr ? error.message : "");
}

/// A row of one channel in libheif's memory, and the distance to the next row.
struct Plane {
    const std::uint8_t* row = nullptr;
    std::ptrdiff_t stride = 0;
};

/// Blue, green, red and perhaps alpha. The row is null if a channel is missing or not of 8 bits.
std::array<Plane, 4> planes_of(const heif_image* image) {
    constexpr std::array order{heif_channel_B, heif_channel_G, heif_channel_R, heif_channel_Alpha};
    std::array<Plane, 4> planes;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool is_like_the_first =
            heif_image_get_width(image, order[i]) == heif_image_get_width(image, order[0]) &&
            heif_image_get_height(image, order[i]) == heif_image_get_height(image, order[0]);
        if (!is_like_the_first || heif_image_get_bits_per_pixel_range(image, order[i]) != 8)
            continue;
        int stride = 0;
        planes[i].row = heif_image_get_plane_readonly(image, order[i], &stride);
        planes[i].stride = stride;
    }
    return planes;
}

Result<Picture> picture_of(const heif_image* image, std::string_view name) {
    const int width = heif_image_get_width(image, heif_channel_B);
    const int height = heif_image_get_height(image, heif_channel_B);
    if (auto fits = check_file_size(name, width, height); !fits)
        return tl::unexpected(fits.error());
    std::array<Plane, 4> planes = planes_of(image);
    for (std::size_t i = 0; i < 3; ++i)
        if (planes[i].row == nullptr) return damaged(name, "it has no colours");
    const std::size_t channels = planes[3].row != nullptr ? 4 : 3;
    const auto columns = static_cast<std::size_t>(width);
    Shrinking shrinking(columns, static_cast<std::size_t>(height), channels);
    std::vector<std::uint8_t> row(channels * columns);
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
        for (std::size_t channel = 0; channel < channels; ++channel) {
            for (std::size_t x = 0; x < columns; ++x)
                row[channels * x + channel] = planes[channel].row[x];
            planes[channel].row += planes[channel].stride;
        }
        shrinking.add_row(y, row);
    }
    return std::move(shrinking).picture();
}

/// Whether libheif turned the picture by a quarter. Where it does not tell (1.15, in Debian 12),
/// its sides do; those of a newer one are filled up to blocks, so both may be alike.
bool is_turned([[maybe_unused]] const heif_context* context, const heif_image_handle* handle,
               [[maybe_unused]] const heif_image* image) {
#if LIBHEIF_HAVE_VERSION(1, 16, 0)
    const int degrees = heif_item_get_property_transform_rotation_ccw(
        context, heif_image_handle_get_item_id(handle), 0);
    return degrees == 90 || degrees == 270;
#else
    const bool was_wide =
        heif_image_handle_get_ispe_width(handle) > heif_image_handle_get_ispe_height(handle);
    const bool is_wide =
        heif_image_get_width(image, heif_channel_B) > heif_image_get_height(image, heif_channel_B);
    return was_wide != is_wide;
#endif
}

/// The shape of its pixels. libheif reports it for the picture before turning.
Resolution resolution_of(const heif_image* image, bool is_turned) {
    std::uint32_t across = 0;
    std::uint32_t down = 0;
    heif_image_get_pixel_aspect_ratio(image, &across, &down);
    if (is_turned) std::swap(across, down);
    // The wider the pixels are, the fewer fit on a length.
    return {static_cast<double>(down), static_cast<double>(across)};
}

Result<HeifHandle> primary_image(heif_context* context, Bytes bytes) {
    heif_context_set_max_decoding_threads(context, 0);
    heif_context_set_maximum_image_size_limit(context, static_cast<int>(max_file_side_px));
    heif_error error =
        heif_context_read_from_memory_without_copy(context, bytes.data(), bytes.size(), nullptr);
    if (error.code != heif_error_Ok) return broken(error, name_of(bytes));
    heif_image_handle* handle = nullptr;
    error = heif_context_get_primary_image_handle(context, &handle);
    if (error.code != heif_error_Ok) return broken(error, name_of(bytes));
    return HeifHandle(handle);
}

Result<Stored> read_heif(Bytes bytes) {
    const std::string_view name = name_of(bytes);
    const Owned<heif_context, heif_context_free> context(heif_context_alloc());
    if (context == nullptr) throw std::bad_alloc();
    const auto handle = primary_image(context.get(), bytes);
    if (!handle) return tl::unexpected(handle.error());
    if (auto fits = check_file_size(name, heif_image_handle_get_width(handle->get()),
                                    heif_image_handle_get_height(handle->get()));
        !fits)
        return tl::unexpected(fits.error());
    const Owned<heif_decoding_options, heif_decoding_options_free> options(
        heif_decoding_options_alloc());
    options->convert_hdr_to_8bit = 1;
    heif_image* decoded = nullptr;
    // Decodes into planes: libheif holds them anyway, and this saves a copy.
    const heif_error error = heif_decode_image(handle->get(), &decoded, heif_colorspace_RGB,
                                               heif_chroma_444, options.get());
    if (error.code != heif_error_Ok) return broken(error, name);
    const Owned<heif_image, heif_image_release> image(decoded);
    auto picture = picture_of(image.get(), name);
    if (!picture) return tl::unexpected(picture.error());
    constexpr int is_upright = 1;
    const bool has_turned = is_turned(context.get(), handle->get(), image.get());
    return Stored{std::move(*picture), resolution_of(image.get(), has_turned), is_upright};
}

}  // namespace
}  // namespace touchline::decode

namespace touchline {

void prepare_heif() {
    (void)heif_init(nullptr);  // a missing codec is reported with the file that needs it
}

Result<Page> decode_heif(std::span<const std::byte> bytes, const PageOrder& order) {
    return decode::without_exceptions(
        [](decode::Bytes all, const PageOrder& wanted) {
            return decode::page_by(decode::read_heif, all, wanted);
        },
        bytes, order);
}

}  // namespace touchline
