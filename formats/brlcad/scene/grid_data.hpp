#pragma once
#include <optional>
#include <string>
#include <vector>

#include "formats/brlcad/scene/solids.hpp"

namespace cardioid::formats::brlcad {

/// What a dsp, ebm, vol or hf says; whatever is missing or wrong becomes the note, and everything after it is nothing.
class GridFields {
public:
    GridFields(SolidTarget& target, const Solid& solid) : target_(target), solid_(solid) {}

    [[nodiscard]] bool good() const { return good_; }
    /// The text of a field; `fallback` where it is not there.
    [[nodiscard]] std::string text(const char* key, const std::string& fallback = {}) const;
    /// A whole number from 1 to 2^20, so that three of them multiply.
    std::size_t count(const char* key);
    double number(const char* key, double fallback);
    /// Numbers between commas, blanks or braces; `fallback` where the field is not there.
    std::vector<double> numbers(const char* key, std::vector<double> fallback);
    /// The map of a field of 16 numbers by rows, the identity where it is not there.
    Affine map(const char* key);
    /// At least `wanted` bytes of what field `key` names: an object of the database where `of_object`, else a file.
    /// An object's elements are of one of the types in `elements`.
    std::string bytes(const char* key, bool of_object, std::uint64_t wanted, std::initializer_list<int> elements);

private:
    void fail(const std::string& note);
    std::string file(const std::string& name, std::uint64_t wanted);

    SolidTarget& target_;
    const Solid& solid_;
    bool good_ = true;
};

}  // namespace cardioid::formats::brlcad
