// SPDX-License-Identifier: Apache-2.0
#include "record/snapshot_file.h"

#include "record/bytes.h"
#include "record/changes.h"
#include "record/files.h"

#include <fmt/format.h>

#include <cstring>
#include <string>
#include <vector>

namespace hawser::record {

namespace {

constexpr char kSnapshotMagic[8] = {'H', 'A', 'W', 'S', 'E', 'R', 'S', 'T'};
/// 2: with a history before the state.
constexpr std::uint32_t kVersion = 1, kWithHistory = 2;

/// As the state says, with what was done to the world before it. @return its hash.
std::uint64_t take(std::span<const std::byte> history, std::span<const std::byte> state,
                   World& world) {
    apply_changes(history, world);
    world.restore(state);
    if (!history.empty()) (void)world.take_events();  // which have been told
    return world.state_hash();
}

}  // namespace

void save_snapshot(const std::filesystem::path& file, const SceneInfo& scene, const World& world,
                   std::span<const std::byte> history) {
    ByteWriter out;
    out.put_bytes(std::as_bytes(std::span(kSnapshotMagic)));
    out.put(history.empty() ? kVersion : kWithHistory);
    out.put(scene.hash);
    out.put_text(scene.name);
    out.put(world.time());
    out.put(world.state_hash());
    if (!history.empty()) {
        out.put(static_cast<std::uint64_t>(history.size()));
        out.put_bytes(history);
    }
    out.put_bytes(world.save());
    out.put(crc32(out.bytes()));
    if (const std::string fault = write_file(file, out.bytes()); !fault.empty())
        throw SnapshotError(fmt::format("{}: cannot write the snapshot: {}", file.string(), fault));
}

std::vector<std::byte> restore_snapshot(const std::filesystem::path& file, const SceneInfo& scene,
                                        World& world) {
    std::vector<std::byte> bytes;
    if (const std::string fault = read_file(file, bytes); !fault.empty())
        throw SnapshotError(fmt::format("{}: the snapshot: {}", file.string(), fault));
    try {
        ByteReader in(bytes);
        if (std::memcmp(in.take(sizeof kSnapshotMagic).data(), kSnapshotMagic,
                        sizeof kSnapshotMagic) != 0)
            throw BadBytes("not a Hawser snapshot");
        const auto version = in.get<std::uint32_t>();
        if (version != kVersion && version != kWithHistory)
            throw BadBytes(fmt::format("snapshot format {}, this program reads {} and {}", version,
                                       kVersion, kWithHistory));
        const auto hash = in.get<std::uint64_t>();
        const std::string name = in.get_text();
        const double time = in.get<double>();
        const auto state_hash = in.get<std::uint64_t>();
        std::span<const std::byte> history;
        if (version == kWithHistory) {
            const auto size = in.get<std::uint64_t>();
            if (size == 0 || size > in.left()) throw BadBytes("data end too early");
            history = in.take(static_cast<std::size_t>(size));
        }
        if (in.left() < 4) throw BadBytes("data end too early");
        const auto state = in.take(in.left() - 4);
        if (in.get<std::uint32_t>() != crc32(std::span(bytes).first(bytes.size() - 4)))
            throw BadBytes("the checksum does not match");
        if (hash != scene.hash)
            throw BadBytes(fmt::format(
                "saved at {:.6g} s from the scene \"{}\" with hash {:016x}; this is \"{}\" with "
                "hash {:016x}: restore it with the same scene file and the same --step, --form, "
                "--scale and --set",
                time, name, hash, scene.name, scene.hash));
        // What does not fit leaves the world as it is.
        std::vector<std::byte> before;
        bool same = true;
        if (history.empty()) {
            before = world.save();
        } else {
            World trial = world.twin();
            same = take(history, state, trial) == state_hash;
        }
        if (same) same = take(history, state, world) == state_hash;
        if (!same) {
            if (!before.empty()) world.restore(before);
            throw BadBytes(
                fmt::format("the restored state has another hash; it was saved with another "
                            "instruction set than {} or another version of Hawser",
                            instruction_set()));
        }
        return {history.begin(), history.end()};
    } catch (const BadBytes& e) {
        throw SnapshotError(fmt::format("{}: {}", file.string(), e.what()));
    } catch (const DefError& e) {
        throw SnapshotError(fmt::format("{}: {}", file.string(), e.what()));
    }
}

}  // namespace hawser::record
