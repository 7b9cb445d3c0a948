#include "app/decode/metadata.h"

#include <array>
#include <memory>
#include <string_view>

#include <lcms2.h>

namespace touchline::decode {
namespace {

struct Release {
    void operator()(void* profile) const { cmsCloseProfile(profile); }
};

using Profile = std::unique_ptr<void, Release>;

struct DeleteTransform {
    void operator()(void* transform) const { cmsDeleteTransform(transform); }
};

/// True for nearly every picture: then there is nothing to do.
bool is_srgb(cmsHPROFILE profile) {
    std::array<char, 200> name{};
    cmsGetProfileInfoASCII(profile, cmsInfoDescription, "en", "US", name.data(), name.size() - 1);
    return std::string_view(name.data()).find("sRGB") != std::string_view::npos;
}

}  // namespace

void convert_to_srgb(const std::vector<std::uint8_t>& colour_profile, Picture& picture) {
    if (colour_profile.empty()) return;
    cmsSetLogErrorHandler([](cmsContext, cmsUInt32Number, const char*) {});
    const Profile from(cmsOpenProfileFromMem(colour_profile.data(),
                                             static_cast<cmsUInt32Number>(colour_profile.size())));
    if (from == nullptr || cmsGetColorSpace(from.get()) != cmsSigRgbData || is_srgb(from.get()))
        return;
    const Profile srgb(cmsCreate_sRGBProfile());
    const std::unique_ptr<void, DeleteTransform> transform(
        cmsCreateTransform(from.get(), TYPE_BGR_8, srgb.get(), TYPE_BGR_8, INTENT_PERCEPTUAL, 0));
    if (transform == nullptr) return;
    cmsDoTransform(transform.get(), picture.bgr.data(), picture.bgr.data(),
                   static_cast<cmsUInt32Number>(picture.bgr.size() / 3));
}

}  // namespace touchline::decode
