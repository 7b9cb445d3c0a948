// The pictures of a folder, as if from a camera: for demonstrations and tests. The preview shows
// one picture, a still takes it, and then the next one follows. Whoever owns decoders decodes the
// files.
// Threads: one caller. A step reads the folder now and then, and decodes one picture.
#pragma once

#include "vision/camera/camera.h"

#include <filesystem>
#include <functional>

namespace touchline {

/// Returns the upright picture in a file, 8-bit BGR, or why there is none.
using ReadPicture = std::function<Result<cv::Mat>(const std::filesystem::path& file)>;

class FolderCamera : public Camera {
  public:
    FolderCamera(std::filesystem::path folder, ReadPicture read);

    /// Returns one camera while the folder holds a file.
    [[nodiscard]] std::vector<CameraName> list() override;

    void choose(const std::string& id) override { wanted_id_ = id; }

    [[nodiscard]] std::optional<CameraAbilities> abilities() const override;

    void want_still() override { is_still_wanted_ = true; }

    [[nodiscard]] CameraView step(double now_s) override;

  private:
    void look_into_folder();
    [[nodiscard]] bool load_next();

    std::filesystem::path folder_;
    ReadPicture read_;
    std::string wanted_id_;
    std::vector<std::filesystem::path> files_;  // by name
    std::filesystem::path last_;                // the one shown
    cv::Mat picture_;                           // empty: none is shown
    std::optional<double> looked_s_;
    bool is_new_ = false;  // not shown yet
    bool is_still_wanted_ = false;
};

}  // namespace touchline
