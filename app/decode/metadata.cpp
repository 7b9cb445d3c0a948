#include "app/decode/metadata.h"

#include "app/decode/exiv2_generations.h"
#include "app/decode/machine_words.h"

#include <algorithm>
#include <exception>
#include <string>
#include <utility>

namespace touchline::decode {
namespace {

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

}  // namespace

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

}  // namespace touchline::decode
