#include "app/force/servo/black_box.h"

#include "app/documents/decode/files.h"

#include <chrono>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr int files_kept = 8;
constexpr std::size_t maps_kept = 64;

std::string variable(const char* name) {
    // Nothing in the program changes its environment.
    const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
    return value == nullptr ? std::string() : value;
}

/// The first free name, else the oldest file.
fs::path next_file(const fs::path& folder) {
    fs::path oldest;
    fs::file_time_type oldest_time;
    for (int i = 1; i <= files_kept; ++i) {
        fs::path path = folder / fmt::format("recording-{}.touchline", i);
        std::error_code error;
        const auto time = fs::last_write_time(path, error);
        if (error) return path;
        if (oldest.empty() || time < oldest_time) {
            oldest = path;
            oldest_time = time;
        }
    }
    return oldest;
}

Result<std::string> write(const Recorder& recorder, const std::string& folder,
                          const std::string& profile, const std::vector<RecordedMap>& maps) {
    if (folder.empty()) {
        return failure("there is no home; set TOUCHLINE_RECORDINGS");
    }
    try {
        std::error_code error;
        fs::create_directories(folder, error);
        const std::string path = next_file(folder);
        return write_whole_file(path, bytes_of(make_recording(recorder, profile, maps))).map([&] {
            fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write, error);
            return path;
        });
    } catch (const std::exception& problem) {  // out of memory, or an invalid name
        return failure(problem.what());
    }
}

}  // namespace

std::string recordings_folder() {
    if (std::string chosen = variable("TOUCHLINE_RECORDINGS"); !chosen.empty()) return chosen;
    if (const std::string state = variable("XDG_STATE_HOME"); !state.empty()) {
        return state + "/touchline";
    }
    const std::string home = variable("HOME");
    return home.empty() ? home : home + "/.local/state/touchline";
}

BlackBox::BlackBox(std::string folder, std::string profile,
                   std::function<void(const std::string&)> tell)
    : folder_(std::move(folder)), profile_(std::move(profile)), tell_(std::move(tell)) {}

void BlackBox::remember(const RecordedMap& map) {
    if (maps_.size() == maps_kept) maps_.erase(maps_.begin());
    maps_.push_back(map);
}

void BlackBox::forget() {
    is_forget_wanted_ = true;
    is_hold_wanted_ = false;
    if (!std::exchange(is_keep_wanted_, false) || writing_.valid()) return;
    tell_(std::string(recording_not_kept) + "the visit is over, and what was felt is forgotten");
}

void BlackBox::update(Recorder& recorder, Fault fault) {
    const bool is_new = fault != Fault::none && fault != last_fault_;
    last_fault_ = fault;
    if (is_new && !is_forget_wanted_) is_hold_wanted_ = true;
    if (writing_.valid()) return finish_writing(recorder);
    if (!is_hold_wanted_ && !is_keep_wanted_ && !is_forget_wanted_) return;
    if (!is_holding_ && !recorder.is_held()) {
        is_holding_ = true;
        recorder.hold();
    } else if (is_holding_ && recorder.is_held()) {
        do_what_is_wanted(recorder);
    }
}

void BlackBox::do_what_is_wanted(Recorder& recorder) {
    if (is_forget_wanted_) return wipe(recorder);
    if (is_keep_wanted_) begin_writing(recorder);
}

void BlackBox::let_go(Recorder& recorder) {
    is_holding_ = false;
    is_hold_wanted_ = false;
    recorder.release();
}

/// The newest map is the one that is felt now.
void BlackBox::wipe(Recorder& recorder) {
    is_forget_wanted_ = false;
    recorder.wipe();
    if (maps_.size() > 1) maps_.erase(maps_.begin(), maps_.end() - 1);
    let_go(recorder);
}

void BlackBox::begin_writing(Recorder& recorder) {
    is_keep_wanted_ = false;
    writing_ = std::async(std::launch::async, [this, &recorder, maps = maps_] {
        return write(recorder, folder_, profile_, maps);
    });
}

void BlackBox::finish_writing(Recorder& recorder) {
    if (writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    const auto written = writing_.get();
    if (is_forget_wanted_)
        wipe(recorder);
    else
        let_go(recorder);
    tell_(written ? std::string(recording_kept) + *written
                  : std::string(recording_not_kept) + written.error().line);
}

}  // namespace touchline
