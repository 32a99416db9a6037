// Whether the default graph shows what volumetric Monte Carlo says, on a small picture of the sphere scene;
// the suite of docs/results has larger ones.
#include <gtest/gtest.h>

#include <iostream>

#include "program.h"
#include "text/json.h"

namespace nephrite::tools::test {
namespace {

TEST(Accuracy, DefaultGraphIsNearVolumetricMonteCarloAndThePaperIsNot) {
    const Workplace place;
    const std::string scene = sceneFile("sphere.json");
    const std::string size = " --size 40x40 ";
    for (const std::string seed : {"1", "2"})
        ASSERT_EQ(place
                      .run("reference " + scene + " --mode volume --spp 32 --seed " + seed + size +
                           "-o half-" + seed + ".exr")
                      .status,
                  0);
    const auto errorsOf = [&](const std::string& graph, const std::string& options) {
        EXPECT_EQ(
            place.run("render " + graphFile(graph) + " --scene " + scene + size + options + "-o picture.exr")
                .status,
            0);
        return json::parse(place.run("compare picture.exr half-1.exr half-2.exr --bins 4 --json").output,
                           "stdout")
            .raw();
    };
    const Json::Value ours = errorsOf("consistent.json", "");
    const Json::Value paper = errorsOf("paper.json", "");
    for (Json::ArrayIndex c = 0; c < 3; ++c) {
        const double error = ours["unbiasedRelRMSE"][c].asDouble();
        const double ratio = ours["meanRatio"][c].asDouble();
        std::cout << "consistent.json, channel " << c << ": relRMSE " << error << ", mean ratio " << ratio
                  << "; paper.json: " << paper["unbiasedRelRMSE"][c].asDouble() << ", "
                  << paper["meanRatio"][c].asDouble() << "\n";
        // The noise of the halves leaves about .02 of each.
        EXPECT_LT(error, 0.09);
        EXPECT_NEAR(ratio, 1, 0.05);
        // Its brightness depends on the size of the picture; this small, it is not as far off as at others.
        EXPECT_GT(paper["unbiasedRelRMSE"][c].asDouble(), 0.15);
    }
}

}  // namespace
}  // namespace nephrite::tools::test
