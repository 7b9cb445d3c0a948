// Tests documents of many pages, and locked ones.
#include "tests/app/documents/decode/decoding_here.h"
#include "tests/app/documents/decode/pdf_writer.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glib.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(PdfDocument, EveryPageOfManyIsCountedAndOpens) {
    std::vector<WrittenPage> pages;
    for (int i = 1; i <= 300; ++i)
        pages.push_back({fmt::format("BT /F 40 Tf 100 400 Td (Number {}) Tj ET", i)});
    const auto pdf = written_pdf(pages);
    for (const int number : {1, 2, 200, 201, 299, 300}) {
        const auto page = decode_page(pdf, {number, 72});
        ASSERT_TRUE(page.has_value()) << page.error().line;
        EXPECT_EQ(page->number, number);
        EXPECT_EQ(page->count, 300);
        ASSERT_EQ(page->told.labels.size(), 1U);
        EXPECT_EQ(page->told.labels[0].text, fmt::format("Number {}", number));
    }
    const auto beyond = decode_page(pdf, {301, 72});
    ASSERT_FALSE(beyond.has_value());
    EXPECT_NE(beyond.error().line.find("the document has 300 pages"), std::string::npos);
    const auto crossed = answer_of(decode_page(pdf, {300, 72})).and_then([](const auto& bytes) {
        return page_of(bytes);
    });
    ASSERT_TRUE(crossed.has_value()) << crossed.error().line;
    EXPECT_EQ(crossed->count, 300);
    const auto work = work_in(arguments_of({WorkerKind::document, {300, 150}}));
    ASSERT_TRUE(work.has_value()) << "the worker is asked for it";
    EXPECT_EQ(work->order.page, 300);
}

TEST(DecodeWork, ALanguageGoesToTheWorkerAsATag) {
    const auto crossed = [](const std::string& tag) {
        return work_in(arguments_of({WorkerKind::document, {1, 150, {tag}}}));
    };
    for (const char* tag : {"en", "de", "pt-BR", ""})
        EXPECT_EQ(crossed(tag).value().order.language.text, tag);
    EXPECT_FALSE(crossed("de;x").has_value());
    EXPECT_FALSE(crossed(std::string(36, 'a')).has_value());
}

using Text = std::string;

/// Applies the cipher of the first encrypted documents.
Text enciphered(const Text& key, Text data) {
    std::array<std::uint8_t, 256> box{};
    for (std::size_t i = 0; i < 256; ++i) box.at(i) = static_cast<std::uint8_t>(i);
    std::uint8_t j = 0;
    for (std::size_t i = 0; i < 256; ++i) {
        j = static_cast<std::uint8_t>(j + box.at(i) +
                                      static_cast<std::uint8_t>(key[i % key.size()]));
        std::swap(box.at(i), box.at(j));
    }
    std::uint8_t i = 0;
    j = 0;
    for (char& c : data) {
        i = static_cast<std::uint8_t>(i + 1);
        j = static_cast<std::uint8_t>(j + box.at(i));
        std::swap(box.at(i), box.at(j));
        c = static_cast<char>(static_cast<std::uint8_t>(c) ^
                              box.at(static_cast<std::uint8_t>(box.at(i) + box.at(j))));
    }
    return data;
}

Text sum_of(const Text& data, std::size_t bytes) {
    std::array<guint8, 16> sum{};
    gsize size = sum.size();
    GChecksum* const md5 = g_checksum_new(G_CHECKSUM_MD5);
    g_checksum_update(md5, reinterpret_cast<const guchar*>(data.data()),
                      static_cast<gssize>(data.size()));
    g_checksum_get_digest(md5, sum.data(), &size);
    g_checksum_free(md5);
    return {reinterpret_cast<const char*>(sum.data()), bytes};
}

Text hex(const Text& data) {
    Text text = "<";
    for (const char c : data) text += fmt::format("{:02X}", static_cast<std::uint8_t>(c));
    return text + ">";
}

Text padded(const Text& password) {
    static const Text padding(
        "\x28\xBF\x4E\x5E\x4E\x75\x8A\x41\x64\x00\x4E\x56\xFF\xFA\x01\x08"
        "\x2E\x2E\x00\xB6\xD0\x68\x3E\x80\x2F\x0C\xA9\xFE\x64\x53\x69\x7A",
        32);
    return (password + padding).substr(0, 32);
}

/// A page with words, locked with a 40-bit key.
encoders::Bytes locked_pdf(const Text& user, const Text& owner) {
    const Text id = "sixteen letters.";
    const Text owner_entry = enciphered(sum_of(padded(owner), 5), padded(user));
    const Text key = sum_of(padded(user) + owner_entry + Text("\xfc\xff\xff\xff", 4) + id, 5);
    const Text user_entry = enciphered(key, padded(""));
    // The page's content is object 6, as five objects come before it.
    const Text content_key = sum_of(key + Text("\6\0\0\0\0", 5), 10);
    const Text content =
        enciphered(content_key, "BT /F 40 Tf 100 400 Td (Locked words) Tj ET 3 w 50 50 90 90 re S");
    PdfWriter pdf;
    pdf.add("<< /Type /Catalog /Pages 2 0 R >>");
    pdf.add("<< /Type /Pages /Kids [ 5 0 R ] /Count 1 >>");
    pdf.add(fmt::format("<< /Filter /Standard /V 1 /R 2 /O {} /U {} /P -4 >>", hex(owner_entry),
                        hex(user_entry)));
    pdf.add("<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>");
    pdf.add(
        "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 600 800] /Contents 6 0 R /Resources << /Font "
        "<< /F 4 0 R >> >> >>");
    pdf.add(stream_of("", content));
    return pdf.finish(1, fmt::format("/Encrypt 3 0 R /ID [{} {}]", hex(id), hex(id)));
}

TEST(PdfDocument, LockedAgainstChangesOnlyOpens) {
    const auto page = decode_page(locked_pdf("", "secret"));
    ASSERT_TRUE(page.has_value()) << page.error().line;
    ASSERT_EQ(page->told.labels.size(), 1U);
    EXPECT_EQ(page->told.labels[0].text, "Locked words");
    EXPECT_EQ(page->words.size(), 2U);
}

TEST(PdfDocument, LockedWithAPasswordIsRefusedForThat) {
    const auto page = decode_page(locked_pdf("open", "secret"));
    ASSERT_FALSE(page.has_value());
    EXPECT_NE(page.error().line.find("locked with a password"), std::string::npos)
        << page.error().line;
}

}  // namespace
}  // namespace touchline
