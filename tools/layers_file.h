// Files that describe a stack of layers for `nephrite profile`.
#pragma once

#include <filesystem>

#include "scattering/layer_stack.h"

namespace nephrite::tools {

/// Reads {"layers": [{"thickness", "absorption", "scattering"}, ...], "g", "eta"}: numbers in mm and 1/mm,
/// thickness absent or null for infinite, g 0 and eta 1 by default. Throws InputError with every fault.
scattering::LayerStack readLayersFile(const std::filesystem::path& file);

}  // namespace nephrite::tools
