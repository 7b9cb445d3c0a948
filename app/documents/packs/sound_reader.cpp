#include "app/documents/decode/one_line.h"
#include "app/documents/packs/plain_names.h"
#include "app/documents/packs/unpack_work.h"
#include "app/isolation/process/descriptor.h"
#include "audio-cues/speech/resampler.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

#include <sndfile.h>

namespace touchline {
namespace {

/// Bytes in memory that libsndfile reads like a file.
struct Memory {
    std::span<const std::byte> bytes;
    sf_count_t at = 0;
};

Memory& memory_of(void* user) {
    return *static_cast<Memory*>(user);
}

sf_count_t length(void* user) {
    return static_cast<sf_count_t>(memory_of(user).bytes.size());
}

sf_count_t seek(sf_count_t offset, int whence, void* user) {
    Memory& memory = memory_of(user);
    const sf_count_t base = whence == SEEK_CUR ? memory.at : whence == SEEK_END ? length(user) : 0;
    sf_count_t wanted = 0;
    if (!__builtin_add_overflow(base, offset, &wanted))
        memory.at = std::clamp<sf_count_t>(wanted, 0, length(user));
    return memory.at;
}

sf_count_t read(void* to, sf_count_t count, void* user) {
    Memory& memory = memory_of(user);
    const sf_count_t got = std::clamp<sf_count_t>(count, 0, length(user) - memory.at);
    if (got > 0)
        std::memcpy(to, &memory.bytes[static_cast<std::size_t>(memory.at)],
                    static_cast<std::size_t>(got));
    memory.at += got;
    return got;
}

sf_count_t write(const void*, sf_count_t, void*) {
    return 0;
}

sf_count_t tell(void* user) {
    return memory_of(user).at;
}

/// True for these forms only: libsndfile knows thirty more, which never reach it.
bool is_known(std::span<const std::byte> bytes) {
    using namespace std::string_view_literals;
    const std::string_view text = as_text(bytes);
    const bool is_wav =
        text.starts_with("RIFF"sv) && text.size() >= 12 && text.substr(8).starts_with("WAVE"sv);
    return is_wav || text.starts_with("OggS"sv) || text.starts_with("fLaC"sv);
}

/// Mixes down to mono. Does not trust the length that the file claims.
PackResult<std::vector<float>> all_samples(SNDFILE* file, const SF_INFO& info) {
    constexpr sf_count_t block_frames = 4096;
    const auto most = static_cast<std::size_t>(pack_limits.sound_s * info.samplerate);
    std::vector<float> block(static_cast<std::size_t>(block_frames * info.channels));
    std::vector<float> mono;
    for (;;) {
        const sf_count_t got = sf_readf_float(file, block.data(), block_frames);
        if (got <= 0) break;
        for (std::size_t i = 0; i < static_cast<std::size_t>(got); ++i) {
            float sum = 0.0F;
            for (int c = 0; c < info.channels; ++c)
                sum += block[i * static_cast<std::size_t>(info.channels) +
                             static_cast<std::size_t>(c)];
            const float sample = sum / static_cast<float>(info.channels);
            mono.push_back(std::isfinite(sample) ? std::clamp(sample, -1.0F, 1.0F) : 0.0F);
        }
        if (mono.size() > most) return refused(FindingKind::sound_long);
    }
    if (mono.empty() || sf_error(file) != SF_ERR_NO_ERROR)
        return refused(FindingKind::sound_broken);
    return mono;
}

std::vector<std::int16_t> whole_numbers(const std::vector<float>& samples) {
    std::vector<std::int16_t> made;
    made.reserve(samples.size());
    for (const float sample : samples)
        made.push_back(
            static_cast<std::int16_t>(std::lround(std::clamp(sample, -1.0F, 1.0F) * 32767.0F)));
    return made;
}

}  // namespace

PackResult<ReadSound> read_sound(std::span<const std::byte> bytes) {
    if (!is_known(bytes)) return refused(FindingKind::sound_unknown);
    Memory memory{bytes};
    SF_VIRTUAL_IO io{length, seek, read, write, tell};
    SF_INFO info{};
    const Owned<SNDFILE, sf_close> file(sf_open_virtual(&io, SFM_READ, &info, &memory));
    if (!file) return refused(FindingKind::sound_broken);
    const bool is_usual = info.channels >= 1 && info.channels <= 2 &&
                          info.samplerate >= least_rate_Hz && info.samplerate <= most_rate_Hz;
    if (!is_usual) return refused(FindingKind::sound_form);
    const auto mono = all_samples(file.get(), info);
    if (!mono) return refusal(mono.error());
    ReadSound sound{whole_numbers(at_frame_rate(*mono, info.samplerate)), {}};
    constexpr float quiet = 0.1F;  // -20 dB: speech peaks near full scale
    const bool is_quiet = std::all_of(mono->begin(), mono->end(),
                                      [](float sample) { return std::abs(sample) < quiet; });
    if (is_quiet) sound.findings.push_back({FindingKind::quiet_sound});
    return sound;
}

}  // namespace touchline
