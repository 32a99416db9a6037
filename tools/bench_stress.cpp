// `nephrite bench stress`: runs the list of everything that tends to break, and says what did.
#include <fmt/format.h>
#include <json/json.h>
#include <stdlib.h>

#include <chrono>
#include <cstdio>
#include <optional>

#include "bench.h"
#include "gpu/device.h"
#include "image/output_file.h"
#include "stress/cases.h"
#include "text/diagnostics.h"

namespace nephrite::tools {
namespace {

struct StressArguments {
    std::string only;
    std::string device;
    std::filesystem::path json;
};

/// A folder for scene files, gone with this.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "nephrite-stress-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw RunError("bench: error: cannot make a temporary folder");
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

std::vector<stress::Case> chosenCases(const StressArguments& arguments, const stress::Place& place) {
    std::vector<stress::Case> chosen;
    for (stress::Case& item : stress::allCases(place)) {
        if (item.name.find(arguments.only) != std::string::npos) chosen.push_back(std::move(item));
    }
    if (chosen.empty())
        throw InputError({"--only"}, fmt::format("no case has {} in its name", inQuotes(arguments.only)));
    return chosen;
}

Json::Value asJson(const stress::Outcome& outcome, double seconds) {
    Json::Value value;
    value["name"] = outcome.name;
    value["checks"] = Json::Value::UInt64{outcome.checks};
    value["seconds"] = seconds;
    value["failures"] = Json::arrayValue;
    for (const std::string& failure : outcome.failures) value["failures"].append(failure);
    return value;
}

/// Prints a case that failed on one line: its first failure, and how many more there are.
void print(const stress::Outcome& outcome) {
    if (outcome.failures.empty()) return;
    const std::size_t more = outcome.failures.size() - 1;
    fmt::print("{}: {}{}\n", outcome.name, outcome.failures.front(),
               more == 0 ? "" : fmt::format(" (and {} more)", more));
    std::fflush(stdout);
}

/// Throws InputError if no device has the name, whichever cases are run: before them, and once.
void requireDevice(const std::string& name) {
    if (!name.empty()) gpu::Device({.name = name});
}

void benchStress(const StressArguments& arguments) {
    requireDevice(arguments.device);
    const TemporaryFolder folder;
    const auto cases = chosenCases(arguments, {folder.path(), arguments.device, {}});
    std::optional<image::OutputFile> file;
    if (!arguments.json.empty()) file.emplace(arguments.json);
    Json::Value all = Json::arrayValue;
    std::size_t checks = 0;
    std::size_t failures = 0;
    for (const stress::Case& item : cases) {
        const auto start = std::chrono::steady_clock::now();
        const stress::Outcome outcome = stress::run(item);
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
        print(outcome);
        checks += outcome.checks;
        failures += outcome.failures.size();
        all.append(asJson(outcome, time.count()));
    }
    fmt::print("{} cases, {} checks, {} failures\n", cases.size(), checks, failures);
    if (file) {
        Json::StreamWriterBuilder builder;
        builder["indentation"] = "  ";
        file->write(Json::writeString(builder, all) + "\n");
        file->commit();
    }
    if (failures > 0) throw RunError(fmt::format("bench: error: {} checks failed", failures));
}

}  // namespace

void addBenchStress(CLI::App& bench, Action& action) {
    CLI::App* verb =
        bench.add_subcommand("stress", "Run everything that tends to break, on the device and on the CPU");
    auto arguments = std::make_shared<StressArguments>();
    verb->add_option("--only", arguments->only, "Only cases with this in their name");
    verb->add_option("--json", arguments->json, "Write every case, its checks and failures to this file");
    verb->add_option("--device", arguments->device, "Part of a device's name (default: the best there is)");
    verb->callback([&action, arguments] { action = [arguments] { benchStress(*arguments); }; });
}

}  // namespace nephrite::tools
