// `nephrite profile`: how light that enters at a point leaves around it, by formula or by Monte Carlo.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>
#include <thread>

#include "image/output_file.h"
#include "interrupt.h"
#include "layers_file.h"
#include "options.h"
#include "profile_models.h"
#include "profile_rules.h"
#include "progress_bar.h"
#include "verbs.h"

namespace nephrite::tools {
namespace {

struct ProfileArguments {
    std::string model;
    std::optional<double> scattering;
    std::optional<double> absorption;
    std::optional<double> g;
    std::optional<double> eta;
    std::optional<double> thickness;
    std::filesystem::path layers;
    std::vector<double> radii;
    std::uint64_t photons = 1000000;
    std::uint64_t seed = 1;
    std::filesystem::path json;

    bool hasCoefficients() const { return scattering || absorption || g || eta; }
};

void requireNumber(const std::string& option, const scene::NumberRule& rule, double number) {
    const bool inside = number >= rule.least && number <= rule.most;
    if (!inside) throw InputError({option}, fmt::format("expected {}, found {}", rule.expected, number));
}

double coefficient(const std::string& option, const std::optional<double>& number) {
    if (!number) throw InputError({option}, "expected a coefficient in 1/mm, found none");
    requireNumber(option, scene::notNegative, *number);
    return *number;
}

scattering::Medium mediumOf(const ProfileArguments& arguments) {
    const scattering::Medium medium{coefficient("--sigma-a", arguments.absorption),
                                    coefficient("--sigma-s", arguments.scattering), arguments.g.value_or(0),
                                    arguments.eta.value_or(1)};
    requireNumber("--g", anisotropyRule, medium.g);
    requireNumber("--eta", indexRule, medium.eta);
    return medium;
}

scattering::LayerStack stackOf(const ProfileArguments& arguments) {
    if (!arguments.layers.empty()) {
        if (arguments.hasCoefficients() || arguments.thickness)
            throw InputError({"--layers"},
                             "the file says everything about the medium: give no other option about it");
        return readLayersFile(arguments.layers);
    }
    const scattering::Medium medium = mediumOf(arguments);
    if (!arguments.thickness) return scattering::layerStackOf(medium);
    requireNumber("--thickness", scene::notNegative, *arguments.thickness);
    return scattering::layerStackOf(medium, *arguments.thickness);
}

Profile simulated(const ProfileArguments& arguments) {
    const scattering::LayerStack stack = stackOf(arguments);
    catchInterrupts();
    ProgressBar bar("photons");
    const scattering::WorkSettings work{.threads = std::max(1u, std::thread::hardware_concurrency()),
                                        .proceed = [&](double done) {
                                            bar.show(done);
                                            return !interrupted();
                                        }};
    auto profile = simulateProfile(stack, arguments.radii, {arguments.photons, arguments.seed, work});
    if (!profile) throw RunError("interrupted");
    return std::move(*profile);
}

Profile computed(const ProfileArguments& arguments) {
    const ModelKind kind = modelKind(arguments.model);
    for (const double radius : arguments.radii) requireNumber("--radii", scene::notNegative, radius);
    if (kind == ModelKind::monteCarlo) return simulated(arguments);
    if (arguments.thickness || !arguments.layers.empty())
        throw InputError(
            {arguments.thickness ? "--thickness" : "--layers"},
            fmt::format("{} is a model of a half space; only montecarlo knows layers", arguments.model));
    if (kind == ModelKind::halfSpace)
        return evaluateProfile(arguments.model, mediumOf(arguments), arguments.radii);
    if (arguments.hasCoefficients())
        throw InputError({"--model"},
                         fmt::format("{} is measured and takes no coefficients", arguments.model));
    return evaluateProfile(arguments.model, {}, arguments.radii);
}

std::string number(double value) {
    return fmt::format("{:.17g}", value);
}

std::string numberOrNull(const std::optional<scattering::Estimate>& estimate) {
    return estimate ? number(estimate->value) : "null";
}

std::string errorOrNull(const std::optional<scattering::Estimate>& estimate) {
    return estimate ? number(estimate->standardError) : "null";
}

std::string jsonOf(const std::string& model, const Profile& profile) {
    const ProfileTotals& totals = profile.totals;
    std::vector<std::string> radii;
    std::vector<std::string> values;
    std::vector<std::string> errors;
    for (const double radius : profile.radii) radii.push_back(number(radius));
    for (const scattering::Estimate& value : profile.values) {
        values.push_back(number(value.value));
        errors.push_back(number(value.standardError));
    }
    std::string text =
        fmt::format(R"json({{
  "model": "{}",
  "totalReflectance": {},
  "totalTransmittance": {},
  "singleReflectance": {},
  "specularReflectance": {},
  "absorptance": {},
  "lost": {},
)json",
                    model, number(totals.totalReflectance.value), number(totals.totalTransmittance.value),
                    numberOrNull(totals.singleReflectance), number(totals.specularReflectance),
                    numberOrNull(totals.absorptance), numberOrNull(totals.lost));
    text += fmt::format(
        R"json(  "standardError": {{
    "totalReflectance": {},
    "totalTransmittance": {},
    "singleReflectance": {},
    "absorptance": {},
    "lost": {},
    "values": [{}]
  }},
  "radii": [{}],
  "values": [{}]
}}
)json",
        number(totals.totalReflectance.standardError), number(totals.totalTransmittance.standardError),
        errorOrNull(totals.singleReflectance), errorOrNull(totals.absorptance), errorOrNull(totals.lost),
        fmt::join(errors, ", "), fmt::join(radii, ", "), fmt::join(values, ", "));
    return text;
}

void printProfile(const ProfileArguments& arguments) {
    requireOther(arguments.json, {&arguments.layers, 1});
    // Before the photons, so that an hour of them does not end at a folder that is not there.
    std::optional<image::OutputFile> json;
    if (!arguments.json.empty()) json.emplace(arguments.json);
    const Profile profile = computed(arguments);
    if (json) {
        json->write(jsonOf(arguments.model, profile));
        json->commit();
    }
    fmt::print("r,value\n");
    for (std::size_t i = 0; i < profile.radii.size(); ++i)
        fmt::print("{},{}\n", number(profile.radii[i]), number(profile.values[i].value));
}

}  // namespace

void addProfileVerb(CLI::App& app, Action& action) {
    CLI::App* verb = app.add_subcommand("profile", "Print how light that enters at a point leaves around it");
    auto arguments = std::make_shared<ProfileArguments>();
    verb->add_option("--model", arguments->model, fmt::format("One of {}", fmt::join(modelNames(), ", ")))
        ->required();
    verb->add_option("--sigma-s", arguments->scattering,
                     "Scattering coefficient, 1/mm (not reduced: g applies)");
    verb->add_option("--sigma-a", arguments->absorption, "Absorption coefficient, 1/mm");
    verb->add_option("--g", arguments->g, "Mean cosine of the scattering angle (default 0)");
    verb->add_option("--eta", arguments->eta, "Refractive index inside over outside (default 1)");
    verb->add_option("--thickness", arguments->thickness,
                     "Of a slab, mm (default: a half space); montecarlo only");
    verb->add_option("--layers", arguments->layers, "File with a stack of layers; montecarlo only");
    // CLI11 takes no text for 0.
    verb->add_option("--radii", arguments->radii, "Distances from the point, mm: a,b,c")
        ->delimiter(',')
        ->check([](const std::string& radius) {
            return radius.empty() ? std::string("expected distances in mm, a,b,c, found none")
                                  : std::string();
        });
    // Standard errors need two photons.
    verb->add_option("--photons", arguments->photons, "Photons of montecarlo")
        ->check(wholeNumber(2, 10000000000))
        ->capture_default_str();
    verb->add_option("--seed", arguments->seed, "Of montecarlo's random numbers")
        ->check(wholeNumber(0, std::numeric_limits<std::uint64_t>::max()))
        ->capture_default_str();
    verb->add_option("--json", arguments->json, "Write totals, values and standard errors to this file");
    verb->callback([&action, arguments] { action = [arguments] { printProfile(*arguments); }; });
}

}  // namespace nephrite::tools
