// Writes the transcripts of all visits, a page for each language: transcripts OUT.
#include "tests/app/kiosk/transcripts/visit_plans.h"
#include "tests/machines/sim/kiosk/house.h"

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace touchline {
namespace {

void write_transcripts(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    for (const Language& language : all_languages()) {
        const std::string& code = language.code();
        std::string page;
        for (const VisitPlan& plan : visit_plans()) {
            page +=
                (page.empty() ? "" : "\n") + heading_of(plan) + text_of(act_out(plan, code), code);
        }
        std::ofstream(folder / (code + ".txt")) << page;
    }
}

}  // namespace
}  // namespace touchline

int main(int count, char** words) {
    if (count != 2) {
        std::cerr << "transcripts OUT: writes the transcripts of all visits into the folder OUT\n";
        return 2;
    }
    setenv("TOUCHLINE_PROGRAMS", TOUCHLINE_WORKERS, 0);
    try {
        touchline::write_transcripts(words[1]);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return 0;
}
