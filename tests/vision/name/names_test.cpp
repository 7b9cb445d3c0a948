#include "vision/name/names.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline::testing {
namespace {

/// The kinds that the network knows, in its order.
const std::vector<std::string> coco{"person",        "bicycle",      "car",
                                    "motorcycle",    "airplane",     "bus",
                                    "train",         "truck",        "boat",
                                    "traffic light", "fire hydrant", "stop sign",
                                    "parking meter", "bench",        "bird",
                                    "cat",           "dog",          "horse",
                                    "sheep",         "cow",          "elephant",
                                    "bear",          "zebra",        "giraffe",
                                    "backpack",      "umbrella",     "handbag",
                                    "tie",           "suitcase",     "frisbee",
                                    "skis",          "snowboard",    "sports ball",
                                    "kite",          "baseball bat", "baseball glove",
                                    "skateboard",    "surfboard",    "tennis racket",
                                    "bottle",        "wine glass",   "cup",
                                    "fork",          "knife",        "spoon",
                                    "bowl",          "banana",       "apple",
                                    "sandwich",      "orange",       "broccoli",
                                    "carrot",        "hot dog",      "pizza",
                                    "donut",         "cake",         "chair",
                                    "couch",         "potted plant", "bed",
                                    "dining table",  "toilet",       "tv",
                                    "laptop",        "mouse",        "remote",
                                    "keyboard",      "cell phone",   "microwave",
                                    "oven",          "toaster",      "sink",
                                    "refrigerator",  "book",         "clock",
                                    "vase",          "scissors",     "teddy bear",
                                    "hair drier",    "toothbrush"};

/// The kinds with another name here.
const std::map<std::string, std::string> our_word{
    {"airplane", "aeroplane"}, {"couch", "sofa"}, {"dining table", "table"}, {"tv", "screen"}};

const std::set<std::string> said{
    "person", "bicycle", "car",          "motorcycle", "airplane",     "bus",     "train",
    "truck",  "boat",    "bench",        "bird",       "cat",          "dog",     "horse",
    "sheep",  "cow",     "elephant",     "bear",       "zebra",        "giraffe", "umbrella",
    "chair",  "couch",   "potted plant", "bed",        "dining table", "tv",      "refrigerator"};

int kind_of(const std::string& word) {
    return static_cast<int>(std::ranges::find(coco, word) - coco.begin());
}

/// A box of that width, 0.2 high.
Detection found(const std::string& word, double likelihood, double width = 0.2) {
    return {kind_of(word), likelihood, {0.1, 0.1, 0.1 + width, 0.3}};
}

std::vector<std::string> ids(const std::vector<Detection>& detections) {
    std::vector<std::string> ids;
    for (const NamedThing& thing : names_of(detections)) ids.emplace_back(id_of(thing.name));
    return ids;
}

using Ids = std::vector<std::string>;

TEST(Names, OnlyWhatMayBeSaidHasAWordHoweverSure) {
    ASSERT_EQ(coco.size(), static_cast<std::size_t>(known_kinds));
    for (const std::string& word : coco) {
        if (said.contains(word)) {
            const std::string ours = our_word.contains(word) ? our_word.at(word) : word;
            EXPECT_EQ(ids({found(word, 1.0)}), Ids{ours});
        } else {
            EXPECT_EQ(ids({found(word, 1.0)}), Ids{}) << word;
        }
    }
}

TEST(Names, BelowItsLimitAnAnimalIsAnAnimalAndAVehicleAVehicle) {
    const std::set<std::string> animals{"bird", "cat",      "dog",  "horse", "sheep",
                                        "cow",  "elephant", "bear", "zebra", "giraffe"};
    const std::set<std::string> vehicles{"bicycle", "car",   "motorcycle", "airplane",
                                         "bus",     "train", "truck",      "boat"};
    for (const std::string& word : said) {
        const Ids own = ids({found(word, 1.0)});
        std::set<Ids> tiers;
        for (double likelihood = 0.35; likelihood < 1.0; likelihood += 0.001) {
            const Ids now = ids({found(word, likelihood)});
            tiers.insert(now);
            EXPECT_TRUE(likelihood >= 0.45 || now.empty()) << word;
            EXPECT_TRUE(likelihood >= 0.59 || now != own) << word;
        }
        std::set<Ids> expected{{}, own};
        if (animals.contains(word)) expected.insert(Ids{"animal"});
        // A car is named as soon as it is a vehicle.
        if (vehicles.contains(word) && word != "car") expected.insert(Ids{"vehicle"});
        EXPECT_EQ(tiers, expected) << word;
    }
}

TEST(Names, TigersAndRhinocerosesAreNoZebrasAndElephants) {
    EXPECT_EQ(ids({found("zebra", 0.80)}), Ids{"animal"});     // really a tiger
    EXPECT_EQ(ids({found("elephant", 0.78)}), Ids{"animal"});  // really a rhinoceros
}

TEST(Names, BesideADogNothingIsAnAnimal) {
    EXPECT_EQ(ids({found("dog", 0.9), found("cow", 0.51, 0.5)}), Ids{"dog"});
    EXPECT_EQ(ids({found("cow", 0.51), found("sheep", 0.51)}), (Ids{"animal", "animal"}));
    EXPECT_EQ(ids({found("boat", 0.9), found("bus", 0.65, 0.5), found("cow", 0.51)}),
              (Ids{"boat", "animal"}));
}

TEST(Names, BesideOneThatIsSureOthersOfItCount) {
    EXPECT_EQ(ids({found("zebra", 0.85), found("zebra", 0.73), found("zebra", 0.46)}),
              (Ids{"zebra", "zebra", "zebra"}));
    EXPECT_EQ(ids({found("zebra", 0.85), found("zebra", 0.44)}), Ids{"zebra"});
    EXPECT_EQ(ids({found("zebra", 0.73), found("horse", 0.46)}), (Ids{"animal", "animal"}));
    EXPECT_EQ(ids({found("person", 0.9), found("chair", 0.5)}), Ids{"person"});
}

TEST(Names, TheLargestIsFirstAndThreeNamesAreEnough) {
    EXPECT_EQ(ids({found("person", 0.9, 0.1), found("bus", 0.8, 0.6), found("dog", 0.9, 0.3),
                   found("car", 0.9, 0.05), found("person", 0.7, 0.02)}),
              (Ids{"bus", "dog", "person", "person"}));
    const std::vector<Detection> crowd(300, found("person", 0.9));
    EXPECT_EQ(names_of(crowd).size(), most_named_things);
    EXPECT_TRUE(names_of({}).empty());
}

TEST(Names, PeopleAreFoundForFacesBeforeTheyAreSaid) {
    const std::vector<Detection> all{found("person", 0.9, 0.1), found("dog", 0.8),
                                     found("person", 0.36, 0.3)};
    const auto people = people_in(all);
    ASSERT_EQ(people.size(), 2U);
    EXPECT_EQ(people[0], all[0].box);
    EXPECT_EQ(people[1], all[2].box);
    EXPECT_EQ(ids({found("person", 0.36)}), Ids{});
}

RC_GTEST_PROP(Names, AreOfThingsThatWereFoundAndNoMoreThanAFew, ()) {
    const auto detections = *rc::gen::container<std::vector<Detection>>(
        rc::gen::map(rc::gen::tuple(rc::gen::inRange(-1, known_kinds + 1),
                                    rc::gen::inRange(350, 1001), rc::gen::inRange(1, 900)),
                     [](const std::tuple<int, int, int>& of) {
                         return Detection{std::get<0>(of),
                                          std::get<1>(of) / 1000.0,
                                          {0.0, 0.1, std::get<2>(of) / 1000.0, 0.4}};
                     }));
    const auto things = names_of(detections);
    std::set<ThingName> names;
    for (std::size_t i = 0; i < things.size(); ++i) {
        names.insert(things[i].name);
        RC_ASSERT(std::ranges::any_of(detections, [&](const Detection& detection) {
            return detection.box == things[i].box && detection.likelihood == things[i].likelihood;
        }));
        if (i > 0) RC_ASSERT(area_of(things[i - 1].box) >= area_of(things[i].box));
    }
    RC_ASSERT(names.size() <= most_names && things.size() <= most_named_things);
}

}  // namespace
}  // namespace touchline::testing
