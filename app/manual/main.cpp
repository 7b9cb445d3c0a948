// touchline-pages CATALOGUES CODE: reads a page of Markdown from the standard input, fills in the
// kiosk's own words in that language, and writes it to the standard output. Used to make the
// package; not installed.
#include "app/manual/manual_words.h"
#include "config/types/utf8.h"

#include <cstdio>
#include <iostream>
#include <iterator>

int main(int argc, char** argv) {
    using namespace touchline;
    if (argc != 3) {
        std::fputs("usage: touchline-pages CATALOGUES CODE\n", stderr);
        return 2;
    }
    const auto language = Language::load(argv[1], argv[2]);
    if (!language) {
        std::fprintf(stderr, "%s\n", plain_line(language.error().line).c_str());
        return 1;
    }
    const std::string page{std::istreambuf_iterator<char>(std::cin), {}};
    std::cout << filled_page(page, *language);
    return std::cout.flush() ? 0 : 1;
}
