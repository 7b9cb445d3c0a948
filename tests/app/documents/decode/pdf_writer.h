// PDF documents written by hand, object by object. Threads: values.
#pragma once

#include "tests/app/documents/decode/encoders.h"

#include <string>
#include <vector>

namespace touchline {

/// Writes objects with the table of their offsets, as PDF needs it.
class PdfWriter {
  public:
    /// Returns the object's number; the first is 1.
    int add(const std::string& body);

    [[nodiscard]] encoders::Bytes finish(int catalogue, const std::string& trailer = {});

  private:
    std::string text_ = "%PDF-1.7\n";
    std::vector<std::size_t> places_;
};

/// Returns a stream: the dictionary and its data.
[[nodiscard]] std::string stream_of(const std::string& dictionary, const std::string& data);

struct WrittenPage {
    std::string content;                             // content operators
    std::string box = "/MediaBox [0 0 600 800]";     // and further entries of the page
    std::string resources = "/Font << /F 4 0 R >>";  // Helvetica
};

/// Object 1 is the catalogue, 2 the page tree, 3 empty, 4 Helvetica; `objects` begin with 5.
/// `catalogue` and `trailer` are added to theirs.
[[nodiscard]] encoders::Bytes written_pdf(const std::vector<WrittenPage>& pages,
                                          const std::vector<std::string>& objects = {},
                                          const std::string& catalogue = {},
                                          const std::string& trailer = {});

}  // namespace touchline
