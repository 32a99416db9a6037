// Lines of comma-separated values (RFC 4180). What has no value is an empty field.
#pragma once

#include <string>
#include <vector>

namespace nephrite::pareto {

/// Quoted where it must be.
std::string csvField(const std::string& text);
/// 17 significant digits; empty if it is not finite.
std::string csvField(double value);
/// A time in ms to the nanosecond, which is what clocks count; empty if it is not finite.
std::string csvTime(double ms);

class CsvLine {
  public:
    template<class... Fields>
    void add(const Fields&... fields) {
        (fields_.push_back(csvField(fields)), ...);
    }
    void addEmpty(std::size_t count) { fields_.resize(fields_.size() + count); }
    std::string text() const;

  private:
    std::vector<std::string> fields_;
};

}  // namespace nephrite::pareto
