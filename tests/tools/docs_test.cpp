// Runs the commands that README.md and docs/*.md show: what a page tells a reader to type works as printed.
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace nephrite {
namespace {

namespace fs = std::filesystem;

/// A fenced block of a page: ```LANGUAGE, or ```LANGUAGE file=PATH for a file that is shown whole.
struct Block {
    std::string language;
    std::string file;
    std::string text;
};

std::vector<Block> blocksOf(const fs::path& page) {
    std::ifstream stream(page);
    std::vector<Block> blocks;
    bool inside = false;
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with("```")) {
            inside = !inside;
            if (!inside) continue;
            const std::string separator = " file=";
            const std::size_t language = line.find(separator);
            const bool named = language != std::string::npos;
            blocks.push_back({line.substr(3, named ? language - 3 : language),
                              named ? line.substr(language + separator.size()) : std::string(),
                              {}});
        } else if (inside) {
            blocks.back().text += line + '\n';
        }
    }
    return blocks;
}

/// The lines of a ```sh block, those that end in a backslash joined with the next, comments left out.
std::vector<std::string> shellLines(const Block& block) {
    std::vector<std::string> lines;
    std::istringstream stream(block.text);
    bool continues = false;
    for (std::string line; std::getline(stream, line);) {
        if (!continues) lines.emplace_back();
        continues = line.ends_with('\\');
        if (continues) line.pop_back();
        lines.back() += line;
    }
    for (std::string& line : lines) {
        line = line.substr(0, line.find(" #"));
        line.erase(line.find_last_not_of(' ') + 1);
    }
    std::erase_if(lines, [](const std::string& line) { return line.empty() || line.front() == '#'; });
    return lines;
}

/// The arguments of a line that calls the program; "" for any other line.
std::string programArguments(const std::string& line) {
    for (const std::string name : {"nephrite ", "build/release/nephrite "}) {
        if (line.starts_with(name)) return line.substr(name.size());
    }
    return {};
}

/// Lines that no test of a page runs, and who does, or why nobody can.
bool isRunElsewhere(const std::string& line) {
    constexpr std::array starts{
        "tools/demo.sh",             // tools/bootstrap-check.sh, on a bare system
        "tools/test.sh",             // the same, and the builds of every change
        "tools/setup.sh",            // both of these
        "tools/bootstrap-check.sh",  // by hand: root and a quarter of an hour
        "tools/results.sh",          // by hand: hours; ends in the bench pareto that pareto_test.cpp runs
        "tools/reference-array.sh",  // reference_test.cpp, with a scheduler that stands for Slurm's
        "cmake ",                    // whoever reads this test's result has built it
        "ctest ",                    // the same
    };
    return std::any_of(starts.begin(), starts.end(),
                       [&](const char* start) { return line.starts_with(start); });
}

bool hasCommands(const fs::path& page) {
    const std::vector<Block> blocks = blocksOf(page);
    return std::any_of(blocks.begin(), blocks.end(),
                       [](const Block& block) { return block.language == "sh"; });
}

/// The pages with commands, as paths below the root of the tree.
std::vector<std::string> pagesWithCommands() {
    const fs::path root = NEPHRITE_SOURCE_DIR;
    std::vector<fs::path> pages{root / "README.md"};
    for (const auto& entry : fs::directory_iterator(root / "docs")) {
        if (entry.path().extension() == ".md") pages.push_back(entry.path());
    }
    std::vector<std::string> names;
    for (const fs::path& page : pages) {
        if (hasCommands(page)) names.push_back(fs::relative(page, root).string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// A copy of what the commands read, to run them in.
class Pages : public testing::TestWithParam<std::string> {
  protected:
    Pages() {
        std::string name = (fs::temp_directory_path() / "nephrite-docs-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for the test");
        folder_ = name;
        for (const char* part : {"graphs", "passes", "shaders"}) {
            fs::copy(fs::path(NEPHRITE_SOURCE_DIR) / part, folder_ / part, fs::copy_options::recursive);
        }
        fs::create_directory(folder_ / "out");
    }
    ~Pages() override { fs::remove_all(folder_); }

    /// Writes a file that the page shows whole.
    void writeFile(const Block& block) const {
        const fs::path file = folder_ / block.file;
        fs::create_directories(file.parent_path());
        std::ofstream stream(file);
        stream << block.text;
        if (!stream.flush()) throw std::runtime_error("cannot write " + file.string());
    }

    /// Runs a line and returns its exit status; what it printed goes to `printed`.
    int run(const std::string& line, std::string& printed) const {
        const std::string arguments = programArguments(line);
        const fs::path log = folder_ / "log";
        // tools/test.sh sets caches that all tests share; otherwise they are the test's own.
        const std::string folder = folder_.string();
        // What goes on until it is interrupted is interrupted after a while.
        const bool goesOn = arguments.find(" --watch") != std::string::npos;
        const std::string command =
            "cd '" + folder + "' && MESA_SHADER_CACHE_DIR=${MESA_SHADER_CACHE_DIR:-" + folder +
            "/mesa} XDG_CACHE_HOME=${XDG_CACHE_HOME:-" + folder + "/cache} " +
            (goesOn ? "timeout --foreground --signal=INT --preserve-status 12 " : "") +
            (arguments.empty() ? line : "'" NEPHRITE_PROGRAM "' " + arguments);
        const int status = std::system(("{ " + command + "; } > '" + log.string() + "' 2>&1").c_str());
        std::ostringstream text;
        text << std::ifstream(log).rdbuf();
        printed = text.str();
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    /// The files out/... a call names, those with a frame number left out.
    static std::vector<std::string> outputs(const std::string& arguments) {
        std::vector<std::string> names;
        for (std::size_t start = arguments.find("out/"); start != std::string::npos;
             start = arguments.find("out/", start + 1)) {
            const std::string name = arguments.substr(start, arguments.find_first_of(" '", start) - start);
            if (name.find('%') == std::string::npos) names.push_back(name);
        }
        return names;
    }

    fs::path folder_;
};

TEST_P(Pages, CommandsWorkAsPrinted) {
    for (const Block& block : blocksOf(fs::path(NEPHRITE_SOURCE_DIR) / GetParam())) {
        if (!block.file.empty()) writeFile(block);
        if (block.language != "sh") continue;
        for (const std::string& line : shellLines(block)) {
            if (isRunElsewhere(line)) continue;
            std::string printed;
            EXPECT_EQ(run(line, printed), 0) << line << '\n' << printed;
            for (const std::string& name : outputs(line)) {
                std::error_code missing;
                EXPECT_GT(fs::file_size(folder_ / name, missing), 0U) << name;
                EXPECT_FALSE(missing) << name << ": " << missing.message();
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Docs, Pages, testing::ValuesIn(pagesWithCommands()), [](const auto& page) {
    std::string name = page.param;
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
});

TEST(Docs, TheQuickStartHasCommands) {
    const auto pages = pagesWithCommands();
    EXPECT_NE(std::find(pages.begin(), pages.end(), "docs/quick-start.md"), pages.end());
    EXPECT_NE(std::find(pages.begin(), pages.end(), "README.md"), pages.end());
}

}  // namespace
}  // namespace nephrite
