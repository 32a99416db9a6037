// Text -> json::Value: our own scan of the words, then JsonCpp for the grammar, its faults put into our form.
#include <fmt/format.h>
#include <json/reader.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <string>

#include "text/json.h"
#include "text/json_scan.h"
#include "text/source_lines.h"

namespace nephrite::json {
namespace {

/// The first fault of JsonCpp's report, which reads "* Line 3, Column 8\n  Message\n...".
TextFault firstFault(std::string_view text, const std::vector<std::size_t>& lineStarts,
                     std::string_view report) {
    const auto numberAfter = [&](std::string_view label) {
        std::size_t value = 1;
        const std::size_t at = report.find(label);
        if (at == std::string_view::npos) return value;
        const char* end = report.data() + report.size();
        std::from_chars(report.data() + at + label.size(), end, value);
        return std::max<std::size_t>(value, 1);
    };
    const std::size_t line = std::min(numberAfter("Line "), lineStarts.size());
    const std::size_t offset = std::min(lineStarts[line - 1] + numberAfter("Column ") - 1, text.size());
    const std::size_t start = std::min(report.find("\n  "), report.size());
    const std::size_t end = std::min(report.find('\n', start + 1), report.size());
    return {offset, std::string(report.substr(std::min(start + 3, end), end - std::min(start + 3, end)))};
}

/// JsonCpp's wording turned into ours: what was expected, what was found.
std::string reworded(std::string_view text, const TextFault& fault) {
    const auto says = [&](std::string_view part) { return fault.message.find(part) != std::string::npos; };
    const std::string found = describeTextAt(text, fault.offset);
    if (says("Duplicate key")) {
        const std::size_t close = text.find('"', fault.offset + 1);
        const bool atKey =
            fault.offset < text.size() && text[fault.offset] == '"' && close != std::string_view::npos;
        const std::string_view key =
            atKey ? text.substr(fault.offset + 1, close - fault.offset - 1) : std::string_view();
        return fmt::format("duplicate key {}, this object already has it", inQuotes(key));
    }
    if (says("Missing ':'")) return fmt::format("expected \":\" after the key, found {}", found);
    if (says("object member name"))
        return fmt::format("expected a key in double quotes or \"}}\", found {}", found);
    if (says("object declaration")) return fmt::format("expected \",\" or \"}}\", found {}", found);
    if (says("array declaration")) return fmt::format("expected \",\" or \"]\", found {}", found);
    if (says("Extra non-whitespace")) return fmt::format("expected nothing after the value, found {}", found);
    if (says("is not a number")) return fmt::format("the number {} is too large for a double", found);
    if (says("value, object or array expected")) return fmt::format("expected a value, found {}", found);
    return fmt::format("malformed JSON: {}, found {}", fault.message, found);
}

/// JsonCpp may place a missing value or comma before the spaces: move on to what is really there.
std::size_t skipSpaces(std::string_view text, std::size_t at) {
    return std::min(text.find_first_not_of(" \t\r\n", at), text.size());
}

std::optional<TextFault> parseTree(const std::string& text, const std::vector<std::size_t>& lineStarts,
                                   Json::Value& root) {
    Json::CharReaderBuilder builder;
    builder["collectComments"] = false;
    builder["allowComments"] = false;  // blanked by our scan: JsonCpp refuses one between a key and its colon
    builder["allowTrailingCommas"] = true;
    builder["rejectDupKeys"] = true;
    builder["failIfExtra"] = true;
    builder["stackLimit"] = maximumDepth + 10;
    const std::unique_ptr<Json::CharReader> reader(builder.newCharReader());
    std::string report;
    try {
        if (reader->parse(text.data(), text.data() + text.size(), &root, &report)) return std::nullopt;
    } catch (const Json::Exception& exception) {
        return TextFault{0, fmt::format("malformed JSON: {}", exception.what())};
    }
    TextFault fault = firstFault(text, lineStarts, report);
    fault.offset = skipSpaces(text, fault.offset);
    fault.message = reworded(text, fault);
    return fault;
}

}  // namespace

Value parse(std::string text, std::string file) {
    auto document = std::make_shared<Document>();
    document->file = std::move(file);
    document->text = std::move(text);
    document->lineStarts = lineStartsOf(document->text);
    Scan scanned = scan(document->text);
    document->keys = std::move(scanned.keys);
    std::optional<TextFault> fault = std::move(scanned.fault);
    if (!fault) fault = parseTree(scanned.bare, document->lineStarts, document->root);
    if (fault) throw InputError(locate(*document, fault->offset), fault->message);
    const Json::Value* root = &document->root;
    return {std::move(document), root};
}

Value parseFile(const std::filesystem::path& path) {
    const auto unreadable = [&](std::string_view why) {
        return InputError(SourceLocation{path.string(), 0, 0}, fmt::format("cannot be read: {}", why));
    };
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) throw unreadable("there is no such file");
    if (std::filesystem::is_directory(status)) throw unreadable("it is a folder");
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw unreadable("it cannot be opened");
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (stream.bad()) throw unreadable("reading stopped before its end");
    return parse(std::move(text), path.string());
}

}  // namespace nephrite::json
