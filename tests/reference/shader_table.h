// Functions of shaders/ evaluated on the device over a table of arguments, so that a test can hold the very
// functions that the passes include against double precision or against a density.
#pragma once

#include <glm/vec4.hpp>
#include <string>
#include <vector>

namespace nephrite::reference {

/// One argument: a value for each row of the table.
struct Column {
    std::string name;
    std::vector<glm::vec4> rows;
};

/// Runs `glsl`, which defines `vec4 row(ivec2 p)` and finds each argument by `load(NAME, p)`, in a pixel pass
/// of its own; a result for each row. All columns have as many rows as the first. `#include` finds the files
/// of shaders/.
std::vector<glm::vec4> evaluateRows(const std::string& glsl, const std::vector<Column>& columns);

}  // namespace nephrite::reference
