// Writes metrics down, for programs and for people.
#include "image/metrics/metrics_report.h"

#include <fmt/format.h>

#include <cmath>

namespace nephrite::image {
namespace {

Json::Value numberOrNull(double value) {
    return std::isfinite(value) ? Json::Value(value) : Json::Value();
}

Json::Value toJson(const std::array<double, 3>& perChannel) {
    Json::Value array = Json::arrayValue;
    for (const double value : perChannel) array.append(numberOrNull(value));
    return array;
}

std::string numberOrDash(double value) {
    return std::isnan(value) ? "-" : fmt::format("{:.5g}", value);
}

std::string line(std::string_view name, const std::array<double, 3>& perChannel) {
    return fmt::format("{:<18}{:>13}{:>13}{:>13}\n", name, numberOrDash(perChannel[0]),
                       numberOrDash(perChannel[1]), numberOrDash(perChannel[2]));
}

std::string line(std::string_view name, double value, std::string_view remark = {}) {
    return fmt::format("{:<18}{:>13}{}{}\n", name, numberOrDash(value), remark.empty() ? "" : "  ", remark);
}

std::string flipRemark(const FlipError& flip) {
    return fmt::format("HDR-FLIP, ACES tone map, {} exposures from 2^{:.3f} to 2^{:.3f}", flip.exposures,
                       flip.startExposure, flip.stopExposure);
}

}  // namespace

Json::Value toJson(const Metrics& metrics) {
    Json::Value json;
    json["rmse"] = numberOrNull(metrics.rmse);
    json["mae"] = numberOrNull(metrics.mae);
    json["relRMSE"] = toJson(metrics.relRmse);
    json["relMSE"] = numberOrNull(metrics.relMse);
    json["psnr"] = numberOrNull(metrics.psnr);
    json["maxAbs"] = numberOrNull(metrics.maxAbs);
    json["nonFinite"] = Json::Value::UInt64{metrics.nonFinite};
    json["meanRatio"] = toJson(metrics.meanRatio);
    json["litPixels"] = Json::Value::UInt64{metrics.litPixels};
    if (metrics.flip) {
        json["flip"] = numberOrNull(metrics.flip->mean);
        json["flipVariant"] = "HDR";
        json["flipToneMap"] = "ACES";
        json["flipExposures"]["start"] = metrics.flip->startExposure;
        json["flipExposures"]["stop"] = metrics.flip->stopExposure;
        json["flipExposures"]["count"] = metrics.flip->exposures;
    }
    if (metrics.unbiased) {
        json["unbiasedMSE"] = numberOrNull(metrics.unbiased->mse);
        json["unbiasedRelRMSE"] = toJson(metrics.unbiased->relRmse);
    }
    return json;
}

std::string toTable(const Metrics& metrics) {
    std::string text = fmt::format("{:<18}{:>13}{:>13}{:>13}\n", "", "red", "green", "blue");
    text += line("relRMSE", metrics.relRmse);
    if (metrics.unbiased) text += line("unbiased relRMSE", metrics.unbiased->relRmse);
    text += line("mean ratio", metrics.meanRatio);
    text += "\n";
    text += line("RMSE", metrics.rmse);
    if (metrics.unbiased) text += line("unbiased MSE", metrics.unbiased->mse);
    text += line("MAE", metrics.mae);
    text += line("relMSE", metrics.relMse);
    text += line("PSNR", metrics.psnr, "dB");
    text += line("largest error", metrics.maxAbs);
    if (metrics.flip) text += line("FLIP", metrics.flip->mean, flipRemark(*metrics.flip));
    text += fmt::format("{:<18}{:>13}\n{:<18}{:>13}\n", "lit", metrics.litPixels, "not finite",
                        metrics.nonFinite);
    return text;
}

}  // namespace nephrite::image
