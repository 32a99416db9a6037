// The pass types of a run: manifests in folders, read when they are first asked for.
#include <algorithm>

#include "graph/pass_type.h"

namespace nephrite::graph {

PassLibrary::PassLibrary(const std::vector<std::filesystem::path>& folders,
                         std::filesystem::path shaderFolder)
    : shaderFolder_(std::move(shaderFolder)) {
    for (const std::filesystem::path& folder : folders) {
        std::error_code error;
        auto files = std::filesystem::directory_iterator(folder, error);
        if (error)
            throw InputError(SourceLocation{folder.string(), 0, 0},
                             "this folder of passes cannot be read: " + error.message());
        for (const std::filesystem::directory_entry& file : files) {
            const std::filesystem::path& path = file.path();
            if (path.extension() == ".json") entries_[path.stem().string()] = Entry{path, nullptr};
        }
    }
}

void PassLibrary::add(PassType type) {
    std::string name = type.name;
    std::filesystem::path manifest = type.manifest;
    entries_[std::move(name)] = Entry{std::move(manifest), std::make_unique<const PassType>(std::move(type))};
}

const PassType* PassLibrary::find(std::string_view name) const {
    const auto found = entries_.find(name);
    if (found == entries_.end()) return nullptr;
    const Entry& entry = found->second;
    if (!entry.type)
        entry.type = std::make_unique<const PassType>(readPassType(entry.manifest, shaderFolder_));
    return entry.type.get();
}

std::vector<std::string> PassLibrary::names() const {
    std::vector<std::string> result;
    result.reserve(entries_.size());
    for (const auto& [name, entry] : entries_) result.push_back(name);
    return result;
}

}  // namespace nephrite::graph
