// Tests whole visits by different people, on a virtual clock.
#include "tests/app/visit/fake_world.h"
#include "tests/app/visit/visit_scenes.h"

#include <algorithm>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// A visitor who knows only what was said: presses a key, waits, listens.
class Listener {
  public:
    Listener(FakeHouse& house, double every_s) : house_(house), every_s_(every_s) {}

    /// Presses a key and returns what was said since, as one text.
    std::string press(KeyRole role) {
        const std::size_t before = house_.transcript.size();
        house_.press(role);
        house_.wait(every_s_);
        std::string heard;
        for (std::size_t i = before; i < house_.transcript.size(); ++i) {
            heard += house_.transcript[i].text + "\n";
        }
        return last_ = heard;
    }

    /// Presses `key` until an item with this name is heard; false after 40 presses.
    bool listen_for(const std::string& name, KeyRole key = KeyRole::down) {
        for (int presses = 0; presses < 40; ++presses) {
            if (press(key).find(name) != std::string::npos) return true;
        }
        return false;
    }

    [[nodiscard]] const std::string& last() const { return last_; }

  private:
    FakeHouse& house_;
    double every_s_;
    std::string last_;
};

void expect_heard(const Listener& listener, const std::string& text) {
    EXPECT_NE(listener.last().find(text), std::string::npos) << listener.last();
}

/// Visits gallery, stick and camera, by what is heard alone.
void visit_all(FakeHouse& house, double every_s) {
    Listener visitor(house, every_s);
    visitor.press(KeyRole::help);  // any key begins
    expect_heard(visitor, "Up, Down and Select");
    visitor.press(KeyRole::select);
    expect_heard(visitor, "What to feel");
    ASSERT_TRUE(visitor.listen_for("Gallery"));
    visitor.press(KeyRole::select);
    expect_heard(visitor, "very easy, 2 pictures, 1 of 6");
    visitor.press(KeyRole::select);
    expect_heard(visitor, "picture 1 of 12");
    visitor.press(KeyRole::select);
    expect_heard(visitor, "Guide me along the largest outline");
    visitor.press(KeyRole::select);
    expect_heard(visitor, "Press any key to stop it.");
    house.wait(5.0);
    EXPECT_TRUE(house.has_said("That was the whole outline.", 0));
    visitor.press(KeyRole::back);
    house.apply(StickCame{{"holiday", "letter"}, {}});
    ASSERT_TRUE(visitor.listen_for("Your USB stick, 2 pictures"));
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.listen_for("letter"));
    visitor.press(KeyRole::select);
    expect_heard(visitor, "Page 1 of 2");
    ASSERT_TRUE(visitor.listen_for("Parts, 2"));
    visitor.press(KeyRole::select);
    visitor.press(KeyRole::select);
    expect_heard(visitor, "The handle will guide you to this part: Body en.");
    house.wait(5.0);
    visitor.press(KeyRole::back);
    visitor.press(KeyRole::back);
    ASSERT_TRUE(visitor.listen_for("Camera"));
    visitor.press(KeyRole::select);
    expect_heard(visitor, "Take the photo");
    visitor.press(KeyRole::select);
    house.wait(1.0);
    EXPECT_TRUE(house.has_said("The photo has been taken.", 0));
    EXPECT_EQ(house.visit.visitor.felt->order.source, PictureSource::camera);
    visitor.press(KeyRole::back);
    ASSERT_TRUE(visitor.listen_for("Finish", KeyRole::up));
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.listen_for("Yes"));
    visitor.press(KeyRole::select);
    expect_heard(visitor, "Goodbye");
    EXPECT_FALSE(is_visit_on(house.visit));
}

TEST(VisitRun, Blind) {
    FakeHouse house;
    visit_all(house, 0.3);
    EXPECT_LT(house.now_s, 60.0) << "keys alone; speech is skipped by who knows it";
}

TEST(VisitRun, OneHand) {
    // The hand is on the keys or on the handle, never on both: the handle never seems to move.
    FakeHouse house;
    visit_all(house, 2.0);
}

TEST(VisitRun, Slow) {
    FakeHouse house;
    visit_all(house, 25.0);
    EXPECT_GT(house.now_s, 600.0);
}

TEST(VisitRun, TwoKeys) {
    FakeHouse house;
    // Down moves and Select selects; no other key is pressed.
    house.press({KeyRole::select, KeyRole::select});
    ASSERT_TRUE(house.choose("Practice shape"));
    house.wait(0.5);
    ASSERT_TRUE(house.choose("Go on to the pictures"));
    ASSERT_TRUE(house.choose("hard"));
    ASSERT_TRUE(house.choose("Back"));
    ASSERT_TRUE(house.choose("very easy"));
    ASSERT_TRUE(house.choose("Picture 5 en"));
    house.wait(0.5);
    ASSERT_TRUE(house.choose("Parts"));
    ASSERT_TRUE(house.choose("Back"));
    ASSERT_TRUE(house.choose("Firmness"));
    ASSERT_TRUE(house.choose("soft"));
    ASSERT_TRUE(house.choose("Explore freely"));
    ASSERT_TRUE(house.choose("Back"));
    ASSERT_TRUE(house.choose("Back"));
    ASSERT_TRUE(house.choose("Settings"));
    ASSERT_TRUE(house.choose("Volume"));
    ASSERT_TRUE(house.choose("Step 6"));
    ASSERT_TRUE(house.choose("Back"));
    ASSERT_TRUE(house.choose("Finish"));
    ASSERT_TRUE(house.choose("Yes"));
    EXPECT_EQ(house.open(), VisitScreen::goodbye);
}

TEST(VisitRun, EveryScreenCanBeLeftByItsItemsAlone) {
    FakeHouse house;
    for (const Visit& visit : scenes_of_all_screens()) {
        if (!is_visit_on(visit) || visit.visitor.over) continue;
        const VisitScreen screen = open_screen(visit);
        bool leads_away = false;
        for (const ScreenItem& item : screen_of(visit, house.world()).items) {
            const auto id = static_cast<VisitItem>(item.id);
            leads_away = leads_away || id == VisitItem::back || id == VisitItem::no ||
                         id == VisitItem::cancel || screen == VisitScreen::language ||
                         screen == VisitScreen::values ||  // every value leads back
                         screen == VisitScreen::choose;
        }
        ASSERT_TRUE(leads_away) << static_cast<int>(screen);
    }
}

TEST(VisitRun, AllLanguages) {
    for (std::size_t i = 0; i < all_languages().size(); ++i) {
        const Language& language = all_languages()[i];
        FakeHouse house;
        house.press(KeyRole::select);
        for (std::size_t down = 0; down < i; ++down) house.press(KeyRole::down);
        const std::size_t chosen = house.transcript.size();
        house.press(KeyRole::select);
        const auto item = [&](const char* english) {
            return house.choose(language.text("visit", english));
        };
        ASSERT_TRUE(item("Gallery"));
        house.press({KeyRole::select, KeyRole::select});
        house.wait(3.0);
        ASSERT_TRUE(item("Parts"));
        house.press({KeyRole::select, KeyRole::select});
        house.press(KeyRole::back);
        ASSERT_TRUE(item("Enlargement"));
        house.press(KeyRole::select);
        house.wait(3.0);
        house.press({KeyRole::help, KeyRole::up, KeyRole::back, KeyRole::back});
        house.apply(TroubleBegan{TroubleKind::camera, ""});
        house.press(KeyRole::select);
        house.wait(91.0);
        house.press(KeyRole::up);
        while (house.open() != VisitScreen::choose) house.press(KeyRole::back);
        ASSERT_TRUE(item("Finish"));
        ASSERT_TRUE(item("Yes"));
        for (std::size_t at = chosen; at < house.transcript.size(); ++at) {
            EXPECT_EQ(house.transcript[at].language, language.code()) << house.transcript[at].text;
            if (language.code() == "en") continue;
            for (const char* english : {" the ", "Select", "Back", "Press", "Picture"}) {
                const std::string said = house.transcript[at].text;
                if (said.find("Picture ") == 0 ||
                    said.find(" " + language.code()) != std::string::npos)
                    continue;  // the simulated pictures' names
                EXPECT_EQ(said.find(english), std::string::npos) << said;
            }
        }
    }
}

StickCame stick_of(unsigned count, bool is_whole) {
    StickCame came;
    for (unsigned i = 0; i < count; ++i)
        came.names.push_back(std::string(1, static_cast<char>('A' + i / 9)) + std::to_string(i));
    if (!is_whole) came.rest = {5, true, false, true};
    return came;
}

/// Returns any event that can happen, at random; keys more often than all else.
VisitEvent rude_event(std::mt19937& random, FakeHouse& house) {
    const auto upto = [&random](unsigned count) { return static_cast<unsigned>(random()) % count; };
    switch (upto(26)) {
        case 0:
            return DeadKeyPressed{};
        case 1:
            return SpeechKeyPressed{static_cast<SpeechKey>(upto(4))};
        case 2:
            return HeadphonesChanged{upto(2) == 0};
        case 3:
            return StickArriving{};
        case 4:
            return stick_of(upto(25), upto(2) == 0);
        case 5:
            return StickGone{upto(2) == 0 ? "" : "It cannot be read. Take another."};
        case 6:
            return PictureReady{house.visit.site.request - upto(3), fake_facts({})};
        case 7:
            return PictureFailed{house.visit.site.request - upto(3), ""};
        case 8:
            return CameraChanged{upto(3) != 0};
        case 9:
            return CameraCaptured{};
        case 10:
            return CameraFailed{""};
        case 11:
            return GuidanceEnded{static_cast<GuidanceEnd>(upto(4))};
        case 12:
            return TroubleBegan{static_cast<TroubleKind>(upto(4)), ""};
        case 13:
            return TroubleEnded{static_cast<TroubleKind>(upto(4))};
        case 14:
            return StaffCalledOff{};
        case 15:
            if (upto(20) == 0) return OpeningChanged{static_cast<SiteOpening>(upto(3))};
            return OpeningChanged{SiteOpening::open};
        case 17:
            return ThingsLookedFor{house.visit.site.request - upto(3),
                                   {1, 1, 2, 2, static_cast<ThingSearch>(3 + upto(2))}};
        case 18:
            return LineRead{upto(2) == 0};
        case 16: {
            HandleSeen handle;
            handle.place_W = {0.0001 * upto(500), -0.0001 * upto(400)};
            if (upto(2) == 0) handle.part = upto(4);
            handle.has_moved = upto(2) == 0;
            return handle;
        }
        default:
            return KeyPressed{static_cast<KeyRole>(upto(key_role_count))};
    }
}

bool is_key(const VisitEvent& event) {
    return std::holds_alternative<KeyPressed>(event) ||
           std::holds_alternative<SpeechKeyPressed>(event) ||
           std::holds_alternative<DeadKeyPressed>(event);
}

void expect_whole(const FakeHouse& house) {
    const Visitor& visitor = house.visit.visitor;
    ASSERT_FALSE(visitor.path.empty());
    ASSERT_LE(visitor.path.size(), 5U);
    ASSERT_LT(visitor.sound.volume, house.rules.volume_steps);
    ASSERT_LT(visitor.sound.language, house.languages.size());
    ASSERT_FALSE(house.screen().title.empty());
    ASSERT_TRUE(!house.visit.visitor.feel.is_force_wanted || visitor.felt);
}

TEST(VisitRun, Rude) {
    std::set<VisitScreen> been;
    for (unsigned seed = 1; seed <= 3; ++seed) {
        std::mt19937 random(seed);
        FakeHouse house;
        double key_s = 0.0;
        for (int i = 0; i < 10000; ++i) {
            const VisitEvent event = rude_event(random, house);
            house.apply(event);
            been.insert(house.open());
            expect_whole(house);
            if (is_key(event)) {
                key_s = house.now_s;
                ASSERT_EQ(house.sounded_s, house.now_s) << "answered in the same step: " << i;
            }
            // Sometimes long enough for the question and for the end of the visit.
            double left_s =
                random() % 200 == 0 ? 130.0 : 0.001 * static_cast<double>(random() % 2500);
            for (; left_s > 0.0; left_s -= 0.5) {
                house.wait(std::min(left_s, 0.5));
                const bool is_worked_for = house.visit.visitor.waiting.has_value();
                const bool is_asked = house.open() == VisitScreen::question;
                if (is_worked_for || is_asked || house.now_s - key_s < 5.0) {
                    if (!is_visit_on(house.visit)) continue;
                    ASSERT_LE(house.now_s - house.sounded_s, 5.2) << "seed " << seed << ": " << i;
                }
            }
        }
        // Never stuck: a few presses lead to choose.
        house.apply(OpeningChanged{SiteOpening::open});
        for (int i = 0; i < 8 && house.open() != VisitScreen::choose; ++i) {
            const bool is_forward =
                house.open() == VisitScreen::attract || house.open() == VisitScreen::goodbye ||
                house.open() == VisitScreen::language || house.open() == VisitScreen::trouble;
            house.press(is_forward ? KeyRole::select : KeyRole::back);
        }
        EXPECT_EQ(house.open(), VisitScreen::choose) << seed;
    }
    EXPECT_GE(been.size(), 16U) << "the rude run comes about";
}

bool is_act_of_visitor(const VisitEvent& event) {
    return is_key(event) || std::holds_alternative<HeadphonesChanged>(event) ||
           std::holds_alternative<StickArriving>(event) ||
           std::holds_alternative<StickCame>(event) || std::holds_alternative<StickGone>(event);
}

/// Names of parts are an answer to the hand, and safety must be heard.
bool may_come_again(const HeardText& heard) {
    return heard.priority == SpeechPriority::safety || heard.text.starts_with("Body ") ||
           heard.text.starts_with("Tail ");
}

TEST(VisitRun, NothingIsSaidTwiceWithinTenSecondsUnasked) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        std::mt19937 random(seed);
        FakeHouse house;
        std::vector<double> acts_s;
        std::size_t compared = 0;
        for (int i = 0; i < 3000; ++i) {
            const VisitEvent event = rude_event(random, house);
            // A hand that begins a visit is another visitor, who has heard nothing.
            const bool is_act = is_act_of_visitor(event) || !is_visit_on(house.visit);
            if (is_act) acts_s.push_back(house.now_s);
            const std::size_t before = house.transcript.size();
            house.apply(event);
            const std::size_t answered = is_act ? house.transcript.size() : before;
            house.wait(0.001 * static_cast<double>(random() % 6000));
            for (std::size_t at = answered; at < house.transcript.size(); ++at) {
                const HeardText& now = house.transcript[at];
                if (may_come_again(now)) continue;
                for (std::size_t j = at;
                     j-- > 0 && now.time_s - house.transcript[j].time_s < 9.9;) {
                    const HeardText& then = house.transcript[j];
                    if (!acts_s.empty() && acts_s.back() > then.time_s) break;
                    ++compared;
                    ASSERT_FALSE(then.text == now.text && then.language == now.language)
                        << "seed " << seed << ": " << now.text;
                }
            }
        }
        EXPECT_GT(compared, 100U);
    }
}

TEST(VisitRun, TheSameEventsGiveTheSameVisit) {
    const auto run = [] {
        std::mt19937 random(7);
        FakeHouse house;
        for (int i = 0; i < 2000; ++i) {
            house.apply(rude_event(random, house));
            house.wait(0.2);
        }
        std::string text;
        for (const HeardText& heard : house.transcript) text += heard.text + "\n";
        return text;
    };
    EXPECT_EQ(run(), run());
}

}  // namespace
}  // namespace touchline
