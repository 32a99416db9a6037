// The two ways a PLY body stores its numbers: as text, and as binary of either byte order.
//
// Both classes offer the same members, so that one decoder (ply.cpp) serves both:
//   number(type, what)    the next value; throws InputError if there is none or it is not finite
//   skip(type)            passes over a value nobody wants
//   endItem()             after each vertex, face, ...
//   leastBytes(element)   how small one item of an element can be stored
//   remaining()           bytes left
//   fail(message)         throws InputError naming the place
#pragma once

#include <string>
#include <string_view>

#include "scene/mesh/ply_header.h"
#include "scene/mesh/text_cursor.h"

namespace nephrite::scene::ply {

class TextValues {
  public:
    TextValues(std::string_view bytes, std::size_t bodyOffset, const std::string& file);
    double number(Type type, std::string_view what);
    void skip(Type type);
    void startItem();
    void endItem();
    std::uint64_t leastBytes(const Element& element) const;
    std::size_t remaining() const { return cursor_.remaining(); }
    /// Bytes after the last item that are not blank.
    std::size_t unread();
    [[noreturn]] void fail(std::string message) const { cursor_.fail(std::move(message)); }

  private:
    TextCursor cursor_;
};

class BinaryValues {
  public:
    BinaryValues(std::string_view bytes, std::size_t bodyOffset, const std::string& file, bool swapBytes);
    double number(Type type, std::string_view what);
    void skip(Type type) { take(bytesOf(type)); }
    void startItem() { itemStart_ = offset_; }
    void endItem() {}
    std::uint64_t leastBytes(const Element& element) const;
    std::size_t remaining() const { return bytes_.size() - offset_; }
    std::size_t unread() const { return remaining(); }
    [[noreturn]] void fail(const std::string& message) const;

  private:
    const char* take(std::size_t count);

    std::string_view bytes_;
    std::string file_;
    bool swapBytes_;
    std::size_t offset_ = 0;
    std::size_t itemStart_ = 0;
};

}  // namespace nephrite::scene::ply
