// The paper's pipeline over the meshes of the paper's Table 1 at both sizes. The meshes are no part of the
// project: the folder is $NEPHRITE_MODELS or ../shared/models beside the tree, and without it the tests are
// skipped.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "runtime/session.h"
#include "scratch_folder.h"

namespace nephrite::runtime {
namespace {

namespace fs = std::filesystem;

fs::path modelFolder() {
    if (const char* folder = std::getenv("NEPHRITE_MODELS")) return folder;
    return fs::path(NEPHRITE_SOURCE_DIR) / ".." / "shared" / "models";
}

struct Model {
    const char* file;
    const char* material;
};

// Table 1's rows with the stand-ins' files; the bunny is open (five holes), so is the teapot.
constexpr Model models[]{{"frog_2900.ply", "apple"},
                         {"teapot_6400.ply", "skin1-table1"},
                         {"goddess_lucy_63932.ply", "apple"},
                         {"bunny_69451.ply", "chicken1"},
                         {"maitreya_buddha_86994.ply", "skin2"},
                         {"dragon_100000.ply", "skimmilk"},
                         {"monster_armadillo_345944.ply", "apple"},
                         {"happy_buddha_1084450.ply", "skin2"}};

/// VmHWM of this process, bytes: the most memory it has ever held.
std::uint64_t peakResidentBytes() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::stoull(line.substr(6)) * 1024;
    return 0;
}

class Models : public testing::TestWithParam<Model> {};

TEST_P(Models, AreFiniteAndLitAtBothSizes) {
    const fs::path mesh = modelFolder() / GetParam().file;
    if (!fs::exists(mesh)) GTEST_SKIP() << "no " << mesh << ": the meshes are not part of the project";
    const ScratchFolder folder;
    const fs::path scene = folder.write(
        "scene.json",
        R"({"camera": {"position": [0, 8, 70], "target": [0, 0, 0], "fovY": 30, "near": 10, "far": 200},
        "lights": [{"type": "point", "position": [40, 50, 50], "intensity": [8000, 8000, 8000]}], "environment": {"radiance": [0.05, 0.05, 0.06]}, "materials": {},
        "objects": [{"mesh": ")" +
            fs::absolute(mesh).string() + R"(", "material": ")" + GetParam().material +
            R"(", "transform": {"fit": 30}}]})");
    for (const std::uint32_t size : {512U, 1024U}) {
        SessionOptions options;
        options.graph = fs::path(NEPHRITE_SOURCE_DIR) / "graphs/paper.json";
        options.scene = scene;
        options.size = {size, size};
        const auto start = std::chrono::steady_clock::now();
        Session session(options);
        const std::chrono::duration<double> setUp = std::chrono::steady_clock::now() - start;
        EXPECT_LT(setUp.count(), 10);
        session.renderFrame(0);
        const image::Image image = session.read("color");
        std::size_t covered = 0;
        std::size_t lit = 0;
        for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
            for (std::size_t c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(image.pixels[i + c]));
            covered += image.pixels[i + 3] > 0;
            lit += image.pixels[i] + image.pixels[i + 1] + image.pixels[i + 2] > 0;
        }
        EXPECT_GT(covered, image.pixels.size() / 4 / 50);
        EXPECT_GT(lit, covered * 9 / 10);
    }
    EXPECT_LT(peakResidentBytes(), std::uint64_t{3} << 29) << "more than 1.5 GiB";
}

INSTANTIATE_TEST_SUITE_P(Table1, Models, testing::ValuesIn(models), [](const auto& instance) {
    const std::string file = instance.param.file;
    return file.substr(0, file.find('.'));
});

}  // namespace
}  // namespace nephrite::runtime
