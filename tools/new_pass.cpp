// `nephrite new-pass NAME`: the two files that a new pass starts from, a manifest and a shader that work.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>

#include "image/output_file.h"
#include "runtime/loading/graph_loading.h"
#include "verbs.h"

namespace nephrite::tools {
namespace {

namespace fs = std::filesystem;

struct NewPassArguments {
    std::string name;
    std::string kind = "pixel";
    fs::path folder = ".";
};

/// A name that is a file's and can stand in a graph, a C identifier but for its dashes.
void requirePassName(const std::string& name) {
    const auto isLetter = [](unsigned char c) { return std::isalpha(c) != 0; };
    const auto isAllowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; };
    const bool right = !name.empty() && isLetter(static_cast<unsigned char>(name.front())) &&
                       std::all_of(name.begin(), name.end(), isAllowed);
    if (!right)
        throw InputError({"new-pass"}, fmt::format("expected a name of letters, digits, \"-\" and \"_\" that "
                                                   "starts with a letter, found {}",
                                                   inQuotes(name)));
}

std::string readTemplate(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream) throw RunError(fmt::format("{}: error: the template cannot be read", file.string()));
    return text;
}

std::string withName(std::string text, const std::string& name) {
    constexpr std::string_view place = "NAME";
    for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at + name.size()))
        text.replace(at, place.size(), name);
    return text;
}

void requireAbsent(const fs::path& file) {
    std::error_code ignored;
    if (fs::exists(fs::symlink_status(file, ignored)))
        throw InputError({file.string()}, "this file is there already; it stays as it is");
}

/// As a shell takes it for one word.
std::string asWord(const std::string& text) {
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._/+-";
    if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

/// What to type next.
void printNextSteps(const NewPassArguments& arguments, const fs::path& manifest, const fs::path& shader) {
    const std::string folder = asWord(arguments.folder.string());
    const std::string inputs = arguments.kind == "raster" ? "" : R"(, "in": {"source": "NODE.PORT"})";
    fmt::print(
        "{}\n{}\n\n"
        "A node of a graph:      \"{}\": {{\"pass\": \"{}\"{}}}\n"
        "Check the manifest:     nephrite check {} --pass-path {}\n"
        "Render while you edit:  nephrite render GRAPH --pass-path {} -o picture.png --watch\n",
        manifest.string(), shader.string(), arguments.name, arguments.name, inputs, asWord(manifest.string()),
        folder, folder);
}

void writePass(const NewPassArguments& arguments) {
    requirePassName(arguments.name);
    const runtime::DataFolders folders = runtime::DataFolders::find();
    const fs::path manifest = arguments.folder / (arguments.name + ".json");
    const fs::path shader = arguments.folder / (arguments.name + ".glsl");
    requireAbsent(manifest);
    requireAbsent(shader);
    const auto names = runtime::loadPassTypes(folders, {})->names();
    if (std::find(names.begin(), names.end(), arguments.name) != names.end())
        fmt::print(stderr, "{}\n",
                   toLine({{manifest.string()},
                           "with --pass-path this pass stands for the project's own of the same name"},
                          "warning"));
    std::error_code error;
    fs::create_directories(arguments.folder, error);
    if (error) throw RunError(fmt::format("{}: error: {}", arguments.folder.string(), error.message()));
    const fs::path templates = folders.passes / "templates";
    image::OutputFile shaderFile(shader);
    image::OutputFile manifestFile(manifest);
    shaderFile.write(withName(readTemplate(templates / (arguments.kind + ".glsl")), arguments.name));
    manifestFile.write(withName(readTemplate(templates / (arguments.kind + ".json")), arguments.name));
    shaderFile.commit();
    manifestFile.commit();
    printNextSteps(arguments, manifest, shader);
}

}  // namespace

void addNewPassVerb(CLI::App& app, Action& action) {
    CLI::App* verb = app.add_subcommand("new-pass", "Write a manifest and a shader to start a pass from");
    auto arguments = std::make_shared<NewPassArguments>();
    verb->add_option("name", arguments->name, "What graphs will call it")->required();
    verb->add_option("--kind", arguments->kind, "pixel, compute or raster")
        ->check(CLI::IsMember({"pixel", "compute", "raster"}))
        ->capture_default_str();
    verb->add_option("-o,--output", arguments->folder, "The folder to write them to")->capture_default_str();
    verb->callback([&action, arguments] { action = [arguments] { writePass(*arguments); }; });
}

}  // namespace nephrite::tools
