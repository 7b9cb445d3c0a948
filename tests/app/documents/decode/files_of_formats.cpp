#include "tests/app/documents/decode/files_of_formats.h"

#include "app/documents/decode/files.h"
#include "tests/app/documents/decode/pdf_writer.h"
#include "tests/app/documents/decode/reference.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;
using encoders::Bytes;

Bytes made_by_convert(const std::string& ending) {
    const fs::path path =
        fs::temp_directory_path() / fmt::format("touchline-{}-sample.{}", getpid(), ending);
    Bytes bytes;
    if (run_command("convert -seed 1 -size 48x37 plasma:red-blue -depth 8 " + path.string()))
        bytes = read_file(path).value_or(Bytes{});
    fs::remove(path);
    return bytes;
}

void put_big_endian(Bytes& bytes, std::size_t at, std::uint32_t value, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        bytes.at(at + i) = static_cast<std::byte>(value >> (8 * (count - 1 - i)) & 0xffU);
}

void put_little_endian(Bytes& bytes, std::size_t at, std::uint32_t value, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        bytes.at(at + i) = static_cast<std::byte>(value >> (8 * i) & 0xffU);
}

}  // namespace

/// Writes the size into the box "ispe", after its name and four bytes.
void put_heif_size(Bytes& bytes, std::uint32_t width, std::uint32_t height) {
    const Bytes name = encoders::bytes_of("ispe");
    const auto found = std::search(bytes.begin(), bytes.end(), name.begin(), name.end());
    const auto at = static_cast<std::size_t>(found - bytes.begin()) + 8;
    put_big_endian(bytes, at, width, 4);
    put_big_endian(bytes, at + 4, height, 4);
}

Bytes tagged_pdf(const std::vector<std::string>& texts, const std::string& alt) {
    // The order fixes the numbers: catalogue 1, tree 2, pages 3, font 4, then five a page.
    const auto first_of = [](std::size_t page) { return 5 + 5 * static_cast<int>(page); };
    std::string kids;
    std::string elements;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        kids += fmt::format("{} 0 R ", first_of(i));
        elements += fmt::format("{} 0 R {} 0 R ", first_of(i) + 2, first_of(i) + 3);
    }
    PdfWriter pdf;
    pdf.add("<< /Type /Catalog /Pages 3 0 R /MarkInfo << /Marked true >> /StructTreeRoot 2 0 R >>");
    pdf.add(fmt::format("<< /Type /StructTreeRoot /K [ {}] >>", elements));
    pdf.add(fmt::format("<< /Type /Pages /Kids [ {}] /Count {} >>", kids, texts.size()));
    pdf.add("<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>");
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const int page = first_of(i);
        const std::string drawing = fmt::format(
            "/H1 << /MCID 0 >> BDC BT /F1 24 Tf 72 150 Td ({}) Tj ET EMC\n"
            // Two dark pixels, stretched.
            "/Figure << /MCID 1 >> BDC q 60 0 0 40 200 30 cm BI /W 2 /H 1 /CS /G /BPC 8 ID \1\1 EI "
            "Q EMC\n",
            texts[i]);
        pdf.add(
            fmt::format("<< /Type /Page /Parent 3 0 R /MediaBox [0 0 300 200] /Contents {} 0 R "
                        "/Resources << /Font << /F1 4 0 R >> >> /StructParents {} >>",
                        page + 1, i));
        pdf.add(fmt::format("<< /Length {} >>\nstream\n{}endstream", drawing.size(), drawing));
        pdf.add(fmt::format("<< /Type /StructElem /S /H1 /P 2 0 R /Pg {} 0 R /K 0 >>", page));
        pdf.add(
            fmt::format("<< /Type /StructElem /S /Figure /P 2 0 R /Pg {} 0 R /K 1 /Alt ({}) "
                        "/A << /O /Layout /BBox [200 30 260 70] >> >>",
                        page, alt));
        pdf.add("null");
    }
    return pdf.finish(1);
}

namespace {

/// A dark square on white, as an inline image with more pixels along its longer side.
std::string drawn(const DrawnImage& image) {
    const int width = image.width_pt > image.height_pt ? 8 : 4;
    const int height = image.height_pt > image.width_pt ? 8 : 4;
    std::string pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            pixels +=
                std::min(x, width - 1 - x) >= width / 4 && std::min(y, height - 1 - y) >= height / 4
                    ? "20"
                    : "FF";
    return fmt::format("q {} 0 0 {} {} {} cm BI /W {} /H {} /CS /G /BPC 8 /F /AHx ID {}> EI Q\n",
                       image.width_pt, image.height_pt, image.x_pt, image.y_pt, width, height,
                       pixels);
}

}  // namespace

Bytes drawn_pdf(const std::vector<std::vector<DrawnImage>>& pages) {
    std::string kids;
    for (std::size_t i = 0; i < pages.size(); ++i) kids += fmt::format("{} 0 R ", 3 + 2 * i);
    PdfWriter pdf;
    pdf.add("<< /Type /Catalog /Pages 2 0 R >>");
    pdf.add(fmt::format("<< /Type /Pages /Kids [ {}] /Count {} >>", kids, pages.size()));
    for (std::size_t i = 0; i < pages.size(); ++i) {
        std::string drawing;
        for (const DrawnImage& image : pages[i]) drawing += drawn(image);
        pdf.add(fmt::format(
            "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 600 800] /Contents {} 0 R >>", 4 + 2 * i));
        pdf.add(fmt::format("<< /Length {} >>\nstream\n{}endstream", drawing.size(), drawing));
    }
    return pdf.finish(1);
}

std::vector<NamedFile> files_of_formats() {
    const Picture picture = encoders::test_picture(48, 37);
    std::vector<NamedFile> files{
        {"PNG", encoders::png(picture)},
        {"JPEG", encoders::jpeg(picture)},
        {"WebP", encoders::lossy_webp(picture)},
        {"TIFF", encoders::tiff(picture)},
        {"SVG",
         encoders::bytes_of(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 30">)"
                            R"(<title>T</title><path d="M1 1 C 20 1 30 20 35 25 Z"/></svg>)")},
        {"PDF", tagged_pdf({"Fish"}, "A fish")}};
    for (const char* ending : {"gif", "bmp", "ppm", "heic", "avif"})
        files.push_back({ending, made_by_convert(ending)});
    return files;
}

std::vector<NamedFile> bombs() {
    const Picture picture = encoders::test_picture(16, 16);
    Bytes png = encoders::png(picture);
    put_big_endian(png, 16, 60'000, 4);
    put_big_endian(png, 20, 60'000, 4);
    Bytes gif = encoders::bytes_of(std::string("GIF89a\xff\xff\xff\xff\x80\0\0", 13) +
                                   std::string("\0\0\0\xff\xff\xff", 6) +
                                   std::string(",\0\0\0\0\xff\xff\xff\xff\0\2\2\x4c\1\0;", 16));
    Bytes bmp = made_by_convert("bmp");
    put_little_endian(bmp, 18, 60'000, 4);
    put_little_endian(bmp, 22, 60'000, 4);
    Bytes webp = encoders::lossless_webp(1, 1, {0, 0, 0, 255});
    put_big_endian(webp, 21, 0xffffff0fU, 4);
    Bytes jpeg = encoders::jpeg(picture);
    const Bytes frame{std::byte{0xff}, std::byte{0xc0}};
    const auto found = std::search(jpeg.begin(), jpeg.end(), frame.begin(), frame.end());
    put_big_endian(jpeg, static_cast<std::size_t>(found - jpeg.begin()) + 5, 0xf000f000U, 4);
    Bytes heic = encoders::heif(picture, {});
    put_heif_size(heic, 20'000, 20'000);
    encoders::HeifForm avif_form;
    avif_form.is_avif = true;
    Bytes avif = encoders::heif(picture, avif_form);
    put_heif_size(avif, 20'000, 20'000);
    std::string svg = R"(<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><g id="a">)"
                      R"(<path d="M0 0h9"/></g>)";
    for (char id = 'b'; id <= 'z'; ++id) {
        svg += fmt::format(R"(<g id="{}">)", id);
        for (int i = 0; i < 10; ++i)
            svg += fmt::format("<use href=\"#{}\"/>", static_cast<char>(id - 1));
        svg += "</g>";
    }
    std::string laughs = "<!DOCTYPE svg [<!ENTITY a \"ha\">";
    for (char name = 'b'; name <= 'z'; ++name) {
        laughs += fmt::format("<!ENTITY {} \"", name);
        for (int i = 0; i < 10; ++i) laughs += fmt::format("&{};", static_cast<char>(name - 1));
        laughs += "\">";
    }
    laughs +=
        R"(]><svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><text>&z;</text></svg>)";
    return {{"PNG of 3600 megapixels", png},
            {"GIF of 4295 megapixels", gif},
            {"BMP of 3600 megapixels", bmp},
            {"WebP of 268 megapixels", webp},
            {"JPEG of 3774 megapixels", jpeg},
            {"HEIC of 400 megapixels", heic},
            {"AVIF of 400 megapixels", avif},
            {"PPM of 3600 megapixels", encoders::bytes_of("P6 60000 60000 255\n")},
            {"SVG of 10^25 uses", encoders::bytes_of(svg + "</svg>")},
            {"SVG of 10^25 entities", encoders::bytes_of(laughs)}};
}

}  // namespace touchline
