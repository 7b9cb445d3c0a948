#include "app/sheets/paper_place.h"

#include <algorithm>

namespace touchline {

double fitting_scale(const Extent& ink, PaperSize room, double most) {
    const Position size = 1000.0 * (ink.high - ink.low);
    const auto fit = [most](double room_mm, double ink_mm) {
        return ink_mm > 0.0 ? room_mm / ink_mm : most;
    };
    return std::min({fit(room.width_mm, size.x), fit(room.height_mm, size.y), most});
}

PaperPlace middle_place(const Extent& ink, const PaperBox& room, double scale) {
    PaperPlace place{{0.0, 0.0}, scale};
    const PaperPoint off = place(ink.middle());
    place.middle = {(room.left_mm + room.right_mm) / 2.0 - off.x_mm,
                    (room.top_mm + room.bottom_mm) / 2.0 - off.y_mm};
    return place;
}

}  // namespace touchline
