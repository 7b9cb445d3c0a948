// faces_bench PICTURES LIST OUT: measures what of photographs becomes a face. LIST is CSV; each
// line names a picture in the folder PICTURES, without its extension, what it shows, and the pose;
// the rest is for readers. Writes a row of CSV for each picture to the standard output, and the map
// of its widest face to OUT/NAME.svg; the memory is that of this process.
#include "app/documents/decode/map_svg.h"
#include "app/documents/models/networks.h"
#include "tests/lab/bench/vision/pictures.h"
#include "vision/face/face_network.h"
#include "vision/name/name_network.h"
#include "vision/name/names.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <sys/resource.h>

namespace touchline::bench {
namespace {

namespace fs = std::filesystem;

struct Listed {
    std::string picture;
    std::string shows;
    std::string pose;
};

/// Reads the list without its first line, which names the columns.
std::vector<Listed> listed_in(const std::string& path) {
    std::vector<Listed> all;
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::istringstream cells(line);
        Listed one;
        std::getline(cells, one.picture, ',');
        std::getline(cells, one.shows, ',');
        std::getline(cells, one.pose, ',');
        all.push_back(std::move(one));
    }
    return all;
}

std::map<std::string, fs::path> files_in(const fs::path& folder) {
    std::map<std::string, fs::path> files;
    std::error_code trouble;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, trouble)) {
        files[entry.path().stem().string()] = entry.path();
    }
    return files;
}

double cpu_ms() {
    return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Networks {
    NameNetwork names;
    FaceNetwork faces;
    PersonNetwork persons;
};

Result<Networks> networks_for_faces() {
    const auto things = read_network(*network_named("nanodet"));
    const auto finder = read_network(*network_named("blazeface"));
    const auto mesh = read_network(*network_named("facemesh"));
    const auto selfie = read_network(*network_named("selfie"));
    for (const auto* bytes : {&things, &finder, &mesh, &selfie}) {
        if (!*bytes) return tl::unexpected(bytes->error());
    }
    auto names = NameNetwork::from_onnx(*things);
    if (!names) return tl::unexpected(names.error());
    auto faces = FaceNetwork::from_onnx(*finder, *mesh);
    if (!faces) return tl::unexpected(faces.error());
    auto persons = PersonNetwork::from_onnx(*selfie);
    if (!persons) return tl::unexpected(persons.error());
    return Networks{std::move(*names), std::move(*faces), std::move(*persons)};
}

Result<std::vector<cv::Rect2d>> persons_in(const cv::Mat3b& picture, NameNetwork& network) {
    const auto found = network.detections(picture);
    if (!found) return tl::unexpected(found.error());
    std::vector<cv::Rect2d> boxes;
    for (const ThingBox& box : people_in(*found)) {
        boxes.emplace_back(cv::Point2d(box.left * picture.cols, box.top * picture.rows),
                           cv::Point2d(box.right * picture.cols, box.bottom * picture.rows));
    }
    return boxes;
}

/// The results for one picture.
struct Measured {
    std::size_t persons = 0;
    std::vector<FaceMesh> faces;
    std::size_t anywhere = 0;  // faces, if all of it were a person
    FaceMap map;               // the widest face's
    double faces_ms = 0.0;
    double map_ms = 0.0;
};

constexpr const char* columns =
    "picture,shows,pose,persons,faces,anywhere,outlines,eyes,turn,"
    "left,top,right,bottom,face_ms,map_ms,MB";

void print_row(const Listed& listed, const Measured& measured) {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const FaceMap& map = measured.map;
    const auto eyes = std::ranges::count_if(map.parts, [](FacePart part) {
        return part == FacePart::left_eye || part == FacePart::right_eye;
    });
    const double turn =
        measured.faces.empty() ? 0.0 : turn_of(measured.faces.front()).narrower_share;
    std::printf("%s,%s,%s,%zu,%zu,%zu,%zu,%td,%.2f,%.0f,%.0f,%.0f,%.0f,%.0f,%.0f,%ld\n",
                listed.picture.c_str(), listed.shows.c_str(), listed.pose.c_str(), measured.persons,
                measured.faces.size(), measured.anywhere, map.map.outlines.size(), eyes, turn,
                map.shown.x, map.shown.y, map.shown.br().x, map.shown.br().y, measured.faces_ms,
                measured.map_ms, usage.ru_maxrss / 1024);
}

Result<Measured> measured_on(const fs::path& file, Networks& networks) {
    const auto picture = pixels_of(file.string());
    if (!picture) return tl::unexpected(picture.error());
    const auto persons = persons_in(*picture, networks.names);
    if (!persons) return tl::unexpected(persons.error());
    const double begin_ms = cpu_ms();
    auto faces = networks.faces.faces(*picture, *persons);
    if (!faces) return tl::unexpected(faces.error());
    const double found_ms = cpu_ms();
    FaceMap map;
    if (!faces->empty()) {
        auto made = drawn_face(*picture, faces->front(), networks.persons);
        if (!made) return tl::unexpected(made.error());
        map = std::move(*made);
    }
    const double mapped_ms = cpu_ms();
    const std::vector<cv::Rect2d> all{{{}, cv::Size2d(picture->size())}};
    const auto anywhere = networks.faces.faces(*picture, all);  // if all of it were a person
    if (!anywhere) return tl::unexpected(anywhere.error());
    return Measured{persons->size(), std::move(*faces),   anywhere->size(),
                    std::move(map),  found_ms - begin_ms, mapped_ms - found_ms};
}

Result<void> measure_all(const std::string& pictures, const std::string& list,
                         const std::string& out) {
    auto networks = networks_for_faces();
    if (!networks) return tl::unexpected(networks.error());
    const std::map<std::string, fs::path> files = files_in(pictures);
    std::puts(columns);
    for (const Listed& listed : listed_in(list)) {
        const auto file = files.find(listed.picture);
        if (file == files.end()) return failure(listed.picture + ": no such picture");
        const auto measured = measured_on(file->second, *networks);
        if (!measured) return tl::unexpected(measured.error());
        print_row(listed, *measured);
        const TactileMap& map = measured->map.map;
        if (!map.outlines.empty())
            std::ofstream(fs::path(out) / (listed.picture + ".svg")) << format_map_svg(map);
    }
    return {};
}

}  // namespace
}  // namespace touchline::bench

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fputs("usage: faces_bench PICTURES LIST OUT\n", stderr);
        return 2;
    }
    cv::setNumThreads(1);
    const auto done = touchline::bench::measure_all(argv[1], argv[2], argv[3]);
    if (done) return 0;
    std::fprintf(stderr, "%s\n", done.error().line.c_str());
    return 1;
}
