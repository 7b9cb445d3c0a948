#include "vision/prepare/capture_trouble.h"

namespace touchline {

std::string_view sentence(CaptureTrouble trouble) {
    switch (trouble) {
        case CaptureTrouble::none:
            return "";
        case CaptureTrouble::too_dark:
            return "It is too dark here. Turn on a lamp.";
        case CaptureTrouble::too_bright:
            return "There is too much light. Turn the lamp away.";
        case CaptureTrouble::glare:
            return "The lamp is mirrored in the page. Tilt or move it.";
        case CaptureTrouble::no_page:
            return "No page is found. Lay it flat under the camera.";
        case CaptureTrouble::too_small:
            return "The page is too far away. Bring it closer.";
        case CaptureTrouble::too_large:
            return "The page is too close. Move it away from the camera.";
        case CaptureTrouble::too_far_left:
            return "Move the page to the right.";
        case CaptureTrouble::too_far_right:
            return "Move the page to the left.";
        case CaptureTrouble::too_far_up:
            return "Move the page down, towards you.";
        case CaptureTrouble::too_far_down:
            return "Move the page up, away from you.";
        case CaptureTrouble::no_markers:
            return "The corners of the stand are covered. Clear them and try again.";
    }
    return "";
}

}  // namespace touchline
