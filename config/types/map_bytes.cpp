#include "config/types/map_bytes.h"

#include "config/types/map_limits.h"
#include "config/types/utf8.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace touchline {
namespace {

static_assert(std::endian::native == std::endian::little, "fields are copied as they are");

constexpr std::uint32_t magic = 0x504d4c54;  // "TLMP"
constexpr std::uint32_t layout = 1;

struct Header {
    std::uint32_t magic;
    std::uint32_t layout;
    std::uint64_t bytes;
    double width_m;
    double height_m;
    std::uint64_t version;
    std::uint32_t outlines;
    std::uint32_t labels;
    std::uint32_t points;
    std::uint32_t text_bytes;
    std::uint32_t title_bytes;
    std::uint32_t description_bytes;
    std::uint64_t reserved;  // 0
};

struct OutlineRecord {
    double weight;
    std::uint32_t points;
    std::uint32_t is_closed;  // 0 or 1
    std::int32_t detail;
    std::uint32_t id_bytes;
    std::uint32_t label_bytes;
    std::uint32_t reserved;  // 0
};

struct LabelRecord {
    double x_m;
    double y_m;
    std::uint32_t text_bytes;
    std::uint32_t reserved;  // 0
};

struct PointRecord {
    double x_m;
    double y_m;
};

static_assert(sizeof(Header) == 72 && sizeof(OutlineRecord) == 32 && sizeof(LabelRecord) == 24 &&
              sizeof(PointRecord) == 16);

tl::unexpected<Error> refused(std::string_view why) {
    return failure("the map cannot be handed over: " + std::string(why));
}

std::uint64_t bytes_in_all(const Header& header) {
    return sizeof(Header) + std::uint64_t{header.outlines} * sizeof(OutlineRecord) +
           std::uint64_t{header.labels} * sizeof(LabelRecord) +
           std::uint64_t{header.points} * sizeof(PointRecord) + header.text_bytes;
}

class Writer {
  public:
    template <class Record>
    void put(const Record& record) {
        static_assert(std::is_trivially_copyable_v<Record>);
        const auto* const first = reinterpret_cast<const std::byte*>(&record);
        bytes_.insert(bytes_.end(), first, first + sizeof(Record));
    }

    void put_text(std::string_view text) {
        const auto* const first = reinterpret_cast<const std::byte*>(text.data());
        bytes_.insert(bytes_.end(), first, first + text.size());
    }

    std::vector<std::byte> take() { return std::move(bytes_); }

  private:
    std::vector<std::byte> bytes_;
};

/// Cuts records off the front of bytes whose size was checked against the header.
class Reader {
  public:
    explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    template <class Record>
    Record take() {
        Record record{};
        std::memcpy(&record, bytes_.data(), sizeof(Record));
        bytes_ = bytes_.subspan(sizeof(Record));
        return record;
    }

    /// Nothing where there are fewer bytes left.
    bool take_text(std::uint32_t size, std::string& text) {
        if (size > bytes_.size()) return false;
        text.assign(reinterpret_cast<const char*>(bytes_.data()), size);
        bytes_ = bytes_.subspan(size);
        return is_utf8(text);
    }

    [[nodiscard]] bool is_empty() const { return bytes_.empty(); }

  private:
    std::span<const std::byte> bytes_;
};

std::uint32_t size_of(const std::string& text) {
    return static_cast<std::uint32_t>(text.size());
}

TactileMap with_utf8_only(TactileMap map) {
    map.title = utf8_of(map.title);
    map.description = utf8_of(map.description);
    for (Outline& outline : map.outlines) {
        outline.id = utf8_of(outline.id);
        outline.label = utf8_of(outline.label);
    }
    for (Label& label : map.labels) label.text = utf8_of(label.text);
    return map;
}

/// Of a map within its limits.
Header header_of(const TactileMap& map) {
    Header header{magic,
                  layout,
                  0,
                  map.area.width_m,
                  map.area.height_m,
                  map.version,
                  static_cast<std::uint32_t>(map.outlines.size()),
                  static_cast<std::uint32_t>(map.labels.size()),
                  static_cast<std::uint32_t>(point_count(map)),
                  static_cast<std::uint32_t>(text_bytes(map)),
                  size_of(map.title),
                  size_of(map.description),
                  0};
    header.bytes = bytes_in_all(header);
    return header;
}

bool is_header(const Header& header, std::size_t bytes) {
    return header.magic == magic && header.layout == layout && header.reserved == 0 &&
           header.outlines <= MapLimits::outlines && header.labels <= MapLimits::labels &&
           header.points <= MapLimits::points && header.text_bytes <= MapLimits::text_bytes &&
           header.bytes == bytes && bytes_in_all(header) == bytes;
}

/// The outline without its points; their number is what its record says.
bool is_record(const OutlineRecord& record) {
    return record.is_closed <= 1 && record.reserved == 0;
}

bool read_points(Reader& reader, const std::vector<OutlineRecord>& records, TactileMap& map,
                 std::uint64_t points) {
    for (std::size_t i = 0; i < records.size(); ++i) {
        if (records[i].points > points) return false;
        points -= records[i].points;
        map.outlines[i].points.reserve(records[i].points);
        for (std::uint32_t k = 0; k < records[i].points; ++k) {
            const auto point = reader.take<PointRecord>();
            map.outlines[i].points.push_back({point.x_m, point.y_m});
        }
    }
    return points == 0;
}

bool read_texts(Reader& reader, const Header& header, const std::vector<OutlineRecord>& outlines,
                const std::vector<LabelRecord>& labels, TactileMap& map) {
    bool is_read = reader.take_text(header.title_bytes, map.title) &&
                   reader.take_text(header.description_bytes, map.description);
    for (std::size_t i = 0; is_read && i < outlines.size(); ++i) {
        is_read = reader.take_text(outlines[i].id_bytes, map.outlines[i].id) &&
                  reader.take_text(outlines[i].label_bytes, map.outlines[i].label);
    }
    for (std::size_t i = 0; is_read && i < labels.size(); ++i) {
        is_read = reader.take_text(labels[i].text_bytes, map.labels[i].text);
    }
    return is_read && reader.is_empty();
}

}  // namespace

Result<std::vector<std::byte>> bytes_of(const TactileMap& given) {
    const TactileMap map = with_utf8_only(given);
    if (const std::string_view fault = fault_of(map); !fault.empty()) return refused(fault);
    Writer writer;
    writer.put(header_of(map));
    for (const Outline& outline : map.outlines) {
        writer.put(OutlineRecord{outline.weight, static_cast<std::uint32_t>(outline.points.size()),
                                 outline.is_closed ? 1U : 0U, outline.detail, size_of(outline.id),
                                 size_of(outline.label), 0});
    }
    for (const Label& label : map.labels) {
        writer.put(LabelRecord{label.place.x, label.place.y, size_of(label.text), 0});
    }
    for (const Outline& outline : map.outlines) {
        for (const Position& p : outline.points) writer.put(PointRecord{p.x, p.y});
    }
    writer.put_text(map.title);
    writer.put_text(map.description);
    for (const Outline& outline : map.outlines) {
        writer.put_text(outline.id);
        writer.put_text(outline.label);
    }
    for (const Label& label : map.labels) writer.put_text(label.text);
    return writer.take();
}

Result<TactileMap> map_of(std::span<const std::byte> bytes) {
    if (bytes.size() < sizeof(Header)) return refused("its bytes end within the header");
    Reader reader(bytes);
    const auto header = reader.take<Header>();
    if (!is_header(header, bytes.size())) return refused("its header does not fit its bytes");
    TactileMap map;
    map.area = {header.width_m, header.height_m};
    map.version = header.version;
    std::vector<OutlineRecord> outlines(header.outlines);
    for (OutlineRecord& record : outlines) {
        record = reader.take<OutlineRecord>();
        if (!is_record(record)) return refused("an outline's record is damaged");
        Outline outline;
        outline.is_closed = record.is_closed == 1;
        outline.weight = record.weight;
        outline.detail = record.detail;
        map.outlines.push_back(std::move(outline));
    }
    std::vector<LabelRecord> labels(header.labels);
    for (LabelRecord& record : labels) {
        record = reader.take<LabelRecord>();
        if (record.reserved != 0) return refused("a label's record is damaged");
        map.labels.push_back({{}, {record.x_m, record.y_m}});
    }
    if (!read_points(reader, outlines, map, header.points)) {
        return refused("its outlines do not share out its points");
    }
    if (!read_texts(reader, header, outlines, labels, map)) {
        return refused("its texts do not fit their room or are no UTF-8");
    }
    if (const std::string_view fault = fault_of(map); !fault.empty()) return refused(fault);
    return map;
}

}  // namespace touchline
