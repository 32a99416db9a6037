// Creation of a plan's images and buffers.
#include "runtime/resources/frame_resources.h"

#include <algorithm>
#include <map>

#include "runtime/resources/resource_descriptions.h"
#include "runtime/resources/vulkan_names.h"

namespace nephrite::runtime {

using graph::Index;
using graph::Resource;
using graph::ResourceKind;

FrameResources::FrameResources(const gpu::Device& device, const graph::Plan& plan,
                               const ImportedImages& imports, LastingImages& lasting)
    : plan_(plan),
      inHeap_(plan.resources.size(), 0),
      places_(plan.resources.size()),
      images_(plan.resources.size()),
      buffers_(plan.resources.size()) {
    findRings(device, lasting.history);
    findKept(device, lasting.kept);
    makeHeap(device);
    for (Index i = 0; i < plan.resources.size(); ++i) make(device, i, imports);
}

/// The resources of one port in different frames share a ring, which is as long as the oldest needs.
void FrameResources::findRings(const gpu::Device& device, HistoryStore& history) {
    struct Port {
        std::uint32_t length = 0;
        std::uint32_t uses = 0;
        std::vector<Index> resources;
    };
    std::map<std::pair<Index, Index>, Port> ports;
    for (Index i = 0; i < plan_.resources.size(); ++i) {
        const Resource& resource = plan_.resources[i];
        if (resource.kind != ResourceKind::History) continue;
        Port& port = ports[{resource.node, resource.port}];
        port.length = std::max(port.length, resource.framesBack + 1U);
        port.uses |= resource.uses;
        port.resources.push_back(i);
    }
    for (const auto& [name, port] : ports) {
        for (const Index resource : port.resources)
            places_[resource].ring = static_cast<Index>(rings_.size());
        rings_.push_back(history.ring(device, plan_, port.resources.front(), port.length, port.uses).ring);
    }
}

void FrameResources::findKept(const gpu::Device& device, HistoryStore& kept) {
    for (Index i = 0; i < plan_.resources.size(); ++i) {
        if (plan_.resources[i].kind != ResourceKind::Kept) continue;
        FoundRing found = kept.ring(device, plan_, i, 1, plan_.resources[i].uses);
        places_[i].ring = static_cast<Index>(rings_.size());
        places_[i].inherited = found.inherited;
        rings_.push_back(std::move(found.ring));
    }
}

/// One allocation for all Transient resources that some kind of memory suits. One that suits none of the
/// kinds that suit those before it gets memory of its own.
void FrameResources::makeHeap(const gpu::Device& device) {
    gpu::MemoryNeeds heap;
    heap.types = ~std::uint32_t{0};
    for (Index i = 0; i < plan_.resources.size(); ++i) {
        const Resource& resource = plan_.resources[i];
        if (resource.kind != ResourceKind::Transient || resource.offset == Resource::noOffset) continue;
        const gpu::MemoryNeeds needs =
            resource.isBuffer ? gpu::memoryNeeds(device, bufferDescription(bufferBytes(plan_, resource)))
                              : gpu::memoryNeeds(device, imageDescription(resource, plan_.inputReads));
        if (needs.alone || (heap.types & needs.types) == 0) continue;
        heap.types &= needs.types;
        heap.alignment = std::max(heap.alignment, needs.alignment);
        inHeap_[i] = 1;
    }
    heap.bytes = plan_.heapBytes;
    if (heap.bytes == 0 || std::find(inHeap_.begin(), inHeap_.end(), 1) == inHeap_.end()) return;
    heap_ = gpu::Memory(device, heap.requirements(), gpu::Residence::Device, nullptr,
                        "the images and buffers of a frame");
}

void FrameResources::make(const gpu::Device& device, Index index, const ImportedImages& imports) {
    const Resource& resource = plan_.resources[index];
    if (places_[index].ring != graph::noIndex) return;
    if (resource.kind == ResourceKind::Imported) {
        places_[index].imported = imports.at(plan_.graph->nodes[resource.node].import).get();
        return;
    }
    const std::string name = plan_.nameOf(resource);
    if (resource.isBuffer) {
        const gpu::BufferDescription description = bufferDescription(bufferBytes(plan_, resource), name);
        buffers_[index] = inHeap_[index] != 0 ? gpu::Buffer(device, description, heap_, resource.offset)
                                              : gpu::Buffer(device, description);
        return;
    }
    const gpu::ImageDescription description = imageDescription(resource, plan_.inputReads, name);
    images_[index] = inHeap_[index] != 0 ? gpu::Image(device, description, heap_, resource.offset)
                                         : gpu::Image(device, description);
}

const gpu::Image& FrameResources::image(Index resource) const {
    const Place& place = places_[resource];
    if (place.imported != nullptr) return *place.imported;
    if (place.ring == graph::noIndex) return images_[resource];
    const HistoryRing& ring = *rings_[place.ring];
    return ring.images[ring.at(plan_.resources[resource].framesBack)];
}

const gpu::Buffer& FrameResources::buffer(Index resource) const {
    const Place& place = places_[resource];
    if (place.ring == graph::noIndex) return buffers_[resource];
    const HistoryRing& ring = *rings_[place.ring];
    return ring.buffers[ring.at(plan_.resources[resource].framesBack)];
}

VkImageView FrameResources::view(Index resource, std::uint16_t mip, std::uint16_t layer) const {
    const gpu::Image& image = this->image(resource);
    const gpu::ImageDescription& whole = image.description();
    const bool everyLayer = layer == graph::every;
    return image.view(mip == graph::every ? 0 : mip, mip == graph::every ? whole.mips : 1,
                      everyLayer ? 0 : layer, everyLayer ? whole.layers : 1, everyLayer && whole.layers > 1);
}

void FrameResources::nextFrame() {
    for (const auto& ring : rings_) ring->rotate();
}

}  // namespace nephrite::runtime
