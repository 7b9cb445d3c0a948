// A full-screen window with a screen of the model in it, for the test of the window and for the
// README's picture:
//   window_probe OUT.png [SIZE 0 ... 3]
// writes what was drawn, says how large it is and how long a frame took, then goes on drawing until
// its input ends, and writes what it drew last.
#include "app/documents/decode/picture.h"
#include "app/screen/kiosk_screen.h"
#include "app/screen/window.h"
#include "app/visit/proxy_radius.h"
#include "tests/app/documents/gallery/pictures.h"
#include "tests/app/screen/sample_screens.h"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr double cap_px = 27.0;
constexpr int frames = 120;

/// The screen's clock at a frame.
constexpr std::int64_t time_ns(int frame) {
    return frame * 1'000'000'000LL / 60;
}

template <class T>
T value_of(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().line);
    return std::move(*result);
}

/// The outlines of a fish, its settings, and a hand on its nose.
ScreenContent fish_content() {
    ScreenContent content;
    for (const ShippedPicture& picture : shipped_pictures()) {
        if (picture.name != "06-fish") continue;
        content.shown.scene = std::make_shared<const Scene>(
            value_of(build_scene(picture.map, CurveOptions{}, proxy_radius_m)));
        content.screen = sample_screens(Language()).at(2).screen;
        content.screen.title = picture.map.title;
        content.screen.text = picture.map.description;
    }
    content.caption = spoken_item(content.screen, *content.screen.focus, content.language);
    content.sound_sign = "corner";
    content.hand.p_WH = {0.010, 0.012};
    content.hand.p_WP = {0.012, 0.014};
    content.hand.force = {0.3, 0.3};
    return content;
}

/// Returns what the window shows now, rows from the top.
Picture pixels_of(const Window& window) {
    Picture picture;
    picture.width = window.width_px();
    picture.height = window.height_px();
    const auto stride = 3 * static_cast<std::size_t>(picture.width);
    std::vector<std::uint8_t> upward(stride * static_cast<std::size_t>(picture.height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, picture.width, picture.height, GL_BGR, GL_UNSIGNED_BYTE, upward.data());
    for (int y = picture.height - 1; y >= 0; --y) {
        const auto row = upward.begin() + y * static_cast<std::ptrdiff_t>(stride);
        picture.bgr.insert(picture.bgr.end(), row, row + static_cast<std::ptrdiff_t>(stride));
    }
    return picture;
}

void draw_and_measure(Window& window, KioskScreen& screen, ScreenContent& content) {
    std::int64_t first_ns = 0;
    std::int64_t rest_ns = 0;
    for (int i = 0; i < frames; ++i) {
        const std::int64_t start_ns = now_ns();
        content.hand.p_WH.x = 0.010 + 0.0001 * i;
        // Its own clock decides which page is shown, so no machine does.
        (void)screen.draw(content, window.width_px(), window.height_px(), time_ns(i));
        glFinish();
        (i == 0 ? first_ns : rest_ns) += now_ns() - start_ns;
        if (i + 1 < frames) window.show_frame();
    }
    fmt::print("{} x {} px; first frame {:.1f} ms, then {:.1f} ms\n", window.width_px(),
               window.height_px(), static_cast<double>(first_ns) * 1e-6,
               static_cast<double>(rest_ns) * 1e-6 / (frames - 1));
}

void write(const std::string& file, const Window& window) {
    const auto written = write_png(file, pixels_of(window));
    if (!written) throw std::runtime_error(written.error().line);
}

/// Nobody ever writes to the input.
bool has_input_ended() {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    return ::poll(&input, 1, 0) > 0;
}

void run(const std::string& file, TextSize size) {
    ScreenContent content = fish_content();
    const KioskScreen* shown = nullptr;
    bool is_down = false;
    const auto draw_at = [&](PixelPoint place) {
        if (is_down && shown != nullptr) content.stroke.push_back(shown->view().to_W(place));
    };
    const auto window =
        value_of(Window::open(true, {[](const PhysicalKey&, bool, bool) {}, draw_at,
                                     [&](const PointerPress& press) {
                                         is_down = press.is_down && !press.is_second;
                                         draw_at(press.place);
                                         fmt::print("{} {}\n", press.is_second ? "second" : "first",
                                                    press.is_down ? "down" : "up");
                                         std::fflush(stdout);
                                     },
                                     [](double) {}}));
    KioskScreen screen = value_of(KioskScreen::make(cap_px));
    shown = &screen;
    content.text_size = size;
    draw_and_measure(*window, screen, content);
    const bool is_drawn_again =
        screen.draw(content, window->width_px(), window->height_px(), time_ns(frames - 1));
    fmt::print("the same again: {}\n", is_drawn_again ? "drawn" : "not drawn");
    write(file, *window);
    window->show_frame();
    fmt::print("ready\n");
    std::fflush(stdout);
    constexpr std::int64_t frame_ns = 50'000'000;
    // From now on the clock stands still: no page turns and no trail fades while the display is
    // read.
    const auto draw = [&] {
        screen.lose_frame();
        (void)screen.draw(content, window->width_px(), window->height_px(), time_ns(frames - 1));
    };
    while (!has_input_ended()) {
        window->wait_until(now_ns() + frame_ns);
        draw();
        window->show_frame();
    }
    draw();
    write(file, *window);
}

}  // namespace
}  // namespace touchline

int main(int count, char** words) {
    using namespace touchline;
    if (count < 2) {
        fmt::print(stderr, "usage: window_probe OUT.png [SIZE]\n");
        return 2;
    }
    try {
        run(words[1], static_cast<TextSize>(count > 2 ? std::atoi(words[2]) % 4 : 0));
        return 0;
    } catch (const std::exception& problem) {
        fmt::print(stderr, "{}\n", problem.what());
        return 1;
    }
}
