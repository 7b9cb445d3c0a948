// Tests that colours of another profile become sRGB.
#include "tests/app/documents/decode/decoding_here.h"
#include "tests/app/documents/decode/encoders.h"
#include "tests/app/documents/decode/with_metadata.h"

#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <lcms2.h>

namespace touchline {
namespace {

using encoders::Bytes;

/// A profile with sRGB's primaries and linear light.
std::vector<std::uint8_t> profile_of_light() {
    const cmsCIExyY white{0.3127, 0.3290, 1.0};
    const cmsCIExyYTRIPLE primaries{{0.64, 0.33, 1.0}, {0.30, 0.60, 1.0}, {0.15, 0.06, 1.0}};
    cmsToneCurve* const straight = cmsBuildGamma(nullptr, 1.0);
    cmsToneCurve* const curves[3] = {straight, straight, straight};
    cmsHPROFILE profile = cmsCreateRGBProfile(&white, &primaries, curves);
    cmsUInt32Number size = 0;
    cmsSaveProfileToMem(profile, nullptr, &size);
    std::vector<std::uint8_t> bytes(size);
    cmsSaveProfileToMem(profile, bytes.data(), &size);
    cmsCloseProfile(profile);
    cmsFreeToneCurve(straight);
    return bytes;
}

Bytes with_profile(const Bytes& bytes, const std::vector<std::uint8_t>& profile) {
    return with_metadata(bytes, [&profile](auto& image) {
        Exiv2::DataBuf data(profile.data(), static_cast<decode::Exiv2Count>(profile.size()));
        if constexpr (requires { image.setIccProfile(data, false); })
            image.setIccProfile(data, false);
        else
            image.setIccProfile(std::move(data), false);  // since 0.28
    });
}

Picture grey(std::uint8_t level) {
    Picture picture{8, 8, {}};
    picture.bgr.assign(192, level);
    return picture;
}

TEST(ColourProfile, IsTakenIntoAccount) {
    // 51 of 255 of the light is 124 of 255 in sRGB.
    const Bytes jpeg = with_profile(encoders::jpeg(grey(51)), profile_of_light());
    const Picture picture = decode_picture(jpeg).value();
    for (const std::uint8_t value : picture.bgr) EXPECT_NEAR(value, 124, 2);
}

TEST(ColourProfile, ThatIsDamagedChangesNothing) {
    std::vector<std::uint8_t> damaged = profile_of_light();
    damaged.resize(damaged.size() / 2);
    const Bytes jpeg = with_profile(encoders::jpeg(grey(51)), damaged);
    const Picture picture = decode_picture(jpeg).value();
    for (const std::uint8_t value : picture.bgr) EXPECT_NEAR(value, 51, 2);
}

}  // namespace
}  // namespace touchline
