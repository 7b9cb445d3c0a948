#include "haptics/servo/recording.h"

#include "config/types/fields.h"

#include <algorithm>
#include <map>
#include <string_view>

namespace touchline {
namespace {

constexpr std::string_view magic = "TLBLACK\n";
constexpr std::uint64_t most_maps = 10'000;
constexpr std::uint64_t most_start_bytes = 1 << 20;

/// FNV-1a.
class Hash {
  public:
    void add(std::span<const std::byte> bytes) {
        for (const std::byte b : bytes) {
            value_ = (value_ ^ std::to_integer<std::uint64_t>(b)) * 0x100000001b3U;
        }
    }

    template <class T>
    void add_value(const T& value) {
        add(std::as_bytes(std::span(&value, 1)));
    }

    [[nodiscard]] std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325U;
};

// Name every member added in tick() or command_fields(); otherwise a run cannot be repeated.
static_assert(sizeof(StepInput) == sizeof(ServoCommands) + 224);

template <class Bytes, class Vector>
void vector(Bytes& bytes, Vector& v) {
    bytes.number(v.x);
    bytes.number(v.y);
}

template <class T, class Field>
void optional(ByteWriter& bytes, const std::optional<T>& value, Field field) {
    bytes.flag(value.has_value());
    const T told = value.value_or(T{});
    field(bytes, told);
}

template <class T, class Field>
void optional(ByteReader& bytes, std::optional<T>& value, Field field) {
    bool is_there = false;
    T told{};
    bytes.flag(is_there);
    field(bytes, told);
    if (is_there) value = told;
}

/// What the device told.
template <class Bytes, class Reading>
void reading(Bytes& bytes, Reading& told) {
    optional(bytes, told.p_D, [](auto& f, auto& place) { vector(f, place); });
    optional(bytes, told.jacobian, [](auto& f, auto& jacobian) {
        vector(f, jacobian.joint_1);
        vector(f, jacobian.joint_2);
    });
    optional(bytes, told.velocity_D, [](auto& f, auto& velocity) { vector(f, velocity); });
    optional(bytes, told.off_plane, [](auto& f, auto& plane) {
        f.number(plane.off_m);
        f.number(plane.m_per_s);
        f.number(plane.on_plane);
        f.number(plane.across_N);
    });
    optional(bytes, told.handle_rad, [](auto& f, auto& angle_rad) { f.number(angle_rad); });
    vector(bytes, told.joints);
    bytes.flag(told.freshness.is_new);
    bytes.number(told.freshness.late_s);
}

/// A tick's outputs.
template <class Bytes, class Tick>
void outputs(Bytes& bytes, Tick& t) {
    bytes.number(t.time_s);
    vector(bytes, t.p_WH);
    vector(bytes, t.p_WP);
    vector(bytes, t.force);
    vector(bytes, t.torques);
    bytes.number(t.handle_Nm);
    bytes.number(t.plane_share);
    bytes.number(t.proxy_angle_rad);
    bytes.number(t.level);
    bytes.number(t.stiffness_N_per_m);
    bytes.number(t.spring_gain);
    bytes.choice(t.state, ContactState::vertex);
    bytes.number(t.outline);
    bytes.number(t.map_version);
    bytes.choice(t.force_state, ForceState::fault);
    bytes.choice(t.fault, Fault::emergency_stop);
    bytes.choice(t.limit, Limit::fault);
    bytes.choice(t.guidance, GuidancePhase::stopped);
    bytes.number(t.guidance_serial);
}

template <class Bytes, class Tick>
void tick(Bytes& bytes, Tick& t) {
    bytes.number(t.input.now_s);
    bytes.number(t.input.missed_ticks);
    optional(bytes, t.input.reading, [](auto& f, auto& told) { reading(f, told); });
    command_fields(bytes, t.input.commands);
    bytes.number(t.input.delay_s);
    bytes.number(t.input.force_share);
    bytes.number(t.wanted_version);
    bytes.flag(t.is_fading_out);
    bytes.flag(t.is_refused);
    outputs(bytes, t);
}

template <class Bytes, class Map>
void map(Bytes& bytes, Map& m) {
    bytes.number(m.version);
    bytes.template text<std::uint8_t>(m.gallery_file);
    bytes.number(m.detail);
    bytes.number(m.hash);
}

std::size_t bytes_per_tick() {
    const TickRecord any;
    ByteWriter writer;
    tick(writer, any);
    return writer.bytes().size();
}

/// The number of the layout follows from the fields of a tick. Number 3 had this many bytes.
std::uint32_t layout() {
    constexpr std::size_t bytes_of_3 = 338;
    return static_cast<std::uint32_t>(3 + bytes_per_tick() - bytes_of_3);
}

bool is_gallery(const std::vector<RecordedMap>& maps, std::uint64_t version) {
    return version == 0 || std::any_of(maps.begin(), maps.end(), [version](const RecordedMap& m) {
               return m.version == version && !m.gallery_file.empty();
           });
}

bool can_run_again(const Recording& recording, const Recorder::Start& start) {
    const auto from = recording.ticks.begin() + static_cast<std::ptrdiff_t>(start.tick);
    return is_gallery(recording.maps, start.map_version) &&
           std::all_of(from, recording.ticks.end(), [&](const TickRecord& t) {
               return is_gallery(recording.maps, t.wanted_version);
           });
}

tl::unexpected<Error> refused(std::string_view why) {
    return failure("this is no recording that can be read: " + std::string(why));
}

using SceneOf = std::function<Result<std::shared_ptr<const Scene>>(std::uint64_t version)>;

/// Every scene that the ticks name, by version; 0 means no scene.
using Scenes = std::map<std::uint64_t, std::shared_ptr<const Scene>>;

Result<Scenes> scenes_of(const Recording& recording, const SceneOf& scene_of) {
    Scenes scenes{{0, nullptr}};
    const auto add = [&](std::uint64_t version) -> Result<void> {
        if (scenes.contains(version)) return {};
        auto scene = scene_of(version);
        if (!scene) return tl::unexpected(scene.error());
        scenes.emplace(version, std::move(*scene));
        return {};
    };
    if (auto added = add(recording.start_version); !added) return tl::unexpected(added.error());
    for (std::size_t i = recording.start_tick; i < recording.ticks.size(); ++i) {
        auto added = add(recording.ticks[i].wanted_version);
        if (!added) return tl::unexpected(added.error());
    }
    return scenes;
}

}  // namespace

std::uint64_t hash_of(const TactileMap& map) {
    Hash hash;
    hash.add_value(map.area.width_m);
    hash.add_value(map.area.height_m);
    for (const Outline& outline : map.outlines) {
        hash.add_value(outline.is_closed);
        hash.add_value(outline.points.size());
        for (const Position& p : outline.points) {
            hash.add_value(p.x);
            hash.add_value(p.y);
        }
    }
    return hash.value();
}

std::uint64_t checksum_of(std::span<const std::byte> bytes) {
    Hash hash;
    hash.add(bytes);
    return hash.value();
}

Recording make_recording(const Recorder& recorder, std::string profile,
                         const std::vector<RecordedMap>& maps) {
    Recording recording;
    recording.profile = std::move(profile);
    recording.ticks = recorder.ticks();
    recording.maps = maps;
    const auto start = recorder.start();
    if (!start || !can_run_again(recording, *start)) return recording;
    recording.start_tick = start->tick;
    recording.start_version = start->map_version;
    const auto image = std::as_bytes(std::span(&start->step, 1));
    recording.start.assign(image.begin(), image.end());
    return recording;
}

std::vector<std::byte> bytes_of(const Recording& recording) {
    ByteWriter bytes;
    bytes.raw(magic);
    bytes.number(layout());
    bytes.text<std::uint8_t>(recording.profile);
    bytes.number(std::uint64_t{recording.maps.size()});
    for (const RecordedMap& m : recording.maps) map(bytes, m);
    bytes.number(std::uint64_t{recording.start.size()});
    bytes.raw(recording.start);
    bytes.number(std::uint64_t{recording.start_tick});
    bytes.number(recording.start_version);
    bytes.number(std::uint64_t{recording.ticks.size()});
    for (const TickRecord& t : recording.ticks) tick(bytes, t);
    bytes.number(checksum_of(bytes.bytes()));
    return bytes.take();
}

Result<Recording> recording_of(std::span<const std::byte> all) {
    ByteReader bytes(all);
    if (bytes.raw_text(magic.size()) != magic) return refused("it does not begin like one");
    if (bytes.number<std::uint32_t>() != layout())
        return refused("it was written by another version of touchline");
    constexpr std::size_t checksum_bytes = sizeof(std::uint64_t);
    if (bytes.left() < checksum_bytes ||
        ByteReader(all.last(checksum_bytes)).number<std::uint64_t>() !=
            checksum_of(all.first(all.size() - checksum_bytes)))
        return refused("it is damaged or cut short");

    Recording recording;
    bytes.text<std::uint8_t>(recording.profile);
    auto count = bytes.number<std::uint64_t>();
    if (count > most_maps) return refused("it names too many maps");
    for (std::uint64_t i = 0; i < count && bytes.is_good(); ++i)
        map(bytes, recording.maps.emplace_back());
    bytes.number(count);
    if (count > most_start_bytes) return refused("its start is too large");
    const auto start = bytes.raw(static_cast<std::size_t>(count));
    recording.start.assign(start.begin(), start.end());
    recording.start_tick = static_cast<std::size_t>(bytes.number<std::uint64_t>());
    bytes.number(recording.start_version);
    bytes.number(count);
    if (count > all.size() || !bytes.is_good() ||
        bytes.left() != count * bytes_per_tick() + checksum_bytes) {
        return refused("its sizes do not fit together");
    }
    if (recording.start_tick > count) return refused("it starts after its end");
    recording.ticks.resize(static_cast<std::size_t>(count));
    for (TickRecord& t : recording.ticks) tick(bytes, t);
    if (!bytes.is_good()) return refused("a value is none that there is");
    return recording;
}

bool came_out_same(const TickRecord& a, const TickRecord& b) {
    ByteWriter of_a;
    ByteWriter of_b;
    outputs(of_a, a);
    outputs(of_b, b);
    return of_a.bytes() == of_b.bytes();
}

Result<Replay> run_again(const Recording& recording, const SceneOf& scene_of) {
    if (recording.start.empty()) {
        return failure(
            "the recording cannot be run again: a visitor's picture was felt, of which only "
            "inputs, outputs and a number are kept, or a shape was in the hand all the time");
    }
    const auto profile = find_device_profile(recording.profile);
    if (!profile) return tl::unexpected(profile.error());
    const auto scenes = scenes_of(recording, scene_of);
    if (!scenes) return tl::unexpected(scenes.error());
    auto step = ServoStep::from_memory(recording.start, scenes->at(recording.start_version).get(),
                                       *profile);
    if (!step) {
        return failure("the recording cannot be run again: another build of touchline wrote it");
    }
    ShapeInHand hand;
    step->lend(&hand);
    Replay replay;
    replay.first = recording.start_tick;
    for (std::size_t i = recording.start_tick; i < recording.ticks.size(); ++i) {
        const TickRecord& told = recording.ticks[i];
        StepInput input = told.input;
        input.scene = scenes->at(told.wanted_version).get();
        if (told.is_fading_out) step->fade_out();
        const DeviceCommand command = step->step(input);
        replay.ticks.push_back(record_of(input, *step, command, told.is_refused));
        if (told.is_refused) step->lose_device();
        if (!replay.differs_at && !came_out_same(replay.ticks.back(), told)) {
            replay.differs_at = i;
        }
    }
    return replay;
}

}  // namespace touchline
