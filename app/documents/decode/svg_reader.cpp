// An SVG as a picture of pixels. librsvg opens no other file as long as it has no base address; it
// has no scripts, animation or network, and it bounds its own nesting.
#include "app/documents/decode/drawing_surface.h"
#include "app/documents/decode/map_svg.h"
#include "app/documents/decode/one_line.h"
#include "app/documents/decode/page.h"
#include "app/documents/decode/readers.h"
#include "app/documents/decode/svg_nodes.h"
#include "app/documents/decode/svg_survey.h"
#include "config/types/map_bytes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glib.h>
#include <librsvg/rsvg.h>
#include <pugixml.hpp>
#include <zlib.h>

namespace touchline::decode {
namespace {

/// A <text> that can be found by its id.
struct SvgText {
    std::string words;
    std::string id;
};

struct SvgWithTexts {
    std::string svg;  // every <text> has an id
    std::vector<SvgText> texts;
};

/// True for elements whose content is painted elsewhere, or nowhere.
bool is_apart(std::string_view name) {
    constexpr std::array<std::string_view, 5> apart{"defs", "symbol", "clipPath", "mask",
                                                    "pattern"};
    return std::ranges::find(apart, name) != apart.end();
}

class Collector {
  public:
    explicit Collector(std::string_view svg) : svg_(svg) {}

    SvgWithTexts collected(const pugi::xml_node& root) {
        walk(root, 0);
        made_.svg.append(svg_.substr(copied_));
        return std::move(made_);
    }

  private:
    void walk(const pugi::xml_node& parent, int depth) {
        if (depth > max_nesting) return;
        for (const pugi::xml_node& element : parent.children()) {
            if (element.type() != pugi::node_element || is_hidden(element)) continue;
            const std::string_view name = local_name(element);
            if (name == "text") take(element);
            if (name != "text" && !is_apart(name)) walk(element, depth + 1);
        }
    }

    void take(const pugi::xml_node& element) {
        std::string words = words_of_text(element, {});
        if (words.empty() || made_.texts.size() >= max_word_boxes) return;
        std::string id = element.attribute("id").value();
        if (id.empty()) {
            id = fmt::format("touchline-text-{}", made_.texts.size() + 1);
            if (!insert_id(element, id)) return;
        }
        made_.texts.push_back({std::move(words), std::move(id)});
    }

    /// Inserts it behind the element's name, so that all else stays as written.
    bool insert_id(const pugi::xml_node& element, const std::string& id) {
        const std::string_view name = element.name();
        const auto at =
            static_cast<std::size_t>(std::max<std::ptrdiff_t>(element.offset_debug(), 0));
        if (at < copied_ || at == 0 || at + name.size() > svg_.size()) return false;
        if (svg_[at - 1] != '<' || svg_.substr(at, name.size()) != name) return false;
        made_.svg.append(svg_.substr(copied_, at + name.size() - copied_));
        made_.svg += fmt::format(" id=\"{}\"", id);
        copied_ = at + name.size();
        return true;
    }

    std::string_view svg_;
    std::size_t copied_ = 0;
    SvgWithTexts made_;
};

/// Gives at most max_word_boxes texts ids. A document that cannot be parsed comes back unchanged.
/// O(text).
SvgWithTexts with_ids(std::string_view svg) {
    pugi::xml_document document;
    const pugi::xml_node root = svg_root_in(svg, document);
    if (!root) return {std::string(svg), {}};
    return Collector(svg).collected(root);
}

/// The box of the painted text in a picture that fills `viewport`; nothing if none of it is
/// painted.
std::optional<TextBox> box_of(RsvgHandle* handle, const SvgText& text,
                              const RsvgRectangle& viewport) {
    RsvgRectangle ink{};
    GError* problem = nullptr;
    const gboolean is_known = rsvg_handle_get_geometry_for_layer(
        handle, ("#" + text.id).c_str(), &viewport, &ink, nullptr, &problem);
    const GlibError frees(problem);
    if (is_known == 0 || !(ink.width > 0.0 && ink.height > 0.0)) return std::nullopt;
    return TextBox{ink.x, ink.y, ink.x + ink.width, ink.y + ink.height};
}

constexpr std::size_t most_text_bytes = std::size_t{64} << 20U;

bool is_packed(Bytes bytes) {
    return bytes.size() > 2 && bytes[0] == std::byte{0x1f} && bytes[1] == std::byte{0x8b};
}

Result<std::string> unpacked(Bytes bytes) {
    constexpr int gzip = 15 + 16;  // zlib's code for its largest window and a gzip header
    z_stream stream{};
    if (inflateInit2(&stream, gzip) != Z_OK) return damaged("SVG", "it cannot be unpacked");
    const Owned<z_stream, inflateEnd> ends(&stream);
    // zlib does not write to its input.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    std::string text;
    std::array<char, 65536> part{};
    for (int status = Z_OK; status != Z_STREAM_END;) {
        stream.next_out = reinterpret_cast<Bytef*>(part.data());
        stream.avail_out = part.size();
        status = inflate(&stream, Z_NO_FLUSH);
        if (status != Z_OK && status != Z_STREAM_END)
            return damaged("SVG", "it cannot be unpacked");
        text.append(part.data(), part.size() - stream.avail_out);
        if (text.size() > most_text_bytes)
            return failure("the SVG picture is too large when unpacked; save it as PNG");
    }
    return text;
}

/// Drops the declaration of the encoding, which has changed.
Result<std::string> narrowed(std::string_view text) {
    const std::size_t low = text.starts_with("\xfe\xff") ? 1 : 0;
    std::vector<gunichar2> units;
    for (std::size_t i = 2; i + 1 < text.size(); i += 2)
        units.push_back(
            static_cast<gunichar2>(static_cast<unsigned char>(text[i + low]) |
                                   static_cast<unsigned char>(text[i + 1 - low]) << 8U));
    glong length = 0;
    const GlibText utf8(
        g_utf16_to_utf8(units.data(), static_cast<glong>(units.size()), nullptr, &length, nullptr));
    if (utf8 == nullptr) return damaged("SVG", "its letters cannot be read");
    const std::string_view all(utf8.get(), static_cast<std::size_t>(length));
    const auto end = all.starts_with("<?xml") ? all.find("?>") : std::string_view::npos;
    return std::string(end == std::string_view::npos ? all : all.substr(end + 2));
}

/// The SVG's text in UTF-8, or in the one-byte encoding that the file declares. Unpacks gzip;
/// converts UTF-16 to UTF-8 and drops its declaration. Fails with one line if the file is damaged,
/// is more than 64 MB unpacked, or is no SVG. O(text).
Result<std::string> svg_text(Bytes bytes) {
    Result<std::string> text = is_packed(bytes) ? unpacked(bytes) : std::string(as_text(bytes));
    if (!text) return text;
    const Bytes unpacked_bytes = std::as_bytes(std::span(*text));
    if (is_packed(unpacked_bytes) || format_of(unpacked_bytes) != FileFormat::svg)
        return not_a_picture(FileFormat::archive);
    if (text->starts_with("\xff\xfe") || text->starts_with("\xfe\xff")) return narrowed(*text);
    return text;
}

/// A document's viewport, and the part of it that becomes the picture.
struct Framing {
    RsvgRectangle viewport{};
    RsvgRectangle shown{};
    double px_per_unit = 0.0;  // of the viewport

    [[nodiscard]] int width_px() const { return side(shown.width); }

    [[nodiscard]] int height_px() const { return side(shown.height); }

  private:
    [[nodiscard]] int side(double length) const {
        return std::max(1, static_cast<int>(std::lround(px_per_unit * length)));
    }
};

/// A document without a size shows its viewBox, or else everything painted, with a margin.
std::optional<Framing> framing_of_unsized(RsvgHandle* handle) {
    gboolean has_box = 0;
    RsvgRectangle box{};
    rsvg_handle_get_intrinsic_dimensions(handle, nullptr, nullptr, nullptr, nullptr, &has_box,
                                         &box);
    if (has_box != 0) {
        const RsvgRectangle whole{0.0, 0.0, box.width, box.height};
        return Framing{whole, whole};
    }
    constexpr double margin_share = 0.03;
    RsvgRectangle ink{};
    if (rsvg_handle_get_geometry_for_element(handle, nullptr, &ink, nullptr, nullptr) == 0)
        return std::nullopt;
    const double margin = margin_share * std::max(ink.width, ink.height);
    return Framing{
        {0.0, 0.0, ink.x + ink.width, ink.y + ink.height},
        {ink.x - margin, ink.y - margin, ink.width + 2.0 * margin, ink.height + 2.0 * margin}};
}

/// The longer side becomes svg_longer_side_px long. Nothing for a document without a size.
std::optional<Framing> framing_of(RsvgHandle* handle) {
    double width = 0.0;
    double height = 0.0;
    const bool is_sized = rsvg_handle_get_intrinsic_size_in_pixels(handle, &width, &height) != 0;
    const RsvgRectangle whole{0.0, 0.0, width, height};
    auto framing = is_sized ? Framing{whole, whole} : framing_of_unsized(handle);
    if (!framing) return framing;
    const double longer = std::max(framing->shown.width, framing->shown.height);
    if (!(framing->shown.width > 0.0 && framing->shown.height > 0.0 && std::isfinite(longer)))
        return std::nullopt;
    framing->px_per_unit = svg_longer_side_px / longer;
    return framing;
}

TactileMap told_by(std::string_view text, const Picture& picture, const LanguageTag& language) {
    if (auto own = parse_own_map(text, Area{}, language);
        own && point_count(*own) <= MapLimits::points)
        return std::move(*own);
    TactileMap told;
    told.area = told_area(picture);
    SvgWords words = words_of_svg(text, language);
    told.title = of_a_person(std::move(words.title));
    told.description = of_a_person(std::move(words.description));
    return told;
}

void add_texts(RsvgHandle* handle, const std::vector<SvgText>& texts, const Framing& framing,
               Page& page) {
    const Picture& picture = page.picture;
    for (const SvgText& text : texts) {
        const auto box = box_of(handle, text, framing.viewport);
        if (!box) continue;
        const auto x_px = [&](double x) { return framing.px_per_unit * (x - framing.shown.x); };
        const auto y_px = [&](double y) { return framing.px_per_unit * (y - framing.shown.y); };
        const auto word = pixels_within(
            {x_px(box->left), y_px(box->top), x_px(box->right), y_px(box->bottom)}, picture);
        if (!word) continue;
        page.words.push_back(*word);
        page.told.labels.push_back(
            {text.words, told_place(picture, 0.5 * (word->left + word->right),
                                    0.5 * (word->top + word->bottom))});
    }
}

tl::unexpected<Error> told(const GlibError& error) {
    return damaged("SVG", error != nullptr ? error->message : "it cannot be drawn");
}

}  // namespace

Result<Page> read_svg(Bytes bytes, const PageOrder& order) {
    if (order.page != 1) return failure("the file has one page only");
    const auto text = svg_text(bytes);
    if (!text) return tl::unexpected(text.error());
    if (drawn_again(*text) > most_drawn_again)
        return failure("the SVG picture repeats its parts too often; save it as PNG");
    const SvgWithTexts source = with_ids(*text);
    GError* problem = nullptr;
    const Owned<RsvgHandle, g_object_unref> handle(rsvg_handle_new_from_data(
        reinterpret_cast<const guint8*>(source.svg.data()), source.svg.size(), &problem));
    if (handle == nullptr) return told(GlibError(problem));
    constexpr double css_pixels_per_inch = 96.0;  // as in CSS
    rsvg_handle_set_dpi(handle.get(), css_pixels_per_inch);
    const auto framing = framing_of(handle.get());
    if (!framing) return damaged("SVG", "nothing is painted, or it has no size");
    if (auto fits = check_size("SVG", framing->width_px(), framing->height_px()); !fits)
        return tl::unexpected(fits.error());
    const DrawingSurface sheet(framing->width_px(), framing->height_px());
    cairo_scale(sheet.context(), framing->px_per_unit, framing->px_per_unit);
    cairo_translate(sheet.context(), -framing->shown.x, -framing->shown.y);
    if (rsvg_handle_render_document(handle.get(), sheet.context(), &framing->viewport, &problem) ==
        0)
        return told(GlibError(problem));
    return sheet.picture().map([&](Picture picture) {
        Page page;
        page.picture = std::move(picture);
        page.told = told_by(*text, page.picture, order.language);
        if (page.told.outlines.empty()) add_texts(handle.get(), source.texts, *framing, page);
        return page;
    });
}

}  // namespace touchline::decode
