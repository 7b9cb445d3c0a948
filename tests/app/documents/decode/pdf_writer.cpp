#include "tests/app/documents/decode/pdf_writer.h"

#include <fmt/format.h>

namespace touchline {

int PdfWriter::add(const std::string& body) {
    places_.push_back(text_.size());
    text_ += fmt::format("{} 0 obj\n{}\nendobj\n", places_.size(), body);
    return static_cast<int>(places_.size());
}

encoders::Bytes PdfWriter::finish(int catalogue, const std::string& trailer) {
    const std::size_t table = text_.size();
    text_ += fmt::format("xref\n0 {}\n0000000000 65535 f \n", places_.size() + 1);
    for (const std::size_t place : places_) text_ += fmt::format("{:010} 00000 n \n", place);
    text_ += fmt::format("trailer\n<< /Size {} /Root {} 0 R {} >>\nstartxref\n{}\n%%EOF\n",
                         places_.size() + 1, catalogue, trailer, table);
    return encoders::bytes_of(text_);
}

std::string stream_of(const std::string& dictionary, const std::string& data) {
    return fmt::format("<< {} /Length {} >>\nstream\n{}\nendstream", dictionary, data.size(), data);
}

encoders::Bytes written_pdf(const std::vector<WrittenPage>& pages,
                            const std::vector<std::string>& objects, const std::string& catalogue,
                            const std::string& trailer) {
    const std::size_t first = 5 + objects.size();
    std::string kids;
    for (std::size_t i = 0; i < pages.size(); ++i) kids += fmt::format("{} 0 R ", first + 2 * i);
    PdfWriter pdf;
    pdf.add(fmt::format("<< /Type /Catalog /Pages 2 0 R {} >>", catalogue));
    pdf.add(fmt::format("<< /Type /Pages /Kids [ {}] /Count {} >>", kids, pages.size()));
    pdf.add("null");
    pdf.add("<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>");
    for (const std::string& object : objects) pdf.add(object);
    for (std::size_t i = 0; i < pages.size(); ++i) {
        pdf.add(
            fmt::format("<< /Type /Page /Parent 2 0 R {} /Contents {} 0 R /Resources << {} >> >>",
                        pages[i].box, first + 2 * i + 1, pages[i].resources));
        pdf.add(stream_of("", pages[i].content));
    }
    return pdf.finish(1, trailer);
}

}  // namespace touchline
