// Reads materials: a preset's name, an object, or a preset with overrides.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene_description.h"

namespace nephrite::scene {

/// The presets of a folder, NAME.json each.
class PresetFolder {
  public:
    /// A folder that does not exist has no presets.
    explicit PresetFolder(std::filesystem::path folder);

    const std::vector<std::string>& names() const { return names_; }  ///< sorted
    bool has(std::string_view name) const;
    std::filesystem::path fileOf(std::string_view name) const;

  private:
    std::filesystem::path folder_;
    std::vector<std::string> names_;
};

/// Reads a material's value. Relative texture paths are relative to `folder`, those of a preset to the
/// preset's folder. Adds every fault; an unknown preset with a suggestion. Reads preset files, and adds their
/// faults, too.
MaterialDescription readMaterial(const json::Value& value, std::string name,
                                 const std::filesystem::path& folder, const PresetFolder& presets,
                                 Diagnostics& diagnostics);

/// The preset of that name, which must exist.
MaterialDescription readPreset(const std::string& name, const PresetFolder& presets,
                               Diagnostics& diagnostics);

/// A path as written in a file of `folder`.
std::filesystem::path resolvePath(const std::string& path, const std::filesystem::path& folder);

}  // namespace nephrite::scene
