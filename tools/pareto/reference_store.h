// The references of a suite's scenes: rendered once, kept in a folder, used again while they are what is
// asked for.
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "image/image.h"
#include "pareto/progress.h"
#include "pareto/results.h"
#include "pareto/suite.h"
#include "scene/scene.h"

namespace nephrite::pareto {

/// Two independent halves of a reference.
struct Reference {
    ReferenceResult result;
    std::array<image::Image, 2> halves;
};

class ReferenceStore {
  public:
    struct Settings {
        std::filesystem::path folder;  ///< made if it is missing
        std::uint32_t width = 512;
        std::uint32_t height = 512;
        std::string commit;  ///< of the program
        unsigned threads = 1;
    };
    explicit ReferenceStore(Settings settings) : settings_(std::move(settings)) {}

    /// The halves FOLDER/SCENE-MODE-SEED.exr. One that is there counts if it is whole and its record says the
    /// same mode, revision of the estimator, samples, seed, size and files of the scene (whichever commit
    /// rendered it); else it is rendered, which
    /// continues what was interrupted. Throws as truth::renderReference does.
    Reference get(const SuiteScene& suiteScene, const scene::Scene& scene, const ReferenceSettings& reference,
                  const Progress& progress) const;

  private:
    image::ExrFile half(const truth::ReferenceRequest& request, const scene::Scene& scene,
                        const std::filesystem::path& file, const Progress& progress) const;

    Settings settings_;
};

}  // namespace nephrite::pareto
