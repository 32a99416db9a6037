// See json_patch.h. Commas are found in the text without its comments, lines and spaces in the text itself.
#include "text/json_patch.h"

#include <fmt/format.h>
#include <json/writer.h>

#include <algorithm>
#include <optional>

#include "text/json_scan.h"

namespace nephrite::json {
namespace {

constexpr std::string_view blanks = " \t";
constexpr std::string_view lineEnds = "\r\n";
constexpr std::string_view spaces = " \t\r\n";

/// The line break and the indentation in front of what starts a line.
struct LineStart {
    std::size_t breakAt = 0;  ///< first byte of the line break
    std::string text;         ///< line break and indentation
};

class Layout {
  public:
    explicit Layout(std::string_view text) : text_(text), bare_(scan(text).bare) {}

    /// The byte after spaces, tabs and, if asked for, line breaks.
    std::size_t skip(std::size_t at, std::string_view what) const {
        return std::min(text_.find_first_not_of(what, at), text_.size());
    }
    /// The first of the spaces and tabs that end at `at`.
    std::size_t skipBack(std::size_t at) const {
        while (at > 0 && blanks.find(text_[at - 1]) != std::string_view::npos) --at;
        return at;
    }
    char charAt(std::size_t at) const { return at < text_.size() ? text_[at] : '\0'; }
    bool isAtLineEnd(std::size_t at) const {
        return at >= text_.size() || lineEnds.find(text_[at]) != std::string_view::npos;
    }

    /// The comma that comes next after a value, comments in between left out.
    std::optional<std::size_t> commaAfter(std::size_t at) const {
        const std::size_t next = bare_.find_first_not_of(spaces, at);
        if (next == std::string::npos || bare_[next] != ',') return std::nullopt;
        return next;
    }
    std::optional<std::size_t> commaBefore(std::size_t at) const {
        const std::size_t last = at == 0 ? std::string::npos : bare_.find_last_not_of(spaces, at - 1);
        if (last == std::string::npos || bare_[last] != ',') return std::nullopt;
        return last;
    }

    /// Nothing unless only spaces and tabs stand before `at` in its line.
    std::optional<LineStart> lineStartBefore(std::size_t at) const {
        const std::size_t indent = skipBack(at);
        if (indent == 0 || !isAtLineEnd(indent - 1)) return std::nullopt;
        std::size_t start = indent - 1;
        if (start > 0 && text_[start] == '\n' && text_[start - 1] == '\r') --start;
        return LineStart{start, std::string(text_.substr(start, at - start))};
    }

    /// The end of the comments that start in the same line as `at`, with only spaces and tabs before them.
    std::size_t behindComments(std::size_t at) const {
        for (;;) {
            const std::size_t next = skip(at, blanks);
            if (charAt(next) != '/') return at;
            if (charAt(next + 1) == '/') return std::min(text_.find_first_of(lineEnds, next), text_.size());
            at = text_.find("*/", next + 2) + 2;
        }
    }

    /// Whether the text before `at`, spaces and tabs aside, is a comment's.
    bool endsInComment(std::size_t at) const {
        const std::size_t end = skipBack(at);
        return end > 0 && bare_[end - 1] != text_[end - 1];
    }

  private:
    std::string_view text_;
    std::string bare_;
};

/// [from, to) of a member that stands first in its line, with what would be left of the line.
Patch withoutLine(const Layout& layout, std::size_t from, std::size_t to, std::size_t lineBreak) {
    const std::size_t rest = layout.skip(to, blanks);
    const bool closes = layout.charAt(rest) == '}' && !layout.endsInComment(lineBreak);
    if (layout.isAtLineEnd(rest) || closes) return {lineBreak, rest, ""};
    return {from, rest, ""};
}

/// [from, to) of a member amid a line, with the spaces on one side of it.
Patch withoutSpaces(const Layout& layout, std::size_t from, std::size_t to) {
    const std::size_t rest = layout.skip(to, blanks);
    const bool closes = rest == to && layout.charAt(to) == '}';
    if (layout.isAtLineEnd(rest) || closes) return {layout.skipBack(from), to, ""};
    return {from, rest, ""};
}

}  // namespace

std::string jsonString(std::string_view text) {
    Json::StreamWriterBuilder builder;
    builder["emitUTF8"] = true;
    return Json::writeString(builder, Json::Value(std::string(text)));
}

std::string patched(std::string_view text, std::vector<Patch> patches) {
    std::stable_sort(patches.begin(), patches.end(),
                     [](const Patch& a, const Patch& b) { return a.from < b.from; });
    std::string result;
    std::size_t done = 0;
    for (const Patch& patch : patches) {
        result += text.substr(done, patch.from - done);
        result += patch.text;
        done = patch.to;
    }
    result += text.substr(done);
    return result;
}

std::vector<Patch> memberAdded(const Value& object, std::string_view key, std::string_view value) {
    const Layout layout(object.document().text);
    const std::string member = fmt::format("{}: {}", jsonString(key), value);
    const auto members = object.members();
    if (members.empty()) {
        const std::size_t at = object.start() + 1;
        return {{at, at, member + (layout.charAt(at) == '/' ? " " : "")}};
    }
    const Value& last = members.back().second;
    const std::optional<std::size_t> comma = layout.commaAfter(last.end());
    const std::size_t behind = comma ? *comma + 1 : last.end();
    const std::optional<LineStart> line = layout.lineStartBefore(last.keyStart());
    if (!line) return {{behind, behind, comma ? " " + member + "," : ", " + member}};
    const std::size_t at = layout.behindComments(behind);
    if (comma) return {{at, at, line->text + member + ","}};
    return {{behind, behind, ","}, {at, at, line->text + member}};
}

std::vector<Patch> memberRemoved(const Value& member) {
    const Layout layout(member.document().text);
    const std::size_t from = member.keyStart();
    std::size_t to = member.end();
    std::vector<Patch> patches;
    if (const auto comma = layout.commaAfter(to)) {
        if (layout.skip(to, spaces) == *comma) {
            to = *comma + 1;
        } else {
            patches.push_back({*comma, *comma + 1, ""});  // a comment stands before it
        }
    } else if (const auto before = layout.commaBefore(from)) {
        if (layout.skip(*before + 1, blanks) == from) return {{*before, to, ""}};
        patches.push_back({*before, *before + 1, ""});
    }
    const std::optional<LineStart> line = layout.lineStartBefore(from);
    patches.push_back(line ? withoutLine(layout, from, to, line->breakAt) : withoutSpaces(layout, from, to));
    return patches;
}

}  // namespace nephrite::json
