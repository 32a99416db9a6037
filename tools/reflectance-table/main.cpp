// make-reflectance-table FOLDER [PHOTONS]: computes, by Monte Carlo, how much of the light that enters a half
// space perpendicularly leaves it again, over reduced albedo and refractive index, and writes
//
//     FOLDER/diffuse_reflectance.csv     albedo,eta,reflectanceOverAlbedo,standardError
//     FOLDER/diffuse_reflectance.glsl    the same for shaders, with the function that interpolates it
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "scattering/albedo_series.h"

namespace {

namespace fs = std::filesystem;
using nephrite::scattering::Estimate;

constexpr int absorptionNodes = 32;  ///< evenly over sqrt(1 - albedo), from 0 to 1
constexpr int indexNodes = 14;       ///< evenly over sqrt(eta - 1), from 0 to 1
/// (albedo / reflectance)^0.6 is nearly linear in sqrt(1 - albedo), so between two nodes of it little is
/// lost.
constexpr double exponent = 0.6;
constexpr std::uint64_t defaultPhotons = 4000000;
constexpr std::uint64_t seed = 20011;

struct Row {
    double eta;
    std::vector<double> albedos;
    std::vector<Estimate> overAlbedo;  ///< reflectance / albedo
};

double evenNode(int index, int count) {
    return static_cast<double>(index) / (count - 1);
}

/// Without absorption everything leaves; the other nodes are run.
Row computeRow(int index, std::uint64_t photons) {
    const double root = evenNode(index, indexNodes);
    Row row{1 + root * root, {1}, {{1, 0}}};
    for (int i = 1; i < absorptionNodes; ++i) {
        const double u = evenNode(i, absorptionNodes);
        row.albedos.push_back((1 - u) * (1 + u));
    }
    const std::span<const double> absorbing = std::span(row.albedos).subspan(1);
    const auto values = nephrite::scattering::reflectanceOverAlbedo(
        row.eta, absorbing,
        {.photons = photons, .seed = seed + static_cast<std::uint64_t>(index), .work = {}});
    row.overAlbedo.insert(row.overAlbedo.end(), values.begin(), values.end());
    return row;
}

std::string csvOf(const std::vector<Row>& rows) {
    std::string text = "albedo,eta,reflectanceOverAlbedo,standardError\n";
    for (const Row& row : rows)
        for (std::size_t i = 0; i < row.albedos.size(); ++i)
            text += fmt::format("{:.17g},{:.17g},{:.9g},{:.3g}\n", row.albedos[i], row.eta,
                                row.overAlbedo[i].value, row.overAlbedo[i].standardError);
    return text;
}

constexpr const char* shaderHead =
    R"glsl(// How much of the light that enters a half space perpendicularly leaves it again, single scattering included: Monte Carlo
// over reduced albedo and refractive index. Written by `make-reflectance-table shaders/tables`; do not edit.
// diffuse_reflectance.csv has the standard errors.
#ifndef DIFFUSE_REFLECTANCE_GLSL
#define DIFFUSE_REFLECTANCE_GLSL

)glsl";

constexpr const char* shaderFunction = R"glsl(
/// Reflectance over albedo (it has a limit where both are 0) for absorbedShare = sigma_a / sigma_t' = 1 - alpha' and the
/// refractive index eta inside over outside, taken as 1 below 1 and as 2 above 2. Good to 0.2 %.
float monteCarloReflectanceOverAlbedo(float absorbedShare, float eta) {
    float column = sqrt(clamp(absorbedShare, 0.0, 1.0)) * float(reflectanceColumns - 1);
    int left = min(int(column), reflectanceColumns - 2);
    float fromLeft = column - float(left);

    // Rows stand at eta = 1 + (row / last)^2, and between them eta itself is the measure.
    float last = float(reflectanceRows - 1);
    float aboveOne = clamp(eta - 1.0, 0.0, 1.0);
    int row = min(int(sqrt(aboveOne) * last), reflectanceRows - 2);
    float squared = aboveOne * last * last;
    float fromRow = clamp((squared - float(row * row)) / float(2 * row + 1), 0.0, 1.0);

    int corner = row * reflectanceColumns + left;
    float lower = mix(reflectanceTable[corner], reflectanceTable[corner + 1], fromLeft);
    corner += reflectanceColumns;
    float upper = mix(reflectanceTable[corner], reflectanceTable[corner + 1], fromLeft);
    return pow(mix(lower, upper, fromRow), -1.0 / reflectanceExponent);
}

#endif
)glsl";

std::string shaderOf(const std::vector<Row>& rows) {
    std::string text = shaderHead;
    text += fmt::format("const int reflectanceColumns = {};  // evenly over sqrt(1 - albedo), from 0 to 1\n",
                        absorptionNodes);
    text += fmt::format("const int reflectanceRows = {};     // evenly over sqrt(eta - 1), from 0 to 1\n",
                        indexNodes);
    text += fmt::format("const float reflectanceExponent = {:.1f};\n", exponent);
    text += "/// (albedo / reflectance)^reflectanceExponent, which between neighbours is nearly linear.\n";
    text += fmt::format("const float reflectanceTable[{}] = float[{}](\n", absorptionNodes * indexNodes,
                        absorptionNodes * indexNodes);
    for (std::size_t row = 0; row < rows.size(); ++row)
        for (std::size_t i = 0; i < rows[row].overAlbedo.size(); ++i) {
            const bool last = row + 1 == rows.size() && i + 1 == rows[row].overAlbedo.size();
            const char* separator = last ? ");\n" : (i + 1) % 8 == 0 ? ",\n" : ", ";
            text += fmt::format("{}{:.6f}{}", i % 8 == 0 ? "    " : "",
                                std::pow(rows[row].overAlbedo[i].value, -exponent), separator);
        }
    return text + shaderFunction;
}

void writeFile(const fs::path& path, const std::string& text) {
    std::ofstream stream(path, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream) throw std::runtime_error(path.string() + ": error: cannot be written");
}

std::uint64_t photonsOf(const std::string& text) {
    std::uint64_t photons = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), photons);
    if (fault != std::errc() || end != text.data() + text.size() || photons == 0)
        throw std::runtime_error("PHOTONS: error: expected a whole number above 0, found \"" + text + "\"");
    return photons;
}

void run(const fs::path& folder, std::uint64_t photons) {
    std::vector<Row> rows;
    for (int index = 0; index < indexNodes; ++index) {
        rows.push_back(computeRow(index, photons));
        fmt::print(stderr, "eta {:.4f} done\n", rows.back().eta);
    }
    writeFile(folder / "diffuse_reflectance.csv", csvOf(rows));
    writeFile(folder / "diffuse_reflectance.glsl", shaderOf(rows));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2 || argc > 3) {
        fmt::print(stderr, "usage: make-reflectance-table FOLDER [PHOTONS]\n");
        return 2;
    }
    try {
        run(argv[1], argc > 2 ? photonsOf(argv[2]) : defaultPhotons);
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
