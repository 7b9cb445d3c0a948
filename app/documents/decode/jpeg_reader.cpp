#include "app/documents/decode/readers.h"
#include "config/types/pinned.h"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>  // jpeglib.h needs FILE

#include <jerror.h>
#include <jpeglib.h>

namespace touchline::decode {
namespace {

/// libjpeg reports an error by a call that must not return, so the call jumps out of the library.
struct ErrorCallbacks {
    jpeg_error_mgr base;  // must be first: a pointer to it is also a pointer to this
    std::jmp_buf way_out;
    bool is_cut_short;
    bool has_no_end_mark;
    std::array<char, JMSG_LENGTH_MAX> message;
};

/// A progressive file of a few kilobytes can ask for thousands of passes over every pixel.
constexpr int max_scans = 200;

ErrorCallbacks& callbacks_of(j_common_ptr codec) {
    return *reinterpret_cast<ErrorCallbacks*>(codec->err);
}

[[noreturn]] void leave(j_common_ptr codec) {
    ErrorCallbacks& errors = callbacks_of(codec);
    errors.base.format_message(codec, errors.message.data());
    std::longjmp(errors.way_out, 1);  // NOLINT(cert-err52-cpp): libjpeg's interface
}

/// Ignores warnings (a picture with stray bytes is a picture), except the one that says that pixels
/// are missing. If only the end mark is missing, all pixels are there.
void note_warning(j_common_ptr codec, int message_level) {
    if (message_level >= 0) return;
    const int code = codec->err->msg_code;
    if (code == JWRN_JPEG_EOF) callbacks_of(codec).has_no_end_mark = true;
    if (code == JWRN_HIT_MARKER) callbacks_of(codec).is_cut_short = true;
}

/// True if a progressive picture has had all its scans: every bit of every coefficient.
bool has_all_scans(const jpeg_decompress_struct& decoder) {
    if (decoder.progressive_mode == FALSE || decoder.coef_bits == nullptr) return true;
    for (int component = 0; component < decoder.num_components; ++component)
        if (std::ranges::any_of(decoder.coef_bits[component], [](int bits) { return bits != 0; }))
            return false;
    return true;
}

void limit_scans(j_common_ptr codec) {
    const auto* decoder = reinterpret_cast<j_decompress_ptr>(codec);
    if (decoder->input_scan_number > max_scans) ERREXIT(codec, JERR_BAD_PROGRESSION);
}

/// Runs one step of the decoder; false if libjpeg gave up in it. The jump ends here, so neither
/// this function nor a step may hold an object with a destructor.
template <class Step>
bool run(ErrorCallbacks& errors, const Step& step) {
    if (setjmp(errors.way_out) != 0) return false;  // NOLINT(cert-err52-cpp): libjpeg's interface
    step();
    return true;
}

class Decoder : public jpeg_decompress_struct, private Pinned {
  public:
    Decoder() : jpeg_decompress_struct{} {
        err = jpeg_std_error(&errors.base);
        errors.base.error_exit = leave;
        errors.base.emit_message = note_warning;
        progress_.progress_monitor = limit_scans;
    }

    ~Decoder() { jpeg_destroy_decompress(this); }

    void open(Bytes bytes) {
        jpeg_create_decompress(this);
        progress = &progress_;
        mem->max_memory_to_use = static_cast<long>(max_library_bytes);
        jpeg_mem_src(this, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
        jpeg_read_header(this, TRUE);
    }

    ErrorCallbacks errors{};

  private:
    jpeg_progress_mgr progress_{};
};

/// The error for the person who brought the picture.
tl::unexpected<Error> given_up(const Decoder& decoder) {
    const int code = decoder.errors.base.msg_code;
    const bool is_memory = code == JERR_OUT_OF_MEMORY || code == JERR_NO_BACKING_STORE;
    if (is_memory && decoder.progressive_mode == TRUE)
        return failure(
            "the JPEG picture is a progressive one, which needs too much memory at its "
            "size; save it smaller, or not progressive");
    if (is_memory) return failure("the JPEG picture needs too much memory; save it smaller");
    return damaged("JPEG", decoder.errors.message.data());
}

/// JFIF's resolution, if it is known. Only the ratio counts, not the unit.
Resolution resolution_of(const jpeg_decompress_struct& decoder) {
    const bool is_told = decoder.density_unit != 0 || decoder.X_density != decoder.Y_density;
    if (decoder.saw_JFIF_marker == FALSE || !is_told) return {};
    return {static_cast<double>(decoder.X_density), static_cast<double>(decoder.Y_density)};
}

/// Converts printing inks to light. Adobe's programs store every ink inverted, and all others
/// follow them. A file without Adobe's mark is taken literally.
void inks_to_bgr(const std::uint8_t* cmyk, std::size_t pixels, bool is_inverted,
                 std::uint8_t* bgr) {
    const unsigned flip = is_inverted ? 0U : 255U;
    for (std::size_t i = 0; i < pixels; ++i, cmyk += 4, bgr += 3) {
        const unsigned light = cmyk[3] ^ flip;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const unsigned passed = (cmyk[2 - channel] ^ flip) * light + 127U;
            bgr[channel] = static_cast<std::uint8_t>(passed / 255U);
        }
    }
}

bool read_rows(Decoder& decoder, bool has_inks, Picture& picture) {
    const std::size_t width = decoder.output_width;
    std::vector<std::uint8_t> ink_row(has_inks ? 4 * width : 0);
    return run(decoder.errors, [&] {
        while (decoder.output_scanline < decoder.output_height) {
            std::uint8_t* out = picture.bgr.data() + 3 * width * decoder.output_scanline;
            JSAMPROW row = has_inks ? ink_row.data() : out;
            jpeg_read_scanlines(&decoder, &row, 1);
            if (has_inks) inks_to_bgr(row, width, decoder.saw_Adobe_marker == TRUE, out);
        }
        // Ignores what camera makers write behind the picture.
        jpeg_abort_decompress(&decoder);
    });
}

}  // namespace

Result<Stored> read_jpeg(Bytes bytes) {
    Decoder decoder;
    if (!run(decoder.errors, [&] { decoder.open(bytes); })) return given_up(decoder);
    if (auto fits =
            check_file_size("JPEG", decoder.image_width, decoder.image_height, max_jpeg_pixels);
        !fits)
        return tl::unexpected(fits.error());
    const unsigned by = reduction_for(decoder.image_width, decoder.image_height);
    const bool has_inks =
        decoder.jpeg_color_space == JCS_CMYK || decoder.jpeg_color_space == JCS_YCCK;
    decoder.scale_num = 1;
    decoder.scale_denom = by;
    decoder.out_color_space = has_inks ? JCS_CMYK : JCS_EXT_BGR;
    if (!run(decoder.errors, [&] { jpeg_start_decompress(&decoder); })) return given_up(decoder);
    const bool is_whole = !decoder.errors.has_no_end_mark || has_all_scans(decoder);
    Picture picture{static_cast<int>(decoder.output_width),
                    static_cast<int>(decoder.output_height),
                    {},
                    1.0 / by};
    picture.bgr.resize(std::size_t{3} * decoder.output_width * decoder.output_height);
    if (!read_rows(decoder, has_inks, picture)) return given_up(decoder);
    if (decoder.errors.is_cut_short || !is_whole) return cut_short("JPEG");
    return Stored{std::move(picture), resolution_of(decoder)};
}

}  // namespace touchline::decode
