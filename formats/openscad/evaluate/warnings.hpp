#pragma once
#include <string>
#include <unordered_set>
#include <vector>

namespace cardioid::formats::openscad {

/// Warnings of one reading: each text once, and only so many that a person reads them.
class Warnings {
public:
    static constexpr std::size_t longest = 100;

    void add(const std::string& where, const std::string& text);
    /// The same without a second warning of the same key, wherever it is.
    void once(const std::string& key, const std::string& where, const std::string& text);
    /// All of them, and a last line that counts what was left out.
    [[nodiscard]] std::vector<std::string> take();

private:
    std::vector<std::string> texts_;
    std::unordered_set<std::string> seen_;
    std::size_t left_out_ = 0;
};

}  // namespace cardioid::formats::openscad
