// Finding #include lines and the files they name.
#include "gpu/shader/source_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace nephrite::gpu {
namespace {

std::string withLineBreak(std::string text) {
    if (text.empty() || text.back() != '\n') text += '\n';
    return text;
}

void skipBlanks(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r"), text.size()));
}

bool take(std::string_view& text, std::string_view word) {
    if (!text.starts_with(word)) return false;
    text.remove_prefix(word.size());
    return true;
}

/// The name in `#include "name"` or `#include <name>`, if the line is one; a part of `line`.
std::optional<std::string_view> includedName(std::string_view line) {
    skipBlanks(line);
    if (!take(line, "#")) return std::nullopt;
    skipBlanks(line);
    if (!take(line, "include")) return std::nullopt;
    skipBlanks(line);
    if (line.empty() || (line.front() != '"' && line.front() != '<')) return std::nullopt;
    const std::size_t end = line.find(line.front() == '"' ? '"' : '>', 1);
    if (end == std::string_view::npos) return std::nullopt;
    return line.substr(1, end - 1);
}

}  // namespace

SourceFiles::SourceFiles(const ShaderSource& source, FileTexts& files) : chunkCount_(source.chunks.size()) {
    for (const SourceChunk& chunk : source.chunks)
        texts_.push_back({chunk.name, chunk.path, withLineBreak(chunk.text), {}});
    for (std::size_t from = 0; from < texts_.size(); ++from) resolve(from, source, files);
}

void SourceFiles::resolve(std::size_t from, const ShaderSource& shader, FileTexts& files) {
    const SourceText source = texts_[from];  // a copy: opening files moves the texts
    std::string_view rest = source.text;
    std::string resolved;
    while (!rest.empty()) {
        const std::string_view line = rest.substr(0, rest.find('\n') + 1);
        const auto name = includedName(line);
        const auto to = name ? find(source, std::string(*name), shader.includeFolders, files) : std::nullopt;
        if (to)
            resolved += fmt::format("#include \"<{}>\"\n", *to);
        else
            resolved += line;
        rest.remove_prefix(line.size());
    }
    const bool isIncluded = from >= chunkCount_;
    texts_[from].resolved =
        isIncluded && shader.rewriteInclude ? shader.rewriteInclude(resolved) : std::move(resolved);
}

std::optional<std::size_t> SourceFiles::find(const SourceText& from, const std::string& requested,
                                             const std::vector<std::filesystem::path>& includeFolders,
                                             FileTexts& files) {
    if (!from.path.empty()) {
        if (auto beside = open(from.path.parent_path() / requested, files)) return beside;
    }
    for (const std::filesystem::path& folder : includeFolders)
        if (auto found = open(folder / requested, files)) return found;
    return std::nullopt;
}

std::optional<std::size_t> SourceFiles::open(const std::filesystem::path& path, FileTexts& files) {
    const std::filesystem::path normal = path.lexically_normal();
    for (std::size_t known = chunkCount_; known < texts_.size(); ++known)
        if (texts_[known].path == normal) return known;
    if (std::find(lookedFor_.begin(), lookedFor_.end(), normal) == lookedFor_.end())
        lookedFor_.push_back(normal);
    const std::string* text = files.read(normal);
    if (text == nullptr) return std::nullopt;
    texts_.push_back({normal.string(), normal, withLineBreak(*text), {}});
    return texts_.size() - 1;
}

std::vector<std::filesystem::path> SourceFiles::includedPaths() const {
    std::vector<std::filesystem::path> paths;
    for (std::size_t index = chunkCount_; index < texts_.size(); ++index) paths.push_back(texts_[index].path);
    return paths;
}

std::string SourceFiles::content() const {
    std::string content = fmt::format("{} pieces\n", chunkCount_);
    for (const SourceText& text : texts_)
        content += fmt::format("text of {} bytes\n{}", text.resolved.size(), text.resolved);
    return content;
}

std::optional<std::size_t> resolvedIndex(std::string_view name) {
    if (!take(name, "<")) return std::nullopt;
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
    if (error != std::errc() || end == name.data() + name.size() || *end != '>') return std::nullopt;
    return index;
}

}  // namespace nephrite::gpu
