#pragma once
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rt_core/api/error.hpp"
#include "rt_core/api/math.hpp"

namespace cardioid {

/// What a parameter may hold.
enum class ParamType { number, colour, vector, text, boolean };

/// One parameter of a shader, light or lighting module, as `cardioid list` prints it. All members point to literals.
struct ParamSpec {
    const char* name;
    ParamType type;
    const char* fallback;  ///< as written in a scene file, "" where it must be given
    const char* help;      ///< what it is, with its unit and range
};

/// A value of a scene file: numbers (one or a list), text, or a truth value.
struct ParamValue {
    enum class Kind { numbers, text, boolean } kind = Kind::numbers;
    std::vector<double> numbers{};
    bool list = false;  ///< written in brackets
    std::string text{};
    bool boolean = false;
};

/// Named values with the place they were written at; every getter checks the type and names the place when it is wrong.
class Params {
public:
    Params() = default;
    /// where: "file:line:column" of the call, for messages.
    explicit Params(std::string where) : where_(std::move(where)) {}

    /// Later values of the same name win.
    void set(std::string name, ParamValue value) {
        for (auto& [key, old] : values_)
            if (key == name) {
                old = std::move(value);
                return;
            }
        values_.emplace_back(std::move(name), std::move(value));
    }
    void set(std::string name, double number) { set(std::move(name), ParamValue{.numbers = {number}}); }
    void set(std::string name, Rgb c) { set(std::move(name), ParamValue{.numbers = {c.r, c.g, c.b}, .list = true}); }
    void set(std::string name, std::string text) {
        set(std::move(name), ParamValue{.kind = ParamValue::Kind::text, .numbers = {}, .text = std::move(text)});
    }

    [[nodiscard]] bool has(std::string_view name) const { return find(name) != nullptr; }
    [[nodiscard]] const std::string& where() const { return where_; }
    [[nodiscard]] std::span<const std::pair<std::string, ParamValue>> all() const { return values_; }

    /// A finite number within [lo, hi]; throws Error(bad_input) otherwise.
    [[nodiscard]] double number(std::string_view name, double fallback, double lo = -HUGE_VAL,
                                double hi = HUGE_VAL) const {
        const ParamValue* v = find(name);
        if (!v) return fallback;
        if (v->kind != ParamValue::Kind::numbers || v->numbers.size() != 1 || v->list) wrong(name, "a number");
        return checked(name, v->numbers[0], lo, hi);
    }
    /// A triple, or one number for grey; every channel finite and within [lo, hi].
    [[nodiscard]] Rgb colour(std::string_view name, Rgb fallback, double lo = 0, double hi = HUGE_VAL) const {
        const ParamValue* v = find(name);
        if (!v) return fallback;
        const bool grey = v->numbers.size() == 1 && !v->list;
        if (v->kind != ParamValue::Kind::numbers || (v->numbers.size() != 3 && !grey))
            wrong(name, "a colour [r, g, b] or one number");
        for (const double x : v->numbers) static_cast<void>(checked(name, x, lo, hi));
        const auto channel = [&](std::size_t i) { return static_cast<float>(v->numbers[grey ? 0 : i]); };
        return {channel(0), channel(1), channel(2)};
    }
    /// A list of exactly `size` finite numbers, or nothing where it is not given.
    [[nodiscard]] std::optional<std::vector<double>> vector(std::string_view name, std::size_t size) const {
        const ParamValue* v = find(name);
        if (!v) return std::nullopt;
        if (v->kind != ParamValue::Kind::numbers || v->numbers.size() != size || !v->list)
            wrong(name, "a list of " + std::to_string(size) + " numbers");
        for (const double x : v->numbers) static_cast<void>(checked(name, x, -HUGE_VAL, HUGE_VAL));
        return v->numbers;
    }
    [[nodiscard]] std::string text(std::string_view name, std::string fallback = {}) const {
        const ParamValue* v = find(name);
        if (!v) return fallback;
        if (v->kind != ParamValue::Kind::text) wrong(name, "a text in quotes");
        return v->text;
    }
    [[nodiscard]] bool boolean(std::string_view name, bool fallback) const {
        const ParamValue* v = find(name);
        if (!v) return fallback;
        if (v->kind == ParamValue::Kind::boolean) return v->boolean;
        if (v->kind == ParamValue::Kind::numbers && v->numbers.size() == 1) return v->numbers[0] != 0;
        wrong(name, "true or false");
    }
    [[nodiscard]] bool is_text(std::string_view name) const {
        const ParamValue* v = find(name);
        return v && v->kind == ParamValue::Kind::text;
    }
    /// Throws Error(bad_input): the value of `name` is not `wanted`.
    [[noreturn]] void wrong(std::string_view name, const std::string& wanted) const {
        throw Error(ErrorCode::bad_input, where_ + ": " + std::string(name) + " must be " + wanted);
    }

private:
    [[nodiscard]] const ParamValue* find(std::string_view name) const {
        for (const auto& [key, value] : values_)
            if (key == name) return &value;
        return nullptr;
    }
    [[nodiscard]] double checked(std::string_view name, double x, double lo, double hi) const {
        if (!std::isfinite(x)) wrong(name, "finite");
        if (x < lo || x > hi) {
            const auto print = [](double v) {
                std::string s = std::to_string(v);
                s.erase(s.find_last_not_of('0') + 1);
                if (s.back() == '.') s.pop_back();
                return s;
            };
            const std::string range = !std::isfinite(hi)   ? "at least " + print(lo)
                                      : !std::isfinite(lo) ? "at most " + print(hi)
                                                           : "between " + print(lo) + " and " + print(hi);
            throw Error(ErrorCode::bad_input,
                        where_ + ": " + std::string(name) + " = " + print(x) + " must be " + range);
        }
        return x;
    }

    std::string where_;
    std::vector<std::pair<std::string, ParamValue>> values_;
};

}  // namespace cardioid
