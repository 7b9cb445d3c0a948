#include "audio-cues/speech/speech_input.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

std::string said(const std::string& table, const std::string& text) {
    return respelled(text, respellings_of(table));
}

TEST(Respelling, WholeWordsAreReplacedAndNoOthers) {
    const std::string table = "dos = dau; signe plus = signe plusse;l\u2019est=l\u2019este";
    EXPECT_EQ(said(table, "le dos, du dos."), "le dau, du dau.");
    EXPECT_EQ(said(table, "dossier ados Dos dos-\u00e0-dos dos\u00e9"),
              "dossier ados Dos dos-\u00e0-dos dos\u00e9");
    EXPECT_EQ(said(table, "signe plus fort"), "signe plusse fort");
    EXPECT_EQ(said(table, "vers l\u2019est \u00abdos\u00bb l\u2019estime"),
              "vers l\u2019este \u00abdau\u00bb l\u2019estime");
    EXPECT_EQ(said(table, "dos"), "dau");
}

/// An A before a word is an article; a letter is not.
TEST(Respelling, TheFirstRowThatFitsCounts) {
    const std::string table = "letter A \u2026 = letter eh \u2026; A \u2026 = A \u2026; A = eh";
    EXPECT_EQ(said(table, "A star. A USB stick, A 4-digit PIN, A \u201cstar\u201d"),
              "A star. A USB stick, A 4-digit PIN, A \u201cstar\u201d");
    EXPECT_EQ(said(table, "The letter A is a peak"), "The letter eh is a peak");
    EXPECT_EQ(said(table, "S A S, A, B and A"), "S eh S, eh, B and eh");
    EXPECT_EQ(said(table, "A\u00a0: x"), "eh\u00a0: x");
}

TEST(Respelling, WhatItGivesIsNotReadAgain) {
    EXPECT_EQ(said("a b = b a; b = c", "a b b"), "b a c");
    EXPECT_EQ(said("1:\u2026 = una:\u2026", "1:15, 11:15, page 1: a, 1:"),
              "una:15, 11:15, page 1: a, 1:");
}

TEST(Respelling, ATableThatIsNoneChangesNothing) {
    for (const std::string table : {"", "none", ";;", " = x", "\u2026 = x"})
        EXPECT_EQ(said(table, "none of x"), "none of x") << table;
}

RC_GTEST_PROP(Respelling, AnyTextAndAnyTableEnd, (const std::string& text)) {
    const std::string table =
        *rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab =;\xe2\x80\xa6")));
    (void)said(table, text);
    RC_ASSERT(said("", text) == text);
}

}  // namespace
}  // namespace touchline
