// Shows what a simulated hand hears: hear_picture MAP.svg OUT.wav OUT.png
#include "app/documents/decode/map_svg.h"
#include "app/documents/decode/picture.h"
#include "tests/audio-cues/hand/hand_sound.h"
#include "tests/audio-cues/hand/rows_of_picture.h"
#include "tests/audio-cues/hand/spectrogram.h"
#include "tests/audio-cues/wav_bytes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

int main(int argc, char** argv) {
    using namespace touchline;
    if (argc != 4) {
        std::fprintf(stderr, "usage: hear_picture MAP.svg OUT.wav OUT.png\n");
        return 2;
    }
    const auto map = read_map_svg(argv[1]);
    const auto run =
        map ? follow(*map, rows_of_picture(map->area), 0.04) : tl::unexpected(map.error());
    if (!run) {
        std::fprintf(stderr, "%s\n", run.error().line.c_str());
        return 1;
    }
    const auto sound = sound_of(*run, CueAmount::full);
    std::vector<int> samples;
    for (const StereoFrame& frame : sound) {
        for (const float sample : {frame.left, frame.right}) {
            samples.push_back(static_cast<int>(std::lround(32767.0F * sample)));
        }
    }
    std::ofstream(argv[2], std::ios::binary) << wav_bytes(frame_rate_Hz, 2, samples);
    const auto columns = static_cast<int>(std::min<std::size_t>(1200, sound.size() / 480));
    const Spectrogram picture = spectrogram_of(sound, columns);
    const auto written =
        write_png(argv[3], GreyView{picture.width, picture.height, picture.pixels});
    std::printf("%zu events in %.1f s\n", run->events.size(), 1e-3 * double(run->handle.size()));
    return written ? 0 : 1;
}
