// SPDX-License-Identifier: Apache-2.0
/// Unusual files and streams: pipes, files with holes, the same file twice, closed and full
/// outputs, times beyond any clock, truncated files.
#include <hawser/recording.h>
#include "cli/program.h"
#include "record/bytes.h"

#include <nlohmann/json.hpp>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace hawser::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr const char* kSwing = "scenes/pendulum.json";

/// Run a line of the shell, with $H for the program, for at most a minute. @return the exit code,
/// 124 after a timeout, −1 if a signal ended it.
int shell(const std::string& line) {
    const std::string whole =
        "H='" + program_file().string() + "'; export H; timeout 60 sh -c '" + line + "'";
    const int status = std::system(whole.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string joined(std::initializer_list<std::string_view> parts) {
    std::string out;
    for (const std::string_view part : parts) out += part;
    return out;
}

/// Expect exit code 1 with this text within the time limit.
void refused(const std::string& arguments, const char* words) {
    const fs::path err = fs::path(testing::TempDir()) / ("refused." + std::to_string(getpid()));
    EXPECT_EQ(shell("$H " + arguments + " >/dev/null 2>" + err.string()), 1) << arguments;
    EXPECT_NE(read_text(err).find(words), std::string::npos) << arguments << "\n" << read_text(err);
    fs::remove(err);
}

std::string run_line(const fs::path& folder, const std::string& more = {}) {
    return "$H run " + std::string(kSwing) + " --duration 0.2 --record " +
           (folder / "r.hwr").string() + more;
}

/// Expect that the recording of run_line() is complete and contains no other data.
void expect_whole(const fs::path& folder, const char* what) {
    const auto r = record::Recording::open(folder / "r.hwr");
    EXPECT_EQ(r.damage, "") << what;
    EXPECT_EQ(r.ending, record::Ending::finished) << what;
    fs::remove(folder / "r.hwr");
}

TEST(Streams, ClosedOnesAreNobodyElsesAndALostReportIsCode1) {
    const fs::path folder = test_folder();
    const struct {
        const char* streams;
        int code;
    } cases[] = {{" >&-", 1},
                 {" >&- 2>&-", 1},
                 {" <&- >&- 2>&-", 1},
                 {" >/dev/full", 1},
                 {" >/dev/full 2>&1", 1},
                 {" <&- >/dev/null", 0},
                 {" 2>&- >/dev/null", 0},
                 {" 2>/dev/full >/dev/null", 0}};
    for (const auto& c : cases) {
        EXPECT_EQ(shell(run_line(folder) + c.streams), c.code) << c.streams;
        expect_whole(folder, c.streams);
    }
    EXPECT_EQ(shell("$H --help >/dev/full 2>&1"), 1);
    EXPECT_EQ(shell("$H --version >&-"), 1);
    EXPECT_EQ(shell("$H check scenes/pendulum.json >/dev/full 2>&1"), 1);
    EXPECT_EQ(shell("$H validate --list >&-"), 1);
    // A message that cannot be printed does not end the program; the exit code reports the error.
    EXPECT_EQ(shell("$H run no_such.json 2>&-"), 1);
    EXPECT_EQ(shell("$H run no_such.json 2>/dev/full"), 1);
    EXPECT_EQ(shell("$H sail >&- 2>&-"), 1);
}

TEST(Streams, ARunGoesOnWhereNobodyReadsItsReport) {
    const fs::path folder = test_folder();
    const std::string code = (folder / "code").string();
    EXPECT_EQ(shell("(sleep 0.3; " + run_line(folder) + " 2>&1; echo $? >" + code + ") | true"), 0);
    EXPECT_EQ(read_text(code), "1\n");
    expect_whole(folder, "a pipe without a reader");
}

TEST(Files, PipesAreRefusedNotWaitedFor) {
    const fs::path folder = test_folder();
    const std::string pipe = (folder / "pipe").string();
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const std::string run = "run " + std::string(kSwing) + " --duration 0.1 ";
    refused("run " + pipe, "plain file");
    refused("check " + pipe, "plain file");
    refused("replay " + pipe, "is a pipe");
    refused("plot " + pipe, "is a pipe");
    for (const char* option : {"--record ", "--csv ", "--summary ", "--save-at 0.1 "})
        refused(joined({run, option, pipe}), "is a pipe");
    refused(run + "--restore " + pipe, "is a pipe");
    refused(run + "--control " + pipe, "is a pipe");
    refused(run + "--record " + folder.string(), "is a folder");
    fs::create_symlink("pipe", folder / "t.json");
    refused(run + "--trace " + (folder / "t.json").string(), "is a pipe");
    refused("settle " + std::string(kSwing) + " --max-time 0.1 -o " + pipe, "is a pipe");
}

TEST(Files, WithHolesAreNotRead) {
    const fs::path folder = test_folder();
    const fs::path file = folder / "holes";
    write_text(file, "HAWSERST");
    fs::resize_file(file, std::uintmax_t{1} << 40);
    const std::string run = "run " + std::string(kSwing) + " --duration 0.1 ";
    refused("replay " + file.string(), "with holes");
    refused("plot " + file.string(), "with holes");
    refused(run + "--restore " + file.string(), "with holes");
    refused(run + "--control " + file.string(), "with holes");
    refused("run " + file.string(), "larger than 64 MiB");
}

TEST(Files, NoOutputIsAnInputOrAnotherOutput) {
    const fs::path folder = test_folder();
    const auto at = [&](const char* name) { return (folder / name).string(); };
    fs::copy_file(kSwing, at("s.json"));
    fs::copy_file("scenes/pendulum.json", at("other.json"));
    write_text(at("c.csv"), "time\n");
    const std::string scene = read_text(at("s.json"));
    const std::string run = "run " + at("s.json") + " --duration 0.1 ";
    fs::create_symlink("s.json", folder / "link.json");
    fs::create_hard_link(at("s.json"), at("hard.json"));
    fs::create_directory(folder / "d");
    for (const std::string& name :
         {at("s.json"), at("link.json"), at("hard.json"), at("d/../s.json")}) {
        for (const char* option : {"--record ", "--csv ", "--summary ", "--save-at 0.1 "})
            refused(joined({run, option, name}), "would overwrite a file of the scene");
        refused(joined({run, "--trace ", name}), "would overwrite a file of the scene");
        refused("settle " + at("s.json") + " -o " + name, "would overwrite a file of the scene");
    }
    EXPECT_EQ(read_text(at("s.json")), scene);
    refused(run + "--control " + at("c.csv") + " --csv " + at("c.csv"), "the control file");
    ASSERT_EQ(shell("$H " + run + "--quiet --save-at 0.05 " + at("a.hws")), 0);
    refused(run + "--restore " + at("a.hws") + " --save-at 0.1 " + at("a.hws"), "the saved state");
    refused(run + "--record " + at("x") + " --csv " + at("x"), "--record and --csv are the same");
    refused(run + "--summary " + at("x") + " --save-at 0.1 " + at("d/../x"),
            "--summary and --save-at are the same");
    refused(run + "--trace " + at("x.json") + " --trace " + at("x.json"), "the same file");
    EXPECT_FALSE(fs::exists(at("x")));
    // Two links to a file that does not exist yet also lead to one file.
    fs::create_symlink("new", folder / "a");
    fs::create_symlink(at("new"), folder / "b");
    fs::create_symlink("a", folder / "c");
    for (const char* name : {"b", "c", "new", "d/../new"})
        refused(run + "--record " + at("a") + " --csv " + at(name),
                "--record and --csv are the same");
    fs::create_symlink("loop", folder / "loop");
    refused(run + "--record " + at("loop"), "Too many levels of symbolic links");
    EXPECT_FALSE(fs::exists(at("new")));
    // Two outputs may go to /dev/null.
    EXPECT_EQ(shell("$H " + run + "--quiet --csv /dev/null --summary /dev/null"), 0);
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    refused(run + "--quiet --summary /dev/full", "cannot write the summary");
}

TEST(Files, AreWrittenBesideAndRenamed) {
    const fs::path folder = test_folder();
    const auto at = [&](const char* name) { return (folder / name).string(); };
    write_text(at("s.json"), "before");
    write_text(at("a.hws"), "before");
    chmod(at("s.json").c_str(), 0640);
    fs::create_symlink("s.json", folder / "link.json");
    // A killed run leaves the data written before.
    EXPECT_EQ(shell("$H run " + std::string(kSwing) +
                    " --duration 1e6 --realtime --quiet --summary " + at("link.json") +
                    " --save-at 1e5 " + at("a.hws") + " & sleep 0.5; kill -9 $!; wait $!"),
              128 + 9);
    EXPECT_EQ(read_text(at("s.json")), "before");
    EXPECT_EQ(read_text(at("a.hws")), "before");
    EXPECT_EQ(shell("$H run " + std::string(kSwing) + " --duration 0.1 --quiet --summary " +
                    at("link.json") + " --save-at 0.1 " + at("a.hws")),
              0);
    EXPECT_TRUE(fs::is_symlink(folder / "link.json"));
    EXPECT_EQ(json::parse(read_text(at("s.json")))["outcome"], "finished");
    EXPECT_EQ(fs::status(at("s.json")).permissions(), fs::perms(0640));
    EXPECT_EQ(read_text(at("a.hws")).rfind("HAWSERST", 0), 0u);
    int files = 0;
    for (const auto& entry : fs::directory_iterator(folder)) files += entry.path().empty() ? 0 : 1;
    EXPECT_EQ(files, 3) << "something was left beside";
}

TEST(Files, AreWrittenWhereALinkToNothingLeads) {
    const fs::path folder = test_folder();
    fs::create_symlink("new.json", folder / "link.json");
    ASSERT_EQ(shell("$H run " + std::string(kSwing) + " --duration 0.1 --quiet --summary " +
                    (folder / "link.json").string()),
              0);
    EXPECT_TRUE(fs::is_symlink(folder / "link.json"));
    EXPECT_EQ(json::parse(read_text(folder / "new.json"))["outcome"], "finished");
}

// A limit of file sizes is reported like a full disk. Before, SIGXFSZ ended the run without a
// message.
TEST(Files, ThatMayNotGrowFurtherEndTheRunWithAMessage) {
    const fs::path folder = test_folder();
    const std::string err = (folder / "err").string();
    for (const char* option : {"--record ", "--csv ", "--summary "}) {
        const std::string line =
            "$H run " + std::string(kSwing) + " --duration 30 --quiet " + option;
        // A block of the shell is 512 bytes: less than each of the three files.
        std::string limited = "ulimit -f 1; " + line;
        limited += (folder / "out").string();
        limited += " 2>";
        limited += err;
        EXPECT_EQ(shell(limited), 1) << option;
        EXPECT_NE(read_text(err).find("File too large"), std::string::npos) << read_text(err);
    }
}

TEST(Files, ThatPicturesAreDrawnFromAreNotDrawnOver) {
    const fs::path folder = test_folder();
    const auto at = [&](const char* name) { return (folder / name).string(); };
    ASSERT_EQ(shell(run_line(folder, " --quiet")), 0);
    const std::string whole = read_text(at("r.hwr"));
    fs::create_hard_link(at("r.hwr"), at("frame_0001.png"));
    refused("plot " + at("r.hwr") + " --only scene --frames 2 -o " + folder.string(),
            "would replace the recording");
    for (const char* name : {"motions.svg", "space.png"}) {
        fs::create_symlink("r.hwr", at(name));
        refused("plot " + at("r.hwr") + " -o " + folder.string(), "would replace the recording");
        EXPECT_FALSE(fs::exists(at("scene.svg")));
        fs::remove(at(name));
    }
    fs::copy_file(at("r.hwr"), at("motions.svg"));
    refused("plot " + at("motions.svg") + " -o " + folder.string(), "would replace the recording");
    EXPECT_EQ(read_text(at("r.hwr")), whole);
    EXPECT_EQ(read_text(at("motions.svg")), whole);
    // Drawings that are not requested replace no file.
    EXPECT_EQ(
        shell("$H plot " + at("motions.svg") + " --only scene >/dev/null -o " + folder.string()),
        0);
}

TEST(Times, MustBeFiniteAndReachable) {
    const fs::path folder = test_folder();
    const std::string run = "run " + std::string(kSwing) + " ";
    refused(run + "--duration 1e18", "cannot be reached");
    refused(run + "--duration 1e300", "cannot be reached");
    refused(run + "--duration inf", "found \"inf\"");
    refused(run + "--duration 1e400", "found \"1e400\"");
    refused(run + "--set settings.duration=1e18", "duration");
    const std::string save = " " + (folder / "a.hws").string();
    for (const char* time : {"nan", "inf", "-inf", "-1", "1e18"})
        refused(joined({run, "--duration 1 --save-at ", time, save}), "--save-at");
    EXPECT_FALSE(fs::exists(folder / "a.hws"));
    refused(run + "--sleep nan", "nan");
    refused("settle " + std::string(kSwing) + " --max-time nan", "nan");
    ASSERT_EQ(shell(run_line(folder, " --quiet")), 0);
    refused("plot " + (folder / "r.hwr").string() + " --at nan -o " + folder.string(), "nan");
}

TEST(Interrupted, RunRecordsItsLastStep) {
    const fs::path folder = test_folder();
    const Outcome run = run_program(
        {"run", kSwing, "--duration", "1e6", "--realtime", "--record-every", "1000000", "--record",
         folder / "r.hwr", "--csv", folder / "r.csv", "--summary", folder / "s.json"},
        1.0);
    EXPECT_EQ(run.code, 130) << run.err;
    const auto steps = json::parse(read_text(folder / "s.json"))["steps"].get<std::int64_t>();
    EXPECT_GT(steps, 1);
    const auto r = record::Recording::open(folder / "r.hwr");
    EXPECT_EQ(r.ending, record::Ending::interrupted);
    EXPECT_EQ(r.end_step, steps);
    ASSERT_EQ(r.frame_count(), 2u);
    EXPECT_EQ(r.frame_head(1).step, steps);
    EXPECT_EQ(r.frame_head(1).hash, r.end_hash);
    const std::string csv = read_text(folder / "r.csv");
    const std::string row = csv.substr(csv.rfind('\n', csv.size() - 2) + 1);
    EXPECT_NEAR(std::stod(row), r.frame_head(1).time, 1e-6) << row;
    const Outcome replay = run_program({"replay", folder / "r.hwr"});
    EXPECT_EQ(replay.code, 0) << replay.err;
    EXPECT_NE(replay.out.find("was interrupted"), std::string::npos) << replay.out;
}

/// Return the bytes of a recording whose last chunk, the end, was changed and signed again.
std::string with_end(std::string bytes, std::size_t offset, std::int64_t value) {
    const std::size_t end = bytes.rfind("DONE");
    EXPECT_NE(end, std::string::npos);
    std::memcpy(bytes.data() + end + 8 + offset, &value, sizeof value);
    const std::size_t size = bytes.size() - end - 4;
    const std::uint32_t crc = record::crc32(std::as_bytes(std::span(bytes.data() + end, size)));
    std::memcpy(bytes.data() + end + size, &crc, sizeof crc);
    return bytes;
}

TEST(Replay, ComparesTheEndAndSaysWhatIsMissing) {
    const fs::path folder = test_folder();
    // 24 steps with frames at 0, 5, 10, 15, 20 and 24.
    ASSERT_EQ(shell(run_line(folder, " --quiet --record-every 5")), 0);
    const std::string whole = read_text(folder / "r.hwr");
    const Outcome good = run_program({"replay", folder / "r.hwr"});
    EXPECT_EQ(good.code, 0) << good.err;
    EXPECT_NE(good.out.find("and at the end, 24 steps"), std::string::npos) << good.out;

    write_text(folder / "r.hwr", with_end(whole, 9, 1234));
    const Outcome other = run_program({"replay", folder / "r.hwr"});
    EXPECT_EQ(other.code, 3);
    EXPECT_NE(other.out.find("difference at the end, step 24"), std::string::npos) << other.out;

    // An end is rejected if it is farther from the last frame than frames are apart, or before it.
    for (const std::int64_t step : {std::int64_t{30}, std::int64_t{23}, std::int64_t{1} << 60}) {
        write_text(folder / "r.hwr", with_end(whole, 1, step));
        const Outcome far = run_program({"replay", folder / "r.hwr"});
        EXPECT_EQ(far.code, 1) << step;
        EXPECT_NE(far.err.find("not complete"), std::string::npos) << far.err;
    }
    for (const std::size_t less : {std::size_t{1}, std::size_t{29}, std::size_t{40}}) {
        write_text(folder / "r.hwr", whole.substr(0, whole.size() - less));
        const Outcome cut = run_program({"replay", "--quiet", folder / "r.hwr"});
        EXPECT_EQ(cut.code, 1) << less;
        EXPECT_NE(cut.err.find("not complete"), std::string::npos) << cut.err;
        EXPECT_NE(cut.out.find("same state hash"), std::string::npos) << cut.out;
    }
}

}  // namespace
}  // namespace hawser::test
