// Draws frames in the window: the screen of the model with the picture's lines and the hand over
// it. Paints still layers only when they change. Threads: the one that holds the OpenGL context.
#pragma once

#include "app/screen/gl_drawing.h"
#include "app/screen/hand_trail.h"
#include "app/screen/screen_content.h"
#include "app/screen/screen_layers.h"
#include "config/types/hand_state.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace touchline {

class KioskScreen {
  public:
    /// `cap_px`: height of a capital letter of TextSize::normal on this monitor (cap_height_px()).
    /// Fails with the driver's message.
    [[nodiscard]] static Result<KioskScreen> make(double cap_px);

    /// Draws one frame of any screen, in a window of this size (px), and returns true; draws
    /// nothing and returns false if it would look like the one drawn last, which is less than
    /// two seconds old. Its contents change at most twice a second, except the handle's marker
    /// (screen_layers.h). `now_ns` never goes back.
    [[nodiscard]] bool draw(const ScreenContent& content, int width_px, int height_px,
                            std::int64_t now_ns);

    /// The place on the screen of the picture drawn last.
    [[nodiscard]] const View& view() const { return layers_.view(); }

    /// True if it lies there now, and lines and hand over it.
    [[nodiscard]] bool shows_picture() const { return layers_.has_marks(); }

    /// The display lost what was drawn: the next frame is drawn whatever it shows.
    void lose_frame() { drawn_ns_.reset(); }

  private:
    static constexpr std::size_t layer_count = 5;

    KioskScreen(double cap_px, Renderer renderer);

    // Each returns whether anything looks different now.
    [[nodiscard]] bool upload_layers(int width_px, int height_px);
    [[nodiscard]] bool upload(std::size_t image, const StillLayer& layer);
    [[nodiscard]] bool update_marks(const ScreenContent& content, std::int64_t now_ns);
    [[nodiscard]] bool update_outlines(double level, std::int64_t now_ns);
    [[nodiscard]] bool update_boxes(const HandState& hand);
    [[nodiscard]] bool update_hand(const HandState& hand, std::int64_t now_ns);
    [[nodiscard]] bool update_pen(const std::vector<Position>& stroke_W);
    void draw_all();

    double cap_px_;
    Renderer renderer_;
    ScreenLayers layers_;
    std::array<ImageLayer, layer_count> images_;  // of the layers, the picture first
    std::array<std::uint64_t, layer_count> versions_{};
    int width_px_ = 0;
    int height_px_ = 0;
    Strokes strokes_;
    StrokeBuffer outlines_, boxes_, pen_, hand_;
    double level_ = 0.0;                  // of the outlines drawn last
    std::uint64_t outlined_version_ = 0;  // of the picture layer below them
    ChangePace outline_pace_;
    HandTrail trail_;
    std::optional<std::int64_t> drawn_ns_;  // when a frame was drawn last
};

}  // namespace touchline
