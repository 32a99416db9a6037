// Results as a script for gnuplot.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "pareto/plot_panels.h"
#include "pareto/report.h"

namespace nephrite::pareto {
namespace {

// Pixels of a panel, and about how much of it axes and titles take.
constexpr int panelWidth = 440;
constexpr int panelHeight = 340;
constexpr int panelsAcross = 2;
constexpr int titleHeight = 70;
constexpr PanelMetrics metrics{panelWidth - 75, panelHeight - 85, 6.5, 14};

/// Colours that remain apart for most who cannot tell red from green (Okabe and Ito 2008).
constexpr std::array colors{"#d55e00", "#009e73", "#0072b2", "#cc79a7", "#e69f00", "#56b4e9", "#4d4d4d"};

/// Between double quotes of a gnuplot script, where no letter may command.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char letter : text) {
        if (letter == '"' || letter == '\\') result += '\\';
        result += letter == '\n' ? ' ' : letter;
    }
    return result + "\"";
}

std::string tics(const Axis& axis) {
    std::string list;
    for (const double value : axis.tics()) list += fmt::format("{}{:.6g}", list.empty() ? "" : ", ", value);
    return "(" + list + ")";
}

std::string label(const Mark& mark) {
    const bool isRight =
        mark.labelPlace == LabelPlace::RightAbove || mark.labelPlace == LabelPlace::RightBelow;
    const bool isAbove =
        mark.labelPlace == LabelPlace::RightAbove || mark.labelPlace == LabelPlace::LeftAbove;
    return fmt::format("set label {} at {:.6g},{:.6g} {} offset {},{} noenhanced tc lt {}\n",
                       quoted(mark.label), mark.error, mark.time, isRight ? "left" : "right",
                       isRight ? 0.7 : -0.7, isAbove ? 0.5 : -0.5, mark.method);
}

/// A method without a time is a line through all of them.
std::string upright(const Mark& mark, const Axis& times) {
    return fmt::format(
        "set arrow from {0:.6g},{1:.6g} to {0:.6g},{2:.6g} nohead dt 3 lw 1.5 lt {3}\n"
        "set label {4} at {0:.6g},{2:.6g} right rotate offset 0.7,-0.3 noenhanced tc lt {3}\n",
        mark.error, times.least, times.greatest, mark.method, quoted(mark.label));
}

/// The points, a block for each method: error, time, colour, filled where on the front.
std::string pointBlock(const Panel& panel) {
    std::string text;
    std::size_t method = 0;
    for (const Mark& mark : panel.marks) {
        if (!mark.isTimed()) continue;
        if (method != 0 && method != mark.method) text += "\n";
        method = mark.method;
        text +=
            fmt::format("{:.6g} {:.6g} {} {}\n", mark.error, mark.time, mark.method, mark.isOnFront ? 7 : 6);
    }
    return text;
}

std::string script(const Panel& panel, std::size_t index) {
    std::string text =
        fmt::format("\n$points{0} << EOD\n{1}EOD\n$front{0} << EOD\n", index, pointBlock(panel));
    for (const auto& [error, time] : frontStair(panel)) text += fmt::format("{:.6g} {:.6g}\n", error, time);
    text += fmt::format("EOD\nset title {}\nset xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\n",
                        quoted(panel.title), panel.errors.least, panel.errors.greatest, panel.times.least,
                        panel.times.greatest);
    text += fmt::format("set xtics {}\nset ytics {}\n", tics(panel.errors), tics(panel.times));
    for (const Mark& mark : panel.marks) text += mark.isTimed() ? label(mark) : upright(mark, panel.times);
    return text + fmt::format(
                      "plot $front{0} with lines lc rgb '#999999' lw 1.5, \\\n"
                      "     $points{0} using 1:2:3 with lines lw 0.5 lc variable, \\\n"
                      "     $points{0} using 1:2:4:3 with points pt variable ps 0.8 lc variable\n"
                      "unset label\nunset arrow\n",
                      index);
}

/// Which numbers the labels of varied points are.
std::string variationsOf(const SuiteResult& result) {
    std::vector<std::string> variations;
    for (const SceneResult& scene : result.scenes) {
        for (const PointResult& point : scene.points) {
            if (point.isFirst) continue;
            std::vector<std::string> parameters;
            for (const auto& entry : point.parameters) parameters.push_back(entry.first);
            std::string text = fmt::format("{} of {}", fmt::join(parameters, ", "), point.method);
            if (std::find(variations.begin(), variations.end(), text) == variations.end())
                variations.push_back(std::move(text));
        }
    }
    return variations.empty() ? "" : fmt::format("Numbers at points: {}", fmt::join(variations, "; "));
}

std::string header(const SuiteResult& result, int across, int down) {
    std::string text =
        "# gnuplot pareto.gp > pareto.svg, or gnuplot -e 'format=\"png\"' pareto.gp > pareto.png\n"
        "if (!exists('format')) format = 'svg'\n";
    text += fmt::format(
        "if (format eq 'png') set terminal pngcairo size {0},{1} font 'sans,9'\n"
        "if (format eq 'svg') set terminal svg size {0},{1} font 'sans,11' background 'white'\n",
        across * panelWidth, down * panelHeight + titleHeight);
    text +=
        "set logscale xy\nset nokey\nset grid lc rgb '#e6e6e6' lt 1\nset border 3\nset tics nomirror\n"
        "set xlabel 'relRMSE of the worst channel, %' offset 0,0.5\nset ylabel 'a frame, ms'\n"
        "set title noenhanced\n";
    for (std::size_t i = 0; i < colors.size(); ++i)
        text += fmt::format("set linetype {} lc rgb '{}'\n", i + 1, colors[i]);
    const std::string title = quoted(fmt::format("{}, {} x {} pixels, commit {}", result.suite, result.width,
                                                 result.height, result.commit)) +
                              R"(."\n".)" + quoted(fmt::format("{}, {}", result.device, result.driver)) +
                              R"(."\n".)" + quoted(variationsOf(result));
    return text +
           fmt::format("set linetype cycle {}\nset multiplot layout {},{} title {} noenhanced font ',11'\n",
                       colors.size(), down, across, title);
}

}  // namespace

std::string resultsAsPlot(const SuiteResult& result) {
    const std::vector<Panel> panels = panelsOf(result, metrics);
    if (panels.empty()) return {};
    const int count = static_cast<int>(panels.size());
    const int across = std::min(panelsAcross, count);
    std::string text = header(result, across, (count + across - 1) / across);
    for (std::size_t i = 0; i < panels.size(); ++i) text += script(panels[i], i);
    return text + "unset multiplot\n";
}

}  // namespace nephrite::pareto
