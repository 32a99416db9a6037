// Results as comma-separated values. What was not measured is an empty field.
#include <fmt/format.h>

#include <cmath>

#include "pareto/csv.h"
#include "pareto/report.h"
#include "truth/reference_run.h"

namespace nephrite::pareto {
namespace {

void addColors(const std::array<double, 3>& channels, CsvLine& line) {
    line.add(channels[0], channels[1], channels[2]);
}

std::string parametersOf(const PointResult& point) {
    std::string text;
    for (const auto& [parameter, value] : point.parameters)
        text += fmt::format("{}{}={}", text.empty() ? "" : " ", parameter, value);
    return text;
}

void addRun(const SuiteResult& result, CsvLine& line) {
    line.add(result.device, result.driver, result.commit, std::to_string(result.width),
             std::to_string(result.height), std::to_string(result.frames));
}

void addPoint(const SceneResult& scene, const PointResult& point, CsvLine& line) {
    line.add(scene.name, point.method, parametersOf(point));
    if (!point.isTimed()) return line.addEmpty(5);
    const runtime::TimeStatistics times = runtime::timeStatistics(point.wallMs);
    line.add(std::string(point.skip ? "true" : "false"), times.median, times.p95, times.min);
    if (point.ratioToBaseline)
        line.add(*point.ratioToBaseline);
    else
        line.addEmpty(1);
}

constexpr std::size_t comparisonFields = 22;

void addComparison(const ComparisonResult& comparison, CsvLine& line) {
    const image::Metrics& metrics = comparison.metrics;
    line.add(std::string(name(comparison.reference)), comparison.port,
             std::string(comparison.isOnFront ? "true" : "false"), comparison.error(), metrics.rmse,
             metrics.mae);
    addColors(metrics.relRmse, line);
    line.add(metrics.relMse, metrics.psnr, metrics.flip ? metrics.flip->mean : std::nan(""), metrics.maxAbs);
    addColors(metrics.meanRatio, line);
    line.add(std::to_string(metrics.nonFinite), std::to_string(metrics.litPixels));
    if (!metrics.unbiased) return line.addEmpty(4);
    line.add(metrics.unbiased->mse);
    addColors(metrics.unbiased->relRmse, line);
}

}  // namespace

std::string resultsAsCsv(const SuiteResult& result) {
    std::string text =
        "device,driver,commit,width,height,frames,scene,method,parameters,skip,frameMedianMs,frameP95Ms,"
        "frameMinMs,ratioToBaseline,reference,port,onFront,error,rmse,mae,relRMSE.R,relRMSE.G,relRMSE.B,"
        "relMSE,"
        "psnr,flip,maxAbs,meanRatio.R,meanRatio.G,meanRatio.B,nonFinite,litPixels,unbiasedMSE,"
        "unbiasedRelRMSE.R,unbiasedRelRMSE.G,unbiasedRelRMSE.B\n";
    for (const SceneResult& scene : result.scenes) {
        for (const PointResult& point : scene.points) {
            CsvLine start;
            addRun(result, start);
            addPoint(scene, point, start);
            for (const ComparisonResult& comparison : point.comparisons) {
                CsvLine line = start;
                addComparison(comparison, line);
                text += line.text();
            }
            if (!point.comparisons.empty()) continue;
            start.addEmpty(comparisonFields);
            text += start.text();
        }
    }
    return text;
}

std::string passesAsCsv(const SuiteResult& result) {
    std::string text =
        "device,driver,commit,width,height,frames,scene,method,parameters,pass,gpuMedianMs,gpuP95Ms,gpuMinMs,"
        "cpuMedianMs,cpuP95Ms,cpuMinMs\n";
    for (const SceneResult& scene : result.scenes) {
        for (const PointResult& point : scene.points) {
            for (const PassResult& pass : point.passes) {
                CsvLine line;
                addRun(result, line);
                line.add(scene.name, point.method, parametersOf(point), pass.name, pass.gpuMs.median,
                         pass.gpuMs.p95, pass.gpuMs.min, pass.cpuMs.median, pass.cpuMs.p95, pass.cpuMs.min);
                text += line.text();
            }
        }
    }
    return text;
}

}  // namespace nephrite::pareto
