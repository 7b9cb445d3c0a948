#include "app/documents/decode/svg_nodes.h"

#include "config/types/angle.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>

namespace touchline::decode {
namespace {

constexpr std::string_view space = " \t\r\n";

/// Takes texts with their tags one by one and keeps the one that serves a language best: one with
/// the same tag, else of the same language ("de" for "de-AT" and the other way round), else without
/// a tag, else any. Among equals the first counts. Ignores the case of tags.
class BestWords {
  public:
    explicit BestWords(const LanguageTag& wanted)
        : wanted_(wanted.text.empty() ? LanguageTag{}.text : in_small_letters(wanted.text)) {}

    /// O(tag + text). Ignores an empty text.
    void offer(std::string_view tag, std::string text) {
        const int rank = rank_of(tag);
        if (text.empty() || rank <= rank_) return;
        best_ = std::move(text);
        rank_ = rank;
    }

    /// Offers every child of this name.
    void offer_children(const pugi::xml_node& parent, std::string_view name) {
        for (const pugi::xml_node& child : parent.children())
            if (child.type() == pugi::node_element && local_name(child) == name)
                offer(tag_of(child), text_of(child));
    }

    [[nodiscard]] std::string take() { return std::move(best_); }

  private:
    [[nodiscard]] int rank_of(std::string_view tag) const {
        if (tag.empty()) return 1;
        const std::string has = in_small_letters(tag);
        if (has == wanted_) return 3;
        return language_in(has) == language_in(wanted_) ? 2 : 0;
    }

    std::string wanted_;
    std::string best_;
    int rank_ = -1;
};

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

struct Arguments {
    std::array<double, 6> value{};
    std::size_t count = 0;
};

std::optional<Arguments> take_arguments(SvgScanner& scanner) {
    Arguments arguments;
    scanner.skip_space();
    if (scanner.take() != '(') return std::nullopt;
    scanner.skip_space();
    while (scanner.peek() != ')') {
        const auto number = scanner.take_number();
        if (!number || arguments.count == arguments.value.size()) return std::nullopt;
        arguments.value[arguments.count++] = *number;
    }
    scanner.take();
    return arguments;
}

Affine rotation(double angle_deg, double x, double y) {
    const double cosine = std::cos(radians(angle_deg));
    const double sine = std::sin(radians(angle_deg));
    const Affine turn{cosine, sine, -sine, cosine, 0.0, 0.0};
    return Affine{1, 0, 0, 1, x, y} * turn * Affine{1, 0, 0, 1, -x, -y};
}

std::optional<Affine> take_one(SvgScanner& scanner) {
    constexpr std::array names{"matrix", "translate", "scale", "rotate", "skewX", "skewY"};
    const auto* const found =
        std::ranges::find_if(names, [&](const char* name) { return scanner.take_word(name); });
    const auto arguments = take_arguments(scanner);
    if (found == names.end() || !arguments) return std::nullopt;
    const auto& v = arguments->value;
    const auto is = [&](std::string_view name, std::size_t count) {
        return *found == name && arguments->count == count;
    };
    if (is("matrix", 6)) return Affine{v[0], v[1], v[2], v[3], v[4], v[5]};
    if (is("translate", 1) || is("translate", 2)) return Affine{1, 0, 0, 1, v[0], v[1]};
    if (is("scale", 1)) return Affine{v[0], 0, 0, v[0], 0, 0};
    if (is("scale", 2)) return Affine{v[0], 0, 0, v[1], 0, 0};
    if (is("rotate", 1) || is("rotate", 3)) return rotation(v[0], v[1], v[2]);
    if (is("skewX", 1)) return Affine{1, 0, std::tan(radians(v[0])), 1, 0, 0};
    if (is("skewY", 1)) return Affine{1, std::tan(radians(v[0])), 0, 1, 0, 0};
    return std::nullopt;
}

}  // namespace

std::string_view local_name(const pugi::xml_node& element) {
    const std::string_view name = element.name();
    const auto colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

bool is_shape(std::string_view name) {
    constexpr std::array<std::string_view, 7> shapes{"path", "polyline", "polygon", "line",
                                                     "rect", "circle",   "ellipse"};
    return std::ranges::find(shapes, name) != shapes.end();
}

pugi::xml_node svg_root_in(std::string_view text, pugi::xml_document& document) {
    if (!document.load_buffer(text.data(), text.size())) return {};
    return child_named(document, "svg");
}

bool is_in_millimetres(const pugi::xml_node& root, double width_mm, double height_mm,
                       const Area& area) {
    const std::string_view width = root.attribute("width").value();
    return width.ends_with("mm") &&
           parse_svg_length(width.substr(0, width.size() - 2)) == width_mm &&
           width_mm <= 1000.0 * area.width_m + 1e-9 && height_mm <= 1000.0 * area.height_m + 1e-9;
}

pugi::xml_node child_named(const pugi::xml_node& parent, std::string_view name) {
    return parent.find_child([&](const pugi::xml_node& child) {
        return child.type() == pugi::node_element && local_name(child) == name;
    });
}

void append_words(std::string& text, std::string_view more) {
    for (auto begin = more.find_first_not_of(space); begin != std::string_view::npos;) {
        const auto end = std::min(more.find_first_of(space, begin), more.size());
        if (!text.empty()) text += ' ';
        text += more.substr(begin, end - begin);
        begin = more.find_first_not_of(space, end);
    }
}

/// Walks without recursion, because the nesting comes from the file.
std::string text_of(pugi::xml_node element) {
    constexpr int nowhere = std::numeric_limits<int>::max();

    struct Collector : pugi::xml_tree_walker {
        bool for_each(pugi::xml_node& node) override {
            if (depth() > told_depth) return true;  // inside a title
            const std::string_view name = local_name(node);
            told_depth = name == "title" || name == "desc" ? depth() : nowhere;
            const bool is_text =
                node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
            if (is_text) append_words(text, node.value());
            return true;
        }

        std::string text;
        int told_depth = nowhere;
    } collector;

    element.traverse(collector);
    return std::move(collector.text);
}

std::string_view property_of(const pugi::xml_node& element, const char* name) {
    std::string_view style = element.attribute("style").value();
    while (!style.empty()) {
        const auto end = std::min(style.find(';'), style.size());
        const std::string_view entry = style.substr(0, end);
        const auto colon = entry.find(':');
        if (colon != std::string_view::npos && trimmed(entry.substr(0, colon), space) == name)
            return trimmed(entry.substr(colon + 1), space);
        style.remove_prefix(std::min(end + 1, style.size()));
    }
    return trimmed(element.attribute(name).value(), space);
}

bool is_hidden(const pugi::xml_node& element) {
    return property_of(element, "display").starts_with("none");
}

std::string_view tag_of(const pugi::xml_node& element) {
    const auto attribute = element.attribute("xml:lang");
    return attribute ? attribute.value() : element.attribute("lang").value();
}

std::string words_in(const pugi::xml_node& parent, std::string_view name,
                     const LanguageTag& language) {
    BestWords best(language);
    best.offer_children(parent, name);
    return best.take();
}

std::string words_of_shape(const pugi::xml_node& shape, const LanguageTag& language) {
    std::string label;
    append_words(label, shape.attribute("data-label").value());
    BestWords best(language);
    best.offer({}, std::move(label));
    best.offer_children(shape, "title");
    return best.take();
}

std::string words_of_text(const pugi::xml_node& text, const LanguageTag& language) {
    BestWords best(language);
    best.offer(tag_of(text), text_of(text));
    best.offer_children(text, "title");
    return best.take();
}

void SvgScanner::skip_space() {
    while (is_space(peek())) ++position_;
}

void SvgScanner::skip_separator() {
    skip_space();
    if (peek() != ',') return;
    ++position_;
    skip_space();
}

bool SvgScanner::take_word(std::string_view word) {
    if (!text_.substr(position_).starts_with(word)) return false;
    position_ += word.size();
    return true;
}

std::optional<double> SvgScanner::take_number() {
    std::string_view rest = text_.substr(position_);
    const bool has_plus = rest.starts_with('+');  // from_chars accepts only the minus
    if (has_plus) rest.remove_prefix(1);
    const std::string_view digits = !has_plus && rest.starts_with('-') ? rest.substr(1) : rest;
    // from_chars would take "inf" and "nan" as well.
    if (digits.empty() || !(is_digit(digits[0]) || digits[0] == '.')) return std::nullopt;
    double value = 0.0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
    position_ = static_cast<std::size_t>(end - text_.data());
    skip_separator();
    return value;
}

std::optional<double> SvgScanner::take_flag() {
    const char c = peek();
    if (c != '0' && c != '1') return std::nullopt;
    ++position_;
    skip_separator();
    return c == '1' ? 1.0 : 0.0;
}

std::optional<double> parse_svg_length(std::string_view text) {
    SvgScanner scanner(text);
    scanner.skip_space();
    const auto value = scanner.take_number();
    if (!value) return std::nullopt;
    scanner.take_word("px");
    scanner.skip_space();
    return scanner.is_at_end() ? value : std::nullopt;
}

double Affine::stretch() const {
    return (std::hypot(a + d, b - c) + std::hypot(a - d, b + c)) / 2.0;
}

Affine operator*(const Affine& outer, const Affine& inner) {
    const UserPoint origin = outer({inner.e, inner.f});
    return {outer.a * inner.a + outer.c * inner.b,
            outer.b * inner.a + outer.d * inner.b,
            outer.a * inner.c + outer.c * inner.d,
            outer.b * inner.c + outer.d * inner.d,
            origin.x,
            origin.y};
}

std::optional<Affine> parse_svg_transform(std::string_view text) {
    SvgScanner scanner(text);
    Affine all;
    scanner.skip_space();
    while (!scanner.is_at_end()) {
        const auto one = take_one(scanner);
        if (!one) return std::nullopt;
        all = all * *one;
        scanner.skip_separator();
    }
    return all;
}

}  // namespace touchline::decode
