// A control for one parameter, made from what its manifest says.
#pragma once

#include "graph/controls.h"

namespace nephrite::view {

class Viewer;

/// A row of a table that beginParameters() has begun: name, control, reset. What is changed goes to the
/// workbench.
void drawParameter(Viewer& viewer, const graph::Control& control);

/// False if there is nothing to see of the table; then it must not be ended.
bool beginParameters(const char* name);
void endParameters();

}  // namespace nephrite::view
