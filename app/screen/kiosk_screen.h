// Draws frames in the window: the screen of the model, or the staff's live view.
// Threads: the one that holds the OpenGL context.
#pragma once

#include "app/screen/live_view.h"
#include "app/screen/screen_layers.h"

#include <cstdint>

namespace touchline {

class KioskScreen {
  public:
    /// `cap_px`: height of a capital letter of TextSize::normal on this monitor (cap_height_px()).
    /// Fails with the driver's message.
    [[nodiscard]] static Result<KioskScreen> make(double cap_px);

    /// Draws one frame of any screen, in a window of this size (px). Its contents change at most
    /// twice a second, except the handle's marker (screen_layers.h). `now_ns` never goes back.
    void draw(const ScreenContent& content, int width_px, int height_px, std::int64_t now_ns);

    /// Draws one frame of the live view. Its words change at most five times a second.
    void draw(const FrameContent& content, int width_px, int height_px, std::int64_t now_ns);

    /// The place on the screen of the picture drawn last.
    [[nodiscard]] const View& view() const;

  private:
    KioskScreen(double cap_px, Renderers renderers);

    void upload_layers(int width_px, int height_px);
    void upload(ImageLayer& image, std::uint64_t& version, const StillLayer& layer) const;
    void update_outlines(double level, std::int64_t now_ns);
    void update_hand(const HandState& hand);

    double cap_px_;
    Renderers renderers_;
    LiveView live_;
    bool is_live_ = true;  // the last frame was the live view

    ScreenLayers layers_;
    ImageLayer sheet_, captions_, picture_;
    std::uint64_t sheet_version_ = 0, captions_version_ = 0, picture_version_ = 0;
    int width_px_ = 0;
    int height_px_ = 0;
    Strokes strokes_;
    StrokeBuffer outlines_, hand_;
    double level_ = 0.0;                  // of the outlines drawn last
    std::uint64_t outlined_version_ = 0;  // of the picture layer below them
    ChangePace outline_pace_;
};

}  // namespace touchline
