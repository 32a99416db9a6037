// The images and buffers of a plan as gpu/ makes them, and what they need of shared memory.
#pragma once

#include "gpu/buffer.h"
#include "gpu/image.h"
#include "graph/compile.h"

namespace nephrite::runtime {

/// `name` for errors and validation messages.
gpu::ImageDescription imageDescription(const graph::Resource& resource, graph::InputReads reads,
                                       std::string name = {});
gpu::BufferDescription bufferDescription(std::uint64_t bytes, std::string name = {});

/// Bytes of a buffer's elements. What it takes in the heap may be more.
std::uint64_t bufferBytes(const graph::Plan& plan, const graph::Resource& resource);

/// Answers CompileRequest::memory with the device's true sizes and alignments. `device` must outlive it.
std::function<graph::MemoryNeed(const graph::Resource&)> memoryNeedsOn(const gpu::Device& device,
                                                                       graph::InputReads reads);

/// The neutral value of an output port as a clear writes it.
VkClearColorValue neutralColor(const graph::OutputPort& port, graph::Format format);
/// What empty space is in a depth image: beyond everything, seen from where the kept surface is.
float neutralDepth(const graph::PassType& type);

/// Records clearing all of an image, which is in TRANSFER_DST_OPTIMAL, or of a buffer (to 0).
void clearImage(VkCommandBuffer commands, const gpu::Image& image, const graph::PassType& type,
                const graph::OutputPort& port, graph::Format format);
void clearBuffer(VkCommandBuffer commands, const gpu::Buffer& buffer);

}  // namespace nephrite::runtime
