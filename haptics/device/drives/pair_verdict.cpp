#include "haptics/device/drives/pair_verdict.h"

namespace touchline {

void PairVerdict::step(double elapsed_s) {
    now_s_ += elapsed_s;
    turns_.reset();
}

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
    told_at_.ask(now_s_);
    if (has_torque) zero_since_ = told_ + 1;
    return told_;
}

void PairVerdict::hear_turns(std::uint64_t number, ShaftTurns turns) {
    turns_ = turns;
    late_s_ = told_at_.late_s(told_ - number);
}

PairNews PairVerdict::news() const {
    const bool is_let_go = let_go_since_ && let_go_ >= *let_go_since_;
    return {state_, turns_, late_s_, is_held_zero(), is_let_go, wrong_};
}

MotorTrouble PairVerdict::trouble(int silent) const {
    if (trouble_.kind != MotorTrouble::Kind::none || state_ == PairState::ready) return trouble_;
    return {MotorTrouble::Kind::silent, silent, 0};
}

}  // namespace touchline
