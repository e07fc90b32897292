// SPDX-License-Identifier: Apache-2.0
/// Main function of all test executables: reports how to repeat a failure, and the time of suites.
#include "support/tier.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>

namespace {

/// Return the processor time of this process and its ended children [s].
double processor_time() {
    double sum = 0.0;
    for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage use{};
        getrusage(who, &use);
        sum += static_cast<double>(use.ru_utime.tv_sec + use.ru_stime.tv_sec) +
               1e-6 * static_cast<double>(use.ru_utime.tv_usec + use.ru_stime.tv_usec);
    }
    return sum;
}

double wall_time() {
    const auto since = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(since).count();
}

class Reporter : public testing::EmptyTestEventListener {
  public:
    explicit Reporter(std::string program) : program_(std::move(program)) {}

    void OnTestSuiteStart(const testing::TestSuite&) override {
        wall_ = wall_time();
        processor_ = processor_time();
    }

    /// Append "program suite wall processor" to the file named by HAWSER_TEST_TIMES.
    void OnTestSuiteEnd(const testing::TestSuite& suite) override {
        const char* path = std::getenv("HAWSER_TEST_TIMES");
        if (path == nullptr) return;
        if (std::FILE* file = std::fopen(path, "a")) {
            std::fprintf(file, "%s %s %.3f %.3f\n",
                         std::filesystem::path(program_).filename().c_str(), suite.name(),
                         wall_time() - wall_, processor_time() - processor_);
            std::fclose(file);
        }
    }

    void OnTestEnd(const testing::TestInfo& test) override {
        if (!test.result()->Failed()) return;
        std::string environment;
        for (const char* name : {"HAWSER_BIN_DIR", "HAWSER_ISA", "HAWSER_SEED", "HAWSER_TIER"})
            if (const char* value = std::getenv(name))
                environment += std::string(name) + "=" + value + " ";
        std::printf("repeat: %s%s --gtest_filter=%s.%s\n", environment.c_str(), program_.c_str(),
                    test.test_suite_name(), test.name());
        std::fflush(stdout);
    }

  private:
    std::string program_;
    double wall_ = 0.0, processor_ = 0.0;
};

/// Set size and seed of RapidCheck's properties by the tier, unless RC_PARAMS is given. RapidCheck
/// prints them on its first use.
void configure_rapidcheck() {
    using hawser::test::Tier;
    constexpr std::uint32_t kFixed = 20261129;
    std::uint32_t seed = kFixed;
    if (!hawser::test::seed_from_environment(seed) && hawser::test::tier() != Tier::quick)
        seed = std::random_device{}();
    const int cases = hawser::test::by_tier(100, 500, 5000);
    const std::string text =
        "seed=" + std::to_string(seed) + " max_success=" + std::to_string(cases);
    constexpr int kOverwrite = 0;
    ::setenv("RC_PARAMS", text.c_str(), kOverwrite);
}

/// Folder for temporary files of this process and its children, removed at its end. Without it,
/// the tests of two builds that run at the same time overwrite each other's files.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name = std::filesystem::temp_directory_path() / "hawser_test_XXXXXX";
        if (::mkdtemp(name.data()) == nullptr) {
            std::perror(name.c_str());
            std::exit(2);
        }
        path_ = name;
        constexpr int kOverwrite = 1;
        for (const char* variable : {"TMPDIR", "TEST_TMPDIR"})
            ::setenv(variable, name.c_str(), kOverwrite);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  private:
    std::filesystem::path path_;
};

}  // namespace

int main(int argc, char** argv) {
    configure_rapidcheck();
    testing::InitGoogleTest(&argc, argv);
    testing::UnitTest::GetInstance()->listeners().Append(new Reporter(argv[0]));
    // A death test starts this program again, in the existing folder.
    const TemporaryFolder folder;
    return RUN_ALL_TESTS();
}
