// What tests of scene files share: a folder of their own, a way to read a scene from text, and its faults.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/scene_description.h"
#include "text/faults.h"

namespace nephrite::scene::test {

inline const std::filesystem::path dataFolder = std::filesystem::path(NEPHRITE_SOURCE_DIR) / "graphs";
inline const std::filesystem::path presetFolder = dataFolder / "materials";

/// A camera any scene can have.
inline const std::string anyCamera = R"("camera": {"position": [0, 0, 40], "near": 1, "far": 100})";

/// A test with a new empty folder, removed with everything in it.
class InFolder : public testing::Test {
  protected:
    InFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "nephrite-scene-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for the test");
        folder_ = name;
    }
    ~InFolder() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path in(const std::string& name) const { return folder_ / name; }
    std::filesystem::path put(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories(in(name).parent_path());
        std::ofstream(in(name), std::ios::binary) << text;
        return in(name);
    }

  private:
    std::filesystem::path folder_;
};

/// The scene a text says; `faults` gets what is wrong with it.
inline SceneDescription readText(const std::string& text, Diagnostics& faults) {
    return readScene(json::parse(text, "scene.json"), {presetFolder, 0}, faults);
}

/// The scene of a text without faults.
inline SceneDescription readGood(const std::string& text) {
    Diagnostics faults;
    SceneDescription scene = readText(text, faults);
    for (const Diagnostic& fault : faults.errors()) ADD_FAILURE() << toLine(fault);
    return scene;
}

inline std::vector<std::string> errorLines(const Diagnostics& diagnostics) {
    std::vector<std::string> lines;
    for (const Diagnostic& fault : diagnostics.errors()) lines.push_back(toLine(fault));
    return lines;
}

inline std::vector<std::string> warningLines(const Diagnostics& diagnostics) {
    std::vector<std::string> lines;
    for (const Diagnostic& warning : diagnostics.warnings()) lines.push_back(toLine(warning, "warning"));
    return lines;
}

}  // namespace nephrite::scene::test
