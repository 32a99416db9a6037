// One reference picture from a scene to its file: rendered with what is done kept beside the output, so that
// an interrupted run continues, and recorded in the file, so that it is known again.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "image/exr.h"
#include "truth/estimator.h"
#include "truth/rendering.h"
#include "truth/tiles.h"

namespace nephrite::truth {

std::string_view name(Mode mode);  ///< "single", "dipole", "volume"
std::optional<Mode> parseMode(std::string_view text);

/// What is rendered.
struct ReferenceRequest {
    std::filesystem::path scene;  ///< as the user named it; the record keeps it for readers
    std::uint32_t width = 512;
    std::uint32_t height = 512;
    double time = 0;            ///< seconds
    std::uint32_t samples = 1;  ///< of each pixel
    EstimatorOptions estimator;
    std::optional<Part> part;  ///< empty: the whole picture
    std::string commit;        ///< of the program
};

/// Where it goes.
struct ReferenceFiles {
    std::filesystem::path picture;
    std::filesystem::path standardErrors;  ///< empty: not written
};

/// What identifies the run, as attributes of its picture: all of the request but the size, and a digest of
/// the scene's files. Throws InputError if one of them cannot be read.
image::Metadata recordOf(const ReferenceRequest& request, const scene::Scene& scene);

/// Renders on `threads` threads and writes the files, each whole or not at all. What is done goes to
/// PICTURE.unfinished every minute and when the watcher says stop; the same request continues from there, to
/// the same bits. Files that are there already and of the same request are left as they are. Throws RunError
/// when stopped or if a file cannot be written, InputError if PICTURE.unfinished is of another request or the
/// scene does not suit the mode.
void renderReference(const ReferenceRequest& request, const scene::Scene& scene, const ReferenceFiles& files,
                     unsigned threads, const Watcher& watcher);

}  // namespace nephrite::truth
