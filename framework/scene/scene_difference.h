// What differs between two loaded scenes, as shaders would see it.
#pragma once

#include "scene/scene_state.h"
#include "scene/scene_versions.h"

namespace nephrite::scene {

/// True if both have the same objects of the same meshes, which move or not alike: what moves has as many
/// vertices here as there.
bool sameMeshes(const Scene::State& a, const Scene::State& b);

/// `versions` of `before`, counted up for each part in which `now` has other bytes. Where things are at a
/// time is not looked at.
SceneVersions versionsAfter(SceneVersions versions, const Scene::State& before, const Scene::State& now);

}  // namespace nephrite::scene
