// SPDX-License-Identifier: Apache-2.0
/// Read netCDF and HDF5 files in a separate program: forged files crash, block or exhaust
/// their libraries.
/// ```
///     read_in_child ─ posix_spawn ─► reader: limits, then library ─ message on descriptor 3 ─►
///     check
///                └ waits `seconds`, then SIGKILL
/// ```
/// The reader sets its own limits before it opens the file: processor time, address space, file
/// size 0, no core file. Plugins of HDF5 are off.
#include "scene/hydro_message.h"
#include "scene/hydro_read.h"
#include "scene/hydro_spawn.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <new>

namespace hawser::scene {
namespace {

constexpr const char* kReaderWord = "--read-coefficients";
constexpr int kReaderArguments = 9;  // program, word, file, three units, body, seconds, bytes
constexpr std::size_t kMinReaderMemory = std::size_t{64} << 20;

/// Return the flag that this program may be started again as the separate reader of coefficient
/// files.
bool& is_reader_program() {
    static bool serves = false;
    return serves;
}

bool number_of(const char* text, double& out) {
    const auto [end, fault] = std::from_chars(text, text + std::strlen(text), out);
    return fault == std::errc() && *end == '\0' && std::isfinite(out);
}

std::string decimal(double value) {
    char text[64];
    const auto [end, fault] = std::to_chars(text, text + sizeof text, value);
    return {text, fault == std::errc() ? end : text};
}

void limit(__rlimit_resource what, rlim_t most) {
    const rlimit both{most, most};
    (void)setrlimit(what, &both);
}

void limit_this_process(double seconds, double memory) {
    (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
    const auto whole = static_cast<rlim_t>(std::ceil(seconds)) + 1;
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, whole);
    limit(RLIMIT_FSIZE, 0);
    alarm(static_cast<unsigned>(whole));
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    limit(RLIMIT_AS, static_cast<rlim_t>(memory));  // sanitizers map terabytes
#else
    static_cast<void>(memory);
#endif
    // An HDF5 file names filters, which the library would load from folders of plugins.
    (void)setenv("HDF5_PLUGIN_PRELOAD", "::", 1);
    (void)setenv("HDF5_USE_FILE_LOCKING", "FALSE", 1);
}

std::vector<char> reply_to(const char* file, const HydroUnits& units) {
    try {
        return message_of(read_in_process(file, units));  // the receiver checks it
    } catch (const std::bad_alloc&) {
        return message_of_error("coefficients '" + std::string(file) +
                                "': reading it needs more memory than its reader may use; raise "
                                "HAWSER_READER_MEMORY [MiB] if the file is whole");
    } catch (const std::exception& error) {
        return message_of_error(error.what());
    }
}

int serve(char** argv) {
    double density = 0, gravity = 0, length = 0, body = 0, seconds = 0, memory = 0;
    const bool arguments_valid =
        number_of(argv[3], density) && number_of(argv[4], gravity) && number_of(argv[5], length) &&
        number_of(argv[6], body) && number_of(argv[7], seconds) && number_of(argv[8], memory) &&
        body >= 0 && body <= 999 && seconds > 0 && seconds <= 3600 && memory >= 0 && memory <= 1e18;
    if (!arguments_valid) return 1;
    limit_this_process(seconds, memory);
    std::vector<char> reply = reply_to(argv[2], {density, gravity, length, static_cast<int>(body)});
    if (reply.size() > kMaxHydroMessage)
        reply = message_of_error(
            "coefficients '" + std::string(argv[2]) + "': " + std::to_string(reply.size()) +
            " bytes of numbers; up to " + std::to_string(kMaxHydroMessage) + " are read");
    for (std::size_t sent = 0; sent < reply.size();) {
        const ssize_t n = write(kReaderDescriptor, reply.data() + sent, reply.size() - sent);
        if (n <= 0) return 1;
        sent += static_cast<std::size_t>(n);
    }
    return 0;
}

/// Return the path of the reader program; empty if none exists.
std::string reader_program(const ReaderLimits& limits) {
    if (!limits.program.empty()) return limits.program;
    if (const char* named = std::getenv("HAWSER_READER"); named && *named) return named;
    const char* const self = "/proc/self/exe";
    if (is_reader_program()) return self;
    std::error_code error;
    const Path sibling = std::filesystem::read_symlink(self, error).parent_path() / "hawser";
    if (!error && access(sibling.c_str(), X_OK) == 0) return sibling.string();
    return {};
}

std::string seconds_text(double seconds) {
    std::string text = decimal(std::round(10.0 * seconds) / 10.0);
    return text + " s";
}

/// Describe why a reader program returned no message.
std::string describe_failure(const SpawnResult& run, const std::string& program,
                             const ReaderLimits& limits) {
    const std::string damaged =
        "; the file is damaged: write it again with the program that made it";
    switch (run.end) {
        case SpawnEnd::not_started:
            return "its reader '" + program + "' cannot be started (" + std::strerror(run.code) +
                   "); let HAWSER_READER name the program hawser";
        case SpawnEnd::too_long:
            return "reading it takes more than " + seconds_text(limits.seconds) + damaged +
                   ", or raise HAWSER_READER_SECONDS";
        case SpawnEnd::too_large:
            return "its reader returned more than " + std::to_string(kMaxHydroMessage) + " bytes" +
                   damaged;
        case SpawnEnd::killed:
            return "its reader ended by signal " + std::to_string(run.code) + " (" +
                   strsignal(run.code) + ")" + damaged;
        case SpawnEnd::exited:
            break;
    }
    return "'" + program + "' is no reader of this version (exit code " + std::to_string(run.code) +
           "); let HAWSER_READER name the program hawser";
}

void check_limits(const Path& file, const ReaderLimits& limits) {
    if (!(limits.seconds >= 0.1 && limits.seconds <= 3600.0))
        throw_hydro_error(file, "the reader's time of " + decimal(limits.seconds) +
                                    " s is outside 0.1 to 3600 s");
    if (limits.memory < kMinReaderMemory)
        throw_hydro_error(file, "the reader's memory of " + std::to_string(limits.memory) +
                                    " bytes is below " + std::to_string(kMinReaderMemory));
}

}  // namespace

WaveCoefficients read_in_child(const Path& file, const HydroUnits& units,
                               const ReaderLimits& limits) {
    check_limits(file, limits);
    const std::string program = reader_program(limits);
    if (program.empty())
        throw_hydro_error(
            file,
            "there is no reader program; let HAWSER_READER name the program hawser, or "
            "call serve_coefficients_reader() first in main()");
    // An absolute path cannot be a network address or an option.
    std::error_code error;
    const Path whole = std::filesystem::absolute(file, error);
    if (error) throw_hydro_error(file, "its folder does not exist any more");
    const SpawnResult run =
        spawn_reader(program,
                     {program, kReaderWord, whole.string(), decimal(units.density),
                      decimal(units.gravity), decimal(units.length), std::to_string(units.body),
                      decimal(limits.seconds), std::to_string(limits.memory)},
                     limits.seconds, kMaxHydroMessage);
    if (run.end != SpawnEnd::exited || run.code != 0)
        throw_hydro_error(file, describe_failure(run, program, limits));
    auto message = read_message(run.output);
    if (!message) throw_hydro_error(file, describe_failure(run, program, limits));
    if (!message->error.empty()) throw DefError(message->error);
    return std::move(message->value);
}

}  // namespace hawser::scene

namespace hawser {

ReaderLimits ReaderLimits::of_environment() {
    ReaderLimits out;
    const auto read = [](const char* name, double least, double most, double& value) {
        const char* const text = std::getenv(name);
        if (text == nullptr || *text == '\0') return;
        if (!scene::number_of(text, value) || value < least || value > most)
            throw DefError(std::string(name) + " = \"" + std::string(text).substr(0, 40) +
                           "\" in the environment is no number from " + scene::decimal(least) +
                           " to " + scene::decimal(most));
    };
    double mebibytes = static_cast<double>(out.memory >> 20);
    read("HAWSER_READER_SECONDS", 0.1, 3600.0, out.seconds);
    read("HAWSER_READER_MEMORY", 64.0, 1e6, mebibytes);
    out.memory = static_cast<std::size_t>(mebibytes * 1048576.0);
    return out;
}

std::optional<int> serve_coefficients_reader(int argc, char** argv) {
    if (argc == scene::kReaderArguments && std::strcmp(argv[1], scene::kReaderWord) == 0)
        return scene::serve(argv);
    scene::is_reader_program() = true;
    return std::nullopt;
}

}  // namespace hawser
