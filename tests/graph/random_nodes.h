// Nodes of random graphs, added one after another so that each reads only what is there.
#pragma once

#include <optional>
#include <vector>

#include "graph/compile.h"
#include "graph/plan_oracle_accesses.h"
#include "graph/random_ports.h"

namespace nephrite::graph::tests {

/// Levels down to 1 x 1.
std::uint32_t mostMips(Extent extent);

class RandomNodes {
  public:
    RandomNodes(Chance& chance, std::uint32_t lightViews);

    void add();
    void addImport(const ImportedImage& image);
    /// Lets some node read some port of so many frames ago.
    void addPrevious(std::uint32_t framesBack);
    /// A port that is wanted as an image. Nothing modifies it.
    PortReference askFor();

    GraphDescription description;
    std::vector<PassType> types;  ///< one for each node

  private:
    /// The node being added.
    struct Draft {
        PassType type;
        NodeDescription node;
        ForEach forEach = ForEach::Nothing;
        std::optional<Extent> extent;  ///< of its outputs, if it says
        std::vector<RandomPort> outputs;
    };

    void chooseKind(Draft& draft);
    void addInputs(Draft& draft);
    void addInput(Draft& draft, RandomPort& port, PortReference from);
    bool overlapsModified(const Draft& draft, const RandomPort& port) const;
    void addModifier(Draft& draft);
    bool canModify(const Draft& draft, const RandomPort& port) const;
    void addDomain(Draft& draft);
    void addOutputs(Draft& draft);
    RandomPort randomOutput(Draft& draft, OutputPort& output);
    void addConditions(Draft& draft);
    void finish(Draft& draft);
    RandomPort* randomReadable();
    std::optional<Expression> randomCondition(const PassType& type);

    Chance& chance_;
    std::uint32_t lightViews_;
    std::vector<RandomPort> ports_;
};

}  // namespace nephrite::graph::tests
