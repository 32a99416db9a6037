// Faults in what the user gave us: where they are, what they say, and the exceptions that carry them.
//
// Every reader collects its faults in a Diagnostics, so that one run names all of them, and then throws one
// InputError. The program turns an InputError into exit status 2 and a RunError into exit status 1.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace nephrite {

/// A place in a text file. Lines and columns count from 1, columns in bytes; line 0 means the whole file.
struct SourceLocation {
    std::string file;
    std::uint32_t line = 0;
    std::uint32_t column = 0;

    friend bool operator==(const SourceLocation&, const SourceLocation&) = default;
};

/// One fault: `file:line:col: error: message`, or `file: error: message` when it has no line.
struct Diagnostic {
    SourceLocation where;
    std::string message;
};

/// The one line a fault is printed as; `severity` is "error" or "warning".
std::string toLine(const Diagnostic& diagnostic, std::string_view severity = "error");

/// What the user gave is wrong (exit status 2). Carries every fault found, in the order found.
class InputError : public std::runtime_error {
  public:
    explicit InputError(std::vector<Diagnostic> faults);
    InputError(SourceLocation where, std::string message);
    const std::vector<Diagnostic>& faults() const { return faults_; }

  private:
    std::vector<Diagnostic> faults_;
};

/// Something failed while running (exit status 1): a lost device, a full disk, a validation message.
class RunError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Collects faults and warnings while a file is read.
class Diagnostics {
  public:
    void error(SourceLocation where, std::string message);
    void warning(SourceLocation where, std::string message);
    bool hasErrors() const { return !errors_.empty(); }
    const std::vector<Diagnostic>& errors() const { return errors_; }
    const std::vector<Diagnostic>& warnings() const { return warnings_; }
    /// Throws InputError with every error collected so far, if there is one.
    void throwIfErrors() const;

  private:
    std::vector<Diagnostic> errors_;
    std::vector<Diagnostic> warnings_;
};

/// `text` between double quotes for a message: control characters escaped, cut short after about 60 bytes.
std::string inQuotes(std::string_view text);

/// `, did you mean "close"?` for the known word nearest to `found` in edit distance, or nothing if none is
/// near.
std::string suggestion(std::string_view found, std::span<const std::string_view> known);
std::string suggestion(std::string_view found, std::span<const std::string> known);

}  // namespace nephrite
