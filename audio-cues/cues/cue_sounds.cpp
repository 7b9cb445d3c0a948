#include "audio-cues/cues/cue_sounds.h"

#include "audio-cues/cues/cue_table.h"

namespace touchline {

MixerCommand sound_of(const CueAt& cue, FrameTime frame) {
    const CueRow& row = row_of(cue.cue);
    return {frame, PlayEarcon{row.earcon, row.level, cue.pan, cue.is_alert}};
}

}  // namespace touchline
