// Damaged files: whatever is done to a file, it loads or ends in one line, and never crashes (most telling when built
// with sanitizers).
#include <random>

#include "tests/io/gltf_samples.h"

namespace kd {
namespace {

/// Decodes and flattens; true where that succeeds. error_of() checks the error.
bool survives(const std::string& bytes) {
    return error_of([&] { (void)flatten(decode_gltf(bytes, "damaged.glb")); }).empty();
}

TEST(G03, CutOffAnywhere) {
    const std::string whole = rich_file().glb();
    ASSERT_TRUE(survives(whole));
    for (std::size_t length = 0; length < whole.size(); length += length < 64 ? 1 : 97) {
        EXPECT_FALSE(survives(whole.substr(0, length))) << length << " bytes";
    }
}

TEST(G03, WithWrongTotalLengthCutOffAnywhere) {
    // As above, but with a header that agrees with what is there, so that the chunks are looked at.
    const std::string whole = rich_file().glb();
    for (std::size_t length = 12; length < whole.size(); length += 97) {
        std::string cut = whole.substr(0, length);
        EXPECT_FALSE(survives(cut.replace(8, 4, GltfBuilder::word(length)))) << length << " bytes";
    }
}

TEST(G02, TextCutOffAnywhere) {
    const std::string whole = rich_file().text();
    ASSERT_TRUE(survives(whole));
    for (std::size_t length = 0; length < whole.size(); length += 97) {
        EXPECT_FALSE(survives(whole.substr(0, length))) << length << " bytes";
    }
}

TEST(G22, JpegCutOffOrChanged) {
    const std::string whole = get_bytes(std::string(KD_SOURCE_DIR) + "/tests/fixtures/io/two_colours.jpg");
    const auto file_with = [&](const std::string& jpeg) {
        GltfBuilder builder = rich_file();
        builder.json["images"][0]["bufferView"] = builder.add_view(jpeg.data(), jpeg.size());
        return builder.glb();
    };
    for (std::size_t length = 1; length < whole.size(); length += 7) {
        EXPECT_TRUE(survives(file_with(whole.substr(0, length)))) << "a broken image must not stop a scene";
    }
    std::mt19937 random(2);
    for (int round = 0; round < 100; ++round) {
        std::string damaged = whole;
        damaged[random() % damaged.size()] = static_cast<char>(random());
        EXPECT_TRUE(survives(file_with(damaged)));
    }
}

TEST(Damage, BytesChangedAtRandom) {
    const std::string whole = rich_file().glb();
    std::mt19937 random(1);
    int loaded = 0;
    for (int round = 0; round < 10000; ++round) {
        std::string damaged = whole;
        for (unsigned k = 1 + random() % 4; k > 0; --k)
            damaged[random() % damaged.size()] = static_cast<char>(random());
        loaded += survives(damaged) ? 1 : 0;
    }
    EXPECT_GT(loaded, 0) << "some changes, as of a coordinate, do no harm";
    EXPECT_LT(loaded, 10000);
}

/// All JSON pointers to numbers in `json`.
void collect_numbers(const nlohmann::json& json, const std::string& pointer, std::vector<std::string>& found) {
    if (json.is_number()) found.push_back(pointer);
    if (!json.is_structured()) return;
    for (const auto& [key, value] : json.items()) collect_numbers(value, pointer + "/" + key, found);
}

TEST(Damage, EveryNumberReplacedByExtremes) {
    const auto whole = nlohmann::json::parse(rich_file().text());
    std::vector<std::string> numbers;
    collect_numbers(whole, "", numbers);
    ASSERT_GT(numbers.size(), 60u);
    const std::vector<nlohmann::json> extremes{0,
                                               -1,
                                               1,
                                               255,
                                               65536,
                                               2147483647,
                                               2147483648u,
                                               4294967295u,
                                               4294967296u,
                                               9223372036854775807,
                                               18446744073709551615u,
                                               1e300,
                                               -1e300,
                                               1e-300,
                                               0.5,
                                               "7",
                                               nullptr,
                                               nlohmann::json::array(),
                                               nlohmann::json::object()};
    for (const std::string& pointer : numbers) {
        for (const auto& extreme : extremes) {
            nlohmann::json damaged = whole;
            damaged[nlohmann::json::json_pointer(pointer)] = extreme;
            SCOPED_TRACE(pointer + " = " + extreme.dump());
            survives(damaged.dump());
        }
    }
}

/// Pointers to everything in `json` but itself.
void collect_all(const nlohmann::json& json, const std::string& pointer, std::vector<std::string>& found) {
    if (!pointer.empty()) found.push_back(pointer);
    if (!json.is_structured()) return;
    for (const auto& [key, value] : json.items()) collect_all(value, pointer + "/" + key, found);
}

TEST(Damage, EveryMemberRemovedOrOfAnotherType) {
    const auto whole = nlohmann::json::parse(rich_file().text());
    std::vector<std::string> members;
    collect_all(whole, "", members);
    ASSERT_GT(members.size(), 100u);
    for (const std::string& pointer : members) {
        SCOPED_TRACE(pointer);
        const nlohmann::json removal = {{{"op", "remove"}, {"path", pointer}}};
        survives(whole.patch(removal).dump());
        const nlohmann::json wrong_type = {{{"op", "replace"}, {"path", pointer}, {"value", true}}};
        survives(whole.patch(wrong_type).dump());
    }
}

}  // namespace
}  // namespace kd
