// Results as JSON.
#include <json/writer.h>

#include "image/metrics/metrics_report.h"
#include "pareto/report.h"
#include "truth/reference_run.h"

namespace nephrite::pareto {
namespace {

Json::Value asJson(const ComparisonResult& comparison) {
    Json::Value value;
    value["reference"] = std::string(name(comparison.reference));
    value["port"] = comparison.port;
    value["error"] = comparison.error();
    value["onFront"] = comparison.isOnFront;
    value["metrics"] = image::toJson(comparison.metrics);
    return value;
}

Json::Value asJson(const ReferenceResult& reference) {
    Json::Value value;
    value["mode"] = std::string(name(reference.mode));
    for (const auto& file : reference.files) value["files"].append(file.string());
    for (const auto& [attribute, text] : reference.record)
        if (attribute != "mode" && attribute != "content") value[attribute] = text;
    for (const double channel : reference.noise) value["noise"].append(channel);
    return value;
}

void addTimes(const PointResult& point, Json::Value& value) {
    if (!point.isTimed()) return;
    value["graph"] = point.graph.string();
    value["skip"] = point.skip;
    value["settings"] = Json::arrayValue;
    for (const std::string& setting : point.settings) value["settings"].append(setting);
    value["wallMs"] = toJson(runtime::timeStatistics(point.wallMs));
    for (const double time : point.wallMs) value["wallMsByRound"].append(time);
    if (point.ratioToBaseline) value["ratioToBaseline"] = *point.ratioToBaseline;
    value["passes"] = Json::arrayValue;
    for (const PassResult& pass : point.passes) value["passes"].append(toJson(pass));
}

Json::Value asJson(const PointResult& point) {
    Json::Value value;
    value["name"] = point.name;
    value["method"] = point.method;
    value["parameters"] = Json::objectValue;
    for (const auto& [parameter, text] : point.parameters) value["parameters"][parameter] = text;
    addTimes(point, value);
    value["comparisons"] = Json::arrayValue;
    for (const ComparisonResult& comparison : point.comparisons)
        value["comparisons"].append(asJson(comparison));
    return value;
}

Json::Value asJson(const SceneResult& scene) {
    Json::Value value;
    value["name"] = scene.name;
    value["scene"] = scene.file.string();
    value["bins"] = scene.bins;
    value["references"] = Json::arrayValue;
    for (const ReferenceResult& reference : scene.references) value["references"].append(asJson(reference));
    value["points"] = Json::arrayValue;
    for (const PointResult& point : scene.points) value["points"].append(asJson(point));
    value["rounds"] = Json::arrayValue;
    for (const auto& round : scene.rounds) {
        Json::Value order = Json::arrayValue;
        for (const std::uint32_t point : round) order.append(point);
        value["rounds"].append(std::move(order));
    }
    return value;
}

}  // namespace

std::string resultsAsJson(const SuiteResult& result) {
    Json::Value value;
    value["suite"] = result.suite;
    value["device"] = result.device;
    value["driver"] = result.driver;
    value["commit"] = result.commit;
    value["width"] = result.width;
    value["height"] = result.height;
    value["frames"] = result.frames;
    value["warmup"] = result.warmup;
    if (!result.baseline.empty()) value["baseline"] = result.baseline;
    value["scenes"] = Json::arrayValue;
    for (const SceneResult& scene : result.scenes) value["scenes"].append(asJson(scene));
    value["leftOut"] = Json::arrayValue;
    for (const LeftOutScene& scene : result.leftOut) {
        Json::Value entry;
        entry["name"] = scene.name;
        entry["why"] = scene.why;
        value["leftOut"].append(std::move(entry));
    }
    Json::StreamWriterBuilder builder;
    builder["indentation"] = "  ";
    builder["precision"] = 17;
    return Json::writeString(builder, value) + "\n";
}

}  // namespace nephrite::pareto
