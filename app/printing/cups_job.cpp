#include "app/printing/cups_job.h"

#include "app/isolation/process/descriptor.h"
#include "config/types/pinned.h"
#include "config/types/steady_clock.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <optional>
#include <string_view>
#include <thread>
#include <vector>

#include <cups/cups.h>
#include <sys/socket.h>

namespace touchline {
namespace {

/// All jobs of this name are the kiosk's, whoever its user is, and may be removed.
constexpr const char* our_name = "touchline";
/// Stands in CUPS's lists and logs, so it tells nothing.
constexpr const char* our_title = "Touchline";

const char* format_of(SheetKind kind) {
    return kind == SheetKind::embosser ? "application/vnd.cups-raw" : "application/pdf";
}

/// Nobody must print words on the back of swell paper, nor braille in another size, whatever the
/// queue's defaults are. An embosser gets bytes, which nothing can be told of.
class JobOptions : private Pinned {
  public:
    explicit JobOptions(SheetKind kind) {
        if (kind == SheetKind::embosser) return;
        add("sides", "one-sided");
        add("print-scaling", "none");
        add("media", kind == SheetKind::letter ? "na_letter_8.5x11in" : "iso_a4_210x297mm");
    }

    ~JobOptions() { cupsFreeOptions(count_, options_); }

    [[nodiscard]] int count() const { return count_; }

    [[nodiscard]] cups_option_t* options() const { return options_; }

  private:
    void add(const char* name, const char* value) {
        count_ = cupsAddOption(name, value, count_, &options_);
    }

    int count_ = 0;
    cups_option_t* options_ = nullptr;
};

using Connection = Owned<http_t, httpClose>;
using Answer = Owned<ipp_t, ippDelete>;

double now_s() {
    return 1e-9 * static_cast<double>(steady_now_ns());
}

void wait(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

/// Ends a request that waits for longer than it may.
int no_longer(http_t* /*connection*/, void* /*nothing*/) {
    return 0;
}

Connection connection_to(const CupsQueue& queue, const PrintPatience& patience) {
    const int most_ms = static_cast<int>(1e3 * patience.answer_s);
    Connection made(httpConnect2(queue.socket.c_str(), 0, nullptr, AF_LOCAL,
                                 HTTP_ENCRYPTION_IF_REQUESTED, 1, most_ms, nullptr));
    if (made) httpSetTimeout(made.get(), patience.answer_s, no_longer, nullptr);
    return made;
}

/// What CUPS said to the last request.
PrintEnd end_of(ipp_status_t status) {
    switch (status) {
        case IPP_STATUS_ERROR_NOT_FOUND:
            return PrintEnd::unknown;
        case IPP_STATUS_ERROR_NOT_ACCEPTING_JOBS:
        case IPP_STATUS_ERROR_DOCUMENT_FORMAT_NOT_SUPPORTED:
        case IPP_STATUS_ERROR_NOT_AUTHORIZED:
        case IPP_STATUS_ERROR_NOT_AUTHENTICATED:
        case IPP_STATUS_ERROR_FORBIDDEN:
        case IPP_STATUS_ERROR_NOT_POSSIBLE:
        case IPP_STATUS_ERROR_TOO_MANY_JOBS:
        case IPP_STATUS_ERROR_REQUEST_ENTITY:
            return PrintEnd::refused;
        default:
            return PrintEnd::no_answer;
    }
}

class CupsWork {
  public:
    CupsWork(const CupsQueue& queue, const PrintPatience& patience)
        : queue_(queue), patience_(patience), connection_(connection_to(queue, patience)) {
        std::array<char, HTTP_MAX_URI> uri{};
        httpAssembleURIf(HTTP_URI_CODING_ALL, uri.data(), static_cast<int>(uri.size()), "ipp",
                         nullptr, "localhost", 0, "/printers/%s", queue.name.c_str());
        uri_ = uri.data();
    }

    [[nodiscard]] PrintEnd check();
    [[nodiscard]] PrintEnd print(std::span<const std::byte> sheet, SheetKind kind);

  private:
    [[nodiscard]] Answer ask(ipp_op_t what, int job, std::span<const char* const> attributes);
    // Nothing: no job is left.
    [[nodiscard]] std::optional<PrintEnd> remove(int job);
    [[nodiscard]] std::optional<PrintEnd> remove_ours();
    [[nodiscard]] bool remove_ours_later();
    [[nodiscard]] bool is_connected() const;
    [[nodiscard]] std::optional<PrintEnd> trouble();
    [[nodiscard]] std::optional<PrintEnd> send(int job, std::span<const std::byte> sheet,
                                               SheetKind kind);
    [[nodiscard]] PrintEnd follow(int job);

    const CupsQueue& queue_;
    const PrintPatience& patience_;
    Connection connection_;
    std::string uri_;
};

bool is_good(const Answer& answer) {
    return answer && ippGetStatusCode(answer.get()) <= IPP_STATUS_OK_CONFLICTING;
}

/// Asks about the queue, or about one job of it. An answer may be an error.
Answer CupsWork::ask(ipp_op_t what, int job, std::span<const char* const> attributes) {
    ipp_t* const request = ippNewRequest(what);
    ippAddString(request, IPP_TAG_OPERATION, IPP_TAG_URI, "printer-uri", nullptr, uri_.c_str());
    if (job > 0) ippAddInteger(request, IPP_TAG_OPERATION, IPP_TAG_INTEGER, "job-id", job);
    ippAddString(request, IPP_TAG_OPERATION, IPP_TAG_NAME, "requesting-user-name", nullptr,
                 our_name);
    if (what == IPP_OP_GET_JOBS) {
        ippAddBoolean(request, IPP_TAG_OPERATION, "my-jobs", 1);
        ippAddString(request, IPP_TAG_OPERATION, IPP_TAG_KEYWORD, "which-jobs", nullptr, "all");
    }
    if (what == IPP_OP_CANCEL_JOB) ippAddBoolean(request, IPP_TAG_OPERATION, "purge-job", 1);
    if (!attributes.empty())
        ippAddStrings(request, IPP_TAG_OPERATION, IPP_TAG_KEYWORD, "requested-attributes",
                      static_cast<int>(attributes.size()), nullptr, attributes.data());
    const char* const place = what == IPP_OP_CANCEL_JOB ? "/jobs/" : "/";
    return Answer(cupsDoRequest(connection_.get(), request, place));
}

/// Takes the job out of the printer, the spool and the history. One that is being printed is ended
/// first, and removed by a request after that.
std::optional<PrintEnd> CupsWork::remove(int job) {
    constexpr std::array wanted{"job-state"};
    for (const double end_s = now_s() + patience_.answer_s; now_s() < end_s;
         wait(patience_.poll_s)) {
        (void)ask(IPP_OP_CANCEL_JOB, job, {});
        const Answer left = ask(IPP_OP_GET_JOB_ATTRIBUTES, job, wanted);
        if (!left) return PrintEnd::no_answer;
        if (ippGetStatusCode(left.get()) == IPP_STATUS_ERROR_NOT_FOUND) return std::nullopt;
    }
    return PrintEnd::not_cleared;
}

std::optional<PrintEnd> CupsWork::remove_ours() {
    constexpr std::array wanted{"job-id"};
    const Answer answer = ask(IPP_OP_GET_JOBS, 0, wanted);
    if (!is_good(answer)) {
        const PrintEnd end = end_of(cupsLastError());
        return end == PrintEnd::unknown || end == PrintEnd::no_answer ? end : PrintEnd::not_cleared;
    }
    std::vector<int> jobs;
    for (ipp_attribute_t* each = ippFirstAttribute(answer.get()); each != nullptr;
         each = ippNextAttribute(answer.get()))
        if (ippGetName(each) != nullptr && std::string_view(ippGetName(each)) == "job-id")
            jobs.push_back(ippGetInteger(each, 0));
    std::optional<PrintEnd> left;
    for (const int job : jobs)
        if (const auto end = remove(job)) left = end;
    return left;
}

/// CUPS went away with a job of ours; its service may start it again.
bool CupsWork::remove_ours_later() {
    for (const double end_s = now_s() + patience_.service_s; now_s() < end_s;
         wait(patience_.poll_s)) {
        connection_ = connection_to(queue_, patience_);
        if (connection_ && !remove_ours()) return true;
        if (patience_.has_to_end()) return false;
    }
    return false;
}

struct ReasonEnd {
    std::string_view beginning;
    PrintEnd end;
};

/// What a printer says of itself (RFC 8011, 5.4.12) that keeps it from printing. Warnings and
/// reports do not, but for that of a printer which is not there.
constexpr std::array reason_ends{ReasonEnd{"media-empty", PrintEnd::no_paper},
                                 ReasonEnd{"media-needed", PrintEnd::no_paper},
                                 ReasonEnd{"offline", PrintEnd::offline},
                                 ReasonEnd{"timed-out", PrintEnd::offline},
                                 ReasonEnd{"shutdown", PrintEnd::offline},
                                 ReasonEnd{"media-jam", PrintEnd::needs_hand},
                                 ReasonEnd{"cover-open", PrintEnd::needs_hand},
                                 ReasonEnd{"door-open", PrintEnd::needs_hand},
                                 ReasonEnd{"interlock-open", PrintEnd::needs_hand},
                                 ReasonEnd{"input-tray-missing", PrintEnd::needs_hand},
                                 ReasonEnd{"output-area-full", PrintEnd::needs_hand},
                                 ReasonEnd{"marker-supply-empty", PrintEnd::needs_hand},
                                 ReasonEnd{"toner-empty", PrintEnd::needs_hand}};

std::optional<PrintEnd> end_of_reason(std::string_view reason) {
    if (reason.ends_with("-warning")) return std::nullopt;
    for (const ReasonEnd& each : reason_ends)
        if (reason.starts_with(each.beginning) &&
            (each.end == PrintEnd::offline || !reason.ends_with("-report")))
            return each.end;
    return std::nullopt;
}

/// What keeps the queue from printing now; nothing: all is well.
std::optional<PrintEnd> CupsWork::trouble() {
    constexpr std::array wanted{"printer-state", "printer-state-reasons",
                                "printer-is-accepting-jobs"};
    const Answer answer = ask(IPP_OP_GET_PRINTER_ATTRIBUTES, 0, wanted);
    if (!is_good(answer)) return end_of(cupsLastError());
    const auto found = [&answer](const char* name, ipp_tag_t tag) {
        return ippFindAttribute(answer.get(), name, tag);
    };
    if (ipp_attribute_t* const reasons = found("printer-state-reasons", IPP_TAG_KEYWORD))
        for (int i = 0; i < ippGetCount(reasons); ++i)
            if (const auto end = end_of_reason(ippGetString(reasons, i, nullptr))) return end;
    if (ipp_attribute_t* const takes = found("printer-is-accepting-jobs", IPP_TAG_BOOLEAN))
        if (ippGetBoolean(takes, 0) == 0) return PrintEnd::refused;
    if (ipp_attribute_t* const state = found("printer-state", IPP_TAG_ENUM))
        if (ippGetInteger(state, 0) == IPP_PSTATE_STOPPED) return PrintEnd::paused;
    return std::nullopt;
}

/// Nothing: CUPS has all of it.
std::optional<PrintEnd> CupsWork::send(int job, std::span<const std::byte> sheet, SheetKind kind) {
    const std::string_view bytes(reinterpret_cast<const char*>(sheet.data()), sheet.size());
    http_status_t status = cupsStartDocument(connection_.get(), queue_.name.c_str(), job, our_title,
                                             format_of(kind), 1);
    if (status == HTTP_STATUS_CONTINUE)
        status = cupsWriteRequestData(connection_.get(), bytes.data(), bytes.size());
    const ipp_status_t said = cupsFinishDocument(connection_.get(), queue_.name.c_str());
    if (status == HTTP_STATUS_CONTINUE && said <= IPP_STATUS_OK_CONFLICTING) return std::nullopt;
    return end_of(said);
}

/// libcups connects again by itself, and a CUPS that was started anew may know nothing of the job.
bool CupsWork::is_connected() const {
    char next = 0;
    const int socket = httpGetFd(connection_.get());
    return recv(socket, &next, 1, MSG_PEEK | MSG_DONTWAIT) < 0 && errno == EAGAIN;
}

/// Waits for the end of a job that CUPS has whole.
PrintEnd CupsWork::follow(int job) {
    constexpr std::array wanted{"job-state"};
    const double end_s = now_s() + patience_.job_s;
    double well_s = now_s();
    for (; now_s() < end_s; wait(patience_.poll_s)) {
        if (!is_connected()) return PrintEnd::no_answer;
        if (patience_.has_to_end()) return PrintEnd::out_of_time;
        const Answer answer = ask(IPP_OP_GET_JOB_ATTRIBUTES, job, wanted);
        // Where CUPS keeps no history, a job that is done is gone; one that failed leaves its
        // printer in trouble.
        if (answer && ippGetStatusCode(answer.get()) == IPP_STATUS_ERROR_NOT_FOUND)
            return trouble().value_or(PrintEnd::printed);
        if (!is_good(answer)) return PrintEnd::no_answer;
        ipp_attribute_t* const state = ippFindAttribute(answer.get(), "job-state", IPP_TAG_ENUM);
        if (state == nullptr) return PrintEnd::no_answer;
        const int is = ippGetInteger(state, 0);
        if (is == IPP_JSTATE_COMPLETED) return PrintEnd::printed;
        const auto troubled = trouble();
        if (is == IPP_JSTATE_CANCELED || is == IPP_JSTATE_ABORTED || is == IPP_JSTATE_STOPPED)
            return troubled.value_or(PrintEnd::failed);
        if (troubled == PrintEnd::no_answer) return PrintEnd::no_answer;
        if (!troubled) well_s = now_s();
        if (now_s() - well_s > patience_.trouble_s) return *troubled;
    }
    return PrintEnd::out_of_time;
}

PrintEnd CupsWork::check() {
    if (!connection_) return PrintEnd::no_service;
    if (const auto left = remove_ours()) return *left;
    return trouble().value_or(PrintEnd::printed);
}

/// What a printer said while it printed last stands there until it prints again, though somebody
/// has seen to it.
bool may_be_over(PrintEnd end) {
    return end == PrintEnd::no_paper || end == PrintEnd::needs_hand || end == PrintEnd::offline;
}

PrintEnd CupsWork::print(std::span<const std::byte> sheet, SheetKind kind) {
    const PrintEnd before = check();
    if (before != PrintEnd::printed && !may_be_over(before)) return before;
    if (patience_.has_to_end()) return PrintEnd::out_of_time;
    const JobOptions told(kind);
    const int job = cupsCreateJob(connection_.get(), queue_.name.c_str(), our_title, told.count(),
                                  told.options());
    if (job <= 0) return end_of(cupsLastError());
    const auto unsent = send(job, sheet, kind);
    const PrintEnd end = unsent ? *unsent : follow(job);
    if (end == PrintEnd::no_answer) {
        (void)remove_ours_later();
        return end;
    }
    if (!remove(job) || remove_ours_later()) return end;
    return end == PrintEnd::printed ? PrintEnd::not_removed : end;
}

}  // namespace

PrintEnd print_by_cups(const CupsQueue& queue, std::span<const std::byte> sheet, SheetKind kind,
                       const PrintPatience& patience) {
    cupsSetUser(our_name);
    return CupsWork(queue, patience).print(sheet, kind);
}

PrintEnd check_at_cups(const CupsQueue& queue, const PrintPatience& patience) {
    cupsSetUser(our_name);
    return CupsWork(queue, patience).check();
}

}  // namespace touchline
