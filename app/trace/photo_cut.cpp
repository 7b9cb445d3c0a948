#include "app/trace/photo_cut.h"

#include <algorithm>

namespace touchline {

cv::Mat cut_off(const cv::Mat& picture, const PhotoCut& cut) {
    const auto share = [](double percent) {
        return percent >= 0.0 && percent <= 40.0 ? 0.01 * percent : 0.0;
    };
    const int left = cvRound(share(cut.left) * picture.cols);
    const int right = cvRound(share(cut.right) * picture.cols);
    const int top = cvRound(share(cut.top) * picture.rows);
    const int bottom = cvRound(share(cut.bottom) * picture.rows);
    return picture(cv::Rect(left, top, std::max(1, picture.cols - left - right),
                            std::max(1, picture.rows - top - bottom)));
}

Picture picture_of(const cv::Mat& bgr) {
    Picture picture;
    picture.width = bgr.cols;
    picture.height = bgr.rows;
    const cv::Mat whole = bgr.isContinuous() ? bgr : bgr.clone();
    picture.bgr.assign(whole.data, whole.data + whole.total() * whole.elemSize());
    return picture;
}

}  // namespace touchline
