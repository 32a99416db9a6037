// Counting through choices.
#include "pareto/combinations.h"

namespace nephrite::pareto {

std::vector<std::vector<std::size_t>> combinations(std::span<const std::size_t> lengths) {
    std::vector<std::vector<std::size_t>> all{{}};
    for (const std::size_t length : lengths) {
        std::vector<std::vector<std::size_t>> longer;
        for (const std::vector<std::size_t>& choice : all)
            for (std::size_t i = 0; i < length; ++i) {
                longer.push_back(choice);
                longer.back().push_back(i);
            }
        all = std::move(longer);
    }
    return all;
}

}  // namespace nephrite::pareto
