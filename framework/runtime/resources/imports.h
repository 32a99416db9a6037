// The images a graph imports from files.
#pragma once

#include <vector>

#include "gpu/image.h"
#include "graph/compile.h"
#include "image/image.h"

namespace nephrite::runtime {

/// Reads every import's file: channels R, G, B, A; one of Y or a single channel is R. As description.imports.
/// Throws InputError if a file is missing, broken, or an import names none.
std::vector<image::Image> readImports(const graph::GraphDescription& description);

/// Uploads one, in the import's format and in the layout that importedImages() says. Throws RunError.
gpu::Image uploadImport(const gpu::Device& device, const graph::GraphImport& import,
                        const image::Image& image, graph::InputReads reads);

/// The same images as the compiler sees them: each frame finds and leaves them as shaders read them.
std::vector<graph::ImportedImage> importedImages(const graph::GraphDescription& description,
                                                 const std::vector<image::Image>& images,
                                                 graph::InputReads reads);
/// The same, reading the files.
std::vector<graph::ImportedImage> importedImages(const graph::GraphDescription& description,
                                                 graph::InputReads reads = graph::InputReads::StorageImage);

}  // namespace nephrite::runtime
