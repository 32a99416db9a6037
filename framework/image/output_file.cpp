// Temporary file beside the target, then rename: the only writing of files in the project.
#include "image/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <system_error>
#include <utility>

#include "text/diagnostics.h"

namespace nephrite::image {
namespace {

/// The file a chain of symbolic links ends at, whether it exists or not; the path itself if it is no link.
std::filesystem::path followLinks(std::filesystem::path path) {
    constexpr int mostLinks = 40;  // what Linux follows before it says ELOOP
    for (int i = 0; i < mostLinks; ++i) {
        std::error_code error;
        const std::filesystem::path link = std::filesystem::read_symlink(path, error);
        if (error) return path;
        path = path.parent_path() / link;
    }
    return path;
}

/// Numbers the temporary files of this process, so that two threads never ask for the same name.
unsigned nextSerial() {
    static std::atomic<unsigned> serial{0};
    return serial++;
}

std::filesystem::path temporaryName(const std::filesystem::path& target) {
    return target.parent_path() / fmt::format(".nephrite-{}-{}.tmp", ::getpid(), nextSerial());
}

bool writtenInPlace(const std::filesystem::path& target) {
    struct stat status {};
    return ::stat(target.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
}

/// A file that exists keeps its permissions; a new one gets the usual ones.
void keepPermissions(const std::filesystem::path& target, int descriptor) {
    struct stat status {};
    if (::stat(target.c_str(), &status) == 0) ::fchmod(descriptor, status.st_mode & 07777);
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path target)
    : target_(std::move(target)), resolved_(followLinks(target_)) {
    if (writtenInPlace(resolved_)) {
        descriptor_ = ::open(resolved_.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor_ < 0) fail(errno);
        return;
    }
    if (!resolved_.has_filename()) fail(EISDIR);
    // A rename would replace a file that is protected from writing.
    if (::access(resolved_.c_str(), W_OK) != 0 && errno != ENOENT) fail(errno);
    do {
        temporary_ = temporaryName(resolved_);
        descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor_ < 0 && errno == EEXIST);
    if (descriptor_ < 0) fail(errno);
    keepPermissions(resolved_, descriptor_);
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : target_(std::move(other.target_)),
      resolved_(std::move(other.resolved_)),
      temporary_(std::exchange(other.temporary_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void OutputFile::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(errno);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

void OutputFile::write(std::string_view text) {
    write(std::as_bytes(std::span(text)));
}

void OutputFile::commit() {
    // Some file systems (NFS, quotas) report a full disk only here.
    if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);
    if (temporary_.empty()) return;
    if (::rename(temporary_.c_str(), resolved_.c_str()) != 0) fail(errno);
    temporary_.clear();
}

void OutputFile::fail(int errorNumber) const {
    const std::string reason = std::generic_category().message(errorNumber);
    throw RunError(toLine({{target_.string()}, fmt::format("cannot be written: {}", reason)}));
}

void writeFile(const std::filesystem::path& target, std::span<const std::byte> bytes) {
    OutputFile file(target);
    file.write(bytes);
    file.commit();
}

void writeFile(const std::filesystem::path& target, std::string_view text) {
    writeFile(target, std::as_bytes(std::span(text)));
}

}  // namespace nephrite::image
