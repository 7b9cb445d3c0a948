// Compares files from elsewhere, opened by our workers and shown by ImageMagick, rsvg-convert or
// pdftoppm:
//
//   opening_compare FILE...
//
// Prints a line for each and a count. The exit status is 1 if one differs too much.
#include "app/documents/decode/opening.h"
#include "tests/app/documents/decode/reference.h"

#include <string>

#include <fmt/format.h>

namespace touchline {
namespace {

bool compare(const std::string& path) {
    const auto page = open_page_of(path);
    if (!page) {
        fmt::print("refused  {}\n", page.error().line);
        return false;
    }
    const auto expected = reference_picture(path, *page);
    if (!expected) {
        fmt::print("alone    {}: {}\n", path, expected.error().line);
        return false;
    }
    const Difference found = difference(page->picture, *expected);
    const Tolerance tolerance = tolerance_for(path);
    const bool is_same =
        found.is_comparable && found.most <= tolerance.most && found.mean <= tolerance.mean;
    fmt::print("{}  {}: {} x {}, at most {}, mean {:.3f}{}\n", is_same ? "same   " : "differs",
               path, page->picture.width, page->picture.height, found.most, found.mean,
               found.is_comparable ? "" : ", another size");
    return is_same;
}

}  // namespace
}  // namespace touchline

int main(int argc, char** argv) {
    int same = 0;
    for (int i = 1; i < argc; ++i) same += touchline::compare(argv[i]) ? 1 : 0;
    fmt::print("{} of {} the same\n", same, argc - 1);
    return same == argc - 1 ? 0 : 1;
}
