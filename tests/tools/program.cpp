// Running the program.
#include "program.h"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace nephrite::tools::test {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

}  // namespace

Workplace::Workplace() {
    std::string name = (fs::temp_directory_path() / "nephrite-program-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
    path_ = name;
}

Workplace::~Workplace() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

fs::path Workplace::write(const std::string& name, const std::string& text) const {
    const fs::path file = path_ / name;
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
}

Answer Workplace::run(const std::string& arguments) const {
    const fs::path out = path_ / ".out";
    const fs::path err = path_ / ".err";
    const std::string command = "cd '" + path_.string() + "' && NEPHRITE_CACHE_DIR='" + path_.string() +
                                "/.cache' '" + NEPHRITE_PROGRAM "' " + arguments + " > '" + out.string() +
                                "' 2> '" + err.string() + "'";
    const int result = std::system(command.c_str());
    Answer answer;
    answer.status = WIFEXITED(result) ? WEXITSTATUS(result) : 128 + WTERMSIG(result);
    answer.output = contents(out);
    answer.errors = contents(err);
    return answer;
}

std::string graphFile(const std::string& name) {
    return std::string("'" NEPHRITE_SOURCE_DIR "/graphs/") + name + "'";
}
std::string sceneFile(const std::string& name) {
    return std::string("'" NEPHRITE_SOURCE_DIR "/graphs/scenes/") + name + "'";
}

}  // namespace nephrite::tools::test
