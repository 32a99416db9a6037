// What a plot shows of a suite's results: panels of points with their axes, before anything is drawn.
#pragma once

#include <string>
#include <vector>

#include "pareto/label_places.h"
#include "pareto/results.h"

namespace nephrite::pareto {

/// A point of a panel.
struct Mark {
    std::string label;
    std::size_t method = 0;  ///< its number in the scene from 1, which decides its colour
    double error = 0;        ///< percent
    double time = 0;         ///< ms; 0: a sum of references, which has none
    bool isOnFront = false;
    LabelPlace labelPlace = LabelPlace::RightAbove;

    bool isTimed() const { return time > 0; }
};

/// Ends of a logarithmic axis.
struct Axis {
    double least = 0;
    double greatest = 0;

    /// Values of round numbers: 1, 2 and 5 of every decade, fewer where there are many decades.
    std::vector<double> tics() const;
};

/// A scene held against a reference.
struct Panel {
    std::string title;
    std::vector<Mark> marks;  ///< by method, then by time
    Axis errors;
    Axis times;
};

/// Size of a panel's plotting area, of a letter and of a line of text, in pixels.
struct PanelMetrics {
    double width = 0;
    double height = 0;
    double letterWidth = 0;
    double lineHeight = 0;
};

/// The panels of all scenes that have a timed point with an error above 0 and finite; other points are left
/// out.
std::vector<Panel> panelsOf(const SuiteResult& result, const PanelMetrics& metrics);

/// The corners (error, time) of the stair below and left of which no point lies: from the panel's top along
/// the front to its right edge.
std::vector<std::pair<double, double>> frontStair(const Panel& panel);

}  // namespace nephrite::pareto
