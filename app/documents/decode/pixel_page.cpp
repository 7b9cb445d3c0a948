// The page of a file that holds one picture of pixels: the picture as it is shown, and what the
// file says beside its pixels, read by libexiv2 (whose XMP reader has state: one thread at a time).
#include "app/documents/decode/exiv2_generations.h"
#include "app/documents/decode/readers.h"
#include "app/isolation/process/descriptor.h"

#include <algorithm>
#include <array>
#include <exception>
#include <string>
#include <string_view>
#include <utility>

#include <lcms2.h>

namespace touchline::decode {
namespace {

struct Metadata {
    std::string title;
    std::string description;                   // text for people who cannot see it comes first
    int orientation = 1;                       // an EXIF number, 1 ... 8
    Resolution resolution{};                   // by EXIF
    std::vector<std::uint8_t> colour_profile;  // ICC; empty: none
};

constexpr std::size_t longest_text = 4000;

std::string cleaned(std::string text) {
    text.resize(std::min({text.find('\0'), text.size(), longest_text}));
    const auto last = text.find_last_not_of(" \t\r\n");
    text.resize(last == std::string::npos ? 0 : last + 1);
    return of_a_person(std::move(text));
}

/// A text in several languages: the one for every language, else the first.
std::string text_of(const Exiv2::Value& value) {
    const auto* const languages = dynamic_cast<const Exiv2::LangAltValue*>(&value);
    if (languages == nullptr) return cleaned(value.toString());
    const auto common = languages->value_.find("x-default");
    if (common != languages->value_.end()) return cleaned(common->second);
    return languages->value_.empty() ? std::string() : cleaned(languages->value_.begin()->second);
}

template <class Data, class Key>
std::string find_text(const Data& data, const char* name) {
    const auto found = data.findKey(Key(name));
    return found == data.end() ? std::string() : text_of(found->value());
}

std::string first_of(std::initializer_list<std::string> texts) {
    for (const std::string& text : texts)
        if (!text.empty()) return text;
    return {};
}

void read_texts(const Exiv2::Image& image, Metadata& metadata) {
    const auto exif = [&](const char* name) {
        return find_text<Exiv2::ExifData, Exiv2::ExifKey>(image.exifData(), name);
    };
    const auto iptc = [&](const char* name) {
        return find_text<Exiv2::IptcData, Exiv2::IptcKey>(image.iptcData(), name);
    };
    const auto xmp = [&](const char* name) {
        return find_text<Exiv2::XmpData, Exiv2::XmpKey>(image.xmpData(), name);
    };
    const bool is_png = image.mimeType() == "image/png";
    metadata.title = first_of({xmp("Xmp.dc.title"), iptc("Iptc.Application2.Headline"),
                               iptc("Iptc.Application2.ObjectName")});
    metadata.description = first_of(
        {xmp("Xmp.iptc.AltTextAccessibility"), xmp("Xmp.iptc.ExtDescrAccessibility"),
         xmp("Xmp.dc.description"), iptc("Iptc.Application2.Caption"),
         exif("Exif.Image.ImageDescription"), is_png ? cleaned(image.comment()) : std::string()});
}

void read_orientation(const Exiv2::Image& image, Metadata& metadata) {
    const auto found = image.exifData().findKey(Exiv2::ExifKey("Exif.Image.Orientation"));
    if (found == image.exifData().end() || found->count() == 0) return;
    const auto orientation = whole_of(*found);
    if (orientation >= 1 && orientation <= 8) metadata.orientation = static_cast<int>(orientation);
}

/// The value of a rational number; 0 if it is none.
double exif_number(const Exiv2::ExifData& exif, const char* name) {
    const auto found = exif.findKey(Exiv2::ExifKey(name));
    if (found == exif.end() || found->count() == 0) return 0.0;
    const auto [above, below] = found->toRational();
    return below == 0 ? 0.0 : static_cast<double>(above) / below;
}

void read_resolution(const Exiv2::Image& image, Metadata& metadata) {
    metadata.resolution = {exif_number(image.exifData(), "Exif.Image.XResolution"),
                           exif_number(image.exifData(), "Exif.Image.YResolution")};
}

void read_profile(Exiv2::Image& image, Metadata& metadata) {
    if (!image.iccProfileDefined()) return;
    const auto profile = profile_of(image);
    metadata.colour_profile.assign(profile.begin(), profile.end());
}

/// Reads everything that can be read. Damaged metadata are no reason to refuse a picture.
Metadata metadata_of(Bytes bytes) {
    Metadata metadata;
    try {
        Exiv2::LogMsg::setLevel(Exiv2::LogMsg::mute);
        const auto image =
            Exiv2::ImageFactory::open(reinterpret_cast<const Exiv2::byte*>(bytes.data()),
                                      static_cast<Exiv2Count>(bytes.size()));
        image->readMetadata();
        read_orientation(*image, metadata);
        read_resolution(*image, metadata);
        read_profile(*image, metadata);
        read_texts(*image, metadata);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception&) {
        return metadata;  // everything read until then
    }
    return metadata;
}

using Profile = Owned<void, cmsCloseProfile>;

/// True for nearly every picture: then there is nothing to do.
bool is_srgb(cmsHPROFILE profile) {
    std::array<char, 200> name{};
    cmsGetProfileInfoASCII(profile, cmsInfoDescription, "en", "US", name.data(), name.size() - 1);
    return std::string_view(name.data()).find("sRGB") != std::string_view::npos;
}

/// Converts colours of another profile to sRGB, in place, by lcms2. Changes nothing if the profile
/// is damaged, or not for red, green and blue.
void convert_to_srgb(const std::vector<std::uint8_t>& colour_profile, Picture& picture) {
    if (colour_profile.empty()) return;
    cmsSetLogErrorHandler([](cmsContext, cmsUInt32Number, const char*) {});
    const Profile from(cmsOpenProfileFromMem(colour_profile.data(),
                                             static_cast<cmsUInt32Number>(colour_profile.size())));
    if (from == nullptr || cmsGetColorSpace(from.get()) != cmsSigRgbData || is_srgb(from.get()))
        return;
    const Profile srgb(cmsCreate_sRGBProfile());
    const Owned<void, cmsDeleteTransform> transform(
        cmsCreateTransform(from.get(), TYPE_BGR_8, srgb.get(), TYPE_BGR_8, INTENT_PERCEPTUAL, 0));
    if (transform == nullptr) return;
    cmsDoTransform(transform.get(), picture.bgr.data(), picture.bgr.data(),
                   static_cast<cmsUInt32Number>(picture.bgr.size() / 3));
}

bool is_told(const Resolution& resolution) {
    return resolution.across > 0.0 && resolution.down > 0.0;
}

}  // namespace

Result<Page> page_by(PixelReader read, Bytes bytes, const PageOrder& order) {
    if (order.page != 1) return failure("the file has one page only");
    auto stored = read(bytes);
    if (!stored) return tl::unexpected(stored.error());
    Metadata metadata = metadata_of(bytes);
    convert_to_srgb(metadata.colour_profile, stored->picture);
    const Resolution& resolution =
        is_told(stored->resolution) ? stored->resolution : metadata.resolution;
    const int orientation = stored->orientation != 0 ? stored->orientation : metadata.orientation;
    Page page;
    page.picture = upright(with_square_pixels(std::move(stored->picture), resolution), orientation);
    page.told.area = told_area(page.picture);
    page.told.title = std::move(metadata.title);
    page.told.description = std::move(metadata.description);
    return page;
}

}  // namespace touchline::decode
