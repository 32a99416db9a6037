// Counting through what a sweep combines.
#include "sweep/runs.h"

#include <fmt/format.h>

#include <algorithm>

#include "pareto/combinations.h"
#include "text/digest.h"

namespace nephrite::sweep {

std::string Run::name() const {
    std::string text = fmt::format("{}/{}/{}x{}", scene->name, graph->name, size.width, size.height);
    for (const Setting* parameter : parameters) text += " " + parameter->text();
    return text;
}

std::string Run::id() const {
    std::vector<std::string> sorted;
    for (const Setting* parameter : parameters) sorted.push_back(parameter->text());
    std::sort(sorted.begin(), sorted.end());
    Digest digest;
    digest.add(fmt::format("{}/{}/{}x{}", scene->name, graph->name, size.width, size.height));
    for (const std::string& parameter : sorted) digest.add(" " + parameter);
    return digest.text();
}

std::vector<std::string> Run::settings() const {
    std::vector<std::string> all;
    for (const Setting& setting : graph->settings) all.push_back(setting.text());
    for (const Setting* parameter : parameters) all.push_back(parameter->text());
    return all;
}

std::vector<Run> runsOf(const Sweep& sweep) {
    std::vector<std::size_t> lengths{sweep.scenes.size(), sweep.graphs.size(), sweep.sizes.size(),
                                     std::max<std::size_t>(sweep.list.size(), 1)};
    for (const Axis& axis : sweep.grid) lengths.push_back(axis.values.size());
    std::vector<Run> runs;
    for (const std::vector<std::size_t>& choice : pareto::combinations(lengths)) {
        Run& run = runs.emplace_back(
            Run{&sweep.scenes[choice[0]], &sweep.graphs[choice[1]], sweep.sizes[choice[2]], {}});
        if (!sweep.list.empty())
            for (const Setting& setting : sweep.list[choice[3]]) run.parameters.push_back(&setting);
        for (std::size_t i = 0; i < sweep.grid.size(); ++i)
            run.parameters.push_back(&sweep.grid[i].values[choice[4 + i]]);
    }
    return runs;
}

}  // namespace nephrite::sweep
