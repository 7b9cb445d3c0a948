// Draws frames in the window: the screen of the model, or the staff's live view, which is the
// picture with outlines, boxes, hand and forces, the status panel, and a chart of how late the loop
// is. Paints still layers only when they change. Threads: the one that holds the OpenGL context.
#pragma once

#include "app/screen/gl_drawing.h"
#include "app/screen/panel.h"
#include "app/screen/screen_content.h"
#include "app/screen/screen_layers.h"
#include "app/visit/status.h"
#include "config/types/hand_state.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace touchline {

/// What the live view shows in one frame.
struct FrameContent {
    Status status;
    bool shows_boxes = false;
    HandState hand;
    ShownScene shown;
    std::optional<LatenessBars> timing = {};  // shown below the panel, if any
    Language language = {};
};

class LiveView {
  public:
    /// `cap_px`: height of a capital letter.
    explicit LiveView(double cap_px) : cap_px_(cap_px) {}

    /// Draws one frame on a screen of this size (px). The panel's words change at most five times a
    /// second, so that they can be read and nothing flickers.
    void draw(const Renderer& renderer, const FrameContent& content, int width_px, int height_px,
              std::int64_t now_ns);

    /// The place on the screen of the picture drawn last.
    [[nodiscard]] const View& view() const { return view_; }

  private:
    void lay_out_again(int width_px, int height_px);
    void update_picture(const ShownScene& shown);
    void update_panel(const FrameContent& content, std::int64_t now_ns);
    /// Returns the height left above it.
    double paint_timing_below(cairo_t* cr, const Rect& rect, const FrameContent& content) const;
    void update_overlay(const FrameContent& content);
    void update_outlines(const Scene& scene, double level);
    void update_boxes(const FrameContent& content);
    void update_hand(const HandState& hand);
    void upload(ImageLayer& layer, const Canvas& canvas, const Rect& rect) const;

    double cap_px_;
    ImageLayer picture_, panel_, overlay_;
    StrokeBuffer boxes_, outlines_, hand_;
    Strokes strokes_;

    int width_px_ = 0;
    int height_px_ = 0;
    ScreenLayout layout_;
    View view_;
    bool is_stale_ = true;  // the size has changed: every layer must be painted again

    // The contents of the layers.
    std::shared_ptr<const Canvas> painted_picture_;
    Status painted_status_;
    std::optional<LatenessBars> painted_timing_;
    std::int64_t panel_ns_ = 0;
    std::string painted_message_;
    std::uint64_t outlined_version_ = 0;  // the map's version
    double outlined_level_ = -1.0;
};

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
    KioskScreen(double cap_px, Renderer renderer);

    void upload_layers(int width_px, int height_px);
    void upload(ImageLayer& image, std::uint64_t& version, const StillLayer& layer) const;
    void update_outlines(double level, std::int64_t now_ns);
    void update_hand(const HandState& hand);

    double cap_px_;
    Renderer renderer_;
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
