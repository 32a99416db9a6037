// A number by which contents are told apart where a mistake only costs work, never truth.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace nephrite {

/// FNV-1a (Fowler, Noll and Vo) of the bytes added so far.
class Digest {
  public:
    void add(std::string_view bytes) {
        for (const char byte : bytes) hash_ = (hash_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
    }
    /// 16 hexadecimal digits.
    std::string text() const;

  private:
    std::uint64_t hash_ = 0xcbf29ce484222325;
};

}  // namespace nephrite
