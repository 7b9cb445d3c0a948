#include "haptics/servo/recording.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace touchline {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

constexpr std::string_view magic = "TLBLACK\n";
constexpr std::uint32_t layout = 3;
constexpr std::size_t longest_text = 255;
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

class Writer {
  public:
    template <class T>
    void number(const T& value) {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
        raw(std::as_bytes(std::span(&value, 1)));
    }

    template <class T>
    void choice(const T& value, T /*last*/) {
        number(value);
    }

    void flag(const bool& value) { number(static_cast<std::uint8_t>(value ? 1 : 0)); }

    void text(const std::string& value) {
        const std::size_t size = std::min(value.size(), longest_text);
        number(static_cast<std::uint8_t>(size));
        raw(std::as_bytes(std::span(value.data(), size)));
    }

    void raw(std::span<const std::byte> bytes) {
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }

    std::vector<std::byte> finish() {
        number(checksum_of(bytes_));
        return std::move(bytes_);
    }

  private:
    std::vector<std::byte> bytes_;
};

/// Never reads past the end; what fails once has failed, and reads zeros from there on.
class Reader {
  public:
    explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    template <class T>
    void number(T& value) {
        value = T{};
        const auto from = raw(sizeof(T));
        if (!from.empty()) std::memcpy(&value, from.data(), sizeof(T));
    }

    template <class T>
    void choice(T& value, T last) {
        std::underlying_type_t<T> told{};
        number(told);
        is_good_ = is_good_ && told <= static_cast<std::underlying_type_t<T>>(last);
        value = is_good_ ? static_cast<T>(told) : T{};
    }

    void flag(bool& value) {
        std::uint8_t told = 0;
        number(told);
        is_good_ = is_good_ && told <= 1;
        value = told == 1;
    }

    void text(std::string& value) {
        std::uint8_t size = 0;
        number(size);
        const auto from = raw(size);
        value.resize(from.size());
        if (!from.empty()) std::memcpy(value.data(), from.data(), from.size());
    }

    std::span<const std::byte> raw(std::size_t size) {
        is_good_ = is_good_ && size <= bytes_.size();
        if (!is_good_) return {};
        const auto front = bytes_.first(size);
        bytes_ = bytes_.subspan(size);
        return front;
    }

    [[nodiscard]] bool is_good() const { return is_good_; }

    [[nodiscard]] std::size_t left() const { return bytes_.size(); }

  private:
    std::span<const std::byte> bytes_;
    bool is_good_ = true;
};

// The fields in their order, for both directions. A field that is added to one of these must be
// named here, or a run could not be repeated.
static_assert(sizeof(ServoCommands) == 176 && sizeof(StepInput) == 256);

template <class File, class Vector>
void vector(File& file, Vector& v) {
    file.number(v.x);
    file.number(v.y);
}

template <class File, class Commands>
void commands(File& file, Commands& c) {
    file.choice(c.mode, Mode::stay);
    file.number(c.stiffness_N_per_m);
    file.number(c.friction);
    file.number(c.radius_m);
    file.number(c.capture_m);
    file.number(c.pop_through_N);
    file.number(c.pop_through_s);
    file.flag(c.is_level_auto);
    file.number(c.level);
    file.number(c.finest_level);
    file.number(c.coarsest_level);
    file.flag(c.is_force_wanted);
    file.flag(c.is_emergency_stop);
    file.number(c.faults_cleared);
    file.number(c.force_ceiling_N);
    file.flag(c.has_frame);
    file.choice(c.guidance.kind, GuidanceKind::to_line);
    file.flag(c.guidance.is_held);
    file.number(c.guidance.serial);
    file.number(c.guidance.outline);
    vector(file, c.guidance.place);
    file.number(c.guidance.speed_m_per_s);
    file.choice(c.pattern.pattern, HandlePattern::time_out);
    file.number(c.pattern.serial);
    file.choice(c.shape, HeldShape::key);
    file.number(c.turn_rad);
}

void angles(Writer& file, const std::optional<JointAngles>& angles) {
    file.flag(angles.has_value());
    vector(file, angles ? *angles : JointAngles{});
}

void angles(Reader& file, std::optional<JointAngles>& angles) {
    bool is_there = false;
    JointAngles told;
    file.flag(is_there);
    vector(file, told);
    if (is_there) angles = told;
}

void angle(Writer& file, const std::optional<double>& angle_rad) {
    file.flag(angle_rad.has_value());
    file.number(angle_rad.value_or(0.0));
}

void angle(Reader& file, std::optional<double>& angle_rad) {
    bool is_there = false;
    double told_rad = 0.0;
    file.flag(is_there);
    file.number(told_rad);
    if (is_there) angle_rad = told_rad;
}

template <class File, class Tick>
void tick(File& file, Tick& t) {
    file.number(t.input.now_s);
    file.number(t.input.missed_ticks);
    angles(file, t.input.angles);
    angle(file, t.input.handle_rad);
    commands(file, t.input.commands);
    file.number(t.input.delay_s);
    file.number(t.input.force_share);
    file.number(t.wanted_version);
    file.flag(t.is_fading_out);
    file.flag(t.is_refused);
    file.number(t.time_s);
    vector(file, t.p_WH);
    vector(file, t.p_WP);
    vector(file, t.force);
    vector(file, t.torques);
    file.number(t.handle_Nm);
    file.number(t.proxy_angle_rad);
    file.number(t.level);
    file.number(t.stiffness_N_per_m);
    file.number(t.spring_gain);
    file.choice(t.state, ContactState::vertex);
    file.number(t.outline);
    file.number(t.map_version);
    file.choice(t.force_state, ForceState::fault);
    file.choice(t.fault, Fault::emergency_stop);
    file.choice(t.limit, Limit::fault);
    file.choice(t.guidance, GuidancePhase::stopped);
    file.number(t.guidance_serial);
}

template <class File, class Map>
void map(File& file, Map& m) {
    file.number(m.version);
    file.text(m.gallery_file);
    file.number(m.detail);
    file.number(m.hash);
}

std::size_t bytes_per_tick() {
    const TickRecord any;
    Writer writer;
    tick(writer, any);
    return writer.finish().size() - sizeof(std::uint64_t);
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

std::vector<std::byte> encode(const Recording& recording) {
    Writer file;
    file.raw(std::as_bytes(std::span(magic)));
    file.number(layout);
    file.text(recording.profile);
    file.number(std::uint64_t{recording.maps.size()});
    for (const RecordedMap& m : recording.maps) map(file, m);
    file.number(std::uint64_t{recording.start.size()});
    file.raw(recording.start);
    file.number(std::uint64_t{recording.start_tick});
    file.number(recording.start_version);
    file.number(std::uint64_t{recording.ticks.size()});
    for (const TickRecord& t : recording.ticks) tick(file, t);
    return file.finish();
}

Result<Recording> decode(std::span<const std::byte> bytes) {
    const std::size_t least = magic.size() + sizeof(layout) + sizeof(std::uint64_t);
    if (bytes.size() < least || std::memcmp(bytes.data(), magic.data(), magic.size()) != 0) {
        return refused("it does not begin like one");
    }
    Reader file(bytes.subspan(magic.size()));
    std::uint32_t told_layout = 0;
    file.number(told_layout);
    if (told_layout != layout) return refused("it was written by another version of touchline");
    std::uint64_t told = 0;
    std::memcpy(&told, bytes.last(sizeof(told)).data(), sizeof(told));
    if (told != checksum_of(bytes.first(bytes.size() - sizeof(told))))
        return refused("it is damaged or cut short");

    Recording recording;
    std::uint64_t count = 0;
    file.text(recording.profile);
    file.number(count);
    if (count > most_maps) return refused("it names too many maps");
    for (std::uint64_t i = 0; i < count && file.is_good(); ++i)
        map(file, recording.maps.emplace_back());
    file.number(count);
    if (count > most_start_bytes) return refused("its start is too large");
    const auto start = file.raw(static_cast<std::size_t>(count));
    recording.start.assign(start.begin(), start.end());
    file.number(count);
    recording.start_tick = static_cast<std::size_t>(count);
    file.number(recording.start_version);
    file.number(count);
    if (count > bytes.size() || !file.is_good() ||
        file.left() != count * bytes_per_tick() + sizeof(std::uint64_t)) {
        return refused("its sizes do not fit together");
    }
    if (recording.start_tick > count) return refused("it starts after its end");
    recording.ticks.resize(static_cast<std::size_t>(count));
    for (TickRecord& t : recording.ticks) tick(file, t);
    if (!file.is_good()) return refused("a value is none that there is");
    return recording;
}

}  // namespace touchline
