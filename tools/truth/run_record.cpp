// Digests, parts, and putting parts together.
#include "truth/run_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>

#include "text/diagnostics.h"
#include "text/digest.h"

namespace nephrite::truth {
namespace {

std::optional<std::uint32_t> number(std::string_view text) {
    constexpr std::uint32_t most = 1000000;
    std::uint32_t value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc{} || end != text.data() + text.size() || value == 0 || value > most)
        return std::nullopt;
    return value;
}

/// A picture of a part, as read.
struct PartPicture {
    std::filesystem::path path;
    image::ExrFile file;
    Part part;
};

PartPicture readPart(const std::filesystem::path& path) {
    PartPicture picture{path, image::readExr(path), {}};
    const auto attribute = picture.file.metadata.find("part");
    const auto part = attribute == picture.file.metadata.end() ? std::nullopt : parsePart(attribute->second);
    if (!part) throw InputError({path.string()}, "this picture is not a part of a split run");
    picture.part = *part;
    return picture;
}

/// Throws unless `other` is of the same run as `first`.
void requireSameRun(const PartPicture& first, const PartPicture& other) {
    const auto differs = [&](const std::string& what, const std::string& expected, const std::string& found) {
        throw InputError({other.path.string()},
                         fmt::format("expected {} {} as in {}, found {}", what, inQuotes(expected),
                                     first.path.string(), inQuotes(found)));
    };
    const auto size = [](const image::Image& image) {
        return fmt::format("{}x{}", image.width, image.height);
    };
    if (size(first.file.image) != size(other.file.image))
        differs("size", size(first.file.image), size(other.file.image));
    if (first.part.count != other.part.count)
        differs("part", fmt::format("I/{}", first.part.count), toText(other.part));
    for (const auto& [name, value] : first.file.metadata) {
        const auto found = other.file.metadata.find(name);
        const std::string text = found == other.file.metadata.end() ? "" : found->second;
        if (name != "part" && name != "scene" && text != value) differs(name, value, text);
    }
    if (first.file.image.channels != other.file.image.channels)
        throw InputError({other.path.string()},
                         fmt::format("its channels are not those of {}", first.path.string()));
}

void copyTiles(const PartPicture& from, image::Image& to) {
    const std::size_t channels = to.channels.size();
    for (const Tile& tile : tilesOf(to.width, to.height, from.part))
        for (std::uint32_t y = tile.y0; y < tile.y1; ++y) {
            const std::size_t begin = (std::size_t{y} * to.width + tile.x0) * channels;
            const auto source = from.file.image.pixels.begin() + static_cast<std::ptrdiff_t>(begin);
            std::copy_n(source, (tile.x1 - tile.x0) * channels,
                        to.pixels.begin() + static_cast<std::ptrdiff_t>(begin));
        }
}

}  // namespace

std::string digestOf(const std::vector<std::filesystem::path>& files) {
    Digest digest;
    for (const std::filesystem::path& file : files) {
        std::ifstream stream(file, std::ios::binary);
        if (!stream) throw InputError({file.string()}, "cannot be read");
        for (std::string block(std::size_t{1} << 16, '\0'); stream;) {
            stream.read(block.data(), static_cast<std::streamsize>(block.size()));
            digest.add(std::string_view(block).substr(0, static_cast<std::size_t>(stream.gcount())));
        }
        digest.add(std::string_view("", 1));  // so that bytes cannot move from one file to the next
    }
    return digest.text();
}

std::optional<Part> parsePart(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    const auto index = number(text.substr(0, slash));
    const auto count = number(text.substr(slash + 1));
    if (!index || !count || *index > *count) return std::nullopt;
    return Part{*index, *count};
}

std::string toText(const Part& part) {
    return fmt::format("{}/{}", part.index, part.count);
}

std::string toText(const image::Metadata& record) {
    std::string text = "nephrite reference, unfinished\n";
    for (const auto& [name, value] : record) text += fmt::format("{} {}\n", name, value);
    return text + "\n";
}

bool isOf(const image::Metadata& record, std::string_view content, const image::ExrFile& picture,
          std::span<const std::string_view> ignored) {
    const auto has = [&](const std::string& name, std::string_view value) {
        const auto attribute = picture.metadata.find(name);
        return attribute != picture.metadata.end() && attribute->second == value;
    };
    const bool isPart = picture.metadata.contains("part");
    if (isPart != record.contains("part") || !has("content", content)) return false;
    return std::all_of(record.begin(), record.end(), [&](const auto& entry) {
        const auto& [name, value] = entry;
        return std::find(ignored.begin(), ignored.end(), name) != ignored.end() || has(name, value);
    });
}

image::ExrFile merge(const std::vector<std::filesystem::path>& files) {
    const PartPicture first = readPart(files.front());
    image::ExrFile whole = first.file;
    std::vector<std::filesystem::path> owners(first.part.count);
    for (const std::filesystem::path& path : files) {
        const PartPicture picture = readPart(path);
        requireSameRun(first, picture);
        std::filesystem::path& owner = owners[picture.part.index - 1];
        if (!owner.empty())
            throw InputError({path.string()},
                             fmt::format("part {} is also in {}", toText(picture.part), owner.string()));
        owner = path;
        copyTiles(picture, whole.image);
    }
    for (std::uint32_t i = 0; i < owners.size(); ++i)
        if (owners[i].empty())
            throw InputError({files.front().string()}, fmt::format("part {} of its run was not given",
                                                                   toText(Part{i + 1, first.part.count})));
    whole.metadata.erase("part");
    return whole;
}

}  // namespace nephrite::truth
