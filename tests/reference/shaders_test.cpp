// Every shader of graphs/paper.json against its formula in double precision, over scenes of every kind:
// within 1e-3 at 99.9 % of the covered pixels where the output is rgba32f, 2e-3 where it is rgba16f. Not all
// pixels can agree: a light texel or an occlusion sample is the nearest one, and single precision rounds to
// the other side now and then.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "reference/evaluation.h"
#include "reference/made_scenes.h"

namespace nephrite::reference {
namespace {

struct Case {
    std::string scene;  ///< of graphs/scenes, or one made for the tests
    Formats formats = Formats::AllFloat32;
    std::vector<std::string> settings;
    bool allLit = false;  ///< every term has light somewhere
};

std::filesystem::path fileOf(const std::string& scene) {
    if (scene == "textured") return writeTexturedScene();
    if (scene == "low-index") return writeLowIndexScene();
    return graphFolder() / "scenes" / (scene + ".json");
}

/// What a failing test prints of its case.
void PrintTo(const Case& value, std::ostream* stream) {
    *stream << value.scene;
}

std::string nameOf(const testing::TestParamInfo<Case>& info) {
    std::string name =
        info.param.scene + (info.param.formats == Formats::Default ? "DefaultFormats" : "Float32");
    name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
    return name;
}

class Shaders : public testing::TestWithParam<Case> {
  protected:
    static constexpr std::uint32_t size = 128;

    void expectAgreement(const Comparison& comparison, double fraction = 0.999) const {
        const Agreement::Result result = comparison.agreement.measure(comparison.tolerance);
        std::cout << fmt::format("{:28} {}\n", comparison.what, result.summary());
        EXPECT_EQ(result.nonFinite, 0U) << comparison.what << ": " << result.summary();
        EXPECT_GE(result.fraction(), fraction) << comparison.what << ": " << result.summary();
        const bool mayBeDark = !GetParam().allLit || comparison.what == "light.position";
        EXPECT_TRUE(result.lit || mayBeDark) << comparison.what << " is black";
    }
};

void expectFinite(const DumpedFrame& frame) {
    for (const auto& [port, image] : frame.images()) {
        std::size_t nonFinite = 0;
        for (const float value : image.pixels) nonFinite += std::isfinite(value) ? 0 : 1;
        EXPECT_EQ(nonFinite, 0U) << port;
    }
}

/// Where the camera sees nothing, nothing is drawn; where it does, alpha is 1.
void expectCoverage(const DumpedFrame& frame, const Evaluation& evaluation) {
    for (const char* port : {"direct.irradiance", "ssao.radiance", "specular.radiance", "refraction.radiance",
                             "single-scatter.radiance", "dipole.radiance", "color"}) {
        const Texels texels = frame.texels(port);
        std::size_t wrong = 0;
        for (int y = 0; y < texels.height(); ++y) {
            for (int x = 0; x < texels.width(); ++x)
                wrong += evaluation.covered({x, y}) || glm::dvec3(texels.at(x, y)) == glm::dvec3(0) ? 0 : 1;
        }
        EXPECT_EQ(wrong, 0U) << port << " has light where nothing is";
    }
    const Texels color = frame.texels("color");
    std::size_t wrong = 0;
    for (int y = 0; y < color.height(); ++y) {
        for (int x = 0; x < color.width(); ++x)
            wrong += color.at(x, y).w == (evaluation.covered({x, y}) ? 1 : 0) ? 0 : 1;
    }
    EXPECT_EQ(wrong, 0U) << "alpha is not the coverage";
}

TEST_P(Shaders, AgreeWithTheirFormulas) {
    const std::filesystem::path scene = fileOf(GetParam().scene);
    const DumpedFrame frame({scene, {size, size}, GetParam().formats, GetParam().settings});
    const SceneData data = readSceneData(scene, size, size);
    const Evaluation evaluation(frame, data);

    expectFinite(frame);
    expectCoverage(frame, evaluation);
    expectAgreement(evaluation.lightViews());
    for (const Comparison& comparison : evaluation.layers()) expectAgreement(comparison);
    expectAgreement(evaluation.lightIrradiance());
    expectAgreement(evaluation.direct());
    expectAgreement(evaluation.singleScatter());
    expectAgreement(evaluation.dipole());
    expectAgreement(evaluation.ambientOcclusion());
    expectAgreement(evaluation.specular());
    expectAgreement(evaluation.refraction());
    expectAgreement(evaluation.composite(), 1);
}

const std::vector<std::string> smallLight{"lightSize=256"};

const std::vector<Case> cases{
    {"textured", Formats::AllFloat32, {"lightSize=128"}, true},
    {"textured", Formats::Default, {"lightSize=128"}, true},
    {"low-index", Formats::AllFloat32, smallLight},
    {"sphere", Formats::AllFloat32, {}},
    {"default", Formats::AllFloat32, smallLight},
    {"default", Formats::Default, smallLight},
    {"layers", Formats::AllFloat32, smallLight},
    {"layers", Formats::Default, smallLight},
    {"environment", Formats::AllFloat32, smallLight},
    {"light-inside", Formats::AllFloat32, smallLight},
    {"several-lights", Formats::AllFloat32, smallLight},
    {"several-lights", Formats::Default, smallLight},
};

INSTANTIATE_TEST_SUITE_P(Scenes, Shaders, testing::ValuesIn(cases), nameOf);

}  // namespace
}  // namespace nephrite::reference
