#include "tests/app/documents/packs/made_packs.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include <sndfile.h>
#include <zlib.h>

namespace touchline::made {
namespace {

template <class Number>
std::string number(Number value) {
    std::string made(sizeof value, '\0');
    std::memcpy(made.data(), &value, sizeof value);
    return made;
}

std::string deflated(const std::string& contents) {
    z_stream stream{};
    deflateInit2(&stream, 9, Z_DEFLATED, -15, 9, Z_DEFAULT_STRATEGY);
    std::string made(deflateBound(&stream, contents.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(contents.data()));
    stream.avail_in = static_cast<uInt>(contents.size());
    stream.next_out = reinterpret_cast<Bytef*>(made.data());
    stream.avail_out = static_cast<uInt>(made.size());
    deflate(&stream, Z_FINISH);
    made.resize(stream.total_out);
    deflateEnd(&stream);
    return made;
}

struct Sink {
    std::vector<std::byte> bytes;
    sf_count_t at = 0;
};

Sink& sink_of(void* user) {
    return *static_cast<Sink*>(user);
}

SF_VIRTUAL_IO sink_calls() {
    return {[](void* user) { return static_cast<sf_count_t>(sink_of(user).bytes.size()); },
            [](sf_count_t offset, int whence, void* user) {
                Sink& sink = sink_of(user);
                const auto end = static_cast<sf_count_t>(sink.bytes.size());
                sink.at = offset + (whence == SEEK_CUR ? sink.at : whence == SEEK_END ? end : 0);
                return sink.at;
            },
            [](void*, sf_count_t, void*) { return sf_count_t{0}; },
            [](const void* from, sf_count_t count, void* user) {
                Sink& sink = sink_of(user);
                const auto end = static_cast<std::size_t>(sink.at + count);
                if (sink.bytes.size() < end) sink.bytes.resize(end);
                std::memcpy(&sink.bytes[static_cast<std::size_t>(sink.at)], from,
                            static_cast<std::size_t>(count));
                sink.at += count;
                return count;
            },
            [](void* user) { return sink_of(user).at; }};
}

}  // namespace

Bytes bytes_of(std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

std::string text_of(const Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Bytes zip(const std::vector<Member>& members) {
    std::string whole;
    std::string list;
    for (const Member& member : members) {
        const std::string packed = member.is_deflated ? deflated(member.contents) : member.contents;
        const auto* const first = reinterpret_cast<const Bytef*>(member.contents.data());
        const auto sum =
            static_cast<std::uint32_t>(crc32(0, first, static_cast<uInt>(member.contents.size())));
        const auto size = member.claimed_bytes == 0xffffffff
                              ? static_cast<std::uint32_t>(member.contents.size())
                              : member.claimed_bytes;
        const std::string& local = member.local_name.empty() ? member.name : member.local_name;
        const auto fields = [&](const std::string& name) {
            const std::uint16_t method = member.is_deflated ? 8 : 0;
            return number<std::uint16_t>(20) + number(member.flags) + number(method) +
                   number<std::uint32_t>(0x00210000) + number(sum) +
                   number(static_cast<std::uint32_t>(packed.size())) + number(size) +
                   number(static_cast<std::uint16_t>(name.size())) + number<std::uint16_t>(0);
        };
        const auto at = static_cast<std::uint32_t>(whole.size());
        whole += "PK\3\4" + fields(local) + local + packed;
        list += "PK\1\2" + number(static_cast<std::uint16_t>(member.made_by << 8U | 20U)) +
                fields(member.name) + std::string(6, '\0') + number(member.attributes) +
                number(at) + member.name;
    }
    const auto count = number(static_cast<std::uint16_t>(members.size()));
    const auto at = static_cast<std::uint32_t>(whole.size());
    whole += list + "PK\5\6" + std::string(4, '\0') + count + count +
             number(static_cast<std::uint32_t>(list.size())) + number(at) + std::string(2, '\0');
    return bytes_of(whole);
}

Member zeros(const std::string& name, std::size_t count) {
    Member member;
    member.name = name;
    member.contents.assign(count, '\0');
    member.is_deflated = true;
    return member;
}

std::vector<Member> small_pack() {
    Member table;
    table.name = "pack.toml";
    table.contents =
        "id = \"small\"\ntitle = \"Small\"\nauthor = \"A\"\nlicence = \"CC0-1.0\"\n"
        "version = \"1.0\"\nlanguages = [\"en\"]\n[[picture]]\nfile = \"a.svg\"\n";
    Member picture;
    picture.name = "a.svg";
    picture.contents =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"116mm\" height=\"84mm\" "
        "viewBox=\"0 0 116 84\" data-difficulty=\"1\"><title>A ring</title><desc>A ring.</desc>"
        "<circle id=\"ring\" cx=\"58\" cy=\"42\" r=\"20\"><title>Ring</title></circle></svg>";
    return {table, picture};
}

Bytes recording(int format, int rate_Hz, double length_s, int channels, float loudness,
                float tone_Hz) {
    SF_INFO info{};
    info.samplerate = rate_Hz;
    info.channels = channels;
    info.format = format;
    SF_VIRTUAL_IO calls = sink_calls();
    Sink sink;
    SNDFILE* file = sf_open_virtual(&calls, SFM_WRITE, &info, &sink);
    if (file == nullptr) return {};
    std::vector<float> samples;
    const int frames = static_cast<int>(length_s * rate_Hz);
    for (int i = 0; i < frames; ++i)
        for (int c = 0; c < channels; ++c)
            samples.push_back(loudness *
                              std::sin(2.0F * 3.14159265F * tone_Hz * static_cast<float>(i) /
                                       static_cast<float>(rate_Hz)));
    sf_writef_float(file, samples.data(), frames);
    sf_close(file);
    return sink.bytes;
}

Bytes ogg() {
    return recording(SF_FORMAT_OGG | SF_FORMAT_VORBIS, 44100, 0.4);
}

void mend_ogg_sums(Bytes& bytes) {
    constexpr std::size_t header = 27;
    constexpr std::size_t sum_at = 22;
    for (std::size_t at = 0; at + header <= bytes.size();) {
        if (std::memcmp(&bytes[at], "OggS", 4) != 0) {
            ++at;
            continue;
        }
        const std::size_t segments = std::to_integer<std::size_t>(bytes[at + 26]);
        std::size_t size = header + segments;
        for (std::size_t i = 0; i < segments && at + header + i < bytes.size(); ++i)
            size += std::to_integer<std::size_t>(bytes[at + header + i]);
        size = std::min(size, bytes.size() - at);
        std::memset(&bytes[at + sum_at], 0, 4);
        std::uint32_t sum = 0;
        for (std::size_t i = at; i < at + size; ++i) {
            sum ^= std::to_integer<std::uint32_t>(bytes[i]) << 24U;
            for (int bit = 0; bit < 8; ++bit)
                sum = (sum << 1U) ^ ((sum & 0x80000000U) != 0 ? 0x04c11db7U : 0U);
        }
        std::memcpy(&bytes[at + sum_at], &sum, sizeof sum);
        at += size;
    }
}

int mutation_count(int a_day) {
    const char* const wished = std::getenv("TOUCHLINE_MUTATIONS");
    return wished != nullptr ? std::atoi(wished) : a_day;
}

std::string example_pack() {
    return TOUCHLINE_SOURCE_DIR "/tests/data/packs/shapes-and-a-boat";
}

}  // namespace touchline::made
