#include "tests/app/visit/visit_scenes.h"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

/// The last key, where the same one again does something else.
int tried_in_help(const Visitor& visitor) {
    const bool matters = visitor.last_key == KeyRole::help || visitor.last_key == KeyRole::back;
    return matters ? static_cast<int>(*visitor.last_key) : 0;
}

/// Names what tells two states apart for navigation; values of settings do not.
std::string name_of(const Visit& visit) {
    const Visitor& visitor = visit.visitor;
    std::string name;
    for (const Standing& standing : visitor.path) {
        name += fmt::format("/{}.{}-{}.{}", static_cast<int>(standing.screen), standing.about,
                            standing.end, standing.focus);
    }
    if (visitor.over) {
        name += fmt::format("+{}.{}", static_cast<int>(visitor.over->screen),
                            visitor.over->screen == VisitScreen::help ? tried_in_help(visitor) : 0);
    }
    if (visitor.felt) {
        const KnownPicture& felt = *visitor.felt;
        name += fmt::format(" {}z{}p{}v{}", static_cast<int>(felt.order.source),
                            felt.order.zoom.factor, felt.facts.place.page, felt.facts.place.view);
    }
    if (visitor.drawing)
        name += fmt::format("d{}{}", visitor.drawing->lines().size(),
                            visitor.drawing->can_redo() ? "r" : "");
    name += visitor.loading ? "l" : "";
    name += visitor.is_capturing ? "c" : "";
    name += visitor.leading ? "g" : "";
    name += visitor.stick_list ? "s" : "";
    const bool is_picture = visitor.path.back().screen == VisitScreen::picture;
    name += is_picture && visitor.feel.shape != HeldShape::none ? "h" : "";
    return name;
}

struct Edge {
    std::size_t from;
    std::size_t to;
    int presses;
};

class Search {
  public:
    explicit Search(FakeHouse& house) : house_(house) {}

    SceneGraph run() {
        find(house_.visit);
        for (std::size_t at = 0; at < graph_.visits.size(); ++at) follow(at);
        measure();
        graph_.steps = edges_.size();
        return std::move(graph_);
    }

  private:
    std::size_t find(const Visit& visit) {
        const auto [found, is_new] = numbers_.emplace(name_of(visit), graph_.visits.size());
        if (is_new) {
            graph_.visits.push_back(visit);
            graph_.names.push_back(found->first);
        }
        return found->second;
    }

    void follow(std::size_t at) {
        for (std::size_t role = 0; role < key_role_count; ++role) {
            const Visit before = graph_.visits[at];
            const VisitStep next =
                step(before, KeyPressed{static_cast<KeyRole>(role)}, house_.world());
            check(before, static_cast<KeyRole>(role), next);
            edges_.push_back({at, find(next.visit), 1});
        }
        for (const VisitEvent& event : events_of(graph_.visits[at])) {
            const VisitStep next = step(graph_.visits[at], event, house_.world());
            edges_.push_back({at, find(next.visit), 0});
        }
    }

    void check(const Visit& before, KeyRole role, const VisitStep& next) {
        const bool is_answered =
            std::any_of(next.orders.begin(), next.orders.end(), [](const VisitOrder& order) {
                return std::holds_alternative<Utterance>(order) ||
                       std::holds_alternative<GiveCue>(order);
            });
        const std::string where = fmt::format("{} key {}", name_of(before), static_cast<int>(role));
        if (!is_answered) graph_.unanswered.push_back(where);
        const bool is_lost = before.visitor.felt && !next.visit.visitor.felt;
        if (role == KeyRole::back && is_lost) graph_.lost.push_back(where);
    }

    static std::vector<VisitEvent> events_of(const Visit& visit) {
        const Visitor& visitor = visit.visitor;
        std::vector<VisitEvent> events;
        if (visitor.loading) {
            const LoadPicture& order = visitor.loading->order;
            events.emplace_back(PictureReady{order.request, fake_facts(order)});
            events.emplace_back(PictureFailed{order.request, {}});
        }
        if (visitor.drawing && visitor.drawing->lines().empty())
            events.emplace_back(PenStroke{{{-0.02, 0.0}, {0.02, 0.0}}});
        if (visitor.is_capturing) events.emplace_back(CameraCaptured{});
        if (visitor.leading && visitor.leading->has_begun) events.emplace_back(GuidanceEnded{});
        if (visitor.path.back().screen == VisitScreen::stick && !visitor.stick_list) {
            events.emplace_back(
                StickCame{{"3", "4", "5", "6", "7", "8", "boat", "lake", "letter"}, {}});
        }
        events.emplace_back(Tick{visit.site.now_s + 200.0});
        if (!visit.site.troubles[0]) events.emplace_back(TroubleBegan{TroubleKind::device, ""});
        events.emplace_back(TroubleEnded{TroubleKind::device});
        if (visitor.path.back().screen == VisitScreen::choose)
            events.emplace_back(OpeningChanged{SiteOpening::closed});
        return events;
    }

    /// Goes backwards from choose. Work that ends by itself costs no press, but is not waited for:
    /// only the way by keys counts.
    void measure() {
        std::vector<std::vector<std::size_t>> back(graph_.visits.size());
        for (const Edge& edge : edges_) {
            if (edge.presses == 1) back[edge.to].push_back(edge.from);
        }
        graph_.presses_to_choose.assign(graph_.visits.size(), -1);
        std::deque<std::size_t> queue;
        for (std::size_t i = 0; i < graph_.visits.size(); ++i) {
            if (open_screen(graph_.visits[i]) != VisitScreen::choose) continue;
            graph_.presses_to_choose[i] = 0;
            queue.push_back(i);
        }
        while (!queue.empty()) {
            const std::size_t at = queue.front();
            queue.pop_front();
            for (const std::size_t from : back[at]) {
                if (graph_.presses_to_choose[from] >= 0) continue;
                graph_.presses_to_choose[from] = graph_.presses_to_choose[at] + 1;
                queue.push_back(from);
            }
        }
    }

    FakeHouse& house_;
    SceneGraph graph_;
    std::map<std::string, std::size_t> numbers_;
    std::vector<Edge> edges_;
};

}  // namespace

bool has_item(const FakeHouse& house, VisitItem item) {
    const SpokenScreen screen = house.screen();
    return std::any_of(screen.items.begin(), screen.items.end(),
                       [item](const ScreenItem& one) { return one.id == static_cast<int>(item); });
}

void to_choose(FakeHouse& house) {
    house.press({KeyRole::select, KeyRole::select});
    ASSERT_EQ(house.open(), VisitScreen::choose);
}

void to_picture(FakeHouse& house) {
    to_choose(house);
    ASSERT_TRUE(house.choose("Gallery"));
    house.press({KeyRole::select, KeyRole::select});  // "very easy", and its first
    house.wait(house.load_s + 0.1);
    ASSERT_EQ(house.open(), VisitScreen::picture);
}

void to_stick_picture(FakeHouse& house, int count) {
    to_choose(house);
    std::vector<std::string> names;
    for (int i = 1; i <= count; ++i) names.push_back("file " + std::to_string(i));
    house.apply(StickCame{names, {}});
    ASSERT_TRUE(house.choose("Your USB stick"));
    house.press(KeyRole::select);
    house.wait(house.load_s + 0.1);
    ASSERT_EQ(house.open(), VisitScreen::picture);
}

void finish(FakeHouse& house) {
    while (house.open() != VisitScreen::choose) house.press(KeyRole::back);
    ASSERT_TRUE(house.choose("Finish"));
    ASSERT_TRUE(house.choose("Yes"));
    ASSERT_EQ(house.open(), VisitScreen::goodbye);
}

const SceneGraph& scene_graph() {
    static const SceneGraph graph = [] {
        FakeHouse house;
        return Search(house).run();
    }();
    return graph;
}

const std::vector<Visit>& scenes_of_all_screens() {
    return scene_graph().visits;
}

}  // namespace touchline
