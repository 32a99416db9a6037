// The JSON of a plan's page, but for its nodes (page_nodes.cpp).
#include "graph/page_data.h"

#include <json/writer.h>

#include <algorithm>
#include <map>

#include "graph/plan_page.h"
#include "graph/plan_words.h"

namespace nephrite::graph {
namespace {

Json::Value resourceAsJson(const Plan& plan, const Resource& resource) {
    Json::Value json;
    json["name"] = plan.nameOf(resource);
    json["format"] = formatName(plan, resource);
    json["size"] = sizeInWords(resource);
    json["bytes"] = resource.bytes;
    json["place"] = placeInWords(resource);
    json["isBuffer"] = resource.isBuffer;
    json["layers"] = resource.layers;
    json["mips"] = resource.mips;
    if (resource.offset != Resource::noOffset) json["offset"] = resource.offset;
    if (resource.first != noIndex) {
        json["first"] = resource.first;
        json["last"] = resource.last;
    }
    json["writers"] = Json::arrayValue;
    json["readers"] = Json::arrayValue;
    return json;
}

Json::Value barrierAsJson(const Plan& plan, const Barrier& barrier) {
    Json::Value json;
    json["resource"] = barrier.resource;
    json["part"] = partInWords(plan, barrier);
    json["from"] = usesInWords(barrier.usesBefore);
    json["to"] = barrier.usesAfter == 0 ? "the next frame" : usesInWords(barrier.usesAfter);
    if (!plan.resources[barrier.resource].isBuffer) {
        json["oldLayout"] = std::string(name(barrier.oldLayout));
        json["newLayout"] = std::string(name(barrier.newLayout));
    }
    json["why"] = protectionInWords(plan, barrier);
    return json;
}

/// `pass`: before which one; null: before the copies out. `point` says which batch point of that pass.
void addBatch(const Plan& plan, Index batch, Json::Value pass, std::string_view point, Json::Value& batches) {
    const Range range = plan.schedule.batches[batch];
    if (range.count == 0) return;
    Json::Value json;
    json["pass"] = std::move(pass);
    json["point"] = std::string(point);
    for (const Barrier& barrier : slice(plan.schedule.barriers, range))
        json["barriers"].append(barrierAsJson(plan, barrier));
    batches.append(std::move(json));
}

std::string pointInWords(const PlannedPass& pass, Index batch) {
    if (pass.clearsFirst && batch == 0) return "before it clears its outputs";
    if (pass.forEach != ForEach::Mips || pass.iterations == 0) return "";
    return "before level " + std::to_string(batch - (pass.clearsFirst ? 1 : 0));
}

Json::Value summaryAsJson(const Plan& plan) {
    Json::Value json;
    json["graph"] = plan.graph->description.name;
    json["width"] = plan.view.width;
    json["height"] = plan.view.height;
    json["policy"] = std::string(name(plan.policy));
    json["heapBytes"] = plan.heapBytes;
    json["naiveBytes"] = plan.naiveBytes;
    json["peakLiveBytes"] = plan.peakLiveBytes;
    json["barriers"] = static_cast<Json::UInt64>(plan.schedule.barriers.size());
    json["barrierBatches"] = plan.schedule.batchCount;
    json["naiveBarriers"] = plan.naiveBarriers;
    return json;
}

bool isSame(const Point& a, const Point& b) {
    return a.x == b.x && a.y == b.y;
}

/// By edge: the edge before it that leaves the same port, or noIndex.
std::vector<Index> edgesBefore(const GraphDrawing& drawing) {
    std::vector<Index> before;
    std::map<std::pair<Index, Index>, Index> lastOfPort;
    for (Index i = 0; i < drawing.edges.size(); ++i) {
        const DrawnEdge& edge = drawing.edges[i];
        const auto [last, isFirst] = lastOfPort.try_emplace({edge.from, edge.output}, i);
        before.push_back(isFirst ? noIndex : last->second);
        last->second = i;
    }
    return before;
}

/// Edges of one port start alike, often for most of their length: "along" names the one before and "shared"
/// how many points are taken from it.
void addCurve(const GraphDrawing& drawing, Index index, Index before, Json::Value& json) {
    const std::vector<Point>& curve = drawing.edges[index].curve;
    auto own = curve.begin();
    if (before != noIndex) {
        const std::vector<Point>& other = drawing.edges[before].curve;
        own = std::mismatch(curve.begin(), curve.end(), other.begin(), other.end(), isSame).first;
        json["along"] = before;
        json["shared"] = static_cast<Json::UInt64>(own - curve.begin());
    }
    json["curve"] = Json::arrayValue;
    for (; own != curve.end(); ++own) {
        json["curve"].append(own->x);
        json["curve"].append(own->y);
    }
}

std::vector<bool> portsWithPictures(const PlanMeasurements& measurements) {
    std::vector<bool> ports;
    for (const PortPicture& picture : measurements.pictures) ports.push_back(!picture.png.empty());
    return ports;
}

/// JSON holds "<" only inside strings, where it may be written otherwise; then no "</script" or "<!--" ends
/// the element around it.
std::string withoutLessThan(const std::string& json) {
    std::string safe;
    safe.reserve(json.size());
    for (const char c : json) {
        if (c == '<')
            safe += "\\u003c";
        else
            safe += c;
    }
    return safe;
}

}  // namespace

Json::Value edgesAsJson(const PageSource& source) {
    Json::Value edges(Json::arrayValue);
    const std::vector<Index> before = edgesBefore(source.drawing);
    for (Index i = 0; i < source.drawing.edges.size(); ++i) {
        const DrawnEdge& edge = source.drawing.edges[i];
        Json::Value json;
        json["from"] = edge.from;
        json["to"] = edge.to;
        json["output"] = edge.output;
        json["input"] = edge.input;
        json["kind"] = std::string(name(edge.kind));
        if (edge.resource != noIndex) json["resource"] = edge.resource;
        json["label"] = edge.label;
        addCurve(source.drawing, i, before[i], json);
        json["labelStart"].append(edge.labelStart.x);
        json["labelStart"].append(edge.labelStart.y);
        edges.append(std::move(json));
    }
    return edges;
}

Json::Value resourcesAsJson(const PageSource& source) {
    Json::Value resources(Json::arrayValue);
    for (const Resource& resource : source.plan.resources)
        resources.append(resourceAsJson(source.plan, resource));
    for (Index i = 0; i < source.drawing.nodes.size(); ++i) {
        const Index node = source.drawing.nodes[i].node;
        if (node == noIndex || source.passes[node] == noIndex) continue;
        const PlannedPass& pass = source.plan.passes[source.passes[node]];
        for (const Index output : slice(source.plan.outputs, pass.outputs))
            resources[output]["writers"].append(i);
        for (const InputRead& read : slice(source.plan.inputs, pass.inputs))
            if (read.resource != noIndex) resources[read.resource]["readers"].append(i);
        if (pass.tileList != noIndex) resources[pass.tileList]["readers"].append(i);
    }
    return resources;
}

Json::Value batchesAsJson(const PageSource& source) {
    const Plan& plan = source.plan;
    Json::Value batches(Json::arrayValue);
    for (Index i = 0; i < plan.passes.size(); ++i) {
        const PlannedPass& pass = plan.passes[i];
        for (Index batch = 0; batch < pass.batchCount(); ++batch)
            addBatch(plan, pass.firstBatch + batch, i, pointInWords(pass, batch), batches);
    }
    addBatch(plan, static_cast<Index>(plan.schedule.batches.size() - 1), Json::nullValue, "", batches);
    return batches;
}

std::string planPageData(const Plan& plan, const PlanMeasurements& measurements) {
    DrawingStyle style;
    style.pictures = portsWithPictures(measurements);
    const GraphDrawing drawing = drawGraph(plan, style);
    const PageSource source{plan, measurements, drawing, passOfNode(plan)};
    Json::Value json = summaryAsJson(plan);
    json["device"] = measurements.device;
    json["note"] = measurements.note;
    json["frames"] = measurements.frames;
    json["frameMs"] = measurements.frameMs;
    json["drawing"]["width"] = drawing.width;
    json["drawing"]["height"] = drawing.height;
    json["nodes"] = nodesAsJson(source);
    json["edges"] = edgesAsJson(source);
    json["resources"] = resourcesAsJson(source);
    json["batches"] = batchesAsJson(source);
    Json::StreamWriterBuilder writer;
    writer["indentation"] = "";
    writer["precision"] = 6;
    return withoutLessThan(Json::writeString(writer, json));
}

}  // namespace nephrite::graph
