// `nephrite merge`: puts pictures of parts of a `reference` run together.
#include <filesystem>

#include "options.h"
#include "text/diagnostics.h"
#include "truth/run_record.h"
#include "verbs.h"

namespace nephrite::tools {
namespace {

struct MergeArguments {
    std::vector<std::filesystem::path> parts;
    std::filesystem::path output;
};

}  // namespace

void addMergeVerb(CLI::App& app, Action& action) {
    CLI::App* verb = app.add_subcommand("merge", "Put the pictures of all parts of a reference together");
    auto arguments = std::make_shared<MergeArguments>();
    verb->add_option("parts", arguments->parts, "Pictures of all parts, in any order")->required();
    verb->add_option("-o,--output", arguments->output, "The whole picture: F.exr")->required();
    verb->callback([&action, arguments] {
        action = [arguments] {
            if (arguments->output.extension() != ".exr")
                throw InputError(
                    {"-o"}, "expected a name ending in .exr, found \"" + arguments->output.string() + "\"");
            requireOther(arguments->output, arguments->parts);
            const image::ExrFile whole = truth::merge(arguments->parts);
            image::writeExr(arguments->output, whole.image, whole.metadata);
        };
    });
}

}  // namespace nephrite::tools
