#include "app/operator/kinds.h"

#include <array>

namespace touchline {
namespace {

constexpr std::array kinds{
    KindRow{"2diy-gen3.1", "2diy 3.1, elbows 15 millimetres in front of the motors",
            "Two motors beside each other, arms of plastic. Measure with the handle pushed away."},
    KindRow{"2diy-gen3.1-172", "2diy 3.1, elbows 10 millimetres in front of the motors",
            "Two motors beside each other, arms of plastic. Measure with the handle pushed away."},
    KindRow{"2diy-gen3.1-180", "2diy 3.1, elbows in line with the motors",
            "Two motors beside each other, arms of plastic. Measure with the handle pushed away."},
    KindRow{"2diy-gen3", "2diy 3, the kind before 3.1",
            "Its programs start with the handle pulled near."},
    KindRow{"2diy-gen2", "2diy 2, motors on one axis",
            "Arms of metal. Its programs start at 241 degrees."},
    KindRow{"2diy-gen2-240", "2diy 2, stopped at 240 degrees",
            "Arms of metal. Its programs start at 240 degrees and use 10978 counts."},
    KindRow{"haplet", "Haplet", "Short arms of 50 and 70 millimetres on a plate."},
    KindRow{"mk2", "Pantograph Mk II", "Built by a laboratory, with its own board."},
    KindRow{"gen3.1-turning", "2diy with a handle that turns",
            "It has a third motor at the handle. It is not sold; you build it yourself."},
};

}  // namespace

std::span<const KindRow> kind_rows() {
    return kinds;
}

}  // namespace touchline
