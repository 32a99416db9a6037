// `nephrite profile` as a user meets it: its numbers, its JSON, and what it says to bad input.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "program.h"
#include "text/json.h"

namespace nephrite::tools::test {
namespace {

using testing::HasSubstr;

const std::string apple = "--sigma-s 2.29 --sigma-a 0.003 --g 0 --eta 1.3 ";

class ProfileVerb : public testing::Test {
  protected:
    /// Runs the verb, expects it to work, and gives the value of each line.
    std::vector<double> values(const std::string& arguments) {
        const Answer answer = place_.run("profile " + arguments);
        EXPECT_EQ(answer.status, 0) << answer.errors;
        EXPECT_EQ(answer.errors, "");
        std::istringstream lines(answer.output);
        std::string line;
        std::getline(lines, line);
        EXPECT_EQ(line, "r,value");
        std::vector<double> result;
        while (std::getline(lines, line)) result.push_back(std::stod(line.substr(line.find(',') + 1)));
        return result;
    }

    Json::Value json(const std::string& name) { return json::parseFile(place_.path() / name).raw(); }

    void expectRefused(const std::string& arguments, const std::string& words) {
        const Answer answer = place_.run("profile " + arguments + " --json refused.json");
        EXPECT_EQ(answer.status, 2) << arguments << answer.errors;
        EXPECT_EQ(answer.output, "");
        EXPECT_THAT(answer.errors, HasSubstr(words));
        EXPECT_THAT(answer.errors, HasSubstr("error: "));
        EXPECT_FALSE(place_.isThere("refused.json"));
    }

    Workplace place_;
};

/// Jensen's dipole for the apple's red in extended precision.
long double dipole(long double radius) {
    const long double absorption = 0.003;
    const long double extinction = absorption + 2.29;
    const long double fit = -1.440L / 1.69L + .710L / 1.3L + .668L + .0636L * 1.3L;
    const long double mismatch = (1 + fit) / (1 - fit);
    const long double decay = std::sqrt(3 * absorption * extinction);
    long double sum = 0;
    for (const long double z : {1 / extinction, (1 + 4 * mismatch / 3) / extinction}) {
        const long double d = std::sqrt(radius * radius + z * z);
        sum += z * (1 + decay * d) * std::exp(-decay * d) / (d * d * d);
    }
    return (1 - absorption / extinction) / (4 * std::numbers::pi_v<long double>)*sum;
}

TEST_F(ProfileVerb, PrintsTheDipoleToTwelveDigits) {
    const auto printed = values("--model dipole " + apple + "--radii 0,0.1,1,10");
    ASSERT_EQ(printed.size(), 4);
    const double radii[] = {0, 0.1, 1, 10};
    for (std::size_t i = 0; i < printed.size(); ++i)
        EXPECT_NEAR(printed[i] / static_cast<double>(dipole(radii[i])), 1, 1e-12) << radii[i];
}

TEST_F(ProfileVerb, KnowsEveryModel) {
    for (const std::string model :
         {"dipole", "better-dipole", "photon-beam-diffusion", "burley", "sum-of-gaussians"}) {
        const auto printed =
            values("--model " + model + " " + apple + "--radii 0.5,1 --json " + model + ".json");
        EXPECT_GT(printed[0], printed[1]) << model;
        const Json::Value report = json(model + ".json");
        EXPECT_EQ(report["model"].asString(), model);
        EXPECT_GT(report["totalReflectance"].asDouble(), 0.8) << model;
        EXPECT_LT(report["totalReflectance"].asDouble(), 1) << model;
        EXPECT_EQ(report["values"][1].asDouble(), printed[1]);
        EXPECT_EQ(report["radii"][1].asDouble(), 1);
    }
    EXPECT_GT(values("--model skin-red --radii 1")[0], values("--model skin-blue --radii 1")[0]);
}

TEST_F(ProfileVerb, AccountsForAllPowerInMonteCarlo) {
    const std::string run =
        "--model montecarlo --sigma-s 90 --sigma-a 10 --g 0.75 --eta 1.4 --thickness 0.02 --photons 5000 ";
    const auto printed = values(run + "--radii 0.02,0.01 --json slab.json");
    ASSERT_EQ(printed.size(), 2);
    EXPECT_LT(printed[0], printed[1]);
    const Json::Value report = json("slab.json");
    double power = 0;
    for (const char* part :
         {"specularReflectance", "totalReflectance", "totalTransmittance", "absorptance", "lost"})
        power += report[part].asDouble();
    EXPECT_NEAR(power, 1, 1e-9);
    EXPECT_GT(report["standardError"]["totalReflectance"].asDouble(), 0);
    EXPECT_LT(report["singleReflectance"].asDouble(), report["totalReflectance"].asDouble());
    EXPECT_EQ(values(run + "--radii 0.02,0.01"), printed);
    EXPECT_NE(values(run + "--radii 0.02,0.01 --seed 2"), printed);
}

TEST_F(ProfileVerb, ReadsAStackOfLayers) {
    place_.write("whole.json",
                 R"json({"layers": [{"absorption": 0.5, "scattering": 2}], "g": 0.5, "eta": 1.3})json");
    const std::string run = "--model montecarlo --photons 2000 --radii 0.5 ";
    EXPECT_EQ(values(run + "--layers whole.json"),
              values(run + "--sigma-s 2 --sigma-a 0.5 --g 0.5 --eta 1.3"));
}

TEST_F(ProfileVerb, RefusesWhatItCannotUse) {
    expectRefused("--model dipol " + apple, "did you mean \"dipole\"?");
    expectRefused("--model dipole --sigma-a 1", "--sigma-s: error: expected a coefficient");
    expectRefused("--model dipole --sigma-a -1 --sigma-s 1", "--sigma-a: error: ");
    expectRefused("--model dipole --sigma-a nan --sigma-s 1", "--sigma-a");
    expectRefused("--model dipole --sigma-a 1 --sigma-s 1 --g 1.5",
                  "--g: error: expected a number between -1 and 1");
    expectRefused("--model dipole --sigma-a 1 --sigma-s 1 --eta 0", "--eta: error: ");
    expectRefused("--model dipole " + apple + "--radii 1,-1", "--radii: error: ");
    expectRefused("--model dipole " + apple + "--radii 1,x", "--radii");
    expectRefused("--model burley " + apple + "--thickness 1",
                  "--thickness: error: burley is a model of a half space");
    expectRefused("--model skin-red " + apple, "takes no coefficients");
    for (const std::string option : {"--photons 1", "--photons -5", "--photons 1e3", "--photons 99999999999",
                                     "--seed -1", "--seed 18446744073709551616"})
        expectRefused("--model montecarlo " + apple + option,
                      option.substr(0, option.find(' ')) + ": expected a whole number");
    expectRefused("--model montecarlo " + apple + "--layers l.json", "--layers: error: ");
}

TEST_F(ProfileVerb, NamesFaultsOfALayersFile) {
    place_.write("l.json", R"json({"layers": [
  {"thickness": null, "absorption": 1, "scatering": 2},
  {"thickness": -1, "absorption": 1, "scattering": "x"}],
  "eta": 0})json");
    const Answer answer = place_.run("profile --model montecarlo --layers l.json");
    EXPECT_EQ(answer.status, 2);
    EXPECT_THAT(answer.errors, HasSubstr("l.json:2:40: error: "));
    EXPECT_THAT(answer.errors, HasSubstr("did you mean \"scattering\"?"));
    EXPECT_THAT(answer.errors, HasSubstr("only the last layer may be infinitely thick"));
    EXPECT_THAT(answer.errors, HasSubstr("l.json:3:17: error: "));
    EXPECT_THAT(answer.errors, HasSubstr("l.json:4:10: error: "));
    EXPECT_EQ(place_.run("profile --model montecarlo --layers missing.json").status, 2);

    place_.write("empty.json", "{}");
    EXPECT_EQ(place_.run("profile --model montecarlo --layers empty.json").errors,
              "empty.json:1:1: error: a stack of layers needs \"layers\"\n");
}

TEST_F(ProfileVerb, SaysWhichFileItCannotWrite) {
    const Answer answer =
        place_.run("profile --model dipole " + apple + "--radii 1 --json no/such/folder.json");
    EXPECT_EQ(answer.status, 1);
    EXPECT_THAT(answer.errors, HasSubstr("no/such/folder.json: error: "));
    EXPECT_EQ(answer.output, "");
}

}  // namespace
}  // namespace nephrite::tools::test
