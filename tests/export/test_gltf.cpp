// SPDX-License-Identifier: Apache-2.0
/// Binary glTF, read by the specification: containers, accessors, poses, joints of wires.
#include "export/export.h"
#include "record/small_scene.h"

#include <hawser/session.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstring>
#include <map>

namespace hawser::test {
namespace {

using nlohmann::json;

/// A .glb file by the specification, with accessors of floats.
struct Glb {
    json doc;
    std::vector<std::byte> buffer;

    explicit Glb(const std::filesystem::path& file) {
        const std::vector<std::byte> bytes = read_bytes(file);
        const auto word = [&](std::size_t at) {
            std::uint32_t value = 0;
            std::memcpy(&value, &bytes.at(at), sizeof value);
            return value;
        };
        EXPECT_EQ(word(0), 0x46546C67U) << "magic";
        EXPECT_EQ(word(4), 2U);
        EXPECT_EQ(word(8), bytes.size());
        const std::size_t size = word(12);
        EXPECT_EQ(word(16), 0x4E4F534AU) << "JSON";
        EXPECT_EQ(size % 4, 0U);
        const auto* text = reinterpret_cast<const char*>(&bytes.at(20));
        doc = json::parse(text, text + size);
        EXPECT_EQ(word(24 + size), 0x004E4942U) << "BIN";
        EXPECT_EQ(word(20 + size), bytes.size() - size - 28);
        buffer.assign(bytes.begin() + static_cast<std::ptrdiff_t>(28 + size), bytes.end());
        EXPECT_EQ(doc["buffers"][0]["byteLength"], buffer.size());
    }

    [[nodiscard]] std::vector<float> floats(int accessor) const {
        const json& a = doc["accessors"][static_cast<std::size_t>(accessor)];
        const json& view = doc["bufferViews"][a["bufferView"].get<std::size_t>()];
        const std::map<std::string, std::size_t> width{{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
        std::vector<float> out(a["count"].get<std::size_t>() *
                               width.at(a["type"].get<std::string>()));
        const auto at = view["byteOffset"].get<std::size_t>();
        EXPECT_EQ(view["byteLength"], out.size() * sizeof(float));
        EXPECT_LE(at + out.size() * sizeof(float), buffer.size());
        std::memcpy(out.data(), &buffer.at(at), out.size() * sizeof(float));
        return out;
    }

    /// Read the values of a node's channel. @return empty if it has none.
    [[nodiscard]] std::vector<float> channel(const std::string& node, const char* path) const {
        const json& animation = doc["animations"][0];
        for (const json& c : animation["channels"]) {
            const auto target = c["target"]["node"].get<std::size_t>();
            if (doc["nodes"][target]["name"] == node && c["target"]["path"] == path)
                return floats(animation["samplers"][c["sampler"].get<std::size_t>()]["output"]);
        }
        return {};
    }
};

record::Recording record_small(const std::filesystem::path& folder, int steps) {
    SmallScene scene;
    scene.record(folder / "r.hwr", steps);
    return record::Recording::open(folder / "r.hwr");
}

TEST(Gltf, HasThePosesOfTheRecording) {
    const auto folder = fresh_folder();
    const record::Recording r = record_small(folder, 150);
    const exporting::Frames frames = exporting::choose_frames(r, 1, 0.0, 1e9);
    ASSERT_EQ(frames.size(), 151U) << "more than are held at a time";
    exporting::write_gltf(r, frames, folder / "r.glb");
    const Glb glb(folder / "r.glb");
    const std::vector<float> p = glb.channel("box & <friends>", "translation"),
                             q = glb.channel("box & <friends>", "rotation");
    ASSERT_EQ(p.size(), 3 * frames.size());
    ASSERT_EQ(q.size(), 4 * frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const Pose pose = r.frame(i).poses[2];
        const Quat& t = pose.orientation;
        for (std::size_t k = 0; k < 3; ++k)
            ASSERT_EQ(p[3 * i + k], static_cast<float>(pose.position[static_cast<int>(k)]));
        const double wanted[] = {t.x(), t.y(), t.z(), t.w()};
        for (std::size_t k = 0; k < 4; ++k) ASSERT_EQ(q[4 * i + k], static_cast<float>(wanted[k]));
    }
    const std::vector<float> times =
        glb.floats(glb.doc["animations"][0]["samplers"][0]["input"].get<int>());
    EXPECT_FLOAT_EQ(times.back(), 2.5F);
    EXPECT_GT(p.back(), -3.0F) << "it swings, so that the test sees motion";
    EXPECT_NE(p[2], p[3 * 40 + 2]);
}

TEST(Gltf, GivesAWireAJointPerEndOfAnElementAndPartsIt) {
    const auto folder = fresh_folder();
    const record::Recording r = record_small(folder, 90);  // wire/s1 breaks at 1.5 s, the end
    exporting::write_gltf(r, exporting::choose_frames(r, 1, 0.0, 1e9), folder / "r.glb");
    const Glb glb(folder / "r.glb");
    std::vector<std::vector<float>> joints;
    for (int j = 0; j < 4; ++j)
        joints.push_back(glb.channel("wire@" + std::to_string(j), "translation"));
    ASSERT_EQ(joints[3].size(), 3U * 91U);
    EXPECT_TRUE(glb.channel("wire@4", "translation").empty());
    const record::Frame before = r.frame(89), end = r.frame(90);
    const auto at = [&](std::size_t joint, std::size_t frame) {
        return Eigen::Vector3f(joints[joint][3 * frame], joints[joint][3 * frame + 1],
                               joints[joint][3 * frame + 2]);
    };
    EXPECT_EQ(at(1, 89), before.poses[1].position.cast<float>().eval());
    EXPECT_EQ(at(2, 89), at(1, 89));
    EXPECT_EQ(at(3, 89), before.poses[2].position.cast<float>().eval()) << "held at its centre";
    EXPECT_EQ(at(1, 90), end.poses[1].position.cast<float>().eval());
    EXPECT_EQ(at(3, 90), at(2, 90)) << "parted: nothing between its ends";
    const json& skin = glb.doc["skins"].back();
    EXPECT_EQ(skin["name"], "wire");
    EXPECT_EQ(skin["joints"].size(), 4U);
}

/// A run that goes back to an earlier time: exported times ascend.
TEST(Gltf, TakesTheLastTakeAlone) {
    const auto folder = fresh_folder();
    {
        Session session({.scene_text = R"({"version": 1, "name": "f", "bodies": [
            {"name": "b", "mass": 1, "sphere": 0.5}]})",
                         .record = (folder / "r.hwr").string()});
        const auto start = session.world().state().save();
        for (int k = 0; k < 20; ++k) ASSERT_EQ(session.step(), Status::ok);
        session.world().state().restore(start);
        for (int k = 0; k < 10; ++k) ASSERT_EQ(session.step(), Status::ok);
        session.finish();
    }
    const record::Recording r = record::Recording::open(folder / "r.hwr");
    ASSERT_EQ(r.takes.size(), 1U);
    const exporting::Frames frames = exporting::choose_frames(r, 1, 0.0, 1e9);
    ASSERT_GE(frames.size(), 10U);
    EXPECT_EQ(r.take_of(frames.front()), 1U);
    EXPECT_EQ(frames.back(), r.frame_count() - 1);
    for (std::size_t i = 1; i < frames.size(); ++i)
        EXPECT_LT(r.frame_head(frames[i - 1]).time, r.frame_head(frames[i]).time);
}

TEST(Gltf, TakesFramesBetweenTimes) {
    const auto folder = fresh_folder();
    const record::Recording r = record_small(folder, 60);
    EXPECT_EQ(exporting::choose_frames(r, 7, 0.0, 1e9),
              (exporting::Frames{0, 7, 14, 21, 28, 35, 42, 49, 56, 60}));
    EXPECT_EQ(exporting::choose_frames(r, 1, 0.5, 0.5 + 2.0 / 60.0),
              (exporting::Frames{30, 31, 32}));
    EXPECT_TRUE(exporting::choose_frames(r, 1, 2.0, 3.0).empty());
    EXPECT_THROW(exporting::write_gltf(r, {0}, folder / "no" / "such" / "r.glb"),
                 std::runtime_error);
}

}  // namespace
}  // namespace hawser::test
