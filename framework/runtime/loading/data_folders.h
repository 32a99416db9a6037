// Where the project's data lives: passes/, shaders/, graphs/; and the published meshes, which are not part of
// it.
#pragma once

#include <filesystem>

namespace nephrite::runtime {

struct DataFolders {
    std::filesystem::path passes;
    std::filesystem::path shaders;
    std::filesystem::path materials;
    std::filesystem::path defaultScene;
    std::filesystem::path models;  ///< meshes that are not part of the project; empty: not at hand

    /// Looks in $NEPHRITE_DATA, then upwards from the running program, then in the source tree it was built
    /// from. Throws RunError if none of them holds passes/ and shaders/. Models are in $NEPHRITE_MODELS, else
    /// in
    /// ../shared/models beside the data.
    static DataFolders find();
};

}  // namespace nephrite::runtime
