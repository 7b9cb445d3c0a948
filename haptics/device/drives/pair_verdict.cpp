#include "haptics/device/drives/pair_verdict.h"

namespace touchline {

void PairVerdict::set_up() {
    state_ = PairState::setting_up;
    trouble_ = {};
    let_go_since_.reset();
}

void PairVerdict::be_ready() {
    state_ = PairState::ready;
    doubts_ = 0;
    may_clear_ = false;
}

void PairVerdict::doubt(const MotorTrouble& trouble) {
    if (doubts_++ > 0) return refuse(trouble);
    go_astray();
}

void PairVerdict::refuse(const MotorTrouble& trouble) {
    state_ = PairState::refused;
    trouble_ = trouble;
    doubts_ = 0;
    may_clear_ = true;
}

std::uint64_t PairVerdict::tell(bool has_torque) {
    ++told_;
    if (has_torque) zero_since_ = told_ + 1;
    return told_;
}

PairNews PairVerdict::news(const std::optional<ShaftTurns>& turns) const {
    return {state_, turns, is_held_zero(), let_go_since_ && let_go_ >= *let_go_since_, wrong_};
}

MotorTrouble PairVerdict::trouble(int silent) const {
    if (trouble_.kind != MotorTrouble::Kind::none || state_ == PairState::ready) return trouble_;
    return {MotorTrouble::Kind::silent, silent, 0};
}

}  // namespace touchline
