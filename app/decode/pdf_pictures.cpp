// The pictures of a page, each as one box, without mere decoration.
#include "app/decode/page.h"
#include "app/decode/pdf_parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchline::decode {
namespace {

constexpr double least_side_pt = 28.0;  // 1 cm
constexpr double fills_page = 0.9;      // of the page's area: a scan of it, or its background
constexpr double touching_pt = 1.0;
constexpr std::size_t most_parts = 1000;

bool is_finite(const PopplerRectangle& box) {
    return std::isfinite(box.x1) && std::isfinite(box.y1) && std::isfinite(box.x2) &&
           std::isfinite(box.y2);
}

PopplerRectangle on_page(const PopplerRectangle& box, const PageSize& page) {
    return {std::clamp(std::min(box.x1, box.x2), 0.0, page.width_pt),
            std::clamp(std::min(box.y1, box.y2), 0.0, page.height_pt),
            std::clamp(std::max(box.x1, box.x2), 0.0, page.width_pt),
            std::clamp(std::max(box.y1, box.y2), 0.0, page.height_pt)};
}

bool touch(const PopplerRectangle& a, const PopplerRectangle& b) {
    return a.x1 <= b.x2 + touching_pt && b.x1 <= a.x2 + touching_pt && a.y1 <= b.y2 + touching_pt &&
           b.y1 <= a.y2 + touching_pt;
}

bool fills(const PopplerRectangle& box, const PageSize& page) {
    return (box.x2 - box.x1) * (box.y2 - box.y1) >= fills_page * page.width_pt * page.height_pt;
}

bool decorates(const PopplerRectangle& box) {
    return std::min(box.x2 - box.x1, box.y2 - box.y1) < least_side_pt;
}

void absorb(PdfText& whole, const PdfText& part) {
    whole.box = {std::min(whole.box.x1, part.box.x1), std::min(whole.box.y1, part.box.y1),
                 std::max(whole.box.x2, part.box.x2), std::max(whole.box.y2, part.box.y2)};
    if (part.text.empty() || whole.text.find(part.text) != std::string::npos) return;
    if (!whole.text.empty()) whole.text += ' ';
    whole.text += part.text;
}

/// Joins each part to the first that it touches.
std::vector<PdfText> joined_once(const std::vector<PdfText>& parts) {
    std::vector<PdfText> wholes;
    for (const PdfText& part : parts) {
        const auto whole = std::find_if(wholes.begin(), wholes.end(), [&part](const PdfText& one) {
            return touch(one.box, part.box);
        });
        if (whole == wholes.end()) {
            wholes.push_back(part);
        } else {
            absorb(*whole, part);
        }
    }
    return wholes;
}

/// Programs cut a picture into strips, and draw its mask over it, so this joins all of them.
std::vector<PdfText> joined(std::vector<PdfText> parts) {
    for (std::size_t before = parts.size() + 1; parts.size() < before;) {
        before = parts.size();
        parts = joined_once(parts);
    }
    return parts;
}

}  // namespace

std::vector<PdfText> pictures_in(std::vector<PdfText> parts, const PageSize& page) {
    if (parts.size() > most_parts) parts.resize(most_parts);
    std::erase_if(parts, [](const PdfText& part) { return !is_finite(part.box); });
    for (PdfText& part : parts) part.box = on_page(part.box, page);
    std::erase_if(parts, [&page](const PdfText& part) {
        return fills(part.box, page) || !(part.box.x1 < part.box.x2 && part.box.y1 < part.box.y2);
    });
    std::vector<PdfText> pictures = joined(std::move(parts));
    std::erase_if(pictures, [&page](const PdfText& picture) {
        return decorates(picture.box) || fills(picture.box, page);
    });
    std::sort(pictures.begin(), pictures.end(), [](const PdfText& a, const PdfText& b) {
        return std::pair(a.box.y1, a.box.x1) < std::pair(b.box.y1, b.box.x1);
    });
    if (pictures.size() > max_figures) pictures.resize(max_figures);
    return pictures;
}

}  // namespace touchline::decode
