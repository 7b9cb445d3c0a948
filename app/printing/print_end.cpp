#include "app/printing/print_end.h"

namespace touchline {

std::string_view line_of(PrintEnd end) {
    switch (end) {
        case PrintEnd::printed:
            return "the printer has printed the sheet";
        case PrintEnd::no_paper:
            return "the printer has no paper; put some in";
        case PrintEnd::needs_hand:
            return "the printer is jammed, open or without ink; see to it";
        case PrintEnd::offline:
            return "the printer does not answer; switch it on and look at its cable";
        case PrintEnd::paused:
            return "the printer is paused; 'cupsenable PRINTER' starts it";
        case PrintEnd::refused:
            return "the printer takes no sheets; 'cupsaccept PRINTER' lets it, and 'lpstat -p' "
                   "says more";
        case PrintEnd::unknown:
            return "CUPS has no printer of this name; 'lpstat -e' lists those it has";
        case PrintEnd::no_service:
            return "CUPS cannot be reached; is its service running, and may the kiosk reach it?";
        case PrintEnd::no_answer:
            return "CUPS has stopped answering; start its service again";
        case PrintEnd::failed:
            return "the sheet was given up by CUPS; its error_log says why";
        case PrintEnd::out_of_time:
            return "the printer took too long for a sheet; see to it";
        case PrintEnd::not_removed:
            return "the sheet is printed, but CUPS keeps it; 'cancel -a -x PRINTER' removes it";
        case PrintEnd::not_cleared:
            return "CUPS keeps sheets of before, so none is printed; 'cancel -a -x PRINTER' "
                   "removes them";
        case PrintEnd::no_sheet:
            return "no sheet can be made of this picture";
        case PrintEnd::not_started:
            break;
    }
    return "a program that prints cannot be started; install Touchline again";
}

}  // namespace touchline
