// Stressed scenes through whole graphs on the device: every image of every node is looked at.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "image/image.h"
#include "stress/outcome.h"
#include "stress/scene_values.h"

namespace nephrite::stress {

/// Where and on what to render.
struct Place {
    std::filesystem::path folder;  ///< for scene files; they are overwritten from case to case
    std::string device;            ///< part of its name; empty: the best there is
    std::vector<std::filesystem::path> passPaths;
};

struct GraphChoice {
    std::filesystem::path file;
    std::vector<std::string> settings;
    bool conserving = true;  ///< of the consistent reading: what leaves is bounded by what enters
};

/// A graph of the project's folder, by its name without .json, with small light views.
GraphChoice graphNamed(const std::string& name);

/// Renders the scene with each graph and checks every image: all values finite; radiance, irradiance and flux
/// not negative; and with a conserving graph, where the picture is of scattered point light only, that the
/// object does not send more towards the camera than could enter it (see radiatedBound in device.cpp).
void checkOnDevice(const SceneValues& scene, const std::vector<GraphChoice>& graphs, const Place& place,
                   Outcome& outcome);

/// Pixels along an edge of the pictures of stressed scenes.
constexpr std::uint32_t stressedSize = 16;

/// The mean of red, green and blue of a picture of `size` x `size` pixels for each graph.
std::vector<Triple> pictureMeans(const SceneValues& scene, const std::vector<GraphChoice>& graphs,
                                 const Place& place, std::uint32_t size = stressedSize);

/// Radiant intensity, W/sr, of what is seen towards the camera, by channel, from a picture of `size` x `size`
/// pixels. The graph must have a node "gbuffer".
Triple radiantIntensity(const SceneValues& scene, const GraphChoice& graph, const Place& place,
                        std::uint32_t size);

}  // namespace nephrite::stress
