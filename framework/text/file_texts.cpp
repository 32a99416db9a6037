// Reading files whole, once.
#include "text/file_texts.h"

#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

namespace nephrite {
namespace {

constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";  // some editors begin a text with it

std::optional<std::string> readWhole(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) return std::nullopt;
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return std::nullopt;
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (stream.bad()) return std::nullopt;
    if (text.starts_with(byteOrderMark)) text.erase(0, byteOrderMark.size());
    return text;
}

}  // namespace

const std::string* FileTexts::read(const std::filesystem::path& file) {
    const auto [entry, isNew] = texts_.try_emplace(file.lexically_normal());
    if (isNew) entry->second = readWhole(entry->first);
    return entry->second ? &*entry->second : nullptr;
}

std::vector<std::filesystem::path> FileTexts::refresh() {
    std::vector<std::filesystem::path> changed;
    for (auto& [file, text] : texts_) {
        std::optional<std::string> now = readWhole(file);
        if (now == text) continue;
        text = std::move(now);
        changed.push_back(file);
    }
    return changed;
}

std::vector<std::filesystem::path> FileTexts::files() const {
    std::vector<std::filesystem::path> files;
    for (const auto& [file, text] : texts_) files.push_back(file);
    return files;
}

}  // namespace nephrite
