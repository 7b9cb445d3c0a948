#include "tests/app/documents/decode/encoders.h"

#include "app/documents/decode/files.h"

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include <gtest/gtest.h>
#include <jpeglib.h>
#include <libheif/heif.h>
#include <png.h>
#include <tiffio.h>
#include <unistd.h>
#include <webp/encode.h>
#include <webp/mux.h>

namespace touchline::encoders {

Bytes bytes_of(const std::string& text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

std::vector<std::uint8_t> rgb_of(const Picture& picture) {
    std::vector<std::uint8_t> rgb(picture.bgr.size());
    for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = picture.bgr[i - i % 3 + 2 - i % 3];
    return rgb;
}

Picture test_picture(int width, int height) {
    Picture picture{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            picture.bgr.push_back(static_cast<std::uint8_t>(255 * x / width));
            picture.bgr.push_back(static_cast<std::uint8_t>(255 * y / height));
            picture.bgr.push_back(static_cast<std::uint8_t>(200 * (x + y) / (width + height) + 40));
        }
    }
    return picture;
}

Bytes png(int width, int height, const PngForm& form, const std::vector<std::uint8_t>& samples) {
    Bytes out;
    png_structp writer = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(writer);
    png_set_write_fn(
        writer, &out,
        [](png_structp self, png_bytep data, std::size_t size) {
            auto& bytes = *static_cast<Bytes*>(png_get_io_ptr(self));
            const auto* begin = reinterpret_cast<const std::byte*>(data);
            bytes.insert(bytes.end(), begin, begin + size);
        },
        nullptr);
    png_set_IHDR(writer, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height),
                 form.bit_depth, form.colour_type,
                 form.is_interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    std::vector<png_color> palette;
    for (std::size_t i = 0; i + 2 < form.palette_rgb.size(); i += 3) {
        palette.push_back({form.palette_rgb[i], form.palette_rgb[i + 1], form.palette_rgb[i + 2]});
    }
    if (!palette.empty()) {
        png_set_PLTE(writer, info, palette.data(), static_cast<int>(palette.size()));
    }
    if (!form.palette_alpha.empty()) {
        png_set_tRNS(writer, info, form.palette_alpha.data(),
                     static_cast<int>(form.palette_alpha.size()), nullptr);
    }
    png_write_info(writer, info);
    const std::size_t row_bytes = png_get_rowbytes(writer, info);
    std::vector<std::uint8_t> own = samples;
    std::vector<png_bytep> rows;
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
        rows.push_back(own.data() + y * row_bytes);
    }
    png_write_image(writer, rows.data());
    png_write_end(writer, info);
    png_destroy_write_struct(&writer, &info);
    return out;
}

Bytes png(const Picture& picture) {
    return png(picture.width, picture.height, {PNG_COLOR_TYPE_RGB, 8}, rgb_of(picture));
}

namespace {

/// An APP1 segment as cameras write it, big-endian, with two tags before the orientation.
std::vector<std::uint8_t> exif(int orientation) {
    const auto value = static_cast<std::uint8_t>(orientation);
    return {'E',  'x',  'i', 'f', 0, 0, 'M', 'M', 0, 42,    0, 0, 0, 8,  // header, directory at 8
            0,    2,                                                     // two entries
            0x01, 0x00, 0,   3,   0, 0, 0,   1,   0, 9,     0, 0,        // width
            0x01, 0x12, 0,   3,   0, 0, 0,   1,   0, value, 0, 0,        // orientation
            0,    0,    0,   0};
}

}  // namespace

Bytes jpeg(int width, int height, const JpegForm& form, const std::vector<std::uint8_t>& samples) {
    jpeg_compress_struct codec{};
    jpeg_error_mgr errors{};
    codec.err = jpeg_std_error(&errors);  // an error here ends the test program
    jpeg_create_compress(&codec);
    unsigned char* memory = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&codec, &memory, &size);
    codec.image_width = static_cast<JDIMENSION>(width);
    codec.image_height = static_cast<JDIMENSION>(height);
    codec.input_components = form.channels;
    codec.in_color_space = form.channels == 1   ? JCS_GRAYSCALE
                           : form.channels == 3 ? JCS_RGB
                                                : JCS_CMYK;
    jpeg_set_defaults(&codec);
    jpeg_set_quality(&codec, form.quality, TRUE);
    if (form.is_progressive) jpeg_simple_progression(&codec);
    if (!form.has_adobe_marker) codec.write_Adobe_marker = FALSE;
    jpeg_start_compress(&codec, TRUE);
    if (form.exif_orientation != 0) {
        const auto segment = exif(form.exif_orientation);
        jpeg_write_marker(&codec, JPEG_APP0 + 1, segment.data(),
                          static_cast<unsigned>(segment.size()));
    }
    std::vector<std::uint8_t> row(static_cast<std::size_t>(width * form.channels));
    while (codec.next_scanline < codec.image_height) {
        const auto begin =
            samples.begin() + static_cast<std::ptrdiff_t>(row.size() * codec.next_scanline);
        std::copy_n(begin, row.size(), row.begin());
        JSAMPROW pointer = row.data();
        jpeg_write_scanlines(&codec, &pointer, 1);
    }
    jpeg_finish_compress(&codec);
    jpeg_destroy_compress(&codec);
    const auto* begin = reinterpret_cast<const std::byte*>(memory);
    Bytes out(begin, begin + size);
    std::free(memory);  // NOLINT: libjpeg allocated it
    return out;
}

Bytes jpeg(const Picture& picture, const JpegForm& form) {
    return jpeg(picture.width, picture.height, form, rgb_of(picture));
}

namespace {

Bytes take_webp(std::size_t size, std::uint8_t* memory) {
    const auto* begin = reinterpret_cast<const std::byte*>(memory);
    Bytes out(begin, begin + size);
    WebPFree(memory);
    return out;
}

}  // namespace

Bytes lossless_webp(int width, int height, const std::vector<std::uint8_t>& bgra) {
    std::uint8_t* memory = nullptr;
    const std::size_t size = WebPEncodeLosslessBGRA(bgra.data(), width, height, 4 * width, &memory);
    return take_webp(size, memory);
}

Bytes lossy_webp(const Picture& picture) {
    std::uint8_t* memory = nullptr;
    const std::size_t size = WebPEncodeBGR(picture.bgr.data(), picture.width, picture.height,
                                           3 * picture.width, 95.0F, &memory);
    return take_webp(size, memory);
}

Bytes moving_webp(const Picture& picture) {
    WebPAnimEncoderOptions options;
    WebPAnimEncoderOptionsInit(&options);
    WebPAnimEncoder* encoder = WebPAnimEncoderNew(picture.width, picture.height, &options);
    WebPConfig config;
    WebPConfigInit(&config);
    for (int frame = 0; frame < 3; ++frame) {
        Picture changed = picture;
        changed.bgr[0] = static_cast<std::uint8_t>(90 * frame);
        WebPPicture image;
        WebPPictureInit(&image);
        image.use_argb = 1;
        image.width = picture.width;
        image.height = picture.height;
        WebPPictureImportBGR(&image, changed.bgr.data(), 3 * picture.width);
        WebPAnimEncoderAdd(encoder, &image, 100 * frame, &config);
        WebPPictureFree(&image);
    }
    WebPAnimEncoderAdd(encoder, nullptr, 300, nullptr);
    WebPData data;
    WebPAnimEncoderAssemble(encoder, &data);
    const auto* begin = reinterpret_cast<const std::byte*>(data.bytes);
    Bytes out(begin, begin + data.size);
    WebPDataClear(&data);
    WebPAnimEncoderDelete(encoder);
    return out;
}

namespace {

void write_pages(TIFF* file, const TiffDirectory& directory) {
    const auto& [width, height, form, samples] = directory;
    for (int page = 0; page < form.pages; ++page) {
        TIFFSetField(file, TIFFTAG_SUBFILETYPE, form.subfile_type);
        TIFFSetField(file, TIFFTAG_IMAGEWIDTH, width);
        TIFFSetField(file, TIFFTAG_IMAGELENGTH, height);
        TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, form.samples_per_pixel);
        TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, form.bits_per_sample);
        TIFFSetField(file, TIFFTAG_PHOTOMETRIC, form.photometric);
        TIFFSetField(file, TIFFTAG_COMPRESSION, form.compression);
        TIFFSetField(file, TIFFTAG_ORIENTATION, form.orientation);
        TIFFSetField(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
        TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, 5);
        if (form.extra_sample >= 0) {
            const auto kind = static_cast<std::uint16_t>(form.extra_sample);
            TIFFSetField(file, TIFFTAG_EXTRASAMPLES, 1, &kind);
        }
        if (!form.palette_rgb.empty()) {
            auto palette = form.palette_rgb;
            TIFFSetField(file, TIFFTAG_COLORMAP, palette.data(), palette.data() + 256,
                         palette.data() + 512);
        }
        const std::size_t row_bytes = samples.size() / static_cast<std::size_t>(height);
        for (int y = 0; y < height; ++y) {
            std::vector<std::uint8_t> row(row_bytes);
            const auto begin = samples.begin() + static_cast<std::ptrdiff_t>(row_bytes) * y;
            std::copy_n(begin, row_bytes, row.begin());
            if (page > 0) std::fill(row.begin(), row.end(), std::uint8_t{77});
            TIFFWriteScanline(file, row.data(), static_cast<std::uint32_t>(y), 0);
        }
        TIFFWriteDirectory(file);
    }
}

}  // namespace

Bytes tiff(const std::vector<TiffDirectory>& directories) {
    const std::string path =
        testing::TempDir() + "touchline-" + std::to_string(::getpid()) + ".tiff";
    TIFF* file = TIFFOpen(path.c_str(), "w");
    if (file == nullptr) throw std::runtime_error("no room for " + path);
    for (const TiffDirectory& directory : directories) write_pages(file, directory);
    TIFFClose(file);
    auto bytes = read_file(path);
    ::unlink(path.c_str());
    return bytes.value();
}

Bytes tiff(int width, int height, const TiffForm& form, const std::vector<std::uint8_t>& samples) {
    return tiff({{width, height, form, samples}});
}

Bytes tiff(const Picture& picture, int orientation) {
    TiffForm form{PHOTOMETRIC_RGB, 3};
    form.orientation = orientation;
    return tiff(picture.width, picture.height, form, rgb_of(picture));
}

Bytes heif(const Picture& picture, const HeifForm& form) {
    heif_context* context = heif_context_alloc();
    heif_encoder* encoder = nullptr;
    heif_context_get_encoder_for_format(
        context, form.is_avif ? heif_compression_AV1 : heif_compression_HEVC, &encoder);
    if (encoder == nullptr) throw std::runtime_error("libheif has no encoder");
    heif_encoder_set_lossy_quality(encoder, form.quality);
    heif_encoder_set_parameter_string(encoder, form.is_avif ? "speed" : "preset",
                                      form.is_avif ? "9" : "ultrafast");
    heif_image* image = nullptr;
    heif_image_create(picture.width, picture.height, heif_colorspace_RGB,
                      heif_chroma_interleaved_RGB, &image);
    heif_image_add_plane(image, heif_channel_interleaved, picture.width, picture.height, 8);
    int stride = 0;
    std::uint8_t* plane = heif_image_get_plane(image, heif_channel_interleaved, &stride);
    const std::vector<std::uint8_t> rgb = rgb_of(picture);
    const std::size_t row_bytes = std::size_t{3} * static_cast<std::size_t>(picture.width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height); ++y)
        std::copy_n(rgb.begin() + static_cast<std::ptrdiff_t>(y * row_bytes), row_bytes,
                    plane + y * static_cast<std::size_t>(stride));
    heif_image_set_pixel_aspect_ratio(image, form.pixel_width, form.pixel_height);
    heif_encoding_options* options = heif_encoding_options_alloc();
    options->macOS_compatibility_workaround = 0;  // it would hide the picture in another
    options->image_orientation = static_cast<heif_orientation>(form.orientation);
    heif_context_encode_image(context, image, encoder, options, nullptr);
    Bytes out;
    heif_writer writer{1, [](heif_context*, const void* data, std::size_t size, void* user) {
                           auto& bytes = *static_cast<Bytes*>(user);
                           const auto* begin = static_cast<const std::byte*>(data);
                           bytes.assign(begin, begin + size);
                           return heif_error{heif_error_Ok, heif_suberror_Unspecified, ""};
                       }};
    heif_context_write(context, &writer, &out);
    heif_encoding_options_free(options);
    heif_image_release(image);
    heif_encoder_release(encoder);
    heif_context_free(context);
    return out;
}

}  // namespace touchline::encoders
