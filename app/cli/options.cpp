#include "app/cli/options.h"

#include "app/cli/commands.h"
#include "app/documents/packs/pack.h"
#include "app/force/backends/kiosk_backends.h"
#include "app/isolation/process/own_folder.h"
#include "config/types/hand_state.h"
#include "config/types/utf8.h"
#include "haptics/pantograph/profile.h"

#include <algorithm>
#include <ostream>
#include <sstream>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace touchline {
namespace {

constexpr int done = 0;
constexpr int unusable_input = 1;
constexpr int wrong_usage = 2;

/// "116x84", millimetres.
std::string parse_area(const std::string& text, Area& area) {
    const std::size_t x = std::min(text.find('x'), text.size());
    const auto width_mm = number_in<double>(std::string_view(text).substr(0, x));
    const auto height_mm =
        number_in<double>(std::string_view(text).substr(std::min(x + 1, text.size())));
    area = {width_mm.value_or(0.0) / 1000.0, height_mm.value_or(0.0) / 1000.0};
    return is_usable(area) ? ""
                           : fmt::format("{} is no area; write millimetres, like 116x84", text);
}

/// "auto" or a level >= 0, fractions allowed.
std::string parse_level(const std::string& text, std::optional<double>& level) {
    level = number_in(text, 0.0, 1000.0);
    if (level || text == "auto") return "";
    return fmt::format("{} is no level; write auto or a number from 0 (finest)", text);
}

std::string parse_mode(const std::string& text, Mode& mode) {
    for (const auto& [name, value] :
         {std::pair{"wall", Mode::wall}, std::pair{"groove", Mode::groove},
          std::pair{"ridge", Mode::ridge}, std::pair{"stay", Mode::stay}}) {
        if (text != name) continue;
        mode = value;
        return "";
    }
    return fmt::format("{} is no mode; write wall, groove, ridge or stay", text);
}

std::string parse_class(const std::string& text, std::optional<PictureClass>& picture_class) {
    for (const auto& [name, value] :
         {std::pair{"photo", PictureClass::photo}, std::pair{"diagram", PictureClass::diagram},
          std::pair{"drawing", PictureClass::line_art},
          std::pair{"text-page", PictureClass::text_page}}) {
        if (text != name) continue;
        picture_class = value;
        return "";
    }
    return fmt::format("{} is no kind of picture; write photo, diagram, drawing or text-page",
                       text);
}

/// A number from `low` to `largest`. Unlike the library's own range, it rejects NaN.
CLI::Validator number_within(double low, double largest, bool is_low_allowed) {
    return {[=](const std::string& text) {
                const auto value = number_in(text, low, largest);
                const bool is_good = value && (is_low_allowed || *value > low);
                return is_good ? std::string{}
                               : fmt::format("{} is not {} {} and at most {}", text,
                                             is_low_allowed ? "at least" : "above", low, largest);
            },
            fmt::format("{} {} {}", low, is_low_allowed ? "to" : "< value <=", largest)};
}

CLI::Validator above_zero(double largest) {
    return number_within(0.0, largest, false);
}

CLI::Validator from_zero(double largest) {
    return number_within(0.0, largest, true);
}

CLI::Option* add_input(CLI::App& command, std::string& input, bool* as_picture) {
    auto* option =
        command.add_option("input", input, "A picture (PNG, JPEG, WebP, TIFF) or a map (.svg)")
            ->required();
    if (as_picture != nullptr) {
        command.add_flag("--picture", *as_picture, "Take an .svg as a picture, not as a map");
    }
    return option;
}

/// A command of a command, which chooses an action.
template <class Action>
CLI::App* add_action(CLI::App& command, Action& chosen, const char* name, Action action,
                     const char* what) {
    CLI::App* const added = command.add_subcommand(name, what);
    added->callback([&chosen, action] { chosen = action; });
    return added;
}

void add_curves(CLI::App& command, CurveOptions& curves) {
    command.add_flag("--resample", curves.resample,
                     "Place points by arc length, no more than the scene needs");
}

class CommandLine {
  public:
    CommandLine() {
        app_.set_help_flag("-h,--help", "Show what can be said here");
        app_.set_version_flag("--version", "touchline " TOUCHLINE_VERSION, "Which version this is");
        app_.require_subcommand(0, 1);
        app_.add_flag("--window", kiosk_.in_window, "The kiosk in a window instead of full screen");
        app_.add_option("--measure", kiosk_.measure_s,
                        "Run the kiosk this many seconds, print its ticks and frames, and end")
            ->check(above_zero(86400.0));
        app_.add_option("files", kiosk_.files,
                        "Pictures, and folders of them, to offer as a USB stick would")
            ->check(CLI::ExistingPath);
        add_trace();
        add_print();
        add_curve();
        add_feel();
        add_tour();
        add_device();
        add_settings();
        add_pack();
        add_models();
        add_bundle();
        add_counters();
    }

    int run(const std::vector<std::string>& arguments, const Programs& programs, std::ostream& out,
            std::ostream& err) {
        try {
            app_.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
        } catch (const CLI::CallForHelp&) {
            const auto chosen = app_.get_subcommands();
            out << (chosen.empty() ? app_ : *chosen.front()).help();
            return done;
        } catch (const CLI::CallForVersion& version) {
            out << version.what() << '\n';
            return done;
        } catch (const CLI::ParseError& error) {
            tell(err, std::string(error.what()) + "; --help shows what can be said");
            return wrong_usage;
        }
        return start(programs, out, err);
    }

  private:
    void add_view(CLI::App& command, ViewChoice& chosen) {
        command
            .add_option("--view", view_,
                        "whole, figure (a photograph's main thing), or a number in the kiosk's "
                        "order; else its first")
            ->check([&chosen](const std::string& text) {
                const auto view = view_choice_of(text);
                if (view) chosen = *view;
                return view ? "" : text + " is no view: whole, figure, or a number from 1 to 101";
            });
    }

    void add_trace() {
        trace_command_ = app_.add_subcommand("trace", "Outlines of a picture as a map");
        add_input(*trace_command_, trace_.input, nullptr);
        trace_command_->add_option("-o", trace_.output, "MAP.svg")->required();
        trace_command_->add_option("--detail", trace_.trace.detail, "1 silhouette ... 5 all")
            ->check(CLI::Range(1, 5));
        add_view(*trace_command_, trace_.view);
        trace_command_->add_option("--area", area_, "Drawing area in millimetres, like 116x84")
            ->check(
                [this](const std::string& text) { return parse_area(text, trace_.trace.area); });
        trace_command_->add_option("--json", trace_.report, "REPORT.json");
        trace_command_->add_option("--edges", trace_.edges, "STRENGTH.png");
        trace_command_->add_option("--figure", trace_.figure,
                                   "MASK.png: 128 and more is the main thing, sure or not");
        trace_command_
            ->add_option("--class", class_, "photo, diagram, drawing or text-page; else decided")
            ->check([this](const std::string& text) {
                return parse_class(text, trace_.trace.picture_class);
            });
    }

    void add_print() {
        print_command_ =
            app_.add_subcommand("print", "A sheet to take home, for swell paper or an embosser");
        add_input(*print_command_, print_.input, nullptr);
        print_command_
            ->add_option("-o", print_.output,
                         "SHEET.pdf or .svg for swell paper; .brf for any embosser; .ubrl for "
                         "CUPS; .index for an Index embosser")
            ->required()
            ->check([](const std::string& text) {
                return sheet_format_of(text)
                           ? ""
                           : text +
                                 " is no sheet; write a name that ends in .pdf, .svg, .brf, "
                                 ".ubrl or .index";
            });
        print_command_->add_option("--detail", print_.trace.detail, "1 silhouette ... 5 all")
            ->check(CLI::Range(1, 5));
        add_view(*print_command_, print_.view);
        print_command_->add_option("--paper", paper_, "a4 or letter")
            ->check([this](const std::string& text) {
                print_.paper = text == "letter" ? PaperKind::letter : PaperKind::a4;
                return text == "a4" || text == "letter" ? ""
                                                        : text + " is no paper; write a4 or letter";
            });
        print_command_->add_option("--language", print_.language, "en, de, es, fr or it")
            ->check([](const std::string& text) {
                return has_braille(text) && text.size() == 2
                           ? ""
                           : text + " is no language of a sheet; write en, de, es, fr or it";
            });
        print_command_->add_option("--grade", grade_, "Braille: uncontracted or contracted")
            ->check([this](const std::string& text) {
                print_.grade =
                    text == "contracted" ? BrailleGrade::contracted : BrailleGrade::uncontracted;
                return text == "contracted" || text == "uncontracted"
                           ? ""
                           : text + " is no braille; write uncontracted or contracted";
            });
    }

    void add_curve() {
        curve_command_ = app_.add_subcommand("curve", "The curve of a picture or map at one level");
        add_input(*curve_command_, curve_.input, &curve_.as_picture);
        curve_command_->add_option("-o", curve_.output, "OUT.svg")->required();
        curve_command_->add_option("--level", curve_.level, "0 finest; fractions are blends")
            ->required()
            ->check(from_zero(1000.0));
        add_curves(*curve_command_, curve_.curves);
        curve_command_->add_flag("--boxes", curve_.with_boxes, "Draw the error boxes");
        curve_command_
            ->add_option("--keep-details", curve_.curves.keep_details,
                         "Share of the wavelet details to keep, largest first")
            ->check(from_zero(1.0));
        curve_command_
            ->add_option("--denoise", denoise_mm_, "Noise to remove, standard deviation in mm")
            ->check(from_zero(10.0));
        curve_command_->add_option("--json", curve_.report, "REPORT.json");
    }

    void add_feel() {
        feel_command_ =
            app_.add_subcommand("feel", "A hand's path over a picture or map, step by step");
        auto* input = add_input(*feel_command_, feel_.input, &feel_.as_picture)->required(false);
        auto* path = feel_command_->add_option("--path", feel_.path, "HAND.csv: t_s,x_m,y_m");
        auto* probe = feel_command_->add_option(
            "--probe", feel_.probe,
            "SHAPE.svg, held in the middle of its drawing area; HAND.csv then has angle_rad");
        feel_command_
            ->add_option("--replay", replay_.recording,
                         "A recording of the kiosk's black box, run again")
            ->excludes(input)
            ->excludes(path)
            ->excludes(probe);
        feel_command_->add_option("-o", feel_.output, "RUN.csv")->required();
        ContactSettings& contact = feel_.contact;
        feel_command_->add_option("--mode", mode_, "wall, groove, ridge or stay")
            ->check(
                [this](const std::string& text) { return parse_mode(text, feel_.contact.mode); })
            ->excludes(probe);
        feel_command_->add_option("--level", level_, "auto, or a level from 0 (finest)")
            ->check([this](const std::string& text) { return parse_level(text, feel_.level); });
        feel_command_->add_option("--stiffness", contact.stiffness_N_per_m, "N/m")
            ->check(above_zero(most_stiffness_N_per_m));
        feel_command_->add_option("--friction", contact.friction, "Coulomb coefficient")
            ->check(from_zero(1.0))
            ->excludes(probe);
        feel_command_
            ->add_option("--radius", contact.radius_m, "Radius of proxy or shape's edges, m")
            ->check(from_zero(0.02));
        feel_command_->add_option("--capture", contact.capture_m, "Half width of a groove, m")
            ->check(above_zero(0.1))
            ->excludes(probe);
        feel_command_->add_option("--profile", feel_.profile,
                                  "Device whose encoders bound the level");
        add_curves(*feel_command_, feel_.curves);
        feel_command_->add_option("--h0", feel_.curves.spacing_m, "Spacing of level 0, m")
            ->check(above_zero(0.1));
        auto* budget =
            feel_command_->add_option("--budget", feel_.budget_boxes, "Boxes that a step may open")
                ->check(CLI::Range(0, 1000000000));
        feel_command_->add_option("--deadline-us", feel_.deadline_us, "Time that a step may take")
            ->check(above_zero(1e6))
            ->excludes(budget);
        feel_command_->add_flag("--timing", feel_.with_timing, "Adds the column step_ns");
    }

    void add_tour() {
        tour_command_ = app_.add_subcommand(
            "tour", "A simulated hand explores a picture or map; no display needed");
        add_input(*tour_command_, tour_.input, &tour_.as_picture);
        tour_command_->add_option("-o", tour_.output, "RUN.png")->required();
    }

    void add_device() {
        device_command_ = app_.add_subcommand("device", "The pantograph and its motors");
        device_command_->require_subcommand(1);
        const auto add = [this](const char* name, DeviceAction action, const char* what) {
            auto* command = add_action(*device_command_, device_.action, name, action, what);
            command->add_option("--make", device_.make, "Its make, as the setting device.make");
            command->add_option("--port", device_.port, "Its port, as the setting device.port");
            if (action == DeviceAction::list) return;
            command->add_option("--serial", device_.serial, "Of the unit, where there are several");
            command->add_option("--profile", device_.profile,
                                "Its kind; a different kind discards what is stored for the unit");
        };
        add("list", DeviceAction::list, "Devices that are there");
        add("probe", DeviceAction::probe, "Whether a device answers, and how fast");
        add("home", DeviceAction::home, "Find where the handle is, step by step");
        add("nudge", DeviceAction::nudge, "Whether the motors have power");
        add("stop", DeviceAction::stop, "Turn the motors off");
    }

    void add_settings() {
        settings_command_ = app_.add_subcommand("settings", "What an operator has set");
        settings_command_->require_subcommand(1);
        const auto add = [this](const char* name, SettingsAction action, const char* what) {
            add_action(*settings_command_, settings_.action, name, action, what)
                ->add_option("file", settings_.file, "Else the file of this site");
        };
        add("check", SettingsAction::check, "Whether a file of settings can be used");
        add("print", SettingsAction::print, "All settings, as they hold with it");
    }

    void add_pack() {
        pack_command_ = app_.add_subcommand("pack", "Picture packs: maps, texts and voices");
        pack_command_->require_subcommand(1);
        const auto add = [this](const char* name, PackAction action, const char* what) {
            auto* command = add_action(*pack_command_, pack_.action, name, action, what);
            command->add_option("pack", pack_.input, "A folder or a zip file")->required();
            return command;
        };
        add("check", PackAction::check, "Whether a pack can be used, and what would better it");
        auto* taken = add("import", PackAction::import, "Install a pack");
        taken->add_option("--library", pack_.library, "The folder of packs; else the user's");
        taken->add_flag("--take-older", pack_.takes_older, "Even over a newer version");
        auto* written = add("export", PackAction::write, "A folder as a zip file");
        written->add_option("-o", pack_.output, "FILE.zip")->required();
        add_action(*pack_command_, pack_.action, "try", PackAction::attempt,
                   "Hear and feel a pack in a window, before it is installed anywhere")
            ->add_option("pack", pack_.input, "A folder or a zip file")
            ->required();
        auto* made = add_action(*pack_command_, pack_.action, "make", PackAction::make,
                                "A pack from a folder of pictures, texts and recordings");
        made->add_option("folder", pack_.input, "Its guide: see touchline(1)")->required();
        made->add_option("-o", pack_.output, "FILE.zip")->required();
        written
            ->add_option("--image", pack_.image_language,
                         "As layered pictures of the IMAGE project, in this language")
            ->check([](const std::string& tag) {
                return is_language_tag(tag)
                           ? ""
                           : fmt::format("{} is no language; write one like en", tag);
            });
    }

    void add_models() {
        models_command_ = app_.add_subcommand(
            "models", "The networks that Touchline can use, and which of them come with it");
        models_command_->require_subcommand(1);
        const auto add = [this](const char* name, ModelsAction action, const char* what) {
            return add_action(*models_command_, models_.action, name, action, what);
        };
        add("list", ModelsAction::list, "What there is, under which licence, and what is here");
        add("check", ModelsAction::check, "Whether those that are here are whole");
        auto* got =
            add("get", ModelsAction::get, "One from its publisher; shows its licence first");
        got->add_option("name", models_.name, "As the list tells it")->required();
        got->add_flag("--yes", models_.is_agreed, "You agree to its licence: nothing is asked");
    }

    void add_bundle() {
        bundle_command_ = app_.add_subcommand(
            "bundle", "What several kiosks of one house have alike, signed by the house");
        bundle_command_->require_subcommand(1);
        const auto add = [this](const char* name, BundleAction action, const char* what) {
            return add_action(*bundle_command_, bundle_.action, name, action, what);
        };
        auto* key = add("key", BundleAction::key,
                        "Make the key of this house, or take that of another kiosk");
        auto* taken = key->add_option("file", bundle_.input, "The key of another kiosk");
        key->add_option("-o", bundle_.output, "HOUSE.touchline-key, for the other kiosks")
            ->excludes(taken);
        key->add_option("--fingerprint", bundle_.fingerprint,
                        "The digits that the other kiosk told")
            ->needs(taken);
        add("make", BundleAction::make,
            "A bundle of this kiosk's settings, profiles, packs, networks")
            ->add_option("-o", bundle_.output, "NAME.touchline-bundle")
            ->required();
        add("check", BundleAction::check, "What a bundle would change here")
            ->add_option("file", bundle_.input, "NAME.touchline-bundle")
            ->required();
        add("apply", BundleAction::apply, "Change it, all or nothing")
            ->add_option("file", bundle_.input, "NAME.touchline-bundle")
            ->required();
        add("undo", BundleAction::undo, "What going back to before the last bundle would change")
            ->add_flag("--yes", bundle_.is_agreed, "Go back");
    }

    void add_counters() {
        counters_command_ =
            app_.add_subcommand("counters", "The days of several kiosks as one table");
        counters_command_
            ->add_option("files", counters_.inputs, "Tables of kiosks, each named after its kiosk")
            ->required();
        counters_command_->add_option("-o", counters_.output, "ALL.csv")->required();
    }

    int start(const Programs& programs, std::ostream& out, std::ostream& err) {
        if (trace_command_->parsed()) {
            return finish(run_trace(trace_).map([&err](const std::string& warning) {
                if (!warning.empty()) tell(err, warning);
            }),
                          err);
        }
        if (print_command_->parsed()) {
            return finish(run_print(print_).map([&err](const std::string& note) {
                if (!note.empty()) tell(err, note);
            }),
                          err);
        }
        if (curve_command_->parsed()) {
            curve_.curves.denoise_m = denoise_mm_ / 1000.0;
            return finish(run_curve(curve_), err);
        }
        if (feel_command_->parsed()) return start_feel(out, err);
        if (tour_command_->parsed()) return finish(programs.tour(tour_), err);
        if (device_command_->parsed()) return start_device(out, err);
        if (settings_command_->parsed()) return start_settings(out, err);
        if (pack_command_->parsed()) return start_pack(programs, out, err);
        if (models_command_->parsed()) return finish(run_models(models_, std::cin, out), err);
        if (bundle_command_->parsed()) return finish(run_bundle(bundle_, out), err);
        if (counters_command_->parsed()) return finish(run_counters(counters_), err);
        return programs.kiosk(kiosk_);
    }

    int start_feel(std::ostream& out, std::ostream& err) {
        if (!replay_.recording.empty()) {
            replay_.output = feel_.output;
            return finish(run_replay(replay_).map(
                              [&out](const std::string& said) { out << plain_line(said) << '\n'; }),
                          err);
        }
        if (feel_.input.empty() || feel_.path.empty()) {
            tell(err,
                 "feel needs a picture or map and --path, or --replay; --help shows what can be "
                 "said");
            return wrong_usage;
        }
        // An unknown profile is wrong usage, like an unknown mode.
        if (const auto profile = find_profile(feel_.profile); !profile) {
            tell(err, profile.error().line);
            return wrong_usage;
        }
        return finish(run_feel(feel_), err);
    }

    int start_pack(const Programs& programs, std::ostream& out, std::ostream& err) {
        if (pack_.action != PackAction::attempt) return finish(run_pack(pack_, out), err);
        const OwnFolder library;
        if (!library.is_there()) {
            tell(err, "no folder can be made for temporary files; check the disk and its rights");
            return unusable_input;
        }
        pack_.library = library.path().string();
        std::ostringstream installed;  // where nobody else can find it
        const int status = finish(run_pack(pack_, installed), err);
        if (status != done) return status;
        KioskArguments kiosk;
        kiosk.in_window = true;
        kiosk.tried_library = library.path().string();
        return programs.kiosk(kiosk);
    }

    int start_settings(std::ostream& out, std::ostream& err) {
        const std::vector<std::string> faults = run_settings(settings_, out);
        for (const std::string& fault : faults) tell(err, fault);
        return faults.empty() ? done : unusable_input;
    }

    int start_device(std::ostream& out, std::ostream& err) {
        if (!device_.profile.empty() && !find_profile(device_.profile)) {
            tell(err, find_profile(device_.profile).error().line);
            return wrong_usage;
        }
        return finish(command_device(device_, out), err);
    }

    static int finish(const Result<void>& result, std::ostream& err) {
        if (result) return done;
        tell(err, result.error().line);
        return unusable_input;
    }

    /// Names in the line may be anything, and the reader's terminal obeys control codes.
    static void tell(std::ostream& err, const std::string& line) {
        err << "touchline: " << plain_line(line) << '\n';
    }

    CLI::App app_{"Feel the outlines of a picture with a force-feedback pantograph", "touchline"};
    CLI::App* trace_command_ = nullptr;
    CLI::App* print_command_ = nullptr;
    CLI::App* curve_command_ = nullptr;
    CLI::App* feel_command_ = nullptr;
    CLI::App* tour_command_ = nullptr;
    CLI::App* device_command_ = nullptr;
    CLI::App* settings_command_ = nullptr;
    CLI::App* pack_command_ = nullptr;
    CLI::App* models_command_ = nullptr;
    CLI::App* bundle_command_ = nullptr;
    CLI::App* counters_command_ = nullptr;
    KioskArguments kiosk_;
    TourArguments tour_;
    TraceCommandOptions trace_;
    PrintCommandOptions print_;
    CurveCommandOptions curve_;
    FeelOptions feel_;
    DeviceCommandOptions device_;
    SettingsCommandOptions settings_;
    PackCommandOptions pack_;
    ModelsCommandOptions models_;
    BundleCommandOptions bundle_;
    CountersCommandOptions counters_;
    ReplayOptions replay_;
    std::string area_;
    std::string view_;
    std::string class_;
    std::string paper_;
    std::string grade_;
    std::string level_;
    std::string mode_;
    double denoise_mm_ = 0.0;
};

}  // namespace

int run_command_line(const std::vector<std::string>& arguments, const Programs& programs,
                     std::ostream& out, std::ostream& err) {
    return CommandLine().run(arguments, programs, out, err);
}

}  // namespace touchline
