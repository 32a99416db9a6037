// See random_edits.h.
#include "random_edits.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace nephrite::runtime::test {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

std::string readFile(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Every file of the project that the picture depends on, less the scene's: those of the copy.
std::vector<fs::path> editable(const Session& session, const fs::path& folder) {
    std::vector<fs::path> files;
    for (const fs::path& file : session.files()) {
        const bool isSource = file.extension() == ".glsl" || file.extension() == ".json";
        const bool isScene = file.string().find("/scenes/") != std::string::npos ||
                             file.string().find("/materials/") != std::string::npos;
        if (isSource && !isScene && fs::exists(file) && file.string().starts_with(folder.string()))
            files.push_back(file);
    }
    return files;
}

}  // namespace

RandomEdits::RandomEdits(std::uint64_t seed, graph::Extent size, Validation validation) : random_(seed) {
    for (const char* name : {"passes", "shaders", "graphs"})
        fs::copy(fs::path(NEPHRITE_SOURCE_DIR) / name, folder_.path() / name, fs::copy_options::recursive);
    setenv("NEPHRITE_DATA", folder_.path().c_str(), 1);
    SessionOptions options;
    options.graph = folder_.path() / "graphs/paper.json";
    options.size = size;
    options.validation = validation;
    options.reuse = true;
    session_ = std::make_unique<Session>(options);
    live_ = std::make_unique<LiveReload>(*session_);
    session_->renderFrame(0);
    firstPicture_ = session_->read("color").pixels;
    for (const fs::path& path : editable(*session_, folder_.path())) {
        const std::string name = fs::relative(path, folder_.path()).string();
        const Kind kind = path.extension() == ".glsl"   ? Kind::Shader
                          : name.starts_with("passes/") ? Kind::Manifest
                                                        : Kind::Graph;
        files_[name] = {kind, readFile(path)};
        texts_[name] = files_[name].original;
    }
}

RandomEdits::~RandomEdits() {
    live_.reset();
    session_.reset();
    unsetenv("NEPHRITE_DATA");
}

void RandomEdits::edit() {
    ++edits_;
    const bool repairs = !wrong_.empty() && below(2) == 0;
    auto file = files_.begin();
    std::advance(file, below(files_.size()));
    if (repairs) file = files_.find(*wrong_.begin());
    const bool breaks = !repairs && below(2) == 0;
    const std::string& name = file->first;
    story_ = fmt::format("{}{} {} {}\n", story_.size() > 2000 ? "" : story_, edits_,
                         breaks ? "breaks" : "edits", name);
    ++counts_[breaks ? "wrong" : "right"];
    ++counts_[file->second.kind == Kind::Shader     ? "shaders"
              : file->second.kind == Kind::Manifest ? "manifests"
                                                    : "graphs"];
    if (breaks)
        wrong_.insert(name);
    else
        wrong_.erase(name);
    save(name, breaks ? wrongText(file->second) : rightText(file->second));
    settle();
    checkPicture();
}

/// What means the same as the original but is another text.
std::string RandomEdits::rightText(const File& file) {
    if (file.kind == Kind::Shader && below(2) == 0)
        return file.original + fmt::format("\nfloat edit{0}() {{ return {0}.0; }}\n", edits_);
    return fmt::format("// edit {}\n", edits_) + file.original;
}

std::string RandomEdits::wrongText(const File& file) {
    const std::string& text = file.original;
    switch (below(4)) {
        case 0:
            return text + fmt::format("\nnothing {}", edits_);
        case 1:
            return text.substr(0, text.size() / 2 + below(text.size() / 4)) + "\x01\xff{";
        case 2:
            return std::string(64, '\0');
        default:
            return file.kind == Kind::Shader ? "#include \"nowhere.glsl\"\n" + text + "}" : "[" + text;
    }
}

void RandomEdits::save(const std::string& name, const std::string& text) {
    const fs::path file = folder_.path() / name;
    texts_[name] = text;
    switch (below(4)) {
        case 0:
            folder_.write(name, text);
            break;
        case 1:
            fs::rename(folder_.write(name + ".new", text), file);
            break;
        case 2:
            fs::rename(file, file.string() + "~");
            folder_.write(name, text);
            break;
        default:
            for (const std::size_t share : {4U, 2U, 1U})
                folder_.write(name, text.substr(0, text.size() / share));
            break;
    }
}

/// Renders until the session shows what the files say, or says what is wrong with them.
void RandomEdits::settle() {
    for (int tries = 0; tries < 400; ++tries) {
        session_->renderFrame(0);
        const bool heard = live_->wait(30ms) && live_->poll().has_value();
        // The last word is about the last save: nothing more may be under way.
        if (heard && live_->faults().empty() == wrong_.empty() && !live_->wait(25ms)) break;
    }
    session_->renderFrame(0);
    EXPECT_EQ(live_->faults().empty(), wrong_.empty())
        << "edit " << edits_ << "\n"
        << story_ << (live_->faults().empty() ? "" : toLine(live_->faults().front()));
}

/// No edit means anything else than the original: broken or not, the picture stays.
void RandomEdits::checkPicture() {
    EXPECT_EQ(session_->read("color").pixels, firstPicture_) << "edit " << edits_ << "\n" << story_;
}

void RandomEdits::restore() {
    for (const auto& [name, file] : files_) {
        if (texts_[name] == file.original) continue;
        folder_.write(name, file.original);
        texts_[name] = file.original;
    }
    wrong_.clear();
    for (int tries = 0; tries < 40; ++tries)
        if (live_->wait(50ms)) live_->poll();
    session_->renderFrame(0);
    EXPECT_TRUE(live_->faults().empty());
    checkPicture();
}

}  // namespace nephrite::runtime::test
