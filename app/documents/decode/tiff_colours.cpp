#include "app/documents/decode/tiff.h"

#include <algorithm>
#include <new>

namespace touchline::decode {
namespace {

tl::unexpected<Error> of_unknown_kind() {
    return failure(
        "the TIFF picture is of a kind that cannot be shown; save it as PNG, or with 8 or 16 bits");
}

SampleForm samples_of(const TiffFile& file) {
    SampleForm form;
    form.bits = file.number(TIFFTAG_BITSPERSAMPLE);
    switch (file.number(TIFFTAG_SAMPLEFORMAT)) {
        case SAMPLEFORMAT_INT:
            form.kind = NumberKind::signed_whole;
            break;
        case SAMPLEFORMAT_IEEEFP:
            form.kind = NumberKind::floating;
            break;
        case SAMPLEFORMAT_COMPLEXINT:
        case SAMPLEFORMAT_COMPLEXIEEEFP:
            form.bits = 0;
            break;
        default:
            break;
    }
    return form;
}

/// libtiff's default for a file without the tag.
std::uint32_t photometric_of(const TiffFile& file, std::uint16_t count) {
    std::uint16_t told = 0;
    if (TIFFGetField(file.get(), TIFFTAG_PHOTOMETRIC, &told) != 0) return told;
    if (count >= 3) return PHOTOMETRIC_RGB;
    const auto compression = file.number(TIFFTAG_COMPRESSION);
    const bool is_fax = compression >= COMPRESSION_CCITTRLE && compression <= COMPRESSION_CCITTFAX4;
    return is_fax ? PHOTOMETRIC_MINISWHITE : PHOTOMETRIC_MINISBLACK;
}

/// False for colours that cannot be shown.
bool read_colours(std::uint32_t photometric, TiffForm& form) {
    const auto set = [&form](TiffColours colours, std::uint16_t count) {
        form.colours = colours;
        form.colour_count = count;
        return form.count >= count;
    };
    switch (photometric) {
        case PHOTOMETRIC_MINISWHITE:
            return set(TiffColours::white_is_zero, 1);
        case PHOTOMETRIC_MINISBLACK:
        case PHOTOMETRIC_MASK:
            return set(TiffColours::grey, 1);
        case PHOTOMETRIC_RGB:
        case PHOTOMETRIC_YCBCR:  // libtiff converts it to red, green and blue
            return set(TiffColours::rgb, 3);
        case PHOTOMETRIC_PALETTE:
            return set(TiffColours::palette, 1) && form.samples.kind == NumberKind::whole &&
                   form.samples.bits <= 16;
        case PHOTOMETRIC_SEPARATED:
            return set(TiffColours::inks, std::min<std::uint16_t>(form.count, 4));
        case PHOTOMETRIC_CIELAB:
        case PHOTOMETRIC_ICCLAB:
        case PHOTOMETRIC_ITULAB:
            form.lab_kind = photometric;
            return set(TiffColours::lab, 3) && form.samples.kind != NumberKind::floating;
        default:
            return false;
    }
}

void read_alpha(const TiffFile& file, TiffForm& form) {
    std::uint16_t count = 0;
    std::uint16_t* kinds = nullptr;
    if (TIFFGetField(file.get(), TIFFTAG_EXTRASAMPLES, &count, &kinds) == 0) {
        // Such files mean alpha, and libtiff reads them so.
        const bool is_rgb_and_one = form.colours == TiffColours::rgb && form.count == 4;
        if (is_rgb_and_one) form.alpha = std::uint16_t{3};
        form.is_multiplied = is_rgb_and_one;
        return;
    }
    for (std::uint16_t i = 0; i < std::min<int>(count, form.count - form.colour_count); ++i) {
        if (kinds[i] != EXTRASAMPLE_ASSOCALPHA && kinds[i] != EXTRASAMPLE_UNASSALPHA) continue;
        form.alpha = static_cast<std::uint16_t>(form.count - count + i);
        form.is_multiplied = kinds[i] == EXTRASAMPLE_ASSOCALPHA;
        return;
    }
}

/// False if there is none.
bool read_palette(const TiffFile& file, TiffForm& form) {
    std::array<std::uint16_t*, 3> parts{};
    if (TIFFGetField(file.get(), TIFFTAG_COLORMAP, &parts[2], &parts[1], &parts[0]) == 0)
        return false;
    const std::size_t count = std::size_t{1} << form.samples.bits;
    // The palette has 16 bits; some programs write 8.
    const bool is_narrow = std::ranges::all_of(parts, [count](const std::uint16_t* part) {
        return std::all_of(part, part + count, [](std::uint16_t value) { return value < 256; });
    });
    for (std::size_t i = 0; i < count; ++i) {
        std::array<std::uint8_t, 3> colour{};
        for (std::size_t part = 0; part < 3; ++part)
            colour[part] = static_cast<std::uint8_t>(
                is_narrow ? parts[part][i] : (parts[part][i] * 255U + 32767U) / 65535U);
        form.palette.push_back(colour);
    }
    return true;
}

std::uint8_t product(unsigned a, unsigned b) {
    return static_cast<std::uint8_t>((a * b + 127U) / 255U);
}

}  // namespace

Result<TiffForm> form_of(const TiffFile& file) {
    TiffForm form;
    form.samples = samples_of(file);
    form.count = static_cast<std::uint16_t>(file.number(TIFFTAG_SAMPLESPERPIXEL));
    form.is_planar = file.is_planar();
    if (!is_known(form.samples) || form.count == 0) return of_unknown_kind();
    if (!read_colours(photometric_of(file, form.count), form)) return of_unknown_kind();
    read_alpha(file, form);
    if (form.colours == TiffColours::palette && !read_palette(file, form))
        return damaged("TIFF", "it has no colours");
    return form;
}

TiffPixels::TiffPixels(const TiffForm& form, const Range& range) : form_(form), range_(range) {
    if (form.colours != TiffColours::lab) return;
    const Owned<void, cmsCloseProfile> lab(cmsCreateLab2Profile(nullptr));
    const Owned<void, cmsCloseProfile> srgb(cmsCreate_sRGBProfile());
    from_lab_.reset(cmsCreateTransform(lab.get(), TYPE_Lab_8, srgb.get(), TYPE_BGR_8,
                                       INTENT_RELATIVE_COLORIMETRIC, 0));
    if (from_lab_ == nullptr) throw std::bad_alloc();
}

std::vector<std::uint16_t> TiffPixels::planes() const {
    std::vector<std::uint16_t> planes;
    for (std::uint16_t i = 0; i < form_.colour_count; ++i) planes.push_back(i);
    if (form_.alpha) planes.push_back(*form_.alpha);
    return planes;
}

std::vector<TiffPixels::Channel> TiffPixels::unpacked(const Stretch& stretch) {
    const std::vector<std::uint16_t> wanted = planes();
    std::vector<Channel> channels;
    if (!form_.is_planar) {
        numbers_.resize(stretch.count * form_.count);
        unpack(stretch.planes[0], form_.samples, numbers_);
        for (const std::uint16_t sample : wanted)
            channels.push_back({numbers_.data() + sample, form_.count});
        return channels;
    }
    numbers_.resize(stretch.count * wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const std::span plane = std::span(numbers_).subspan(i * stretch.count, stretch.count);
        unpack(stretch.planes[i], form_.samples, plane);
        channels.push_back({plane.data(), 1});
    }
    return channels;
}

void TiffPixels::write_colours(std::span<const Channel> channels, std::size_t count) {
    const std::size_t step = this->channels();
    const bool is_rgb = form_.colours == TiffColours::rgb;
    const unsigned flip = form_.colours == TiffColours::white_is_zero ? 255U : 0U;
    for (std::size_t part = 0; part < 3; ++part) {
        const Channel& channel = channels[is_rgb ? 2 - part : 0];
        for (std::size_t x = 0; x < count; ++x) {
            const float number = channel.first[x * channel.step];
            pixels_[step * x + part] =
                form_.colours == TiffColours::palette
                    ? form_.palette[static_cast<std::size_t>(number)][part]
                    : static_cast<std::uint8_t>(level(number, range_) ^ flip);
        }
    }
}

/// Cyan, magenta, yellow, black. The colours of fewer than three inks are unknown.
void TiffPixels::write_inks(std::span<const Channel> channels, std::size_t count) {
    const std::size_t step = this->channels();
    for (std::size_t x = 0; x < count; ++x) {
        const auto light = [&](std::size_t i) {
            return 255U - level(channels[i].first[x * channels[i].step], range_);
        };
        std::uint8_t* const to = &pixels_[step * x];
        if (form_.colour_count < 3) {
            const unsigned grey = form_.colour_count == 2 ? product(light(0), light(1)) : light(0);
            std::fill_n(to, 3, static_cast<std::uint8_t>(grey));
            continue;
        }
        const unsigned passed = form_.colour_count == 4 ? light(3) : 255U;
        for (std::size_t part = 0; part < 3; ++part) to[part] = product(light(2 - part), passed);
    }
}

/// Uses lcms2's 8-bit form: L fills the whole range, a and b have 128 in the middle.
void TiffPixels::write_lab(std::span<const Channel> channels, std::size_t count) {
    const Range own = own_range(form_.samples);
    const bool is_signed =
        form_.lab_kind == PHOTOMETRIC_CIELAB && form_.samples.kind == NumberKind::whole;
    const auto colour = [&](float number, float span_of_fax, float least_of_fax) {
        const float half = (own.high + 1.0F) / 2.0F;
        if (is_signed) number += number < half ? half : -half;
        const std::uint8_t plain = level(number, own);
        if (form_.lab_kind != PHOTOMETRIC_ITULAB) return plain;
        return static_cast<std::uint8_t>(
            std::clamp(128.0F + least_of_fax + span_of_fax * plain / 255.0F, 0.0F, 255.0F));
    };
    lab_.resize(6 * count);
    for (std::size_t x = 0; x < count; ++x) {
        const auto number = [&](std::size_t i) { return channels[i].first[x * channels[i].step]; };
        lab_[3 * x] = level(number(0), own_range({NumberKind::whole, form_.samples.bits}));
        lab_[3 * x + 1] = colour(number(1), 170.0F, -85.0F);
        lab_[3 * x + 2] = colour(number(2), 200.0F, -75.0F);
    }
    std::uint8_t* const bgr = lab_.data() + 3 * count;
    cmsDoTransform(from_lab_.get(), lab_.data(), bgr, static_cast<cmsUInt32Number>(count));
    for (std::size_t x = 0; x < count; ++x)
        std::copy_n(bgr + 3 * x, 3, &pixels_[this->channels() * x]);
}

std::span<const std::uint8_t> TiffPixels::pixels_of(const Stretch& stretch) {
    const std::vector<Channel> channels = unpacked(stretch);
    const std::size_t step = this->channels();
    pixels_.resize(step * stretch.count);
    switch (form_.colours) {
        case TiffColours::inks:
            write_inks(channels, stretch.count);
            break;
        case TiffColours::lab:
            write_lab(channels, stretch.count);
            break;
        default:
            write_colours(channels, stretch.count);
    }
    if (!form_.alpha) return pixels_;
    const Channel& alpha = channels.back();
    const Range own = own_range(form_.samples);
    for (std::size_t x = 0; x < stretch.count; ++x) {
        std::uint8_t* const pixel = &pixels_[step * x];
        pixel[3] = level(alpha.first[x * alpha.step], own);
        if (form_.is_multiplied) unmultiply(pixel);
    }
    return pixels_;
}

void TiffPixels::look(const Stretch& stretch, Seen& seen) {
    const std::vector<Channel> channels = unpacked(stretch);
    for (std::size_t i = 0; i < form_.colour_count; ++i)
        for (std::size_t x = 0; x < stretch.count; ++x)
            seen.add(channels[i].first[x * channels[i].step]);
}

}  // namespace touchline::decode
