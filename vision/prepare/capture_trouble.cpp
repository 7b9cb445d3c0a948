#include "vision/prepare/capture_trouble.h"

namespace touchline {

std::string_view sentence(CaptureTrouble trouble) {
    switch (trouble) {
        case CaptureTrouble::none:
            return "";
        case CaptureTrouble::too_dark:
            return "It is too dark here. Ask the staff for more light.";
        case CaptureTrouble::too_bright:
            return "There is too much light. Ask the staff to turn the lamp away.";
        case CaptureTrouble::glare:
            return "The lamp is reflected in the sheet. Ask the staff to move it.";
        case CaptureTrouble::no_page:
            return "No sheet is found. Lay it flat on the tray.";
        case CaptureTrouble::too_small:
            return "The sheet is too far away. Bring it closer.";
        case CaptureTrouble::too_large:
            return "The sheet is too close. Move it away from the camera.";
        case CaptureTrouble::too_far_left:
            return "Move the sheet to the right.";
        case CaptureTrouble::too_far_right:
            return "Move the sheet to the left.";
        case CaptureTrouble::too_far_up:
            return "Move the sheet down, towards you.";
        case CaptureTrouble::too_far_down:
            return "Move the sheet up, away from you.";
    }
    return "";
}

}  // namespace touchline
