// A pass manifest read: its ports and parameters, and what they must be together.
#include "graph/pass_type.h"

#include <fmt/format.h>

#include <set>

#include "graph/keys.h"
#include "graph/manifest_ports.h"
#include "graph/manifest_roles.h"
#include "graph/value_readers.h"

namespace nephrite::graph {
namespace {

constexpr std::array<std::string_view, 4> kindNames{"pixel", "compute", "raster", "native"};

class ManifestReader {
  public:
    ManifestReader(const json::Value& value, std::string name, Diagnostics& diagnostics)
        : object_(value, "a pass", keys::manifest(), diagnostics), diagnostics_(diagnostics) {
        type_.name = std::move(name);
        type_.where = value.where();
    }

    PassType read() {
        if (!object_.value().isObject()) return std::move(type_);
        if (const auto value = object_.optional("doc")) {
            type_.doc = value->string(diagnostics_, "a string").value_or("");
        }
        if (const auto value = object_.optional("sideEffect")) {
            type_.sideEffect = value->boolean(diagnostics_, "true or false").value_or(false);
        }
        readKind();
        readShader();
        readRaster();
        readPortsAndParameters();
        if (const auto value = object_.optional("skipWhen"))
            type_.skipWhen = readExpression(*value, diagnostics_);
        readRoles();
        object_.finish();
        checkPorts();
        checkExpressions();
        return std::move(type_);
    }

  private:
    void readKind() {
        const auto value = object_.optional("kind");
        if (!value) return;
        const auto choice = readChoice(*value, kindNames, diagnostics_);
        if (choice) type_.kind = static_cast<PassKind>(*choice);
        kindKnown_ = choice.has_value();
    }

    void readShader() {
        const auto value = object_.optional("shader");
        const bool native = type_.kind == PassKind::Native;
        if (value && native) diagnostics_.error(value->whereKey(), "a native pass has no shader");
        if (!value && kindKnown_ && !native) {
            diagnostics_.error(type_.where,
                               fmt::format("a {} pass needs \"shader\"", graph::name(type_.kind)));
        }
        if (!value) return;
        const auto file = value->string(diagnostics_, "a shader's file name");
        if (file && file->empty())
            diagnostics_.error(value->where(), "expected a shader's file name, found \"\"");
        if (file) type_.shader = *file;
    }

    void readRaster() {
        const auto value = object_.optional("raster");
        if (!value) return;
        if (kindKnown_ && type_.kind != PassKind::Raster) {
            diagnostics_.error(value->whereKey(), fmt::format("\"raster\" has no meaning in a {} pass",
                                                              graph::name(type_.kind)));
        }
        static constexpr std::array<std::string_view, 2> keep{"nearest", "farthest"};
        static constexpr std::array<std::string_view, 3> cull{"none", "back", "front"};
        json::ObjectReader raster(*value, "\"raster\"", keys::raster(), diagnostics_);
        if (const auto choice = raster.optional("keep")) {
            type_.raster.keep =
                static_cast<RasterState::Keep>(readChoice(*choice, keep, diagnostics_).value_or(0));
        }
        if (const auto choice = raster.optional("cull")) {
            type_.raster.cull =
                static_cast<RasterState::Cull>(readChoice(*choice, cull, diagnostics_).value_or(0));
        }
        raster.finish();
    }

    void readPortsAndParameters() {
        if (const auto value = object_.optional("parameters"))
            type_.parameters = readParameters(*value, diagnostics_);
        if (const auto value = object_.optional("inputs")) type_.inputs = readInputs(*value, diagnostics_);
        if (const auto value = object_.optional("outputs")) type_.outputs = readOutputs(*value, diagnostics_);
    }

    void readRoles() {
        if (const auto value = object_.optional("forEach"))
            type_.forEach = readForEach(*value, diagnostics_).value_or(ForEach::Nothing);
        const auto domain = object_.optional("domain");
        if (domain) type_.domain = domain->string(diagnostics_, "an input's name").value_or("");
        if (domain && domain->isString() && kindKnown_) resolveDomain(type_, *domain, diagnostics_);
        resolveModifies(type_, object_.value(), diagnostics_);
        if (type_.forEach != ForEach::Mips) return refuseUndrawnParts(type_, object_.value(), diagnostics_);
        if (const auto fault = whyNotForEachMip(type_)) diagnostics_.error(fault->where, fault->message);
    }

    void checkPorts() {
        const bool mayWriteNothing =
            type_.kind == PassKind::Native || (type_.kind == PassKind::Compute && type_.sideEffect);
        if (kindKnown_ && !mayWriteNothing && type_.outputs.empty()) {
            diagnostics_.error(type_.where,
                               fmt::format("a {} pass needs an output", graph::name(type_.kind)));
        }
        std::set<std::string_view> inputs;
        for (const InputPort& input : type_.inputs) inputs.insert(input.name);
        int depthOutputs = 0;
        for (const OutputPort& output : type_.outputs) {
            if (inputs.count(output.name) > 0) {
                diagnostics_.error(output.where,
                                   fmt::format("{} is an input too: ports of a pass have different names",
                                               inQuotes(output.name)));
            }
            if (type_.kind == PassKind::Raster && !output.bufferElement.empty()) {
                diagnostics_.error(output.where,
                                   "a raster pass writes images, it cannot have a buffer as an output");
            }
            if (output.bufferElement.empty() && info(output.format).isDepth)
                checkDepth(output, ++depthOutputs);
        }
    }

    void checkDepth(const OutputPort& output, int count) {
        if (kindKnown_ && type_.kind != PassKind::Raster) {
            diagnostics_.error(output.where,
                               fmt::format("d32f is written by raster passes only, found it in a {} pass",
                                           graph::name(type_.kind)));
        } else if (count > 1) {
            diagnostics_.error(output.where, "a raster pass has one output of format d32f at most");
        }
    }

    void checkExpressions() {
        const ExpressionScope conditions{type_.parameters, type_.inputs, true, {}};
        const ExpressionScope counts{type_.parameters, type_.inputs, false, {}};
        if (type_.skipWhen) checkNames(*type_.skipWhen, conditions, diagnostics_);
        for (const InputPort& input : type_.inputs) {
            if (input.neededWhen) checkNames(*input.neededWhen, conditions, diagnostics_);
        }
        for (const OutputPort& output : type_.outputs) {
            checkNames(output.mips, counts, diagnostics_);
            checkNames(output.layers, counts, diagnostics_);
            checkNames(output.bufferCount, counts, diagnostics_);
            if (!output.size) continue;
            checkNames(*output.size, counts, diagnostics_);
            if (output.size->kind == SizeRule::Kind::Like) checkLike(*output.size);
        }
    }

    void checkLike(const SizeRule& size) {
        const InputPort* input = findNamed(type_.inputs, size.like);
        if (input == nullptr) {
            diagnostics_.error(size.where, fmt::format("unknown input {}{}", inQuotes(size.like),
                                                       suggestionAmong(size.like, type_.inputs)));
        } else if (!input->bufferElement.empty()) {
            diagnostics_.error(size.where,
                               fmt::format("{} is a buffer and has no size in pixels", inQuotes(size.like)));
        }
    }

    json::ObjectReader object_;
    Diagnostics& diagnostics_;
    PassType type_;
    bool kindKnown_ = false;
};

}  // namespace

std::string_view name(PassKind kind) {
    return kindNames[static_cast<std::size_t>(kind)];
}

PassType readPassType(const json::Value& value, std::string name, Diagnostics& diagnostics) {
    return ManifestReader(value, std::move(name), diagnostics).read();
}

PassType readPassType(const std::filesystem::path& manifest, const std::filesystem::path& shaderFolder) {
    const json::Value value = json::parseFile(manifest);
    Diagnostics diagnostics;
    PassType type = readPassType(value, manifest.stem().string(), diagnostics);
    type.manifest = manifest;
    const auto exists = [](const std::filesystem::path& path) {
        std::error_code error;
        return std::filesystem::is_regular_file(path, error);
    };
    const std::filesystem::path beside = manifest.parent_path() / type.shader;
    const std::filesystem::path shared = shaderFolder / type.shader;
    if (!type.shader.empty() && !exists(beside) && !exists(shared)) {
        diagnostics.error(value.find("shader")->where(),
                          fmt::format("the shader {} is neither beside the manifest nor in {}",
                                      inQuotes(type.shader.string()), shaderFolder.string()));
    }
    diagnostics.throwIfErrors();
    if (!type.shader.empty()) type.shader = exists(beside) ? beside : shared;
    return type;
}

}  // namespace nephrite::graph
