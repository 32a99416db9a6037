// See plan_page.h.
#include "graph/plan_page.h"

#include "graph/page_template.h"

namespace nephrite::graph {

std::string planAsHtml(const Plan& plan, const PlanMeasurements& measurements) {
    constexpr std::string_view marker = "{{data}}";
    std::string page(pageTemplate());
    return page.replace(page.find(marker), marker.size(), planPageData(plan, measurements));
}

}  // namespace nephrite::graph
