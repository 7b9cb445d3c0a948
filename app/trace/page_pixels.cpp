#include "app/trace/page_pixels.h"

namespace touchline {

cv::Mat view_of(const decode::AnswerParts& page) {
    return {static_cast<int>(page.header.height), static_cast<int>(page.header.width), CV_8UC3,
            const_cast<std::byte*>(page.pixels.data())};
}

}  // namespace touchline
