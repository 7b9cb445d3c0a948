// Replaces an operator, a number or a condition so that its mutant can be chosen while the program
// runs: one build for all mutants of a folder. Included before every source that is made with
// mutants; schemata.py writes the uses.
//
// A binary operator becomes two with an object between: `a < b` is written `a <Less{17}> b`. Both
// have the precedence of the original, so that nothing has to find the operands.
#pragma once

#include <initializer_list>
#include <type_traits>
#include <utility>

namespace mutation {

inline constexpr unsigned char reached = 1;
inline constexpr unsigned char does_not_compile = 2;

inline constexpr int none = -1;  // not 0, which means that a number has no mutant for 0 or 1

extern int active;             // the chosen mutant
extern unsigned char* states;  // of all mutants: reached or not

inline bool on(int mutant) {
    states[mutant] = reached;
    return __builtin_expect(active == mutant, false);
}

template <class T>
T number(int as_zero, int as_one, T value) {
    if (on(as_zero)) return static_cast<T>(0);
    return on(as_one) ? static_cast<T>(1) : value;
}

inline bool truth(int mutant, bool value) {
    return on(mutant) != value;
}

/// Evaluates `a && b && c`, or with `||` if `is_any`; the mutant between two operands joins them
/// the other way, with && binding tighter as in the text.
template <bool is_any, int... mutants, class... Operands>
bool chain(const Operands&... operands) {
    constexpr int between[] = {0, mutants...};
    bool is_found = false;
    bool holds = true;  // of the operands joined by && so far
    int i = 0;
    const auto take = [&](const auto& operand) {
        if (i > 0 && on(between[i]) != is_any) {
            is_found = is_found || holds;
            holds = true;
        }
        if (!is_found && holds) holds = operand();
        ++i;
    };
    (take(operands), ...);
    return is_found || holds;
}

#define TOUCHLINE_OPERATOR(Name, opening, closing, real, changed)                 \
    struct Name {                                                                 \
        int mutant;                                                               \
    };                                                                            \
    template <class Left>                                                         \
    struct Name##Left {                                                           \
        Left&& left;                                                              \
        int mutant;                                                               \
    };                                                                            \
    template <class Left>                                                         \
    Name##Left<Left> operator opening(Left&& left, Name at) {                     \
        return {std::forward<Left>(left), at.mutant};                             \
    }                                                                             \
    template <class Left, class Right>                                            \
    auto operator closing(Name##Left<Left>&& at, Right&& right)                   \
        ->decltype(std::forward<Left>(at.left) real std::forward<Right>(right)) { \
        TOUCHLINE_EITHER(Left, at.left, at.mutant, real, changed)                 \
    }

// Assignment binds from the right, so the object takes its right side first.
#define TOUCHLINE_ASSIGNMENT(Name, real, changed)               \
    struct Name {                                               \
        int mutant;                                             \
    };                                                          \
    template <class Right>                                      \
    struct Name##Right {                                        \
        Right&& right;                                          \
        int mutant;                                             \
    };                                                          \
    template <class Right>                                      \
    Name##Right<Right> operator real(Name at, Right&& right) {  \
        return {std::forward<Right>(right), at.mutant};         \
    }                                                           \
    template <class Left, class Right>                          \
    auto operator real(Left& left, Name##Right<Right>&& at)     \
        ->decltype(left real std::forward<Right>(at.right)) {   \
        auto&& right = std::forward<Right>(at.right);           \
        TOUCHLINE_EITHER(Left&, left, at.mutant, real, changed) \
    }

#define TOUCHLINE_EITHER(Left, left, mutant, real, changed)                                        \
    using Real = decltype(std::forward<Left>(left) real std::forward<Right>(right));               \
    if constexpr (requires {                                                                       \
                      static_cast<Real>(std::forward<Left>(left)                                   \
                                            changed std::forward<Right>(right));                   \
                  }) {                                                                             \
        if (on(mutant)) {                                                                          \
            return static_cast<Real>(std::forward<Left>(left) changed std::forward<Right>(right)); \
        }                                                                                          \
    } else {                                                                                       \
        states[mutant] = does_not_compile;                                                         \
    }                                                                                              \
    return std::forward<Left>(left) real std::forward<Right>(right);

TOUCHLINE_OPERATOR(Less, <, >, <, <=)
TOUCHLINE_OPERATOR(LessOrEqual, <, >, <=, <)
TOUCHLINE_OPERATOR(Greater, <, >, >, >=)
TOUCHLINE_OPERATOR(GreaterOrEqual, <, >, >=, >)
TOUCHLINE_OPERATOR(Equal, ==, ==, ==, !=)
TOUCHLINE_OPERATOR(Unequal, ==, ==, !=, ==)
TOUCHLINE_OPERATOR(Plus, +, +, +, -)
TOUCHLINE_OPERATOR(Minus, +, +, -, +)
TOUCHLINE_OPERATOR(Times, *, *, *, /)
TOUCHLINE_OPERATOR(Over, *, *, /, *)
TOUCHLINE_ASSIGNMENT(Add, +=, -=)
TOUCHLINE_ASSIGNMENT(Subtract, -=, +=)
TOUCHLINE_ASSIGNMENT(Multiply, *=, /=)
TOUCHLINE_ASSIGNMENT(Divide, /=, *=)

/// std::min() and std::max(), which change places.
template <bool is_least>
struct Extremum {
    int mutant;

    template <class T>
    const T& operator()(const T& a, const T& b) const {
        const bool is_first = on(mutant) != is_least ? !(b < a) : !(a < b);
        return is_first ? a : b;
    }

    template <class T>
    T operator()(std::initializer_list<T> values) const {
        const T* found = values.begin();
        for (const T& value : values) {
            if (on(mutant) != is_least ? value < *found : *found < value) found = &value;
        }
        return *found;
    }
};

}  // namespace mutation
