// See source_lines.h.
#include "text/source_lines.h"

#include <algorithm>

#include "text/json_scan.h"

namespace nephrite::json {

std::vector<std::size_t> lineStartsOf(std::string_view text) {
    std::vector<std::size_t> starts{0};
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool carriageReturn = text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n');
        if (text[i] == '\n' || carriageReturn) starts.push_back(i + 1);
    }
    return starts;
}

SourceLocation locate(const Document& document, std::size_t offset) {
    const auto& starts = document.lineStarts;
    const auto next = std::upper_bound(starts.begin(), starts.end(), offset);
    const auto line = static_cast<std::size_t>(next - starts.begin());
    std::size_t start = starts[line - 1];
    if (line == 1) start = std::min(byteOrderMarkLength(document.text), offset);
    return {document.file, static_cast<std::uint32_t>(line), static_cast<std::uint32_t>(offset - start + 1)};
}

}  // namespace nephrite::json
