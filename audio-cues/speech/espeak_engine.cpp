#include "audio-cues/speech/espeak_engine.h"

#include <cstddef>

#include <espeak-ng/speak_lib.h>

/// Replaces libpcaudio's function: the engine would look for a sound device although it plays
/// nothing, and connect to the user's sound server by a thread of its own.
extern "C" void* create_audio_device_object(const char*, const char*, const char*) {
    return nullptr;
}

namespace touchline {
namespace {

constexpr int piece_ms = 20;

const SpeechSink* current_sink = nullptr;  // the library has one callback per process

int take_samples(short* samples, int count, espeak_EVENT*) {
    if (samples == nullptr || count <= 0 || current_sink == nullptr) return 0;
    const bool goes_on = (*current_sink)({samples, static_cast<std::size_t>(count)});
    return goes_on ? 0 : 1;
}

}  // namespace

Result<EspeakEngine> EspeakEngine::start(const std::string& voice) {
    const int found_Hz =
        espeak_Initialize(AUDIO_OUTPUT_SYNCHRONOUS, piece_ms, nullptr, espeakINITIALIZE_DONT_EXIT);
    if (found_Hz != rate_Hz) {
        return failure("The speech engine does not start; install espeak-ng-data.");
    }
    espeak_SetSynthCallback(take_samples);
    espeak_VOICE wanted{};
    wanted.languages = voice.c_str();
    if (espeak_SetVoiceByProperties(&wanted) != EE_OK) {
        return failure("The speech engine has no voice " + voice + ".");
    }
    EspeakEngine engine;
    // Makes the engine read every file now: it leaves to the English rules what a voice cannot read
    // itself (here a Chinese character) and, with a second copy of them since 1.52, the words that
    // a dictionary marks as English.
    engine.speak("a 你 software", {}, [](std::span<const std::int16_t>) { return true; });
    return engine;
}

void EspeakEngine::speak(const std::string& text, const EngineRate& rate, const SpeechSink& sink) {
    const std::string plain = plain_text(text);
    espeak_SetParameter(espeakRATE, rate.words_per_minute, 0);
    espeak_SetParameter(espeakWORDGAP, rate.word_gap, 0);
    current_sink = &sink;
    espeak_Synth(plain.c_str(), plain.size() + 1, 0, POS_CHARACTER, 0,
                 espeakCHARS_UTF8 | espeakENDPAUSE, nullptr, nullptr);
    current_sink = nullptr;
}

}  // namespace touchline
