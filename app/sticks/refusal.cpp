#include "app/sticks/refusal.h"

namespace touchline {
namespace {

/// The rest of a sentence that begins with the file or the stick.
std::string_view why(StickRefusal refusal) {
    switch (refusal) {
        case StickRefusal::gone:
            return " cannot be read because the stick was pulled out; put it in again";
        case StickRefusal::no_such_file:
            return " is no longer on the stick; choose another file";
        case StickRefusal::no_file:
            return " is only a link or a device; choose the picture itself";
        case StickRefusal::too_large:
            return " is too large; save it smaller and bring it again";
        case StickRefusal::empty:
            return " is empty; copy it to the stick again";
        case StickRefusal::unreadable:
            return " cannot be read because the stick was pulled out or is damaged; put it in "
                   "again "
                   "or try another stick";
        case StickRefusal::locked:
            return " is locked for the user who saved it; copy it to a stick formatted as FAT or "
                   "exFAT";
        case StickRefusal::out_of_time:
            return " takes too long to read; put the stick in again or try another one";
        case StickRefusal::not_started:
            return " cannot be read because a part of Touchline is missing; please tell the "
                   "operator";
    }
    return " cannot be read; choose another one";
}

}  // namespace

std::string sentence_of(StickRefusal refusal, std::string_view name) {
    return (name.empty() ? "The stick" : std::string(name)).append(why(refusal));
}

}  // namespace touchline
