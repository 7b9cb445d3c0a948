// The camera's way to a picture that can be felt: previews for a companion, and a photograph when
// it is asked for. Threads: one, except for its files, which any thread may open. No call waits.
#pragma once

#include "app/documents/trace/trace_work.h"
#include "app/kiosk/loading/stages.h"
#include "app/screen/canvas.h"
#include "config/types/result.h"
#include "vision/camera/camera.h"

#include <memory>
#include <optional>
#include <utility>

namespace touchline {

/// What is new since the last step.
struct PhotoNews {
    CameraCondition condition = CameraCondition::absent;
    FilePtr photo;              // the one asked for; null: none yet
    bool has_given_up = false;  // the photo will not come
    bool is_doubtful = false;   // the photo is blurred or too bright even after a second attempt
};

class PhotoCapture {
  public:
    explicit PhotoCapture(std::unique_ptr<Camera> camera) : camera_(std::move(camera)) {}

    /// Cuts this much off the sides of every picture from now on.
    void set(const PhotoCut& cut) { cut_ = cut; }

    /// Turns previews on or off. Off forgets the last one.
    void show(bool is_wanted);

    /// Takes a photograph. It comes, or is given up, in one of the next steps.
    void take() {
        is_awaited_ = true;
        camera_->want_still();
    }

    [[nodiscard]] PhotoNews step(double now_s);

    /// The camera's view; null while nothing is to be shown.
    [[nodiscard]] const std::shared_ptr<const Canvas>& preview() const { return preview_; }

    /// The visitor is gone: no picture of theirs stays.
    void forget() {
        is_stale_ = std::exchange(is_awaited_, false) || is_stale_;
        show(false);
    }

  private:
    std::unique_ptr<Camera> camera_;
    PhotoCut cut_;
    bool is_shown_ = false;
    bool is_awaited_ = false;  // a photograph is awaited
    bool is_stale_ = false;    // the next photograph belongs to a visitor who is gone
    std::shared_ptr<const Canvas> preview_;
};

/// A photograph as a file of the list. Opening it gives the page that was laid down, without the
/// lamp's shade, or the photograph as it is if no page is found. One sentence says what makes it
/// unusable (too dark, a page that is cut off).
[[nodiscard]] FilePtr file_of(CameraFrame frame, const PhotoCut& cut);

/// The camera of this machine: the folder of pictures that TOUCHLINE_CAMERA names, or else the
/// first camera that libcamera finds, now or later. Fails if libcamera does not start.
[[nodiscard]] Result<std::unique_ptr<Camera>> open_camera();

}  // namespace touchline
