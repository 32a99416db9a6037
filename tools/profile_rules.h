// What the numbers that describe a medium may be, in a file and on the command line alike.
#pragma once

#include "scene/value_rules.h"

namespace nephrite::tools {

inline constexpr scene::NumberRule anisotropyRule{"a number between -1 and 1", -1, 1};
inline constexpr scene::NumberRule indexRule{"a refractive index between 0.01 and 100", 0.01, 100};

}  // namespace nephrite::tools
