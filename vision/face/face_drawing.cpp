#include "vision/face/face_drawing.h"

#include "vision/face/person_outline.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace touchline {

Result<FaceMap> drawn_face(const cv::Mat3b& picture, const FaceMesh& mesh, PersonNetwork& persons) {
    const cv::Rect part = head_and_shoulders(mesh, picture.size());
    return persons.mask_of(picture, part).map([&](const cv::Mat1b& mask) {
        std::vector<PartLine> lines = face_lines(mesh, shows_eyes(picture, mesh));
        std::ranges::move(person_outline({mask, part}, mesh), std::back_inserter(lines));
        return face_map(box_of(mesh), lines, Area{});
    });
}

}  // namespace touchline
