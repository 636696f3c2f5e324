// What fuzzing starts from and what it once found, through the same functions in every build.
#include <cstdlib>

#include "tests/fuzz/seeds.h"
#include "tests/fuzz/targets.h"
#include "tests/io/scratch.h"

namespace kd::fuzz {
namespace {

namespace fs = std::filesystem;

struct Target {
    const char* name;
    void (*run)(std::string_view bytes);
    Seeds (*seeds)();
};

constexpr Target targets[] = {
    {"gltf", gltf, gltf_seeds}, {"rays_csv", rays_csv, rays_csv_seeds}, {"session", session, session_seeds}};

class Fuzz : public testing::TestWithParam<Target> {
  protected:
    [[nodiscard]] static fs::path folder(const char* kind) {
        return fs::path(KD_SOURCE_DIR) / "tests" / "fuzz" / kind / GetParam().name;
    }
};

void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

/// Runs every file of a folder; how many there were.
int replay(const Target& target, const fs::path& folder) {
    int count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (entry.path().filename() == ".gitkeep") continue;
        SCOPED_TRACE(entry.path());
        EXPECT_NO_THROW(target.run(get_bytes(entry.path())));
        ++count;
    }
    return count;
}

TEST_P(Fuzz, TheCorpusKeepsItsPromises) { EXPECT_GE(replay(GetParam(), folder("corpus")), 5); }

/// Nothing has been found yet; a folder that is not there is a failure.
TEST_P(Fuzz, WhatWasFoundStaysMended) { EXPECT_NO_THROW((void)replay(GetParam(), folder("regressions"))); }

/// With KD_UPDATE_CORPUS=1 the seeds are written anew.
TEST_P(Fuzz, EverySeedIsInTheCorpus) {
    const bool update = std::getenv("KD_UPDATE_CORPUS") != nullptr;
    for (const auto& [name, bytes] : GetParam().seeds()) {
        EXPECT_LT(bytes.size(), 16384u) << name << ": small inputs fuzz faster";
        if (update) put_bytes(folder("corpus") / name, bytes);
        const fs::path kept = folder("corpus") / name;
        ASSERT_TRUE(fs::is_regular_file(kept)) << name << "; run with KD_UPDATE_CORPUS=1";
        EXPECT_TRUE(get_bytes(kept) == bytes) << name << " is another one; run with KD_UPDATE_CORPUS=1";
        EXPECT_NO_THROW(GetParam().run(bytes)) << name;
    }
}

std::string name_of_target(const testing::TestParamInfo<Target>& test) { return test.param.name; }

INSTANTIATE_TEST_SUITE_P(Targets, Fuzz, testing::ValuesIn(targets), name_of_target);

}  // namespace
}  // namespace kd::fuzz
