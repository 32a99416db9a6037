// A folder of a test's own, and ways to look at what is in it.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace nephrite::image {

class Scratch : public testing::Test {
  protected:
    Scratch() {
        std::string name = (std::filesystem::temp_directory_path() / "nephrite-image-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for the test");
        folder_ = name;
    }
    ~Scratch() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path in(const std::string& name) const { return folder_ / name; }

    std::filesystem::path put(const std::string& name, const std::string& bytes) const {
        std::ofstream(in(name), std::ios::binary) << bytes;
        return in(name);
    }

    static std::string contents(const std::filesystem::path& path) {
        std::ifstream stream(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    /// The names of everything in the folder, sorted.
    std::vector<std::string> listing() const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
            names.push_back(entry.path().filename().string());
        }
        std::sort(names.begin(), names.end());
        return names;
    }

    /// What a function's exception of this type says, or "" if there is none.
    template<typename Exception, typename Function>
    static std::string messageOf(Function function) {
        try {
            function();
        } catch (const Exception& fault) {
            return fault.what();
        }
        return {};
    }

  private:
    std::filesystem::path folder_;
};

}  // namespace nephrite::image
