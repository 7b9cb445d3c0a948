#include "app/documents/decode/pdf_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

#include <glib.h>
#include <poppler/GfxFont.h>
#include <poppler/GlobalParams.h>
#include <poppler/PDFDoc.h>
#include <poppler/SplashOutputDev.h>
#include <poppler/Stream.h>
#include <poppler/splash/SplashBitmap.h>

namespace touchline::decode {
namespace {

constexpr std::size_t most_letters = 50'000;
constexpr std::size_t most_images = 1000;
constexpr double least_user_unit = 0.01;
constexpr double most_user_unit = 10'000.0;

SplashColorPtr white() {
    static std::array<SplashColor, 1> colour{{{255, 255, 255, 255}}};
    return colour[0];
}

/// True for arrows, frames, blocks, shapes, dingbats, and fonts' private characters.
bool draws(gunichar sign) {
    const bool is_shape = (sign >= 0x2190 && sign <= 0x21ff) ||
                          (sign >= 0x2300 && sign <= 0x23ff) ||
                          (sign >= 0x2500 && sign <= 0x27bf) || (sign >= 0x2b00 && sign <= 0x2bff);
    switch (g_unichar_type(sign)) {
        case G_UNICODE_OTHER_SYMBOL:
        case G_UNICODE_PRIVATE_USE:
        case G_UNICODE_UNASSIGNED:
        case G_UNICODE_CONTROL:
            return true;
        default:
            return is_shape || sign == '_';
    }
}

/// True for fonts that draw a picture for every letter of the alphabet.
bool is_of_pictures(const GfxFont& font) {
    std::string name = font.getName().value_or("");
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    constexpr std::array<std::string_view, 4> pictures{"wingdings", "webdings", "dingbats",
                                                       "marlett"};
    return std::ranges::any_of(pictures, [&name](std::string_view known) {
        return name.find(known) != std::string::npos;
    });
}

struct Extent {
    double above = 0.75;  // above the line, times the font's size
    double below = 0.25;
};

Extent extent_of(GfxFont& font) {
    constexpr double least = 0.1;
    constexpr double most = 1.5;
    Extent extent{font.getAscent(), -font.getDescent()};
    if (font.getType() == fontType3) {
        const auto& own = static_cast<Gfx8BitFont&>(font);
        extent = {own.getFontMatrix()[3] * own.getFontBBox()[3],
                  -own.getFontMatrix()[3] * own.getFontBBox()[1]};
    }
    if (!(extent.above >= least && extent.above <= most)) extent.above = Extent{}.above;
    if (!(extent.below >= 0.0 && extent.below <= most)) extent.below = Extent{}.below;
    return extent;
}

/// Draws only the letters, black on white, and records the places of letters and images.
class LetterDevice final : public SplashOutputDev {
  public:
    explicit LetterDevice(DrawnPage& found)
        : SplashOutputDev(splashModeMono8, 1, false, white()), found_(found) {}

    void drawChar(GfxState* state, double x, double y, double dx, double dy, double originX,
                  double originY, CharCode code, int nBytes, const Unicode* u, int uLen) override {
        if (in_mask_ > 0) return;
        // Draws letters without ink as if filled: a pattern may fill them, or they may clip a
        // picture.
        const int way_of_painting = state->getRender();
        const int ink = way_of_painting & 3;
        state->setRender(ink == 3 ? 0 : ink);
        SplashOutputDev::drawChar(state, x, y, dx, dy, originX, originY, code, nBytes, u, uLen);
        state->setRender(way_of_painting);
        keep(*state, {x, y}, {dx, dy}, {originX, originY}, {u, u + std::max(uLen, 0)},
             nBytes == 1 && code == ' ');
    }

    bool beginType3Char(GfxState* state, double x, double y, double dx, double dy, CharCode code,
                        const Unicode* u, int uLen) override {
        if (in_mask_ > 0) return true;
        keep(*state, {x, y}, {dx, dy}, {}, {u, u + std::max(uLen, 0)}, code == ' ');
        const bool is_drawn = SplashOutputDev::beginType3Char(state, x, y, dx, dy, code, u, uLen);
        if (!is_drawn) ++in_letter_;
        return is_drawn;
    }

    void endType3Char(GfxState* state) override {
        if (in_letter_ > 0) --in_letter_;
        SplashOutputDev::endType3Char(state);
    }

    // Draws only the strokes of letters that are drawings themselves.
    void stroke(GfxState* state) override {
        if (in_letter_ > 0) SplashOutputDev::stroke(state);
    }

    void fill(GfxState* state) override {
        if (in_letter_ > 0) SplashOutputDev::fill(state);
    }

    void eoFill(GfxState* state) override {
        if (in_letter_ > 0) SplashOutputDev::eoFill(state);
    }

    void drawImageMask(GfxState* state, Object* ref, Stream* stream, int width, int height,
                       bool invert, bool interpolate, bool is_inline) override {
        if (in_letter_ > 0)
            return SplashOutputDev::drawImageMask(state, ref, stream, width, height, invert,
                                                  interpolate, is_inline);
        keep_image(*state);
        OutputDev::drawImageMask(state, ref, stream, width, height, invert, interpolate, is_inline);
    }

    void drawImage(GfxState* state, Object* ref, Stream* stream, int width, int height,
                   GfxImageColorMap* colours, bool interpolate, const int* mask,
                   bool is_inline) override {
        keep_image(*state);
        OutputDev::drawImage(state, ref, stream, width, height, colours, interpolate, mask,
                             is_inline);
    }

    void drawMaskedImage(GfxState* state, Object*, Stream*, int, int, GfxImageColorMap*, bool,
                         Stream*, int, int, bool, bool) override {
        keep_image(*state);
    }

    void drawSoftMaskedImage(GfxState* state, Object*, Stream*, int, int, GfxImageColorMap*, bool,
                             Stream*, int, int, GfxImageColorMap*, bool) override {
        keep_image(*state);
    }

    void setSoftMaskFromImageMask(GfxState* state, Object* ref, Stream* stream, int width,
                                  int height, bool invert, bool is_inline, double*) override {
        OutputDev::drawImageMask(state, ref, stream, width, height, invert, false, is_inline);
    }

    void unsetSoftMaskFromImageMask(GfxState*, double*) override {}

    // Letters are black whatever their colour, and opaque.
    void updateFillColorSpace(GfxState*) override {}

    void updateStrokeColorSpace(GfxState*) override {}

    void updateFillColor(GfxState*) override {}

    void updateStrokeColor(GfxState*) override {}

    void updateBlendMode(GfxState*) override {}

    void updateFillOpacity(GfxState*) override {}

    void updateStrokeOpacity(GfxState*) override {}

    void updatePatternOpacity(GfxState*) override {}

    void clearPatternOpacity(GfxState*) override {}

    void updateTransfer(GfxState*) override {}

    // Patterns and shadings are no writing.
    bool useShadedFills(int) override { return true; }

    bool tilingPatternFill(GfxState*, Gfx*, Catalog*, GfxTilingPattern*, const double*, int, int,
                           int, int, double, double) override {
        return true;
    }

    bool functionShadedFill(GfxState*, GfxFunctionShading*) override { return true; }

    bool axialShadedFill(GfxState*, GfxAxialShading*, double, double) override { return true; }

    bool radialShadedFill(GfxState*, GfxRadialShading*, double, double) override { return true; }

    bool gouraudTriangleShadedFill(GfxState*, GfxGouraudTriangleShading*) override { return true; }

    bool patchMeshShadedFill(GfxState*, GfxPatchMeshShading*) override { return true; }

    // Draws the content of a group directly, and no content of a mask.
    bool checkTransparencyGroup(GfxState*, bool) override { return false; }

    void beginTransparencyGroup(GfxState*, const double*, GfxColorSpace*, bool, bool,
                                bool is_mask) override {
        groups_.push_back(is_mask);
        if (is_mask) ++in_mask_;
    }

    void endTransparencyGroup(GfxState*) override {
        if (groups_.empty()) return;
        if (groups_.back()) --in_mask_;
        groups_.pop_back();
    }

    void paintTransparencyGroup(GfxState*, const double*) override {}

    void setSoftMask(GfxState*, const double*, bool, Function*, GfxColor*) override {}

    void clearSoftMask(GfxState*) override {}

  private:
    /// A vector in the page's units, in pixels.
    static Place pixels(const GfxState& state, double x, double y) {
        const double* const m = state.getCTM();
        return {m[0] * x + m[2] * y, m[1] * x + m[3] * y};
    }

    /// A vector in the text's units, in pixels.
    static Place text_pixels(GfxState& state, double x, double y) {
        double to_x = 0.0;
        double to_y = 0.0;
        state.textTransformDelta(x, y, &to_x, &to_y);
        return pixels(state, to_x, to_y);
    }

    static Place pixel_at(const GfxState& state, const Place& place) {
        Place at = pixels(state, place.x, place.y);
        at.x += state.getCTM()[4];
        at.y += state.getCTM()[5];
        return at;
    }

    static TextBox around_cell(const Place& from, const Place& along, const Place& up,
                               const Place& down) {
        const auto [left, right] = std::minmax({0.0, along.x});
        const auto [top, bottom] = std::minmax({0.0, along.y});
        const auto [up_left, up_right] = std::minmax({up.x, down.x});
        const auto [up_top, up_bottom] = std::minmax({up.y, down.y});
        return {from.x + left + up_left, from.y + top + up_top, from.x + right + up_right,
                from.y + bottom + up_bottom};
    }

    void keep(GfxState& state, const Place& place, Place advance, const Place& origin,
              std::vector<Unicode> signs, bool is_code_of_blank) {
        if (found_.letters.size() >= most_letters || state.getFont() == nullptr) return;
        GfxFont& face = *state.getFont();
        const bool is_vertical = face.getWMode() != 0;
        const double size = state.getFontSize();
        const double spacing =
            state.getCharSpace() + (is_code_of_blank ? state.getWordSpace() : 0.0);
        double spacing_x = 0.0;
        double spacing_y = 0.0;
        state.textTransformDelta(is_vertical ? 0.0 : spacing * state.getHorizScaling(),
                                 is_vertical ? spacing : 0.0, &spacing_x, &spacing_y);
        advance = {advance.x - spacing_x, advance.y - spacing_y};
        const Extent extent = extent_of(face);
        DrawnLetter letter;
        letter.at = pixel_at(state, place);
        const Place way = pixels(state, advance.x, advance.y);
        letter.next = {letter.at.x + way.x, letter.at.y + way.y};
        letter.up = text_pixels(state, 0.0, size * extent.above);
        const Place down = text_pixels(state, 0.0, -size * extent.below);
        letter.box =
            around_cell(pixel_at(state, {place.x - origin.x, place.y - origin.y}),
                        is_vertical ? text_pixels(state, size * state.getHorizScaling(), 0.0) : way,
                        letter.up, down);
        letter.is_sign = is_of_pictures(face) || signs.empty();
        for (const Unicode sign : signs) {
            if (!g_unichar_validate(sign)) continue;
            letter.is_sign = letter.is_sign || (draws(sign) && !g_unichar_isspace(sign));
            std::array<char, 6> utf8{};
            letter.text.append(utf8.data(),
                               static_cast<std::size_t>(g_unichar_to_utf8(sign, utf8.data())));
        }
        const TextBox& box = letter.box;
        if (std::isfinite(box.left + box.right + box.top + box.bottom))
            found_.letters.push_back(std::move(letter));
    }

    /// Keeps the visible part of the unit square within its clip.
    void keep_image(const GfxState& state) {
        if (in_mask_ > 0 || found_.images.size() >= most_images) return;
        const Place corner = pixel_at(state, {});
        TextBox box = around_cell(corner, pixels(state, 1.0, 0.0), pixels(state, 0.0, 1.0), {});
        TextBox clip;
        state.getClipBBox(&clip.left, &clip.top, &clip.right, &clip.bottom);
        box = {std::max(box.left, clip.left), std::max(box.top, clip.top),
               std::min(box.right, clip.right), std::min(box.bottom, clip.bottom)};
        if (box.left < box.right && box.top < box.bottom) found_.images.push_back(box);
    }

    DrawnPage& found_;
    std::vector<bool> groups_;  // for each open group: is it a mask?
    int in_mask_ = 0;
    int in_letter_ = 0;
};

LetterInk ink_of(SplashBitmap& drawn) {
    LetterInk ink{drawn.getWidth(), drawn.getHeight(), {}};
    ink.cover.reserve(static_cast<std::size_t>(ink.width) * static_cast<std::size_t>(ink.height));
    const unsigned char* row = drawn.getDataPtr();
    for (int y = 0; y < ink.height; ++y, row += drawn.getRowSize())
        for (int x = 0; x < ink.width; ++x)
            ink.cover.push_back(static_cast<std::uint8_t>(255 - row[x]));
    return ink;
}

}  // namespace

/// The first user makes poppler's tables, the last one removes them.
class PopplerParameters {
  public:
    PopplerParameters() : held_([](ErrorCategory, Goffset, const char*) {}) {}

  private:
    GlobalParamsIniter held_;
};

void prepare_pdf() {
    static const PopplerParameters for_good;
}

struct PdfProgram::Inside {
    explicit Inside(Bytes pdf)
        : document(new MemStream(reinterpret_cast<const char*>(pdf.data()), 0,
                                 static_cast<Goffset>(pdf.size()), Object(objNull))) {}

    PopplerParameters parameters;
    PDFDoc document;
};

PdfProgram::PdfProgram(Bytes pdf) : inside_(std::make_unique<Inside>(pdf)) {}

PdfProgram::~PdfProgram() = default;

double PdfProgram::user_unit(int page) {
    PDFDoc& document = inside_->document;
    if (!document.isOk()) return 1.0;
    const Ref* const place = document.getCatalog()->getPageRef(page);
    if (place == nullptr) return 1.0;
    const Object found = document.getXRef()->fetch(*place);
    if (!found.isDict()) return 1.0;
    const Object unit = found.dictLookup("UserUnit");
    const double value = unit.isNum() ? unit.getNum() : 1.0;
    return value >= least_user_unit && value <= most_user_unit ? value : 1.0;
}

DrawnPage PdfProgram::drawn(int page, double scale) {
    DrawnPage found;
    if (!inside_->document.isOk()) return found;
    LetterDevice device(found);
    device.startDoc(&inside_->document);
    const double dpi = 72.0 * scale;
    inside_->document.displayPage(&device, page, dpi, dpi, 0, false, true, false);
    if (SplashBitmap* const drawn = device.getBitmap()) found.ink = ink_of(*drawn);
    return found;
}

}  // namespace touchline::decode
