// Matching the passes of two plans, sources first.
#include "runtime/frame/takeover.h"

#include <algorithm>
#include <map>
#include <string_view>

namespace nephrite::runtime {
namespace {

using graph::Index;
using graph::InputRead;
using graph::noIndex;
using graph::PlannedPass;
using graph::Resource;
using graph::ResourceKind;

bool sameShape(const Resource& a, const Resource& b) {
    return a.extent == b.extent && a.mips == b.mips && a.layers == b.layers &&
           a.layersPerIteration == b.layersPerIteration && a.format == b.format && a.isBuffer == b.isBuffer &&
           a.framesBack == b.framesBack;
}

class Matching {
  public:
    Matching(const PlanInUse& next, const PlanInUse& before)
        : next_(next),
          before_(before),
          matches_(next.plan.passes.size(), noIndex),
          nextWriters_(next.plan.resources.size(), noIndex),
          sourcesBefore_(before.plan.passes.size()) {
        Writers writers(before.plan.resources.size(), noIndex);
        for (Index pass = 0; pass < before.plan.passes.size(); ++pass) {
            byName_[before.plan.nameOf(before.plan.passes[pass])] = pass;
            sourcesBefore_[pass] = sourcesOf(before.plan, before.plan.passes[pass], writers);
            noteWrites(before.plan, pass, writers);
        }
    }

    std::vector<Index> run() {
        for (Index pass = 0; pass < matches_.size(); ++pass) {
            const auto known = byName_.find(next_.plan.nameOf(next_.plan.passes[pass]));
            if (known != byName_.end() && same(pass, known->second)) matches_[pass] = known->second;
            noteWrites(next_.plan, pass, nextWriters_);
        }
        return std::move(matches_);
    }

  private:
    using Writers = std::vector<Index>;  ///< by resource: the pass that wrote it last

    /// What a pass reads, and the pass of this frame that wrote it.
    struct Source {
        Index resource = noIndex;
        Index writer = noIndex;
    };

    static std::vector<Source> sourcesOf(const graph::Plan& plan, const PlannedPass& pass,
                                         const Writers& writers) {
        std::vector<Source> sources;
        const auto add = [&](Index resource) {
            sources.push_back({resource, resource == noIndex ? noIndex : writers[resource]});
        };
        for (const InputRead& read : slice(plan.inputs, pass.inputs)) add(read.resource);
        add(pass.tileList);
        return sources;
    }

    static void noteWrites(const graph::Plan& plan, Index pass, Writers& writers) {
        for (const Index output : slice(plan.outputs, plan.passes[pass].outputs)) writers[output] = pass;
    }

    bool same(Index pass, Index earlier) const {
        const PlannedPass& a = next_.plan.passes[pass];
        const PlannedPass& b = before_.plan.passes[earlier];
        return samePrograms(pass, earlier) && a.iterations == b.iterations && a.extent == b.extent &&
               a.view == b.view && a.forEach == b.forEach && a.clearsFirst == b.clearsFirst &&
               sameOutputs(a, b) && sameReads(a, b) &&
               sameSources(sourcesOf(next_.plan, a, nextWriters_), sourcesBefore_[earlier]);
    }

    bool samePrograms(Index pass, Index earlier) const {
        const auto& a = next_.bindings[pass];
        const auto& b = before_.bindings[earlier];
        return a && b && &a->program() == &b->program() &&
               a->interface().parameterWords == b->interface().parameterWords;
    }

    bool sameOutputs(const PlannedPass& a, const PlannedPass& b) const {
        const auto now = slice(next_.plan.outputs, a.outputs);
        const auto then = slice(before_.plan.outputs, b.outputs);
        return std::equal(now.begin(), now.end(), then.begin(), then.end(), [&](Index left, Index right) {
            const Resource& resource = next_.plan.resources[left];
            const Resource& earlier = before_.plan.resources[right];
            const bool isThere = resource.kind != ResourceKind::Kept ||
                                 (earlier.kind == ResourceKind::Kept && next_.resources.isInherited(left));
            return isThere && sameShape(resource, earlier);
        });
    }

    bool sameReads(const PlannedPass& a, const PlannedPass& b) const {
        const auto now = slice(next_.plan.inputs, a.inputs);
        const auto then = slice(before_.plan.inputs, b.inputs);
        return std::equal(now.begin(), now.end(), then.begin(), then.end(),
                          [](const InputRead& left, const InputRead& right) {
                              return left.extent == right.extent && left.mip == right.mip &&
                                     left.layer == right.layer && left.perIteration == right.perIteration &&
                                     left.modified == right.modified;
                          });
    }

    bool sameSources(const std::vector<Source>& now, const std::vector<Source>& then) const {
        return std::equal(now.begin(), now.end(), then.begin(), then.end(),
                          [&](const Source& a, const Source& b) { return sameSource(a, b); });
    }

    bool sameSource(const Source& a, const Source& b) const {
        if (a.resource == noIndex || b.resource == noIndex) return a.resource == b.resource;
        if (!sameShape(next_.plan.resources[a.resource], before_.plan.resources[b.resource])) return false;
        if (a.writer != noIndex) return b.writer != noIndex && matches_[a.writer] == b.writer;
        return b.writer == noIndex &&
               next_.resources.imported(a.resource) == before_.resources.imported(b.resource);
    }

    const PlanInUse& next_;
    const PlanInUse& before_;
    std::map<std::string_view, Index> byName_;        ///< passes of `before`
    std::vector<Index> matches_;                      ///< by pass of `next`
    Writers nextWriters_;                             ///< as far as the passes were looked at
    std::vector<std::vector<Source>> sourcesBefore_;  ///< by pass of `before`
};

}  // namespace

std::vector<Index> samePasses(const PlanInUse& next, const PlanInUse& before) {
    return Matching(next, before).run();
}

}  // namespace nephrite::runtime
