#include "formats/openscad/evaluate/warnings.hpp"

#include <utility>

namespace cardioid::formats::openscad {

void Warnings::add(const std::string& where, const std::string& text) {
    if (texts_.size() >= longest) {
        ++left_out_;
        return;
    }
    std::string line = where + ": " + text;
    if (seen_.insert(line).second) texts_.push_back(std::move(line));
}

void Warnings::once(const std::string& key, const std::string& where, const std::string& text) {
    constexpr std::size_t keys = 10'000;  // an adversary's file may hold any number of names
    if (seen_.size() < keys && seen_.insert(key).second) add(where, text);
}

std::vector<std::string> Warnings::take() {
    if (left_out_ > 0) texts_.push_back(std::to_string(left_out_) + " more warnings were left out");
    return std::exchange(texts_, {});
}

}  // namespace cardioid::formats::openscad
