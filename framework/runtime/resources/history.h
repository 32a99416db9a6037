// Images and buffers that outlast the frame: those of earlier frames, and results that are kept. They outlive
// plans: a graph that is compiled anew goes on where it was.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/image.h"
#include "graph/plan.h"

namespace nephrite::runtime {

/// The last frames of one port: one more than the deepest `previous(...)` that reads it.
struct HistoryRing {
    std::vector<gpu::Image> images;    ///< or
    std::vector<gpu::Buffer> buffers;  ///< one for each frame
    std::uint32_t current = 0;         ///< holds this frame's

    std::uint32_t length() const { return static_cast<std::uint32_t>(images.size() + buffers.size()); }
    /// Where the contents of `framesBack` frames ago are.
    std::uint32_t at(std::uint32_t framesBack) const {
        return (current + length() - framesBack % length()) % length();
    }
    /// From here on what is this frame's is the last frame's; the oldest is written over.
    void rotate() { current = (current + 1) % length(); }
};

/// A ring and whether its contents come from the plan before.
struct FoundRing {
    std::shared_ptr<HistoryRing> ring;
    bool inherited = false;
};

class HistoryStore {
  public:
    /// The ring of the port of plan.resources[resource] (any of its frames), `length` long. The one of the
    /// last plan if it has the same name, extent, format, levels, layers, uses, layout and length. Otherwise
    /// a new one in the layout in which frames start: with the frames of the last plan's if only length, uses
    /// or layout were wanting, and all others neutral. What a plan takes does not depend on those before it.
    /// No frame may be under way. Throws RunError if memory runs out.
    FoundRing ring(const gpu::Device& device, const graph::Plan& plan, graph::Index resource,
                   std::uint32_t length, std::uint32_t uses);
    /// Lets go of rings that no plan holds.
    void dropUnused();

  private:
    struct Entry {
        graph::Resource resource;  ///< uses and layout it was made for
        std::shared_ptr<HistoryRing> ring;
    };
    std::multimap<std::string, Entry> rings_;  ///< by name and shape
};

/// What outlasts plans, apart by what it is for: a result that is kept never becomes a frame of history.
struct LastingImages {
    HistoryStore history;
    HistoryStore kept;  ///< rings of length 1

    void dropUnused() {
        history.dropUnused();
        kept.dropUnused();
    }
};

}  // namespace nephrite::runtime
