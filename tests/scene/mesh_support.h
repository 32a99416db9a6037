// What the mesh tests share: catching a reader's fault, and small meshes as bytes.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

#include "scene/mesh/mesh.h"
#include "text/diagnostics.h"

namespace nephrite::scene::test {

/// The first line that `read` faults with, or "" if it does not.
template<typename Read>
std::string faultOf(const Read& read) {
    try {
        read();
    } catch (const InputError& error) {
        return toLine(error.faults().front());
    }
    return "";
}

/// The bytes of a value in the host's or the opposite order.
template<typename T>
std::string bytesOf(T value, bool reversed = false) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
    return reversed ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

inline void expectNear(const glm::dvec3& found, const glm::dvec3& expected, double tolerance) {
    EXPECT_LE(glm::length(found - expected), tolerance)
        << "found (" << found.x << ", " << found.y << ", " << found.z << "), expected (" << expected.x << ", "
        << expected.y << ", " << expected.z << ")";
}

}  // namespace nephrite::scene::test
