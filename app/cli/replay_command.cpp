#include "app/cli/commands.h"
#include "app/cli/hand_csv.h"
#include "app/cli/load.h"
#include "app/documents/decode/files.h"
#include "app/documents/gallery/gallery.h"
#include "app/force/servo/scene_order.h"
#include "haptics/servo/recording.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <vector>

#include <fmt/format.h>

namespace touchline {
namespace {

Result<Recording> read_recording(const std::string& path) {
    return read_file(path)
        .and_then([](const std::vector<std::byte>& bytes) { return recording_of(bytes); })
        .map_error([&path](const Error& error) {
            const bool names_path = error.line.starts_with(path);
            return names_path ? error : Error{fmt::format("{}: {}", path, error.line)};
        });
}

/// A name from a file must not lead out of the gallery.
bool is_plain_name(const std::string& name) {
    return !name.empty() && name.front() != '.' && name.find('/') == std::string::npos;
}

Result<std::shared_ptr<const Scene>> scene_of(const RecordedMap& map,
                                              const DeviceProfile& profile) {
    if (!is_plain_name(map.gallery_file)) return failure("it names no picture of the gallery");
    const std::string path = gallery_folder() + "/" + map.gallery_file;
    auto felt = load_drawing(path, map.detail);
    if (!felt) return tl::unexpected(felt.error());
    if (hash_of(*felt) != map.hash) {
        return failure(fmt::format("{} is not the picture that was felt", path));
    }
    felt->version = map.version;
    return build_scene(*felt, felt_order(profile, map.detail)).map([](Scene scene) {
        return std::make_shared<const Scene>(std::move(scene));
    });
}

void write_row(fmt::memory_buffer& out, const TickRecord& tick) {
    auto to = std::back_inserter(out);
    fmt::format_to(to, "{},{},{},{},{},{},{},{},{},", tick.time_s, tick.p_WH.x, tick.p_WH.y,
                   tick.p_WP.x, tick.p_WP.y, tick.force.x, tick.force.y, name_of(tick.state),
                   tick.level);
    if (tick.outline >= 0) fmt::format_to(to, "{}", tick.outline);
    fmt::format_to(to, ",{},{},{},{},{},{},{},{}\n", tick.torques.x, tick.torques.y,
                   tick.stiffness_N_per_m, tick.spring_gain, name_of(tick.force_state),
                   name_of(tick.fault), name_of(tick.limit), tick.map_version);
}

Result<void> write_table(const std::string& path, const std::vector<TickRecord>& ticks) {
    fmt::memory_buffer out;
    fmt::format_to(std::back_inserter(out),
                   "t_s,x_m,y_m,proxy_x_m,proxy_y_m,fx_N,fy_N,state,level,outline,torque_1_Nm,"
                   "torque_2_Nm,stiffness_N_per_m,spring_gain,force_state,fault,limit,"
                   "map_version\n");
    for (const TickRecord& tick : ticks) write_row(out, tick);
    return write_whole_file(path, fmt::to_string(out));
}

Result<std::string> write_as_recorded(const Recording& recording, const std::string& output) {
    return write_table(output, recording.ticks).map([&recording] {
        return fmt::format(
            "{} ticks as recorded; not run again: a visitor's picture was felt, which is not kept",
            recording.ticks.size());
    });
}

}  // namespace

Result<std::string> run_replay(const ReplayOptions& options) {
    const auto recording = read_recording(options.recording);
    if (!recording) return tl::unexpected(recording.error());
    if (recording->start.empty()) return write_as_recorded(*recording, options.output);
    const auto profile = find_device_profile(recording->profile);
    if (!profile) return tl::unexpected(profile.error());
    const auto replay =
        run_again(*recording, [&](std::uint64_t version) -> Result<std::shared_ptr<const Scene>> {
            const auto& maps = recording->maps;
            const auto found =
                std::find_if(maps.begin(), maps.end(),
                             [version](const RecordedMap& m) { return m.version == version; });
            if (found == maps.end()) return failure("the recording does not name a map it used");
            return scene_of(*found, *profile);
        });
    if (!replay) {
        return failure(fmt::format("{}: {}", options.recording, replay.error().line));
    }
    if (auto written = write_table(options.output, replay->ticks); !written) {
        return tl::unexpected(written.error());
    }
    if (replay->differs_at) {
        return failure(fmt::format("{}: run again it is not the same from {} s on",
                                   options.recording,
                                   recording->ticks[*replay->differs_at].time_s));
    }
    return fmt::format("{} ticks run again: the same, bit for bit", replay->ticks.size());
}

}  // namespace touchline
