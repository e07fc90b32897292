// SPDX-License-Identifier: Apache-2.0
#include "export/gltf_document.h"
#include "export/gltf_layout.h"
#include "record/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace hawser::exporting {
namespace {

constexpr std::size_t kFramesAtOnce = 64;  ///< Number of frames held at a time.

/// Writer of a file in any order. It uses a temporary name and renames the file when it is
/// complete.
class OpenFile {
  public:
    explicit OpenFile(const std::filesystem::path& file) : file_(file), part_(file) {
        if (const std::string fault = record::output_fault(file); !fault.empty())
            throw std::runtime_error(
                fmt::format("{}: cannot write the glTF: {}", file.string(), fault));
        part_ += ".part";
        out_.reset(std::fopen(part_.c_str(), "wb"));
        if (!out_) fail();
    }
    ~OpenFile() {
        if (!out_) return;
        out_.reset();
        std::error_code ignored;
        std::filesystem::remove(part_, ignored);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    void add_value(const void* data, std::size_t size) {
        if (std::fwrite(data, 1, size, out_.get()) != size) fail();
    }
    void write_at(std::size_t place, const void* data, std::size_t size) {
        if (fseeko(out_.get(), static_cast<off_t>(place), SEEK_SET) != 0) fail();
        add_value(data, size);
    }
    void finish() {
        if (std::fclose(out_.release()) != 0) fail();
        std::filesystem::rename(part_, file_);
    }

  private:
    struct Close {
        void operator()(std::FILE* f) const { std::fclose(f); }
    };
    [[noreturn]] void fail() const {
        throw std::runtime_error(
            fmt::format("{}: cannot write the glTF: {}", file_.string(), std::strerror(errno)));
    }
    std::filesystem::path file_, part_;
    std::unique_ptr<std::FILE, Close> out_;
};

/// Values of one channel in a block of frames.
struct Track {
    std::size_t place = 0;  ///< Offset in the buffer [bytes].
    std::size_t width = 3;  ///< Number of values in each frame.
    std::vector<float> values;
    void add_value(const Vec3& v) {
        for (int k = 0; k < 3; ++k) values.push_back(static_cast<float>(v[k]));
    }
    void add_value(const Quat& q) {
        for (const double c : {q.x(), q.y(), q.z(), q.w()}) values.push_back(static_cast<float>(c));
    }
};

/// Converter of frames to channels, block by block.
class Animator {
  public:
    Animator(const record::Recording& recording, const Layout& layout)
        : layout_(layout), reader_(recording) {
        for (const BodyNode& b : layout.bodies) {
            if (b.moves) tracks_.push_back({b.data, 3, {}});
            if (b.has_rotation) tracks_.push_back({b.rotation_offset, 4, {}});
            if (b.comes) tracks_.push_back({b.size, 3, {}});
        }
        first_joint_ = tracks_.size();
    }

    void add(const record::Frame& frame) {
        std::size_t t = 0;
        for (const BodyNode& b : layout_.bodies) {
            const auto body = static_cast<std::size_t>(b.body);
            if (b.moves) tracks_[t++].add_value(frame.poses[body].position);
            if (b.has_rotation) tracks_[t++].add_value(frame.poses[body].orientation);
            if (b.comes) tracks_[t++].add_value(Vec3::Constant(frame.there[body] ? 1.0 : 0.0));
        }
        reader_.read(frame, lines_);
        for (const WireNodes& wire : layout_.wires) {
            static const WireLine kGone;
            const auto line = std::find_if(lines_.begin(), lines_.end(),
                                           [&](const WireLine& l) { return l.name == wire.name; });
            joint_positions(wire, line == lines_.end() ? kGone : *line, joints_);
            for (std::size_t j = 0; j < joints_.size(); ++j, ++t) {
                if (t == tracks_.size()) tracks_.push_back({0, 3, {}});
                tracks_[t].place = wire.data + j * 12 * frames_;
                tracks_[t].add_value(joints_[j]);
            }
        }
    }

    /// Write the values to the file and clear them.
    /// @param base  Offset of the buffer in the file [bytes].
    /// @param done  Number of frames written before.
    void flush(OpenFile& out, std::size_t base, std::size_t done) {
        for (Track& track : tracks_) {
            out.write_at(base + track.place + done * track.width * sizeof(float),
                         track.values.data(), track.values.size() * sizeof(float));
            track.values.clear();
        }
    }
    void of_frames(std::size_t count) { frames_ = count; }

  private:
    const Layout& layout_;
    WireReader reader_;
    std::vector<WireLine> lines_;
    std::vector<Vec3> joints_;
    std::vector<Track> tracks_;
    std::size_t first_joint_ = 0, frames_ = 0;
};

void write_u32(OpenFile& out, std::uint64_t value) {
    const auto v = static_cast<std::uint32_t>(value);
    out.add_value(&v, sizeof v);
}

}  // namespace

Frames choose_frames(const record::Recording& recording, std::size_t every, double from,
                     double to) {
    Frames out;
    std::size_t frames_in_range = 0, last = recording.frame_count();
    for (std::size_t i = first_frame(recording); i < recording.frame_count(); ++i) {
        const double time = recording.frame_head(i).time;
        if (time < from - 1e-9 || time > to + 1e-9) continue;
        if (frames_in_range++ % every == 0) out.push_back(i);
        last = i;
    }
    if (!out.empty() && out.back() != last) out.push_back(last);
    return out;
}

void write_gltf(const record::Recording& recording, const Frames& frames,
                const std::filesystem::path& file, const Progress& progress) {
    Layout layout = compute_layout(recording, frames);
    GltfDocument document(recording, frames, layout);
    std::string json = document.json();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::size_t total = 12 + 8 + json.size() + 8 + document.buffer_bytes();
    if (total > 0xFFFFFFFFu)
        throw std::runtime_error(fmt::format(
            "{}: a binary glTF of {} frames would take {} MB, and may have 4,294; give a larger "
            "--every, or a shorter time",
            file.string(), frames.size(), total / 1'000'000));
    OpenFile out(file);
    out.add_value("glTF", 4);
    write_u32(out, 2);
    write_u32(out, total);
    write_u32(out, json.size());
    out.add_value("JSON", 4);
    out.add_value(json.data(), json.size());
    write_u32(out, document.buffer_bytes());
    out.add_value("BIN\0", 4);
    const std::size_t base = 12 + 8 + json.size() + 8;
    const std::vector<std::byte>& fixed = document.fixed_bytes();
    out.add_value(fixed.data(), fixed.size());
    Animator animator(recording, layout);
    animator.of_frames(frames.size());
    for (std::size_t i = 0, done = 0; i < frames.size(); ++i) {
        animator.add(recording.frame(frames[i]));
        if ((i + 1) % kFramesAtOnce != 0 && i + 1 < frames.size()) continue;
        animator.flush(out, base, done);
        done = i + 1;
        if (progress) progress(done);
    }
    out.finish();
}

}  // namespace hawser::exporting
