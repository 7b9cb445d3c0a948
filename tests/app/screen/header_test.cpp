#include "app/screen/header.h"

#include "app/screen/canvas.h"
#include "tests/app/screen/every_screen.h"
#include "tests/app/screen/probes.h"

#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(Header, LeavesRoomForThePlaceOfEveryItem) {
    const Canvas probe(1, 1);
    const Language language = every_language().front();
    SpokenScreen screen;
    screen.title = "A very long name of a list that the band has hardly any room for at all";
    screen.items = {{1, ItemRole::choice, "boat", "", "", "picture 137 of 205"},
                    {2, ItemRole::choice, "Back", "", "", std::string()}};
    const TextSizes sizes = text_sizes(TextSize::normal, usual_cap_px, 1280, 720);
    const Rect band{0.0, 0.0, 1280.0, 60.0};
    const TurnedText title = lay_out_header(probe.context(), screen, band, sizes, language).title;
    const double place_px =
        line_width_px(probe.context(), {sizes.normal_px}, *screen.items.front().place);
    EXPECT_LE(title.rect.x + title.rect.width + place_px, band.width);
}

}  // namespace
}  // namespace touchline
