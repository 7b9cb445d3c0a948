// The camera on its way to a picture that can be felt: previews for a companion, a photograph when
// it is asked for. Threads: one, but for the files that it makes, which any may open. No call
// waits.
#pragma once

#include "app/loading/stages.h"
#include "app/screen/canvas.h"
#include "app/trace/photo_cut.h"
#include "config/types/result.h"
#include "vision/camera/camera.h"

#include <memory>
#include <optional>
#include <utility>

namespace touchline {

/// What is new since the last step.
struct PhotoNews {
    CameraCondition condition = CameraCondition::absent;
    FilePtr photo;               // that was asked for; null: none yet
    bool has_given_up = false;   // it will not come
    bool is_doubtful = false;    // of the photo: blurred or too bright even after a second attempt
    bool has_a_preview = false;  // a new one
};

class PhotoCapture {
  public:
    explicit PhotoCapture(std::unique_ptr<Camera> camera) : camera_(std::move(camera)) {}

    /// So much is left out at the sides of every picture from now on.
    void set(const PhotoCut& cut) { cut_ = cut; }

    /// Previews are wanted from now on, or no more: then the last one is forgotten.
    void show(bool is_wanted);

    /// A photograph: comes, or is given up, in one of the next steps.
    void take() {
        is_awaited_ = true;
        camera_->want_still();
    }

    [[nodiscard]] PhotoNews step(double now_s);

    /// What the camera sees; null while nothing is to be shown.
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
    bool is_awaited_ = false;  // a photograph
    bool is_stale_ = false;    // the next one is of a visitor who is gone
    std::shared_ptr<const Canvas> preview_;
};

/// A photograph as a file of the list: opened, it is the page that was laid down, without the shade
/// of the lamp; where no page is found, the photograph as it is. One sentence says what keeps it
/// from being used (too dark, a page that is cut off).
[[nodiscard]] FilePtr file_of(CameraFrame frame, const PhotoCut& cut);

/// The camera of this machine: a folder of pictures where TOUCHLINE_CAMERA names one, else the
/// first that libcamera finds, now or later. Fails where libcamera does not start.
[[nodiscard]] Result<std::unique_ptr<Camera>> open_camera();

}  // namespace touchline
