// Passes values from any number of threads to one, without a lock.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

namespace touchline {

/// Vyukov's bounded queue, with one reader. A writer never waits for the reader: if `capacity`
/// values (a power of two) wait to be read, push() gives up. The reader never waits for a writer.
/// Order is kept per writer. Rejected: the servo's ring, which has only one writer.
template <class T, std::size_t capacity>
class CommandQueue {
    static_assert(std::is_trivially_copyable_v<T>, "values are copied while nobody can wait");
    static_assert((capacity & (capacity - 1)) == 0, "indices run on past the end");
    static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

  public:
    CommandQueue() {
        for (std::size_t i = 0; i < capacity; ++i) slots_[i].turn.store(i);
    }

    /// Any thread. Returns false, and counts the loss, if the queue is full.
    bool push(const T& value) {
        std::uint64_t end = end_.load(std::memory_order_relaxed);
        while (true) {
            Slot& slot = slots_[end % capacity];
            const std::uint64_t turn = slot.turn.load(std::memory_order_acquire);
            if (turn < end) {
                dropped_.fetch_add(1, std::memory_order_relaxed);
                return false;
            }
            if (turn > end) {
                end = end_.load(std::memory_order_relaxed);  // another writer was here
            } else if (end_.compare_exchange_weak(end, end + 1, std::memory_order_relaxed)) {
                slot.value = value;
                slot.turn.store(end + 1, std::memory_order_release);
                return true;
            }
        }
    }

    /// The reader: returns the oldest complete value.
    std::optional<T> pop() {
        Slot& slot = slots_[begin_ % capacity];
        if (slot.turn.load(std::memory_order_acquire) != begin_ + 1) return std::nullopt;
        const T value = slot.value;
        slot.turn.store(begin_ + capacity, std::memory_order_release);
        ++begin_;
        return value;
    }

    /// Any thread: the number lost so far.
    [[nodiscard]] std::uint64_t dropped() const { return dropped_.load(std::memory_order_relaxed); }

  private:
    struct Slot {
        std::atomic<std::uint64_t> turn{0};  // the index that may write here; one more: read
        T value{};
    };

    std::array<Slot, capacity> slots_;
    std::atomic<std::uint64_t> end_{0};
    std::uint64_t begin_ = 0;  // the reader's
    std::atomic<std::uint64_t> dropped_{0};
};

}  // namespace touchline
