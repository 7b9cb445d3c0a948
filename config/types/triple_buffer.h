// The latest value, from one thread or process to another, neither of which can wait.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace touchline {

/// Hands the latest value from one writer to one reader, lock-free and wait-free. Each side owns
/// one of three slots, and both swap theirs with the one in between. In memory that two processes
/// share, a corrupted peer can spoil the values but not the indices: there are as many slots as an
/// index has values.
template <class T>
class TripleBuffer {
    static_assert(std::is_trivially_copyable_v<T>, "values are copied while nobody can wait");

  public:
    explicit TripleBuffer(const T& initial = T{}) { slots_.fill(initial); }

    /// Writer.
    void write(const T& value) {
        slots_[write_slot_ & slot_mask] = value;
        const std::uint8_t free = middle_.exchange(
            static_cast<std::uint8_t>(write_slot_ | is_new_bit), std::memory_order_acq_rel);
        write_slot_ = free & slot_mask;
    }

    /// Reader: takes the newest value if there is one since the last call.
    bool update() {
        if ((middle_.load(std::memory_order_relaxed) & is_new_bit) == 0) return false;
        const std::uint8_t taken = middle_.exchange(read_slot_, std::memory_order_acq_rel);
        read_slot_ = taken & slot_mask;
        return true;
    }

    /// Reader: returns the value taken last.
    [[nodiscard]] const T& value() const { return slots_[read_slot_ & slot_mask]; }

  private:
    static constexpr std::uint8_t slot_mask = 3;
    static constexpr std::uint8_t is_new_bit = 4;

    static_assert(std::atomic<std::uint8_t>::is_always_lock_free);

    std::array<T, slot_mask + 1> slots_;  // three in use
    std::atomic<std::uint8_t> middle_{1};
    std::uint8_t write_slot_ = 0;  // the writer's
    std::uint8_t read_slot_ = 2;   // the reader's
};

}  // namespace touchline
