// `nephrite schema graph|pass|scene|sweep`: the JSON Schema of a file format, for editors.
#include <cstdio>

#include "graph/schema.h"
#include "scene/scene_schema.h"
#include "sweep/sweep.h"
#include "verbs.h"

namespace nephrite::tools {

void addSchemaVerb(CLI::App& app, Action& action) {
    CLI::App* verb = app.add_subcommand("schema", "Print the JSON Schema of a file format");
    auto format = std::make_shared<std::string>();
    verb->add_option("format", *format, "graph, pass, scene or sweep")
        ->required()
        ->check(CLI::IsMember({"graph", "pass", "scene", "sweep"}));
    verb->callback([&action, format] {
        action = [format] {
            const std::string schema = *format == "graph"   ? graph::graphSchema()
                                       : *format == "pass"  ? graph::passSchema()
                                       : *format == "scene" ? scene::sceneSchema()
                                                            : sweep::sweepSchema();
            std::puts(schema.c_str());
        };
    });
}

}  // namespace nephrite::tools
