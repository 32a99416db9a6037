// Walks over the words and lines of a text mesh file and names the place of a fault.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "text/diagnostics.h"

namespace nephrite::scene {

/// A position in text that is made of lines of words. Lines end with \n or \r\n.
class TextCursor {
  public:
    /// `continuations`: a backslash at the end of a line joins it with the next.
    TextCursor(std::string_view text, std::string file, bool continuations = false);

    bool atEnd() const { return offset_ >= text_.size(); }
    std::size_t offset() const { return offset_; }
    std::size_t remaining() const { return text_.size() - offset_; }

    /// Skips blanks in the line, then says whether the line is over.
    bool atLineEnd();
    /// The character where the next word starts; only where atLineEnd() is false.
    char next() const { return text_[offset_]; }
    /// Goes to the start of the next line.
    void skipLine();
    /// Skips empty lines; false if nothing but them is left.
    bool findLine();
    /// The next word of the line, empty at its end.
    std::string_view word();
    /// The next word as a finite number that a float can hold. Throws InputError naming `what`.
    double number(std::string_view what);
    /// Adds an error unless the line is over, then goes to the next.
    void endLine(std::string_view what);

    /// The place of the last word read, or of the line's end if there was none.
    SourceLocation where() const;
    /// Throws InputError at where().
    [[noreturn]] void fail(std::string message) const;

  private:
    void skipBlanks();

    std::string_view text_;
    std::string file_;
    bool continuations_;
    std::size_t offset_ = 0;
    std::size_t lineStart_ = 0;
    std::size_t wordStart_ = 0;
    std::uint32_t line_ = 1;
};

/// `the word "abc"`, cut short if it is long, with unprintable bytes escaped.
std::string quoted(std::string_view word);

}  // namespace nephrite::scene
