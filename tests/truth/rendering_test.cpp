// Splitting, interrupting and threading change nothing; the camera is the GPU's.
#include "truth/rendering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "scene/view.h"
#include "support.h"
#include "truth/run_record.h"

namespace nephrite::truth {
namespace {

const std::string skin = R"({"preset": "skin1", "eta": 1})";
const std::string glass = test::material(test::layer(0.005, 0.05), 1.5);

/// A scene with an estimator, rendered at 20 x 13.
struct Work {
    scene::Scene scene;
    World world{scene, 0};
    Camera camera{scene.description().camera, 20, 13};
    std::unique_ptr<Estimator> estimator;

    explicit Work(Mode mode = Mode::Volume, std::uint64_t seed = 1, const std::string& material = skin)
        : scene(test::sceneOf(test::sphereScene(material))),
          estimator(makeEstimator(world, {mode, seed, 1 << 10, 1 << 13}, scene)) {}
    Rendering rendering(const Part& part = {}, std::uint32_t samples = 6) {
        return {world, camera, *estimator, part, samples};
    }
};

image::Image rendered(Work& work, unsigned threads, const Part& part = {}) {
    Rendering rendering = work.rendering(part);
    rendering.run(threads, {});
    EXPECT_TRUE(rendering.isFinished());
    return rendering.picture();
}

TEST(Rendering, PartsAddUpToTheWhole) {
    for (const auto& [mode, material] : {std::pair{Mode::Volume, skin}, std::pair{Mode::Single, skin},
                                         std::pair{Mode::Single, glass}, std::pair{Mode::Dipole, skin}}) {
        Work work(mode, 1, material);
        const image::Image whole = rendered(work, 2);
        image::Image sum = rendered(work, 1, {1, 3});
        for (const std::uint32_t part : {2U, 3U}) {
            const image::Image more = rendered(work, 1, {part, 3});
            for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += more.pixels[i];
        }
        EXPECT_EQ(sum.pixels, whole.pixels);
        EXPECT_GT(*std::max_element(whole.pixels.begin(), whole.pixels.end()), 0);
    }
}

TEST(Rendering, ContinuesWhereItStopped) {
    for (const auto& [mode, material] :
         {std::pair{Mode::Volume, skin}, std::pair{Mode::Volume, glass}, std::pair{Mode::Dipole, skin}}) {
        Work work(mode, 1, material);
        const image::Image whole = rendered(work, 2);
        std::string saved;
        int stops = 0;
        for (bool finished = false; !finished; ++stops) {
            Rendering rendering = work.rendering();
            if (!saved.empty()) {
                ASSERT_TRUE(rendering.restore(saved));
            }
            double least = -1;
            Watcher watcher;
            watcher.progress = [&](double done) { least = least < 0 ? done : least; };
            watcher.stop = [&] { return least >= 0 && stops < 3; };
            rendering.run(2, watcher);
            saved = rendering.save();
            finished = rendering.isFinished();
            if (finished) {
                EXPECT_EQ(rendering.picture().pixels, whole.pixels);
            }
        }
        Rendering other = work.rendering({}, 7);
        EXPECT_FALSE(other.restore("short"));
    }
}

/// Bytes of the right number that no rendering saved.
TEST(Rendering, DoesNotContinueFromDamage) {
    Work work;
    Rendering half = work.rendering();
    Watcher watcher;
    bool isFirst = true;
    watcher.stop = [&] { return !std::exchange(isFirst, false); };
    half.run(1, watcher);
    const std::string good = half.save();
    const auto damaged = [&](std::size_t place, auto value) {
        std::string bytes = good;
        std::memcpy(&bytes[place], &value, sizeof(value));
        return bytes;
    };
    Rendering rendering = work.rendering();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const std::string& bytes :
         {damaged(0, std::uint32_t{7}), damaged(0, std::uint32_t{3}), damaged(0, ~std::uint32_t{0}),
          damaged(4, nan), damaged(4, HUGE_VAL), damaged(12, nan), damaged(12, -1.0), good + "1",
          damaged(good.size() - 8, nan)}) {
        EXPECT_FALSE(rendering.restore(bytes));
        EXPECT_EQ(rendering.save(), work.rendering().save());
    }
    EXPECT_TRUE(rendering.restore(good));
}

/// Samples of a round share no photons: their mean varies a quarter as much as they do. Many paths make the
/// photons' part of the variance the greater one.
TEST(Rendering, SamplesOfARoundAreIndependent) {
    Work work(Mode::Single, 1, glass);
    const CameraRay ray = work.camera.through(7, 9);
    const auto seen = work.world.geometry().trace(ray.ray);
    ASSERT_TRUE(seen);
    scattering::RunningStatistics samples, rounds;
    for (std::uint32_t first = 0; first < 160; first += 4) {
        work.estimator->beginRound(first, first + 4, 2);
        scattering::RunningStatistics round;
        for (std::uint32_t sample = first; sample < first + 4; ++sample) {
            scattering::RunningStatistics paths;
            for (std::uint32_t pixel = 0; pixel < 200; ++pixel) {
                std::array<double, 3> values{};
                work.estimator->sample(ray, *seen, pixel, sample, values);
                paths.add(values[0]);
            }
            samples.add(paths.mean());
            round.add(paths.mean());
        }
        rounds.add(round.mean());
    }
    EXPECT_NEAR(4 * rounds.variance() / samples.variance(), 1, 0.7);
}

TEST(Rendering, SeesThroughTheGpusPixels) {
    const auto scene = test::sceneOf(test::sphereScene(skin));
    scene::CameraDescription description = scene.description().camera;
    description.position = {3, 20, 30};
    description.up = {0.2, 1, 0};
    const Camera camera(description, 32, 20);
    const scene::View view = scene::cameraView(description, 32, 20);
    for (std::uint32_t y = 0; y < 20; y += 19)
        for (std::uint32_t x = 0; x < 32; x += 31) {
            const glm::vec3 expected = scene::viewRay(view, (static_cast<float>(x) + 0.5F) / 32,
                                                      (static_cast<float>(y) + 0.5F) / 20);
            EXPECT_LT(glm::distance(camera.through(x, y).ray.direction, glm::dvec3(expected)), 1e-6);
        }
    EXPECT_GT(camera.through(16, 0).ray.direction.y, camera.through(16, 19).ray.direction.y);
}

TEST(Part, IsReadFromText) {
    EXPECT_EQ(toText(*parsePart("2/16")), "2/16");
    for (const char* wrong : {"", "1", "0/4", "5/4", "1/0", "-1/4", "1/4x", "a/b", "1/4/2"})
        EXPECT_FALSE(parsePart(wrong)) << wrong;
}

}  // namespace
}  // namespace nephrite::truth
