// Holds a frame with skipping against the same frame without.
#pragma once

#include "runtime/frame/executor.h"

namespace nephrite::runtime {

/// Compares every requested image of two executors' last frames, bit for bit. Throws RunError naming the
/// first output that differs, its first texel that does, and both values. No frame may be under way.
void compareFrames(const gpu::Device& device, const Executor& skipping, const Executor& plain);

}  // namespace nephrite::runtime
