// SPDX-License-Identifier: Apache-2.0
// netCDF and HDF5 files with changed bytes, and faulty readers. Each is rejected with a reason, or
// read as valid coefficients, and this process survives.
#include "scene/hydro_binary.h"
#include "scene/hydro_message.h"
#include "support/random.h"
#include "support/tier.h"

#include <chrono>
#include <cstring>

namespace hawser::test::hydro {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string bytes_of(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Return the path of the program that the tests start; empty if it is not built.
std::string program() {
    const char* folder = std::getenv("HAWSER_BIN_DIR");
    const fs::path path = fs::path(folder ? folder : "") / "hawser";
    return fs::exists(path) ? path.string() : std::string();
}

/// Change 1 to 4 bytes, words or lengths, often in headers, like an attacker.
std::string forged(std::string bytes, Random& random) {
    const auto place = [&](std::size_t width) {
        const std::size_t last = bytes.size() - width;
        const std::size_t near = std::min<std::size_t>(last, 1200);
        return static_cast<std::size_t>(
            random.integer(0, static_cast<int>(random.chance(0.5) ? near : last)));
    };
    for (int n = random.integer(1, 4); n > 0; --n) {
        switch (random.integer(0, 3)) {
            case 0:
                bytes[place(1)] = static_cast<char>(random.integer(0, 255));
                break;
            case 1: {
                const std::uint32_t words[] = {0u, 0xFFFFFFFFu, 0x7FFFFFFFu, 0x80000000u, 0x10000u};
                std::memcpy(&bytes[place(4)], &words[random.integer(0, 4)], 4);
                break;
            }
            case 2: {
                const std::uint64_t words[] = {~0ull, 1ull << 63, 1ull << 40, 0x7FF0000000000000u};
                std::memcpy(&bytes[place(8)], &words[random.integer(0, 3)], 8);
                break;
            }
            default:
                std::memmove(&bytes[place(16)], &bytes[place(16)], 16);
        }
    }
    if (random.chance(0.1))
        bytes.resize(static_cast<std::size_t>(random.integer(0, static_cast<int>(bytes.size()))));
    return bytes;
}

/// Read `count` forged files made from each seed file. Print counts of the results.
void read_forged(const std::vector<fs::path>& from, int count) {
    if (program().empty()) GTEST_SKIP() << "HAWSER_BIN_DIR has no program";
    const Folder folder;
    Random random(first_seed(17));
    int read = 0, refused = 0, crashed = 0;
    double longest = 0.0;
    ReaderLimits limits;
    limits.program = program();
    for (int i = 0; i < count; ++i)
        for (const fs::path& good : from) {
            const std::string file =
                folder.write("forged" + good.extension().string(), forged(bytes_of(good), random));
            const auto start = Clock::now();
            try {
                const WaveCoefficients c = read_coefficients(file, kUnits, limits);
                EXPECT_EQ(coefficients_fault(c), "");
                ++read;
            } catch (const DefError& error) {
                const std::string text = error.what();
                EXPECT_NE(text.find("forged"), std::string::npos) << text;
                ++refused;
                crashed += text.find("by signal") != std::string::npos ? 1 : 0;
            }
            longest = std::max(longest, seconds_since(start));
        }
    std::printf(
        "%d forged files read, %d refused, of these %d crashed their reader; longest %.2f s\n",
        read, refused, crashed, longest);
    EXPECT_GT(refused, 0);
    EXPECT_LT(longest, limits.seconds + 2.0);  // the limit, on a busy machine
}

#if HAWSER_HAVE_NETCDF && HAWSER_HAVE_HDF5

std::vector<fs::path> good_files(const Folder& folder) {
    return {write_sample_netcdf(folder / "classic.nc", false),
            write_sample_netcdf(folder / "four.nc", true), write_sample_hdf5(folder / "bemio.h5")};
}

TEST(HydroForged, FilesAreRefusedOrRead) {
    const Folder folder;
    read_forged(good_files(folder), 20);
}
TEST(HydroForged, FilesAreRefusedOrRead_full) {
    const Folder folder;
    read_forged(good_files(folder), 170);
}
TEST(HydroForged, FilesAreRefusedOrRead_long) {
    const Folder folder;
    read_forged(good_files(folder), 3400);
}

/// A reader with less memory than the file needs reports the remedy, and this process continues.
TEST(HydroForged, MemoryOfTheReaderIsLimited) {
    if (program().empty()) GTEST_SKIP() << "HAWSER_BIN_DIR has no program";
    const Folder folder;
    // 19,000,000 values of 8 bytes: below the limit of values, above 64 MiB.
    const std::string file = write_large_netcdf(folder / "large.nc", 19'000'000).string();
    ReaderLimits limits;
    limits.program = program();
    limits.memory = std::size_t{128} << 20;
    try {
        (void)read_coefficients(file, kUnits, limits);
        ADD_FAILURE() << "read";
    } catch (const DefError& error) {
        EXPECT_NE(std::string(error.what()).find("HAWSER_READER_MEMORY"), std::string::npos)
            << error.what();
    }
}

#endif

/// Write a shell script that acts as the reader.
std::string script(const Folder& folder, const std::string& text) {
    const std::string path = folder.write("reader.sh", "#!/bin/sh\n" + text + "\n");
    fs::permissions(path, fs::perms::owner_all);
    return path;
}

std::string refusal_with(const Folder& folder, const std::string& text, double seconds = 10.0) {
    ReaderLimits limits;
    limits.program = script(folder, text);
    limits.seconds = seconds;
    try {
        (void)read_coefficients(folder.write("a.nc", "CDF"), kUnits, limits);
        return "read";
    } catch (const DefError& error) {
        return error.what();
    }
}

TEST(HydroReader, ReadersThatMisbehaveAreRefused) {
    const Folder folder;
    const auto has = [](const std::string& text, const char* part) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
    };
    has(refusal_with(folder, "exit 0"), "is no reader of this version");
    has(refusal_with(folder, "exit 3"), "exit code 3");
    has(refusal_with(folder, "kill -BUS $$"), "ended by signal 7");
    has(refusal_with(folder, "echo nonsense >&3"), "is no reader of this version");
    const auto start = Clock::now();
    has(refusal_with(folder, "exec sleep 60", 0.3), "takes more than 0.3 s");
    // The script closes its output and continues.
    has(refusal_with(folder, "exec sleep 60 3>&-", 0.3), "takes more than 0.3 s");
    EXPECT_LT(seconds_since(start), 10.0);
    has(refusal_with(folder, "exec head -c 600000000 /dev/zero >&3"), "returned more than");
    ReaderLimits none;
    none.program = "/no/such/program";
    EXPECT_THROW((void)read_coefficients(folder.write("a.nc", "CDF"), kUnits, none), DefError);
    none.program = "/bin/true";
    none.seconds = std::nan("");
    EXPECT_THROW((void)read_coefficients(folder.write("a.nc", "CDF"), kUnits, none), DefError);
}

TEST(HydroReader, LimitsOfTheEnvironmentAreChecked) {
    ::setenv("HAWSER_READER_SECONDS", "2.5", 1);
    ::setenv("HAWSER_READER_MEMORY", "512", 1);
    EXPECT_EQ(ReaderLimits::of_environment().seconds, 2.5);
    EXPECT_EQ(ReaderLimits::of_environment().memory, std::size_t{512} << 20);
    for (const char* bad : {"0", "-1", "nan", "inf", "1e9", "2 s"}) {
        ::setenv("HAWSER_READER_SECONDS", bad, 1);
        EXPECT_THROW((void)ReaderLimits::of_environment(), DefError) << bad;
    }
    ::unsetenv("HAWSER_READER_SECONDS");
    ::unsetenv("HAWSER_READER_MEMORY");
}

WaveCoefficients some_coefficients() {
    WaveCoefficients c;
    c.frequency = {0.5, 1.0, 1.5};
    c.heading = {0.0, 1.0};
    for (int i = 0; i < 3; ++i) {
        c.added_mass.push_back(Matrix6::Identity() * (i + 1.0));
        c.damping.push_back(Matrix6::Identity() * (i + 2.0));
    }
    c.has_infinite = true;
    c.infinite = Matrix6::Identity() * 0.5;
    c.excitation.assign(36, {1.0, -2.0});
    return c;
}

TEST(HydroMessage, GoesThroughUnchanged) {
    const WaveCoefficients c = some_coefficients();
    const auto read = scene::read_message(scene::message_of(c));
    ASSERT_TRUE(read && read->error.empty());
    EXPECT_EQ(read->value.frequency, c.frequency);
    EXPECT_EQ(read->value.heading, c.heading);
    EXPECT_EQ(read->value.added_mass, c.added_mass);
    EXPECT_EQ(read->value.damping, c.damping);
    EXPECT_EQ(read->value.excitation, c.excitation);
    EXPECT_EQ(read->value.infinite, c.infinite);
    EXPECT_TRUE(read->value.has_infinite && !read->value.has_zero && !read->value.has_stiffness);
    const auto error = scene::read_message(scene::message_of_error("a\nb\x1b[2J"));
    ASSERT_TRUE(error);
    EXPECT_EQ(error->error, "a?b?[2J");
}

/// Random counts, lengths and contents: the message is rejected, or its faults are found.
TEST(HydroMessage, ForgedOnesAreRefused) {
    const std::vector<char> good = scene::message_of(some_coefficients());
    Random random(first_seed(18));
    const int rounds = by_tier(20'000, 200'000, 2'000'000);
    int read = 0;
    for (int i = 0; i < rounds; ++i) {
        const std::string bytes = forged({good.begin(), good.end()}, random);
        const auto message = scene::read_message(bytes);
        if (!message || !message->error.empty()) continue;
        ++read;
        (void)coefficients_fault(message->value);
    }
    EXPECT_GT(read, 0);
    EXPECT_LT(read, rounds);
    EXPECT_FALSE(scene::read_message({}));
}

}  // namespace
}  // namespace hawser::test::hydro
