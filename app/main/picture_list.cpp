#include "app/main/picture_list.h"

namespace touchline {

int PictureList::size() const {
    return static_cast<int>(of_stick_.size() + standing_.size());
}

const FilePtr& PictureList::at(int place) const {
    const auto index = static_cast<std::size_t>(place);
    return index < of_stick_.size() ? of_stick_[index] : standing_.at(index - of_stick_.size());
}

std::optional<int> PictureList::place_of(const FilePtr& file) const {
    for (int place = 0; file && place < size(); ++place)
        if (at(place) == file) return place;
    return std::nullopt;
}

}  // namespace touchline
