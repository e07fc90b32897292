// SPDX-License-Identifier: Apache-2.0
#include "record/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

namespace hawser::record {
namespace {

/// File descriptor that is closed by the destructor.
class Descriptor {
  public:
    explicit Descriptor(int value) : value_(value) {}
    ~Descriptor() {
        if (value_ >= 0) ::close(value_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int get() const noexcept { return value_; }
    /// Close the file. @return true if all data was written.
    [[nodiscard]] bool close() noexcept { return ::close(std::exchange(value_, -1)) == 0; }

  private:
    int value_;
};

std::string error_text(int error) { return std::strerror(error); }

/// Describe a file that is not a plain file.
const char* file_type_words(mode_t mode) {
    if (S_ISDIR(mode)) return "a folder";
    if (S_ISFIFO(mode)) return "a pipe";
    if (S_ISSOCK(mode)) return "a socket";
    if (S_ISBLK(mode) || S_ISCHR(mode)) return "a device";
    return "no plain file";
}

template <class Out>
std::string read_to(const std::filesystem::path& file, Out& out, std::size_t most) {
    // Without O_NONBLOCK, open() would wait for the writer of a pipe.
    const Descriptor in(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat about{};
    if (in.get() < 0 || ::fstat(in.get(), &about) != 0) return "cannot open: " + error_text(errno);
    if (!S_ISREG(about.st_mode))
        return std::string("is ") + file_type_words(about.st_mode) + ", expected a plain file";
    const auto size = static_cast<std::size_t>(about.st_size);
    if (size > most) return "larger than " + std::to_string(most >> 20U) + " MiB";
    const auto held = 512 * static_cast<std::size_t>(about.st_blocks);
    if (size >= kSparseFileSize && held < size / 16)
        return "a file with holes: of " + std::to_string(size) + " bytes only " +
               std::to_string(held) + " are there; it is no whole file of this program";
    out.resize(size);
    std::size_t done = 0;
    while (done < size) {
        const ssize_t n = ::read(in.get(), out.data() + done, size - done);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return "cannot read: " + error_text(errno);
        if (n == 0) break;  // The file became shorter while it was read.
        done += static_cast<std::size_t>(n);
    }
    out.resize(done);
    return {};
}

bool write_all(int to, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(to, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(n));
    }
    return true;
}

/// Return the target of a path after all symbolic links, also if no file exists there.
std::filesystem::path target(const std::filesystem::path& file) {
    constexpr int kMaxLinks = 40;  // as many as Linux follows
    std::error_code failure;
    std::filesystem::path at = std::filesystem::absolute(file, failure);
    for (int links = 0; !failure && links < kMaxLinks; ++links) {
        const auto out = std::filesystem::weakly_canonical(at, failure);
        if (failure) break;
        // weakly_canonical() follows existing links; it leaves a link to a missing file unchanged.
        if (!std::filesystem::is_symlink(std::filesystem::symlink_status(out, failure))) return out;
        at = out.parent_path() / std::filesystem::read_symlink(out, failure);
    }
    return file;
}

bool is_device(const std::filesystem::path& file) {
    struct stat about{};
    return ::stat(file.c_str(), &about) == 0 && S_ISCHR(about.st_mode);
}

/// Open a new file in the folder of `to` for writing, with the permissions that `to` has or would
/// get.
int open_temporary(const std::filesystem::path& to, std::string& name) {
    name = to.string() + ".XXXXXX";
    const int out = ::mkostemp(name.data(), O_CLOEXEC);
    if (out < 0) return out;
    struct stat about{};
    const mode_t mask = ::umask(0);
    ::umask(mask);
    const mode_t rights = ::stat(to.c_str(), &about) == 0 ? about.st_mode & 07777U : 0666U & ~mask;
    (void)::fchmod(out,
                   rights);  // A failure is ignored: the file is usable without these permissions.
    return out;
}

}  // namespace

std::string read_file(const std::filesystem::path& file, std::vector<std::byte>& out,
                      std::size_t most) {
    return read_to(file, out, most);
}

std::string read_file(const std::filesystem::path& file, std::string& out, std::size_t most) {
    return read_to(file, out, most);
}

std::string output_fault(const std::filesystem::path& file) {
    struct stat about{};
    const std::filesystem::path to = target(file);
    if (::stat(to.c_str(), &about) == 0) {
        if (S_ISCHR(about.st_mode))
            return ::access(to.c_str(), W_OK) == 0 ? std::string() : error_text(errno);
        if (!S_ISREG(about.st_mode))
            return std::string("is ") + file_type_words(about.st_mode) + ", expected a plain file";
        if (::access(to.c_str(), W_OK) != 0) return error_text(errno);
    }
    std::string name;
    const Descriptor out(open_temporary(to, name));
    if (out.get() < 0) return error_text(errno);
    ::unlink(name.c_str());
    return {};
}

std::string write_file(const std::filesystem::path& file, std::span<const std::byte> bytes,
                       Flush flush) {
    const std::filesystem::path to = target(file);
    if (is_device(to)) {
        Descriptor out(::open(to.c_str(), O_WRONLY | O_CLOEXEC));
        if (out.get() < 0 || !write_all(out.get(), bytes) || !out.close()) return error_text(errno);
        return {};
    }
    if (const std::string fault = output_fault(to); !fault.empty()) return fault;
    std::string name;
    Descriptor out(open_temporary(to, name));
    if (out.get() < 0) return error_text(errno);
    // Flush the data before the rename: otherwise a crash could replace the old file by an empty
    // one.
    if (write_all(out.get(), bytes) && (flush == Flush::later || ::fsync(out.get()) == 0) &&
        out.close() && std::rename(name.c_str(), to.c_str()) == 0)
        return {};
    const std::string why = error_text(errno);
    ::unlink(name.c_str());
    return why;
}

std::string write_file(const std::filesystem::path& file, const std::string& text, Flush flush) {
    return write_file(file, std::as_bytes(std::span(text.data(), text.size())), flush);
}

std::string flush_folder(const std::filesystem::path& folder) {
    const Descriptor all(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    return all.get() >= 0 && ::syncfs(all.get()) == 0 ? std::string() : error_text(errno);
}

bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
    struct stat x{}, y{};
    if (::stat(a.c_str(), &x) == 0 && ::stat(b.c_str(), &y) == 0)
        return x.st_dev == y.st_dev && x.st_ino == y.st_ino && !S_ISCHR(x.st_mode);
    return target(a) == target(b);
}

}  // namespace hawser::record
