// Turns glslang's log into faults at the author's files and lines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gpu/shader/source_files.h"
#include "text/diagnostics.h"

namespace nephrite::gpu {

/// glslang was given the index of each text of `files` as its name. Faults without a line are reported for
/// `name`. Returns at least one fault.
std::vector<Diagnostic> faultsOf(std::string_view log, const SourceFiles& files, const std::string& name);

}  // namespace nephrite::gpu
