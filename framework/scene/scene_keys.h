// The keys of scene files: what the readers accept and what the schema is made of.
#pragma once

#include <span>

#include "text/json.h"

namespace nephrite::scene::keys {

std::span<const json::Key> scene();
std::span<const json::Key> camera();
std::span<const json::Key> light();
std::span<const json::Key> environment();

std::span<const json::Key> material();  ///< in a scene
std::span<const json::Key> preset();    ///< the same but for "preset"
std::span<const json::Key> layer();
std::span<const json::Key> texture();

std::span<const json::Key> object();
std::span<const json::Key> model();
std::span<const json::Key> transform();
std::span<const json::Key> clip();
std::span<const json::Key> rotation();
std::span<const json::Key> path();

}  // namespace nephrite::scene::keys
