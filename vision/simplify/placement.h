// Maps pixels to the drawing area.
// Threads: a value.
#pragma once

#include "config/types/map_frame.h"

#include <algorithm>

#include <opencv2/core.hpp>

namespace touchline {

/// Centres the whole picture in the area, as large as fits, aspect kept; row down = W y down.
class Placement {
  public:
    Placement(cv::Size picture, cv::Size working, const Area& area)
        : mm_per_pixel_(1000.0 *
                        std::min(area.width_m / picture.width, area.height_m / picture.height)),
          mm_per_column_(mm_per_pixel_ * picture.width / working.width),
          mm_per_row_(mm_per_pixel_ * picture.height / working.height),
          left_mm_(500.0 * area.width_m - 0.5 * mm_per_pixel_ * picture.width),
          top_mm_(500.0 * area.height_m - 0.5 * mm_per_pixel_ * picture.height) {}

    double picture_pixels_per_metre() const { return 1000.0 / mm_per_pixel_; }

    double metres_per_working_pixel() const { return 0.5e-3 * (mm_per_column_ + mm_per_row_); }

    /// Converts a place in working pixels to millimetres of the viewBox, x right, y down.
    cv::Point2d in_mm(cv::Point2d at) const {
        return {left_mm_ + (at.x + 0.5) * mm_per_column_, top_mm_ + (at.y + 0.5) * mm_per_row_};
    }

  private:
    double mm_per_pixel_;
    double mm_per_column_;
    double mm_per_row_;
    double left_mm_;
    double top_mm_;
};

}  // namespace touchline
