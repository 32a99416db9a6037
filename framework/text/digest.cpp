// Digests as text.
#include "text/digest.h"

#include <fmt/format.h>

namespace nephrite {

std::string Digest::text() const {
    return fmt::format("{:016x}", hash_);
}

}  // namespace nephrite
