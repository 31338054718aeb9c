#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/openscad/evaluate/warnings.hpp"
#include "formats/openscad/syntax/ast.hpp"
#include "rt_core/api/params.hpp"

namespace cardioid::formats::openscad {

/// The names a call's arguments may have.
struct Signature {
    std::span<const std::string_view> positional;  ///< in the order that unnamed arguments fill
    std::span<const std::string_view> named;
    bool any_arguments = false;
};

/// The arguments of one call by name. Unnamed ones fill the declared list in order, wherever they stand; of two of the
/// same name the last wins, with a warning; an unknown name is a warning. Getters give the fallback for what is
/// missing or undef, and throw Error(bad_input) for a value of another type; numbers may be infinite or NaN.
class Arguments {
public:
    Arguments(const Ast& ast, const Call& call, const Signature& signature, Warnings& warnings);

    [[nodiscard]] bool has(std::string_view name) const { return find(name) != nullptr; }
    [[nodiscard]] bool is(std::string_view name, ValueKind kind) const;
    [[nodiscard]] const Value* value(std::string_view name) const;
    [[nodiscard]] double number(std::string_view name, double fallback) const;
    [[nodiscard]] std::optional<double> number(std::string_view name) const;
    [[nodiscard]] bool boolean(std::string_view name, bool fallback) const;
    [[nodiscard]] std::string text(std::string_view name) const;  ///< "" where it is missing
    /// A list of at least `least` numbers (the range of Ast::numbers), or nothing.
    [[nodiscard]] std::optional<std::span<const double>> numbers(std::string_view name, std::size_t least) const;
    /// [x, y, z], or one number for all three.
    [[nodiscard]] Vec3d size(std::string_view name, double fallback) const;
    /// [x, y, z], of which missing ones are `missing`.
    [[nodiscard]] std::optional<Vec3d> vector(std::string_view name, double missing = 0) const;
    /// All of them as a hook's parameters.
    [[nodiscard]] Params params() const;

    [[nodiscard]] std::string where() const { return ast_.where(call_.place); }
    /// Throws Error(bad_input): `name` of this call must be `wanted`.
    [[noreturn]] void wrong(std::string_view name, const std::string& wanted) const;
    /// Throws Error(bad_input) with the place of the call.
    [[noreturn]] void fail(const std::string& message) const;
    [[nodiscard]] const Ast& ast() const { return ast_; }

private:
    struct Bound {
        std::string_view name;
        const Argument* argument;
    };
    void bind(std::string_view name, const Argument& argument, Warnings& warnings);
    [[nodiscard]] const Argument* find(std::string_view name) const;

    const Ast& ast_;
    const Call& call_;
    std::vector<Bound> bound_;
};

/// A value as a hook's parameter; nothing for undef, ranges and mixed lists.
std::optional<ParamValue> param_value(const Ast& ast, const Value& value);

}  // namespace cardioid::formats::openscad
