#include "app/documents/decode/word_reader.h"

#include "app/documents/decode/readers.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <leptonica/allheaders.h>
#include <tesseract/baseapi.h>

namespace touchline {
namespace {

struct PixRelease {
    void operator()(Pix* pix) const { pixDestroy(&pix); }

    void operator()(Pixa* parts) const { pixaDestroy(&parts); }

    void operator()(Boxa* boxes) const { boxaDestroy(&boxes); }
};

using OwnedPix = std::unique_ptr<Pix, PixRelease>;

constexpr int largest_letter = 6;      // this many of the largest letters fill the longer side
constexpr double most_of_a_box = 0.3;  // a line fills less of its box
constexpr int soft_edge_px = 3;

/// The dark parts, as on a printed page.
OwnedPix dark_parts_of(Pix* grey) {
    Pix* dark = nullptr;
    pixOtsuAdaptiveThreshold(grey, pixGetWidth(grey), pixGetHeight(grey), 0, 0, 0.0F, nullptr,
                             &dark);
    return OwnedPix(dark);
}

bool is_large_line(Pix* part, int longer_side) {
    const int width = pixGetWidth(part);
    const int height = pixGetHeight(part);
    if (largest_letter * std::max(width, height) <= longer_side) return false;
    int dark = 0;
    pixCountPixels(part, &dark, nullptr);
    return dark < most_of_a_box * width * height;
}

void paint_over(Pix* grey, Pix* part, int left, int top) {
    constexpr int reach = 2 * soft_edge_px + 1;
    const OwnedPix framed(pixAddBorder(part, soft_edge_px, 0));
    const OwnedPix grown(pixDilateBrick(nullptr, framed.get(), reach, reach));
    if (grown != nullptr)
        pixPaintThroughMask(grey, grown.get(), left - soft_edge_px, top - soft_edge_px, 255);
}

/// Paints lines that reach over a sixth of the longer side white, and keeps filled shapes. 8 bits
/// per pixel. Returns the picture unchanged if memory runs out.
OwnedPix without_shapes(OwnedPix grey) {
    const OwnedPix dark = dark_parts_of(grey.get());
    if (dark == nullptr) return grey;
    Pixa* found = nullptr;
    const std::unique_ptr<Boxa, PixRelease> boxes(pixConnComp(dark.get(), &found, 8));
    const std::unique_ptr<Pixa, PixRelease> parts(found);
    if (boxes == nullptr || parts == nullptr) return grey;
    const int longer_side = std::max(pixGetWidth(grey.get()), pixGetHeight(grey.get()));
    for (int i = 0; i < pixaGetCount(parts.get()); ++i) {
        const OwnedPix part(pixaGetPix(parts.get(), i, L_CLONE));
        int left = 0;
        int top = 0;
        boxaGetBoxGeometry(boxes.get(), i, &left, &top, nullptr, nullptr);
        if (is_large_line(part.get(), longer_side)) paint_over(grey.get(), part.get(), left, top);
    }
    return grey;
}

using decode::SeenWord;

/// Letters of 10 pixels can be read if they are enlarged twice; time grows with the pixels.
constexpr double wanted_pixels = 4e6;
constexpr double most_enlarged = 2.0;

/// Tesseract needs it to find the sizes of letters; that of a screen or a page.
constexpr int pixels_per_inch = 150;

/// A shape with more holes than any letter has is no letter, so tesseract looks inside it. Its own
/// limit (45) takes a ring for a letter with the words in it as holes.
constexpr const char* most_holes_setting = "edges_children_count_limit";
constexpr const char* most_holes = "5";

using OwnedText = std::unique_ptr<char[]>;

/// Grey as bright as the eye sees it. Null if memory runs out.
OwnedPix grey_of(const Picture& picture) {
    OwnedPix grey(pixCreateNoInit(picture.width, picture.height, 8));
    if (grey == nullptr) return nullptr;
    const std::uint8_t* at = picture.bgr.data();
    for (int y = 0; y < picture.height; ++y) {
        l_uint32* const line = pixGetData(grey.get()) + std::ptrdiff_t{y} * pixGetWpl(grey.get());
        for (int x = 0; x < picture.width; ++x, at += 3) {
            SET_DATA_BYTE(line, x, static_cast<l_uint8>(decode::lightness_of(at)));
        }
    }
    return grey;
}

/// Enlarged pixels per pixel of the picture.
double scale_for(const Picture& picture) {
    const double pixels = static_cast<double>(picture.width) * picture.height;
    return std::min(most_enlarged, std::sqrt(wanted_pixels / pixels));
}

OwnedPix scaled(OwnedPix grey, double scale) {
    if (grey == nullptr) return nullptr;
    const auto factor = static_cast<float>(scale);
    return OwnedPix(pixScale(grey.get(), factor, factor));
}

std::uint16_t pixel(double value, int most) {
    return static_cast<std::uint16_t>(std::clamp(value, 0.0, static_cast<double>(most)));
}

/// The box at `at`; a box without pixels if tesseract does not say.
WordBox box_at(const tesseract::ResultIterator& at, double scale, const Picture& picture) {
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;
    if (!at.BoundingBox(tesseract::RIL_WORD, &left, &top, &right, &bottom)) return {};
    return {pixel(std::floor(left / scale), picture.width),
            pixel(std::floor(top / scale), picture.height),
            pixel(std::ceil(right / scale), picture.width),
            pixel(std::ceil(bottom / scale), picture.height)};
}

std::vector<SeenWord> words_seen(tesseract::TessBaseAPI& tesseract, double scale,
                                 const Picture& picture) {
    std::vector<SeenWord> seen;
    const std::unique_ptr<tesseract::ResultIterator> at(tesseract.GetIterator());
    if (at == nullptr) return seen;
    bool begins_line = true;  // stays true if the line's first word is left out
    do {
        begins_line = begins_line || at->IsAtBeginningOf(tesseract::RIL_TEXTLINE);
        if (at->Empty(tesseract::RIL_WORD)) continue;
        const OwnedText text(at->GetUTF8Text(tesseract::RIL_WORD));
        const WordBox box = box_at(*at, scale, picture);
        if (text == nullptr || box.left >= box.right || box.top >= box.bottom) continue;
        const double confidence = at->Confidence(tesseract::RIL_WORD);
        seen.push_back({text.get(), confidence, box, std::exchange(begins_line, false)});
    } while (at->Next(tesseract::RIL_WORD));
    return seen;
}

std::string codes_of(const ReadingOrder& order) {
    std::string codes;
    for (const WrittenLanguage language : order.languages) {
        if (!codes.empty()) codes += '+';
        codes += code_of(language);
    }
    return codes;
}

tl::unexpected<Error> missing(WrittenLanguage language) {
    return failure("words in pictures cannot be read in " + std::string(name_of(language)) +
                   ": its data are missing; install the package tesseract-ocr-" +
                   std::string(code_of(language)));
}

/// Tesseract silently skips any missing language but the first.
Result<void> check_loaded(const tesseract::TessBaseAPI& tesseract, const ReadingOrder& order) {
    std::vector<std::string> loaded;
    tesseract.GetLoadedLanguagesAsVector(&loaded);
    for (const WrittenLanguage language : order.languages)
        if (std::ranges::count(loaded, code_of(language)) == 0) return missing(language);
    return {};
}

}  // namespace

WordReader::WordReader(std::unique_ptr<tesseract::TessBaseAPI> tesseract)
    : tesseract_(std::move(tesseract)) {}

WordReader::~WordReader() = default;
WordReader::WordReader(WordReader&& other) noexcept = default;
WordReader& WordReader::operator=(WordReader&& other) noexcept = default;

Result<WordReader> WordReader::load(const ReadingOrder& order) {
    setMsgSeverity(L_SEVERITY_NONE);
    auto tesseract = std::make_unique<tesseract::TessBaseAPI>();
    const bool is_ready =
        tesseract->Init(nullptr, codes_of(order).c_str(), tesseract::OEM_LSTM_ONLY) == 0;
    if (!is_ready || !tesseract->SetVariable(most_holes_setting, most_holes))
        return missing(order.languages.front());
    tesseract->SetPageSegMode(tesseract::PSM_SPARSE_TEXT);
    return check_loaded(*tesseract, order).map([&tesseract] {
        return WordReader(std::move(tesseract));
    });
}

Result<FoundWords> WordReader::read(const Picture& picture) {
    const double scale = scale_for(picture);
    OwnedPix grey = scaled(grey_of(picture), scale);
    if (grey == nullptr)
        return failure("the picture needs too much memory to be read; it is shown without words");
    grey = without_shapes(std::move(grey));
    tesseract_->SetImage(grey.get());
    tesseract_->SetSourceResolution(pixels_per_inch);
    if (tesseract_->Recognize(nullptr) != 0)
        return failure("the words in the picture cannot be read; it is shown without them");
    const auto seen = words_seen(*tesseract_, scale, picture);
    return decode::believed(seen, picture.width, picture.height);
}

}  // namespace touchline
