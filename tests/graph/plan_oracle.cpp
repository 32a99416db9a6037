// The model. An access happens at a stage named by its Use. A barrier orders every earlier access whose use
// is in usesBefore, or which is already ordered before a use in usesBefore (dependencies chain), before later
// accesses whose use is in usesAfter. A write must be made available by a barrier that names it and says
// writeBefore, and is visible to the uses of that and of later chained barriers. Changing the layout is a
// write of its own between the two halves.
#include "graph/plan_oracle.h"

#include <fmt/format.h>

#include <algorithm>

namespace nephrite::graph::tests {
namespace {

using Uses = std::uint32_t;

constexpr Uses maskOf(Use use) {
    return Uses{1} << static_cast<unsigned>(use);
}

bool isWrite(Use use) {
    constexpr Uses all = maskOf(Use::ComputeWrite) | maskOf(Use::ColorAttachment) |
                         maskOf(Use::DepthAttachment) | maskOf(Use::Clear);
    return (all & maskOf(use)) != 0;
}

/// The layout a use needs by Vulkan's rules.
Layout neededLayout(Use use, const Plan& plan, const Resource& resource) {
    if (resource.isBuffer) return Layout::Undefined;
    const bool isDepth = resource.format == Format::d32f;
    if (use == Use::ComputeRead || use == Use::RasterRead) {
        return isDepth || plan.inputReads == InputReads::SampledImage ? Layout::ShaderRead : Layout::General;
    }
    if (use == Use::ComputeWrite) return Layout::General;
    if (use == Use::ColorAttachment) return Layout::ColorAttachment;
    if (use == Use::DepthAttachment) return Layout::DepthAttachment;
    return use == Use::Clear ? Layout::TransferDestination : Layout::TransferSource;
}

/// An access that has happened; a layout change is one with use None.
struct Access {
    Use use = Use::None;
    Uses orderedBefore = 0;
};

class ResourceModel {
  public:
    ResourceModel(const Plan& plan, const Resource& resource, std::vector<std::string>& findings)
        : plan_(plan), resource_(resource), findings_(findings) {}

    void apply(const Barrier& barrier) {
        checkRange(barrier);
        checkBefore(barrier);
        endPromise();
        const bool changesLayout = barrier.oldLayout != barrier.newLayout;
        bool ordersSomething = false;
        bool ordersAll = true;
        for (Access& access : accesses_) {
            const bool reached = ((maskOf(access.use) | access.orderedBefore) & barrier.usesBefore) != 0;
            ordersAll &= reached;
            if (!reached) continue;
            ordersSomething |= (barrier.usesAfter & ~access.orderedBefore) != 0;
            access.orderedBefore |= barrier.usesAfter;
            if (isLastWrite(access)) showWrite(access, barrier);
        }
        if (changesLayout) {
            changeLayout(barrier, ordersAll);
        } else if (!ordersSomething) {
            report("a needless barrier");
        }
        promised_ = barrier.usesAfter;
    }

    void use(Use use, Index pass) {
        promised_ &= ~maskOf(use);
        changedSinceUse_ = false;
        if (layout_ != neededLayout(use, plan_, resource_))
            report(fmt::format("pass {} finds the wrong layout", pass));
        if (isWrite(use)) {
            write(use, pass);
        } else {
            read(use, pass);
        }
        // A requested resource's copy comes after the last pass, where lifetimes do not reach.
        const bool isCopyOut = pass == plan_.passes.size();
        const bool lives =
            isCopyOut ? resource_.last + 1 == pass : resource_.first <= pass && pass <= resource_.last;
        if (!lives) report(fmt::format("pass {} uses it outside its life", pass));
        if ((resource_.uses & maskOf(use)) == 0) report("a use that the resource does not list");
    }

    void finish() { endPromise(); }

  private:
    void report(const std::string& what) { findings_.push_back(plan_.nameOf(resource_) + ": " + what); }

    bool isLastWrite(const Access& access) const { return &access == accesses_.data() && hasContents_; }

    void checkRange(const Barrier& barrier) {
        const bool isWhole = barrier.baseMip == 0 && barrier.mips == resource_.mips &&
                             barrier.baseLayer == 0 && barrier.layers == resource_.layers;
        if (!isWhole) report("a barrier over a part of it");
    }

    /// What the barrier waits for must have happened since the last write, and a write only it can make
    /// available.
    void checkBefore(const Barrier& barrier) {
        Uses happened = 0;
        for (const Access& access : accesses_) happened |= maskOf(access.use) | access.orderedBefore;
        if ((barrier.usesBefore & ~happened) != 0) report("a wait for what did not happen");
        if (barrier.usesAfter == 0) report("a barrier that nothing waits at");
        if (barrier.writeBefore && (!hasContents_ || isAvailable_)) report("makes nothing available");
    }

    void showWrite(const Access& writer, const Barrier& barrier) {
        if (barrier.writeBefore && (maskOf(writer.use) & barrier.usesBefore) != 0) isAvailable_ = true;
        if (isAvailable_) visibleTo_ |= barrier.usesAfter;
    }

    void changeLayout(const Barrier& barrier, bool ordersAll) {
        if (resource_.isBuffer) report("a layout change of a buffer");
        if (barrier.oldLayout != layout_) report("a layout change from another layout than it is in");
        if (!ordersAll) report("a layout change that races with an access");
        if (hasContents_ && !isAvailable_) report("a layout change that loses contents");
        if (changedSinceUse_) report("two layout changes without a use between them");
        changedSinceUse_ = true;
        layout_ = barrier.newLayout;
        visibleTo_ = barrier.usesAfter;
        isAvailable_ = true;
        accesses_.assign(1, {Use::None, barrier.usesAfter});
    }

    void write(Use use, Index pass) {
        for (const Access& access : accesses_) {
            if ((access.orderedBefore & maskOf(use)) == 0)
                report(fmt::format("pass {} writes it in a race", pass));
        }
        accesses_.assign(1, {use, 0});
        hasContents_ = true;
        isAvailable_ = false;
        visibleTo_ = 0;
    }

    void read(Use use, Index pass) {
        if (!hasContents_) report(fmt::format("pass {} reads undefined contents", pass));
        if ((visibleTo_ & maskOf(use)) == 0) report(fmt::format("pass {} reads what it cannot see", pass));
        accesses_.push_back({use, 0});
    }

    /// Every use a barrier makes wait must come before the next barrier.
    void endPromise() {
        if (promised_ != 0) report("a barrier makes uses wait that do not come");
        promised_ = 0;
    }

    const Plan& plan_;
    const Resource& resource_;
    std::vector<std::string>& findings_;
    Layout layout_ = Layout::Undefined;
    std::vector<Access> accesses_;  ///< the last write or layout change, then the reads since
    bool hasContents_ = false;
    bool isAvailable_ = false;  ///< the last write is
    bool changedSinceUse_ = false;
    Uses visibleTo_ = 0;
    Uses promised_ = 0;
};

class PlanModel {
  public:
    explicit PlanModel(const Plan& plan) : plan_(plan) {
        for (const Resource& resource : plan.resources) models_.emplace_back(plan, resource, findings_);
    }

    std::vector<std::string> run() {
        for (Index i = 0; i < plan_.passes.size(); ++i) {
            apply(plan_.passes[i].barriers);
            runPass(i);
        }
        apply(plan_.finalBarriers);
        std::vector<Index> copied;
        for (const RequestedOutput& output : plan_.requested) {
            if (output.resource != noIndex) copied.push_back(output.resource);
        }
        std::sort(copied.begin(), copied.end());
        copied.erase(std::unique(copied.begin(), copied.end()), copied.end());
        for (const Index resource : copied)
            models_[resource].use(Use::Copy, static_cast<Index>(plan_.passes.size()));
        for (ResourceModel& model : models_) model.finish();
        return std::move(findings_);
    }

  private:
    void apply(Range range) {
        for (const Barrier& barrier : slice(plan_.barriers, range)) models_[barrier.resource].apply(barrier);
    }

    void runPass(Index index) {
        const PlannedPass& pass = plan_.passes[index];
        const bool isRaster = plan_.graph->nodes[pass.node].type->kind == PassKind::Raster;
        for (const InputRead& input : slice(plan_.inputs, pass.inputs)) {
            if (input.resource == noIndex) continue;
            models_[input.resource].use(isRaster ? Use::RasterRead : Use::ComputeRead, index);
        }
        for (const Index output : slice(plan_.outputs, pass.outputs)) {
            if (output == noIndex) continue;
            const bool isDepth =
                plan_.resources[output].format == Format::d32f && !plan_.resources[output].isBuffer;
            const Use raster = isDepth ? Use::DepthAttachment : Use::ColorAttachment;
            models_[output].use(pass.iterations == 0 ? Use::Clear
                                : isRaster           ? raster
                                                     : Use::ComputeWrite,
                                index);
        }
    }

    const Plan& plan_;
    std::vector<std::string> findings_;
    std::vector<ResourceModel> models_;
};

}  // namespace

std::vector<std::string> findHazards(const Plan& plan) {
    return PlanModel(plan).run();
}

}  // namespace nephrite::graph::tests
