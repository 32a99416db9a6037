// `node.port`, `import(name)` and what may stand around them: previous(...), mip(..., k), layer(..., k).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "graph/description.h"
#include "graph/value_readers.h"

namespace nephrite::graph {
namespace {

constexpr std::uint32_t mostFramesBack = 64;
constexpr std::uint32_t highestMip = 31;
constexpr std::uint32_t highestLayer = 65534;  // one below what stands for every layer
constexpr std::array<std::string_view, 4> words{"previous", "mip", "layer", "import"};

class ReferenceReader {
  public:
    ReferenceReader(std::string_view text, const SourceLocation& where, Diagnostics& diagnostics)
        : text_(text), where_(where), diagnostics_(diagnostics) {
        reference_.where = where;
    }

    std::optional<PortReference> read() {
        if (!readOpenings() || !readPort() || !readClosings()) return std::nullopt;
        if (at_ == text_.size()) return std::move(reference_);
        return fault(
            at_, fmt::format("expected the end after {}, found {}", inQuotes(text_.substr(0, at_)), found()));
    }

  private:
    enum class Form : std::uint8_t { Previous, Mip, Layer };

    /// `previous(`, `mip(` and `layer(`, as many as there are.
    bool readOpenings() {
        while (true) {
            if (!open_.empty()) skipSpaces();
            const std::size_t start = at_;
            const std::string_view word = text_.substr(at_, text_.find_first_of("(),", at_) - at_);
            const bool isCall = start + word.size() < text_.size() && text_[start + word.size()] == '(';
            if (!isCall || word == "import") return true;
            const auto known = std::find(words.begin(), words.end() - 1, word);
            if (known == words.end() - 1) {
                return refuse(start, fmt::format("expected \"previous\", \"mip\", \"layer\" or \"import\" "
                                                 "before \"(\", found {}{}",
                                                 inQuotes(word), suggestion(word, words)));
            }
            if (!mayOpen(static_cast<Form>(known - words.begin()), start)) return false;
            at_ = start + word.size() + 1;
        }
    }

    bool mayOpen(Form form, std::size_t start) {
        const auto count = static_cast<std::uint32_t>(std::count(open_.begin(), open_.end(), form));
        if (form == Form::Previous && count == mostFramesBack) return tooFarBack(start, count + 1);
        if (form != Form::Previous && count > 0) {
            return refuse(start,
                          fmt::format("{}(...) stands here twice", words[static_cast<std::size_t>(form)]));
        }
        open_.push_back(form);
        return true;
    }

    bool tooFarBack(std::size_t offset, std::uint32_t frames) {
        return refuse(
            offset, fmt::format("previous(...) goes back 1 to {} frames, found {}", mostFramesBack, frames));
    }

    bool readPort() {
        const std::size_t start = at_;
        std::string_view port = text_.substr(at_, text_.find_first_of("(),", at_) - at_);
        if (port == "import" && text_.substr(start + port.size(), 1) == "(") return readImport(start);
        if (!open_.empty()) port = port.substr(0, port.find_last_not_of(' ') + 1);
        const std::size_t dot = port.find('.');
        const bool wellFormed = dot != std::string_view::npos && isIdentifier(port.substr(0, dot), true) &&
                                isIdentifier(port.substr(dot + 1));
        if (!wellFormed) {
            return refuse(start, fmt::format("expected a \"node.port\", found {}",
                                             open_.empty() ? inQuotes(text_) : found(port)));
        }
        at_ += port.size();
        reference_.node = port.substr(0, dot);
        reference_.port = port.substr(dot + 1);
        return true;
    }

    bool readImport(std::size_t start) {
        at_ = start + std::string_view("import(").size();
        skipSpaces();
        const std::size_t nameStart = at_;
        std::string_view name = text_.substr(at_, text_.find_first_of("(),", at_) - at_);
        name = name.substr(0, name.find_last_not_of(' ') + 1);
        if (!isIdentifier(name, true)) {
            return refuse(nameStart, fmt::format("expected an import's name, found {}", found(name)));
        }
        at_ += name.size();
        reference_.node = fmt::format("import({})", name);
        reference_.port = "image";
        return close();
    }

    /// The numbers and parentheses that end what readOpenings() found, the innermost first.
    bool readClosings() {
        while (!open_.empty()) {
            const Form form = open_.back();
            open_.pop_back();
            if (form == Form::Previous) {
                if (!readFrames()) return false;
            } else if (!readIndex(form)) {
                return false;
            }
            if (!close()) return false;
        }
        return true;
    }

    bool readFrames() {
        std::uint32_t frames = 1;
        const std::size_t start = at_;
        if (comma() && !readNumber("how many frames", frames)) return false;
        reference_.framesBack += std::min(frames, mostFramesBack + 1);
        if (frames > 0 && reference_.framesBack <= mostFramesBack) return true;
        return tooFarBack(frames == 1 ? start : numberAt_, frames == 0 ? 0 : reference_.framesBack);
    }

    bool readIndex(Form form) {
        const bool isMip = form == Form::Mip;
        const std::string_view what = isMip ? "a mip level's number" : "an array layer's number";
        if (!comma()) return refuse(at_, fmt::format("expected \",\" and {}, found {}", what, found()));
        std::uint32_t index = 0;
        if (!readNumber(what, index)) return false;
        const std::uint32_t highest = isMip ? highestMip : highestLayer;
        if (index > highest) {
            return refuse(numberAt_, fmt::format("{} is from 0 to {}, found {}", what, highest, index));
        }
        (isMip ? reference_.mip : reference_.layer) = index;
        return true;
    }

    bool readNumber(std::string_view what, std::uint32_t& number) {
        skipSpaces();
        numberAt_ = at_;
        const char* start = text_.data() + at_;
        const auto [end, error] = std::from_chars(start, text_.data() + text_.size(), number);
        const bool isInteger = end == text_.data() + text_.size() || *end == ' ' || *end == ')';
        if (error != std::errc() || !isInteger) {
            return refuse(at_, fmt::format("expected {}, found {}", what, found()));
        }
        at_ += static_cast<std::size_t>(end - start);
        return true;
    }

    bool comma() {
        skipSpaces();
        if (text_.substr(at_, 1) != ",") return false;
        ++at_;
        return true;
    }

    bool close() {
        skipSpaces();
        if (text_.substr(at_, 1) != ")") {
            return refuse(at_, fmt::format("expected \")\", found {}", found()));
        }
        ++at_;
        return true;
    }

    void skipSpaces() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    }

    /// What stands here, for "found ...".
    std::string found() const {
        if (at_ >= text_.size()) return "the end";
        const bool isMark = std::string_view("(),").find(text_[at_]) != std::string_view::npos;
        return inQuotes(text_.substr(at_, isMark ? 1 : text_.find_first_of("(), ", at_) - at_));
    }
    std::string found(std::string_view word) const { return word.empty() ? found() : inQuotes(word); }

    /// Adds the fault that stands at a byte of the text. A text in a JSON file starts after its quote.
    bool refuse(std::size_t offset, std::string message) {
        SourceLocation place = where_;
        if (place.line != 0 && offset > 0) place.column += static_cast<std::uint32_t>(offset) + 1;
        diagnostics_.error(std::move(place), std::move(message));
        return false;
    }
    std::nullopt_t fault(std::size_t offset, std::string message) {
        refuse(offset, std::move(message));
        return std::nullopt;
    }

    std::string_view text_;
    const SourceLocation& where_;
    Diagnostics& diagnostics_;
    PortReference reference_;
    std::vector<Form> open_;
    std::size_t at_ = 0;
    std::size_t numberAt_ = 0;  ///< where the number read last starts
};

}  // namespace

std::optional<PortReference> readPortReference(const std::string& text, const SourceLocation& where,
                                               Diagnostics& diagnostics) {
    return ReferenceReader(text, where, diagnostics).read();
}

std::string toText(const PortReference& reference) {
    const bool isImport = reference.node.find('(') != std::string::npos;
    std::string text = isImport ? reference.node : fmt::format("{}.{}", reference.node, reference.port);
    if (reference.mip) text = fmt::format("mip({}, {})", text, *reference.mip);
    if (reference.layer) text = fmt::format("layer({}, {})", text, *reference.layer);
    if (reference.framesBack == 1) return fmt::format("previous({})", text);
    return reference.framesBack == 0 ? text : fmt::format("previous({}, {})", text, reference.framesBack);
}

}  // namespace nephrite::graph
