// Loads the meshes of a scene's objects, each file and shape once.
#pragma once

#include "scene/scene_state.h"

namespace nephrite::scene {

/// Fills `meshes` and `meshOfObject` and adds the mesh files to `files`. Adds every fault: those of the file
/// as `FILE: error: ...` and with them the scene's line.
void loadMeshes(Scene::State& state, Diagnostics& diagnostics);

}  // namespace nephrite::scene
