// `render --watch` as a user has it running beside an editor.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "image/exr.h"
#include "program.h"

namespace nephrite::tools::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

/// The program running in the background; killed if it still does at the end.
class Running {
  public:
    Running(const std::filesystem::path& folder, std::vector<std::string> arguments) : log_(folder / "log") {
        arguments.insert(arguments.begin(), NEPHRITE_PROGRAM);
        std::vector<char*> pointers;
        for (std::string& argument : arguments) pointers.push_back(argument.data());
        pointers.push_back(nullptr);
        process_ = fork();
        if (process_ != 0) return;
        const int file = open(log_.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
        dup2(file, STDERR_FILENO);
        if (chdir(folder.c_str()) == 0) execv(NEPHRITE_PROGRAM, pointers.data());
        _exit(127);
    }
    ~Running() {
        if (process_ > 0) kill(process_, SIGKILL);
        if (process_ > 0) waitpid(process_, nullptr, 0);
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    int interrupt() {
        kill(process_, SIGINT);
        int status = 0;
        waitpid(process_, &status, 0);
        process_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    std::string log() const {
        std::ostringstream text;
        text << std::ifstream(log_).rdbuf();
        return text.str();
    }

  private:
    std::filesystem::path log_;
    pid_t process_ = -1;
};

class Watch : public testing::Test {
  protected:
    Watch() {
        place_.write(
            "passes/flat.json",
            R"({"kind": "pixel", "shader": "flat.glsl", "outputs": {"color": {"format": "rgba32f"}}})");
        writeShader("1.0");
        place_.write("graph.json",
                     R"({"nodes": {"flat": {"pass": "flat"}}, "outputs": {"color": "flat.color"}})");
    }
    void writeShader(const std::string& value) const {
        place_.write("passes/flat.glsl",
                     "void pixel(ivec2 p) {\n    store(color, p, vec4(" + value + "));\n}\n");
    }
    std::vector<std::string> arguments() const {
        return {"render", "graph.json", "--pass-path", "passes", "--size", "8x8", "-o", "out.exr", "--watch"};
    }
    float value() const {
        const std::filesystem::path file = place_.path() / "out.exr";
        return std::filesystem::exists(file) ? image::readExr(file).image.at(3, 3, 0) : -1.0F;
    }
    template<class Condition>
    static bool comesTrue(Condition condition) {
        for (int i = 0; i < 600 && !condition(); ++i) std::this_thread::sleep_for(20ms);
        return condition();
    }

    Workplace place_;
};

TEST_F(Watch, WritesThePictureAgainWheneverAFileIsSaved) {
    Running program(place_.path(), arguments());
    EXPECT_TRUE(comesTrue([&] { return value() == 1; }));
    writeShader("2.0");
    EXPECT_TRUE(comesTrue([&] { return value() == 2; })) << program.log();
    EXPECT_TRUE(comesTrue([&] { return program.log().find("rendered 1 frame") != std::string::npos; }));
    EXPECT_THAT(program.log(), HasSubstr("reloaded flat.glsl in "));
    writeShader("wrong");
    EXPECT_TRUE(comesTrue([&] { return program.log().find("error") != std::string::npos; }));
    EXPECT_THAT(program.log(), HasSubstr("passes/flat.glsl:2:26: error: 'wrong'"));
    EXPECT_EQ(value(), 2);
    writeShader("3.0");
    EXPECT_TRUE(comesTrue([&] { return value() == 3; })) << program.log();
    EXPECT_EQ(program.interrupt(), 0);
}

TEST_F(Watch, AGraphWithoutThePictureIsNamedAndGoesOn) {
    Running program(place_.path(), arguments());
    EXPECT_TRUE(comesTrue([&] { return value() == 1; }));
    place_.write("graph.json",
                 R"({"nodes": {"flat": {"pass": "flat"}}, "outputs": {"other": "flat.color"}})");
    EXPECT_TRUE(comesTrue([&] { return program.log().find("\"color\"") != std::string::npos; }));
    EXPECT_EQ(program.interrupt(), 0);
}

}  // namespace
}  // namespace nephrite::tools::test
