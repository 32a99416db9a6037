// Where the project's data lives: passes/, shaders/, graphs/.
#pragma once

#include <filesystem>

namespace nephrite::runtime {

struct DataFolders {
    std::filesystem::path passes;
    std::filesystem::path shaders;
    std::filesystem::path materials;
    std::filesystem::path defaultScene;

    /// Looks in $NEPHRITE_DATA, then upwards from the running program, then in the source tree it was built
    /// from. Throws RunError if none of them holds passes/ and shaders/.
    static DataFolders find();
};

}  // namespace nephrite::runtime
