// Tests the operator's screens of several kiosks: nothing changes before it was told and answered,
// and no house key is trusted without the PIN.
#include "tests/app/operator/at_operator_menu.h"

namespace touchline {
namespace {

class AtSeveralKiosks : public AtOperatorMenu {
  protected:
    AtSeveralKiosks() { EXPECT_TRUE(rig.open({"Upkeep", "Several kiosks"})); }

    void look_at_bundle() {
        ASSERT_TRUE(rig.open({"all kiosks"}));
        rig.house_lines = {"Firmness: from 400 newtons per metre to 500 newtons per metre",
                           "Pack Gardens: new"};
        rig.heard();
        rig.take(HouseLooked{P::bundle});
    }

    void look_at_key() {
        ASSERT_TRUE(rig.open({"house"}));
        rig.house_lines = {"6 3 2 9", "6 9 5 1"};
        rig.heard();
        rig.take(HouseLooked{P::house_key});
    }
};

TEST_F(AtSeveralKiosks, ABundleIsToldLineByLineBeforeItIsApplied) {
    look_at_bundle();
    EXPECT_EQ(rig.state.place, P::bundle);
    EXPECT_NE(rig.heard().find("What the bundle changes"), std::string::npos);
    rig.press(R::down);
    EXPECT_NE(rig.heard().find("Pack Gardens: new"), std::string::npos);
    ASSERT_TRUE(rig.open({"Apply the bundle"}));
    EXPECT_EQ(rig.count<ApplyBundle>(), 0) << "it is asked first";
    ASSERT_TRUE(rig.open({"No"}));
    EXPECT_EQ(rig.count<ApplyBundle>(), 0);
    look_at_bundle();
    ASSERT_TRUE(rig.open({"Apply the bundle", "Yes"}));
    EXPECT_EQ(rig.count<ApplyBundle>(), 1);
    EXPECT_EQ(rig.state.place, P::several);
}

TEST_F(AtSeveralKiosks, AKioskThatIsAlikeSaysSo) {
    ASSERT_TRUE(rig.open({"all kiosks"}));
    rig.take(HouseLooked{P::bundle});
    EXPECT_NE(rig.heard().find("This kiosk is as the bundle says."), std::string::npos);
}

TEST_F(AtSeveralKiosks, WhoHasGoneElsewhereIsNotCalledBack) {
    ASSERT_TRUE(rig.open({"all kiosks"}));
    rig.press(R::back);
    rig.take(HouseLooked{P::bundle});
    EXPECT_EQ(rig.state.place, P::upkeep);
}

TEST_F(AtSeveralKiosks, AKeyIsTrustedAfterThePinOnly) {
    look_at_key();
    EXPECT_NE(rig.heard().find("6 3 2 9"), std::string::npos);
    ASSERT_TRUE(rig.open({"Trust this house key"}));
    EXPECT_EQ(rig.state.place, P::key_pin);
    rig.enter_pin("9999");
    EXPECT_EQ(rig.count<TrustHouseKey>(), 0);
    EXPECT_EQ(rig.state.place, P::key_pin);
    EXPECT_EQ(rig.state.tries.wrong, 1);
    rig.enter_pin("1234");
    EXPECT_EQ(rig.count<TrustHouseKey>(), 1);
    EXPECT_EQ(rig.state.place, P::several);
}

TEST_F(AtSeveralKiosks, APinThatIsNotGivenTrustsNothing) {
    look_at_key();
    ASSERT_TRUE(rig.open({"Trust this house key"}));
    rig.press({R::up, R::back, R::back});
    EXPECT_EQ(rig.state.place, P::house_key);
    rig.press(R::back);
    EXPECT_EQ(rig.count<TrustHouseKey>(), 0);
}

TEST_F(AtSeveralKiosks, TheWayBackIsToldAndAskedFor) {
    ASSERT_TRUE(rig.open({"Back to before the bundle"}));
    EXPECT_EQ(rig.count<LookAtWayBack>(), 1);
    rig.house_lines = {"Pack Gardens: removed"};
    rig.take(HouseLooked{P::way_back});
    EXPECT_NE(rig.heard().find("Pack Gardens: removed"), std::string::npos);
    ASSERT_TRUE(rig.open({"Go back", "Yes"}));
    EXPECT_EQ(rig.count<GoBackToBefore>(), 1);
}

}  // namespace
}  // namespace touchline
