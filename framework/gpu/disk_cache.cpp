// Files of the disk cache: a header with lengths and a checksum, the whole key, the value.
#include "gpu/disk_cache.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <system_error>
#include <thread>

namespace nephrite::gpu {
namespace {

struct Header {
    std::array<char, 8> magic{'n', 'e', 'p', 'h', 'r', 'c', '0', '1'};
    std::uint64_t keyBytes = 0;
    std::uint64_t valueBytes = 0;
    std::uint64_t checksum = 0;  ///< of key and value
};

/// FNV-1a, 64 bits (Fowler, Noll, Vo).
std::uint64_t hash(std::span<const std::byte> bytes, std::uint64_t state = 0xcbf29ce484222325u) {
    for (const std::byte byte : bytes) {
        state ^= static_cast<std::uint64_t>(byte);
        state *= 0x100000001b3u;
    }
    return state;
}

std::span<const std::byte> bytesOf(std::string_view text) {
    return std::as_bytes(std::span(text));
}

std::uint64_t checksumOf(std::string_view key, std::span<const std::byte> value) {
    return hash(value, hash(bytesOf(key)));
}

/// The environment variable as a path; nothing if it is unset or empty.
std::optional<std::filesystem::path> folderFrom(const char* variable) {
    const char* value = std::getenv(variable);
    if (value == nullptr || *value == '\0') return std::nullopt;
    return std::filesystem::path(value);
}

bool writeFile(const std::filesystem::path& path, std::string_view key, std::span<const std::byte> value) {
    Header header;
    header.keyBytes = key.size();
    header.valueBytes = value.size();
    header.checksum = checksumOf(key, value);
    std::ofstream stream(path, std::ios::binary | std::ios::trunc);
    stream.write(reinterpret_cast<const char*>(&header), sizeof(header));
    stream.write(key.data(), static_cast<std::streamsize>(key.size()));
    stream.write(reinterpret_cast<const char*>(value.data()), static_cast<std::streamsize>(value.size()));
    stream.close();
    return stream.good();
}

/// A name that no other process and no other thread of this one uses at the same time.
std::filesystem::path temporaryBeside(const std::filesystem::path& file) {
    std::filesystem::path temporary = file;
    temporary +=
        fmt::format(".{}-{:x}.tmp", ::getpid(), std::hash<std::thread::id>{}(std::this_thread::get_id()));
    return temporary;
}

}  // namespace

std::optional<std::filesystem::path> defaultCacheFolder() {
    if (auto folder = folderFrom("NEPHRITE_CACHE_DIR")) return folder;
    // The XDG base directory specification says to ignore a relative path.
    if (auto folder = folderFrom("XDG_CACHE_HOME"); folder && folder->is_absolute())
        return *folder / "nephrite";
    if (auto folder = folderFrom("HOME")) return *folder / ".cache" / "nephrite";
    return std::nullopt;
}

DiskCache DiskCache::standard() {
    const auto folder = defaultCacheFolder();
    return folder ? DiskCache(*folder) : DiskCache();
}

std::filesystem::path DiskCache::fileOf(std::string_view kind, std::string_view key) const {
    return folder_ / fmt::format("{}-{:016x}", kind, hash(bytesOf(key)));
}

std::optional<std::vector<std::byte>> DiskCache::read(std::string_view kind, std::string_view key) const {
    if (folder_.empty()) return std::nullopt;
    const std::filesystem::path file = fileOf(kind, key);
    std::error_code error;
    const std::uintmax_t fileBytes = std::filesystem::file_size(file, error);
    if (error || fileBytes < sizeof(Header) + key.size()) return std::nullopt;
    std::ifstream stream(file, std::ios::binary);
    Header header;
    const auto magic = header.magic;
    stream.read(reinterpret_cast<char*>(&header), sizeof(header));
    if (!stream || header.magic != magic || header.keyBytes != key.size() ||
        header.valueBytes != fileBytes - sizeof(Header) - key.size())
        return std::nullopt;
    std::string storedKey(key.size(), '\0');
    stream.read(storedKey.data(), static_cast<std::streamsize>(storedKey.size()));
    std::vector<std::byte> value(header.valueBytes);
    stream.read(reinterpret_cast<char*>(value.data()), static_cast<std::streamsize>(value.size()));
    if (!stream || storedKey != key || checksumOf(key, value) != header.checksum) return std::nullopt;
    return value;
}

bool DiskCache::write(std::string_view kind, std::string_view key, std::span<const std::byte> value) const {
    if (folder_.empty()) return false;
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error) return false;
    const std::filesystem::path file = fileOf(kind, key);
    const std::filesystem::path temporary = temporaryBeside(file);
    const bool written = writeFile(temporary, key, value);
    if (written) std::filesystem::rename(temporary, file, error);
    if (written && !error) return true;
    std::filesystem::remove(temporary, error);
    return false;
}

}  // namespace nephrite::gpu
