// See random_json.h.
#include "text/random_json.h"

#include <array>

namespace nephrite::json::tests {
namespace {

class Writer {
  public:
    explicit Writer(Random& random) : random_(random), newline_(oneIn(random, 4) ? "\r\n" : "\n") {}

    std::string document() {
        if (oneIn(random_, 8)) text_ += "\xEF\xBB\xBF";
        space();
        object(0);
        space();
        return text_;
    }

  private:
    bool once(unsigned n) { return oneIn(random_, n); }

    /// Spaces, line breaks, comments or nothing.
    void space() {
        while (once(3)) {
            const unsigned kind = below(random_, 5);
            if (kind == 0) text_ += "// line, \"" + std::to_string(serial_++) + "\": {" + newline_;
            if (kind == 1) text_ += "/* block, " + std::to_string(serial_++) + " } */";
            if (kind == 2) text_ += newline_ + std::string(below(random_, 5), ' ');
            if (kind >= 3) text_ += kind == 3 ? " " : "\t";
        }
    }

    void value(int depth) {
        const unsigned kind = below(random_, depth > 3 ? 3 : 5);
        if (kind == 3) return object(depth + 1);
        if (kind == 4) return array(depth + 1);
        static constexpr std::array<const char*, 8> words{"1",    "-0.50", "true",       "null",
                                                          "2e-7", "\"\"",  "\"a // b\"", "\"\\u0041,}\""};
        text_ += words[below(random_, words.size())];
    }

    void object(int depth) {
        list('{', '}', [&](unsigned i) {
            text_ += "\"" + std::string(once(5) ? "\\u006b" : "k") + std::to_string(i) + "\"";
            space();
            text_ += ':';
            space();
            value(depth);
        });
    }

    void array(int depth) {
        list('[', ']', [&](unsigned) { value(depth); });
    }

    /// In one of three layouts: a member a line, all in one line, anything.
    template<class Member>
    void list(char open, char close, Member member) {
        const unsigned layout = below(random_, 3);
        const std::string indent = newline_ + std::string(below(random_, 9), ' ');
        const unsigned count = below(random_, 5);
        text_ += open;
        for (unsigned i = 0; i < count; ++i) {
            if (layout == 0) text_ += indent;
            if (layout == 2) space();
            member(i);
            if (layout == 2) space();
            if (i + 1 < count || once(3)) text_ += layout == 1 ? ", " : ",";
            if (layout == 0 && once(3)) text_ += "  // of " + std::to_string(serial_++) + newline_;
        }
        if (layout == 0 && once(2)) text_ += indent;
        if (layout == 2) space();
        text_ += close;
    }

    Random& random_;
    std::string newline_;
    std::string text_;
    int serial_ = 0;
};

}  // namespace

std::string randomDocument(Random& random) {
    return Writer(random).document();
}

std::string randomValue(Random& random) {
    static constexpr std::array<const char*, 7> values{
        "3.25", "false", "\"new\"", "[]", "[7, 8]", "{}", "{\"x\": [1, {\"y\": 2}]}"};
    return values[below(random, values.size())];
}

std::vector<Comment> commentsIn(const std::string& text) {
    std::vector<Comment> comments;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == '"') {
            for (++at; text[at] != '"'; ++at) at += text[at] == '\\' ? 1 : 0;
        } else if (text.compare(at, 2, "//") == 0) {
            const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
            comments.push_back({at, text.substr(at, end - at)});
            at = end;
        } else if (text.compare(at, 2, "/*") == 0) {
            const std::size_t end = text.find("*/", at + 2) + 2;
            comments.push_back({at, text.substr(at, end - at)});
            at = end - 1;
        }
    }
    return comments;
}

std::vector<Path> pathsOf(const Value& root) {
    std::vector<Path> paths;
    std::vector<std::pair<Path, Value>> pending{{{}, root}};
    const auto follow = [&](const Path& parent, const std::string& step, const Value& child) {
        Path path = parent;
        path.push_back(step);
        paths.push_back(path);
        pending.emplace_back(std::move(path), child);
    };
    while (!pending.empty()) {
        const auto [path, value] = pending.back();
        pending.pop_back();
        for (const auto& [key, member] : value.members()) follow(path, key, member);
        for (std::size_t i = 0; value.isArray() && i < value.size(); ++i)
            follow(path, std::to_string(i), value.at(i));
    }
    return paths;
}

std::string squeezed(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c != ' ' && c != '\t' && c != '\r' && c != '\n' && c != ',') result += c;
    }
    return result;
}

}  // namespace nephrite::json::tests
