// The exact half space against closed forms, tables and its own limits; Monte Carlo and the shaders' table
// against it.
#include "scattering/half_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "scattering/albedo_series.h"
#include "statistics.h"

namespace nephrite::scattering {
namespace {

/// H(mu) of isotropic scattering by iterating Chandrasekhar's equation, 1/H = sqrt(1 - albedo) + albedo/2 int
/// nu H(nu) / (mu + nu) dnu, on a midpoint grid; at 1.
double iteratedH(double albedo) {
    constexpr int cells = 400;
    std::vector<double> h(cells, 1.0);
    const auto at = [&](double mu) {
        double sum = 0;
        for (int i = 0; i < cells; ++i)
            sum += (i + 0.5) / cells * h[static_cast<std::size_t>(i)] / (mu + (i + 0.5) / cells);
        return 1 / (std::sqrt(1 - albedo) + albedo / 2 * sum / cells);
    };
    for (int sweep = 0; sweep < 30; ++sweep) {
        std::vector<double> next(cells);
        for (int i = 0; i < cells; ++i) next[static_cast<std::size_t>(i)] = at((i + 0.5) / cells);
        h = next;
    }
    return at(1);
}

TEST(HalfSpace, IsChandrasekharsPlaneAlbedoWithoutABoundary) {
    for (const double albedo : {0.3, 0.9}) {
        const double expected = 1 - std::sqrt(1 - albedo) * iteratedH(albedo);
        EXPECT_NEAR(halfSpaceReflectance({1 - albedo, albedo, 0, 1}), expected, 3e-5);
    }
}

TEST(HalfSpace, HasGiovanellisValue) {
    // Giovanelli (1955): mu_a 10, mu_s 90, n 1.5, 0.2600 with the specular 0.04.
    EXPECT_NEAR(0.04 + 0.96 * halfSpaceReflectance({10, 90, 0, 1.5}), 0.2600, 0.00015);
}

TEST(HalfSpace, ReturnsEverythingWithoutAbsorption) {
    for (const double eta : {0.5, 1.0, 1.3, 2.0, 4.0})
        EXPECT_NEAR(halfSpaceReflectance({0, 1, 0, eta}), 1, 1e-9);
}

TEST(HalfSpace, ReturnsOnlySingleScatteringAsTheAlbedoVanishes) {
    // albedo/2 int c/(1 + c) dc
    const double albedo = 1e-7;
    EXPECT_NEAR(halfSpaceReflectance({1 - albedo, albedo, 0, 1}) / albedo, (1 - std::log(2.0)) / 2, 1e-7);
    EXPECT_EQ(halfSpaceReflectance({1, 0, 0, 1.3}), 0);
    EXPECT_EQ(halfSpaceReflectance({0, 0, 0, 1.3}), 0);
}

TEST(HalfSpace, OnlyDependsOnReducedCoefficients) {
    EXPECT_DOUBLE_EQ(halfSpaceReflectance({1, 20, 0.9, 1.4}),
                     halfSpaceReflectance(reduced({1, 20, 0.9, 1.4})));
}

TEST(AlbedoSeries, AgreesWithTheExactSolution) {
    const std::vector<double> albedos{1e-9, 0.3, 0.8, 0.99};
    statistics::Family family;
    std::uint64_t seed = 9;
    for (const double eta : {0.8, 1.0, 1.3, 2.0}) {
        const auto estimates =
            reflectanceOverAlbedo(eta, albedos, {.photons = 15 * 4096, .seed = seed++, .work = {}});
        for (std::size_t i = 0; i < albedos.size(); ++i) {
            const double expected = halfSpaceReflectance({1 - albedos[i], albedos[i], 0, eta}) / albedos[i];
            family.add(std::to_string(eta) + ' ' + std::to_string(albedos[i]),
                       statistics::meanTest(estimates[i].value, estimates[i].standardError, 15, expected));
        }
    }
    EXPECT_TRUE(family.holds());
}

TEST(AlbedoSeries, RejectsAWrongIndex) {
    const std::vector<double> albedos{0.8};
    const auto estimates = reflectanceOverAlbedo(1.3, albedos, {.photons = 15 * 4096, .seed = 1, .work = {}});
    const double wrong = halfSpaceReflectance({0.2, 0.8, 0, 1.35}) / 0.8;
    statistics::Family family;
    family.add("eta", statistics::meanTest(estimates[0].value, estimates[0].standardError, 15, wrong));
    EXPECT_FALSE(family.holds());
}

struct TableRow {
    double albedo = 0;
    double eta = 0;
    double value = 0;
    double standardError = 0;
};

std::vector<TableRow> tableRows() {
    std::ifstream file(NEPHRITE_SOURCE_DIR "/shaders/tables/diffuse_reflectance.csv");
    std::vector<TableRow> rows;
    std::string line;
    std::getline(file, line);
    EXPECT_EQ(line, "albedo,eta,reflectanceOverAlbedo,standardError");
    while (std::getline(file, line)) {
        TableRow row;
        char comma = 0;
        std::istringstream(line) >> row.albedo >> comma >> row.eta >> comma >> row.value >> comma >>
            row.standardError;
        rows.push_back(row);
    }
    return rows;
}

double exactOverAlbedo(double albedo, double eta) {
    const double least = std::max(albedo, 1e-9);
    return halfSpaceReflectance({1 - least, least, 0, eta}) / least;
}

TEST(ReflectanceTable, AgreesWithTheExactSolutionWithinItsErrors) {
    constexpr std::uint64_t batches = 977;
    const auto rows = tableRows();
    ASSERT_EQ(rows.size(), 32 * 14);
    statistics::Family family;
    for (const TableRow& row : rows) {
        const double expected = exactOverAlbedo(row.albedo, row.eta);
        EXPECT_LE(row.standardError, 0.001 * row.value);
        if (row.albedo == 1) {
            EXPECT_EQ(row.value, 1);
            continue;
        }
        family.add(std::to_string(row.albedo) + ' ' + std::to_string(row.eta),
                   statistics::meanTest(row.value, row.standardError, batches, expected));
    }
    EXPECT_TRUE(family.holds());
}

/// The table as the shader has it.
std::vector<double> shaderTable() {
    std::ifstream file(NEPHRITE_SOURCE_DIR "/shaders/tables/diffuse_reflectance.glsl");
    std::stringstream text;
    text << file.rdbuf();
    const std::string all = text.str();
    const std::size_t start = all.find("= float[448](") + 13;
    std::istringstream numbers(all.substr(start, all.find(");", start) - start));
    std::vector<double> table;
    for (double number = 0; numbers >> number;) {
        table.push_back(number);
        char comma = 0;
        numbers >> comma;
    }
    return table;
}

/// What the shader's function does, in double.
double interpolated(const std::vector<double>& table, double absorbedShare, double eta) {
    const double column = std::sqrt(absorbedShare) * 31;
    const int left = std::min(static_cast<int>(column), 30);
    const double squared = (eta - 1) * 169;
    const int row = std::min(static_cast<int>(std::sqrt(squared)), 12);
    const double up = (squared - row * row) / (2 * row + 1);
    const auto at = [&](int r) {
        const auto corner = static_cast<std::size_t>(r * 32 + left);
        return table[corner] + (table[corner + 1] - table[corner]) * (column - left);
    };
    return std::pow(at(row) + (at(row + 1) - at(row)) * up, -1 / 0.6);
}

TEST(ReflectanceTable, IsInterpolatedToAFifthOfAPercent) {
    const auto table = shaderTable();
    ASSERT_EQ(table.size(), 448);
    for (int i = 0; i <= 61; ++i)
        for (int j = 0; j <= 39; ++j) {
            const double u = i / 61.0;
            const double eta = 1 + j / 39.0;
            const double expected = exactOverAlbedo((1 - u) * (1 + u), eta);
            // Interpolation 0.2 %, noise of the nodes three standard errors of 0.07 %.
            EXPECT_NEAR(interpolated(table, u * u, eta) / expected, 1, 0.002 + 0.0021) << u << ' ' << eta;
        }
}

}  // namespace
}  // namespace nephrite::scattering
