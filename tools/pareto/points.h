// The points of a suite: each method with each combination of the values it varies.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pareto/suite.h"

namespace nephrite::pareto {

/// A method at one combination of values.
struct Point {
    const Method* method = nullptr;
    std::string name;  ///< "screen-space", "screen-space mostTaps=24"
    std::vector<std::pair<std::string, std::string>>
        parameters;                 ///< what it varies, and the value, JSON text
    std::vector<Setting> settings;  ///< all: the method's and the varied
    bool isFirst = true;            ///< the first combination, which stands for the method

    /// The settings as runtime::SessionOptions has them.
    std::vector<std::string> settingTexts() const;
};

/// The points of a method, the last variation changing fastest. It must outlive them.
std::vector<Point> pointsOf(const Method& method);

/// Which scenes and methods are measured: `SCENE/METHOD`, each with the wildcards * and ? of file names;
/// without a slash, all methods of the scenes so named.
class Selection {
  public:
    /// An empty pattern selects everything.
    explicit Selection(std::string_view pattern = {});
    bool has(const SuiteScene& scene, const Method& method) const;

  private:
    std::string pattern_;
};

/// The points of a scene: those selected and, before them, the baseline's if any is timed; of sums of
/// references only those the scene has all of. None if nothing is selected. The suite must outlive them.
std::vector<Point> pointsOf(const Suite& suite, const SuiteScene& scene, const Selection& selection);

/// Whether a point is held against the reference or made of it.
bool needs(const std::vector<Point>& points, truth::Mode reference);

}  // namespace nephrite::pareto
