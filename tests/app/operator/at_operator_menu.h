// The operator at the menu, where most tests of their screens begin.
#pragma once

#include "tests/app/operator/operator_rig.h"

#include <gtest/gtest.h>

namespace touchline {

class AtOperatorMenu : public testing::Test {
  protected:
    using R = KeyRole;
    using P = OperatorPlace;

    AtOperatorMenu() { rig.open_menu(); }

    OperatorRig rig;
};

}  // namespace touchline
