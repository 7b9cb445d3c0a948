#include "tests/app/sheets/rendered_page.h"

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include <cairo.h>
#include <liblouis/liblouis.h>
#include <opencv2/imgproc.hpp>
#include <poppler.h>

namespace touchline {
namespace {

constexpr double mm_per_inch = 25.4;
constexpr double points_per_inch = 72.0;

struct ReleaseObject {
    void operator()(void* object) const { g_object_unref(object); }
};

using Document = std::unique_ptr<PopplerDocument, ReleaseObject>;
using DocumentPage = std::unique_ptr<PopplerPage, ReleaseObject>;

Document opened(std::span<const std::byte> pdf) {
    GBytes* const bytes = g_bytes_new(pdf.data(), pdf.size());
    GError* error = nullptr;
    Document document(poppler_document_new_from_bytes(bytes, nullptr, &error));
    g_bytes_unref(bytes);
    if (!document) throw std::runtime_error("no PDF");
    return document;
}

}  // namespace

cv::Point InkPage::pixel(PaperPoint p) const {
    return {static_cast<int>(std::floor(p.x_mm * px_per_mm)),
            static_cast<int>(std::floor(p.y_mm * px_per_mm))};
}

cv::Rect InkPage::pixels(const PaperBox& box) const {
    const cv::Point low = pixel({box.left_mm, box.top_mm});
    const cv::Point high = pixel({box.right_mm, box.bottom_mm});
    return {low, high + cv::Point(1, 1)};
}

InkPage rendered(std::span<const std::byte> pdf, int index, double dpi) {
    const Document document = opened(pdf);
    const DocumentPage page(poppler_document_get_page(document.get(), index));
    if (!page) throw std::runtime_error("no such page");
    double width = 0.0;
    double height = 0.0;
    poppler_page_get_size(page.get(), &width, &height);
    const double scale = dpi / points_per_inch;
    const cv::Size size(static_cast<int>(std::lround(width * scale)),
                        static_cast<int>(std::lround(height * scale)));
    cv::Mat4b pixels(size, cv::Vec4b(255, 255, 255, 255));
    cairo_surface_t* const surface =
        cairo_image_surface_create_for_data(pixels.data, CAIRO_FORMAT_ARGB32, size.width,
                                            size.height, static_cast<int>(pixels.step[0]));
    cairo_t* const cr = cairo_create(surface);
    cairo_scale(cr, scale, scale);
    poppler_page_render_for_printing(page.get(), cr);
    cairo_destroy(cr);
    cairo_surface_finish(surface);
    cairo_surface_destroy(surface);
    cv::Mat1b blue;
    cv::extractChannel(pixels, blue, 0);
    InkPage page_of_ink{{}, dpi / mm_per_inch};
    cv::threshold(blue, page_of_ink.ink, 127.0, 255.0, cv::THRESH_BINARY_INV);
    return page_of_ink;
}

int page_count(std::span<const std::byte> pdf) {
    return poppler_document_get_n_pages(opened(pdf).get());
}

PaperSize page_size(std::span<const std::byte> pdf) {
    const Document document = opened(pdf);
    const DocumentPage page(poppler_document_get_page(document.get(), 0));
    PaperSize size;
    poppler_page_get_size(page.get(), &size.width_mm, &size.height_mm);
    size.width_mm *= mm_per_inch / points_per_inch;
    size.height_mm *= mm_per_inch / points_per_inch;
    return size;
}

double least_gap_mm(const InkPage& page) {
    // Each white pixel belongs to its nearest piece; where two pieces' white meets, the way across
    // is the sum of both distances.
    cv::Mat1i pieces;
    if (cv::connectedComponents(page.ink, pieces, 8, CV_32S) < 3)
        return std::numeric_limits<double>::infinity();
    cv::Mat1f far;
    cv::Mat1i owners;
    cv::Mat1b paper;
    cv::bitwise_not(page.ink, paper);
    cv::distanceTransform(paper, far, owners, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_CCOMP);
    double least_px = std::numeric_limits<double>::infinity();
    for (int y = 0; y + 1 < far.rows; ++y)
        for (int x = 0; x + 1 < far.cols; ++x)
            for (const cv::Point other : {cv::Point(x + 1, y), cv::Point(x, y + 1)})
                if (owners(y, x) != owners(other))
                    least_px = std::min<double>(least_px, far(y, x) + far(other));
    return least_px / page.px_per_mm;
}

std::vector<PaperPoint> dots_on(const InkPage& page) {
    cv::Mat1i pieces;
    cv::Mat1i facts;
    cv::Mat1d middles;
    const int count = cv::connectedComponentsWithStats(page.ink, pieces, facts, middles, 8);
    const double side_px = braille_dot_mm * page.px_per_mm;
    std::vector<PaperPoint> dots;
    for (int i = 1; i < count; ++i) {
        const int wide = facts(i, cv::CC_STAT_WIDTH);
        const int high = facts(i, cv::CC_STAT_HEIGHT);
        if (std::abs(wide - side_px) > 2.5 || std::abs(high - side_px) > 2.5) continue;
        dots.push_back(
            {(middles(i, 0) + 0.5) / page.px_per_mm, (middles(i, 1) + 0.5) / page.px_per_mm});
    }
    return dots;
}

std::vector<std::uint8_t> read_row(const std::vector<PaperPoint>& dots, PaperPoint first_dot,
                                   std::size_t cells, std::vector<int>& used) {
    constexpr double nearest_mm = 0.3;
    std::vector<std::uint8_t> read(cells, 0);
    for (std::size_t i = 0; i < dots.size(); ++i)
        for (std::size_t cell = 0; cell < cells; ++cell)
            for (int dot = 0; dot < 6; ++dot) {
                // The sizes of braille, told here again.
                const double x = first_dot.x_mm + 6.0 * static_cast<double>(cell) + (dot / 3) * 2.5;
                const double y = first_dot.y_mm + (dot % 3) * 2.5;
                if (std::hypot(dots[i].x_mm - x, dots[i].y_mm - y) > nearest_mm) continue;
                read[cell] =
                    static_cast<std::uint8_t>(read[cell] | 1U << static_cast<unsigned>(dot));
                ++used[i];
            }
    return read;
}

std::string back_translated(const std::vector<std::uint8_t>& cells, const std::string& table) {
    std::vector<widechar> in;
    for (const std::uint8_t cell : cells) in.push_back(0x2800U + cell);
    std::vector<widechar> out(in.size() * 16 + 64);
    int from = static_cast<int>(in.size());
    int to = static_cast<int>(out.size());
    if (lou_backTranslateString(table.c_str(), in.data(), &from, out.data(), &to, nullptr, nullptr,
                                0) == 0)
        throw std::runtime_error("liblouis cannot read " + table);
    std::string text;
    for (int i = 0; i < to; ++i) {
        char utf8[6];
        text.append(utf8, static_cast<std::size_t>(
                              g_unichar_to_utf8(out[static_cast<std::size_t>(i)], utf8)));
    }
    return text;
}

}  // namespace touchline
