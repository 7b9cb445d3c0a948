#include "tests/machines/sim/inverse3/emulated_service.h"

#include <algorithm>
#include <utility>

namespace touchline {
namespace {

constexpr double turn_s = 5e-5;  // how often what carries the frames looks

}  // namespace

EmulatedService::EmulatedService(ServiceEmulator& service, double& now_s, std::string_view name)
    : service_(service), now_s_(now_s), session_(name), caught_up_s_(now_s) {
    to_client_.push_back({now_s + way_s, service_.greet()});
}

ArmNews EmulatedService::news() {
    catch_up(now_s_);
    return session_.news();
}

void EmulatedService::tell(const WantedArmForce& wanted) {
    catch_up(now_s_);
    wanted_ = wanted;
}

void EmulatedService::rest(double span_s) {
    now_s_ += span_s;
    catch_up(now_s_);
}

void EmulatedService::spoil(AnswerFault fault, int count, double late_s) {
    fault_ = fault;
    faults_left_ = count;
    late_s_ = late_s;
}

void EmulatedService::close() {
    if (is_closed_) return;
    catch_up(now_s_);
    is_closed_ = true;
    session_.lose();
    service_.leave();
}

void EmulatedService::catch_up(double t_s) {
    while (caught_up_s_ + turn_s <= t_s) {
        caught_up_s_ += turn_s;
        service_.advance_to(caught_up_s_);
        if (!is_closed_) exchange(caught_up_s_);
    }
    service_.advance_to(t_s);
}

void EmulatedService::exchange(double t_s) {
    while (!to_service_.empty() && to_service_.front().at_s <= t_s) {
        send_answer(service_.answer(to_service_.front().text), t_s + way_s);
        to_service_.pop_front();
    }
    while (!is_frozen_ && !to_client_.empty() && to_client_.front().at_s <= t_s) {
        session_.hear(to_client_.front().text, t_s);
        to_client_.pop_front();
    }
    const auto command = is_frozen_ ? std::nullopt : session_.due(wanted_, t_s);
    if (!command) return;
    ++sent_;
    to_service_.push_back({t_s + way_s, std::string(command->text())});
}

// Answers keep their order: one that is late holds up the others.
void EmulatedService::send_answer(const std::string& text, double at_s) {
    const AnswerFault fault = faults_left_ > 0 ? fault_ : AnswerFault::none;
    faults_left_ = std::max(faults_left_ - 1, 0);
    OnTheWay answer{fault == AnswerFault::late ? at_s + late_s_ : at_s, text};
    if (!to_client_.empty()) answer.at_s = std::max(answer.at_s, to_client_.back().at_s);
    switch (fault) {
        case AnswerFault::none:
        case AnswerFault::late:
            break;
        case AnswerFault::lost:
            return;
        case AnswerFault::cut:
            answer.text.resize(text.size() / 2);
            break;
        case AnswerFault::garbled:
            answer.text[text.size() / 3] = '{';
            break;
        case AnswerFault::doubled:
            to_client_.push_back(answer);
            break;
        case AnswerFault::other_arm: {
            const std::string& name = service_.arm().name;
            answer.text.replace(text.find('"' + name + '"') + 1, name.size(), "other");
            break;
        }
    }
    to_client_.push_back(std::move(answer));
}

}  // namespace touchline
