#include "formats/openscad/evaluate/arguments.hpp"

#include <algorithm>

#include "rt_core/scene/nearest_name.hpp"

namespace cardioid::formats::openscad {
namespace {

bool contains(std::span<const std::string_view> names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string unknown_argument(std::string_view call, std::string_view name, const Signature& signature) {
    std::vector<std::string_view> known(signature.positional.begin(), signature.positional.end());
    known.insert(known.end(), signature.named.begin(), signature.named.end());
    return std::string(call) + "() has no parameter \"" + std::string(name.substr(0, 40)) + "\"" +
           did_you_mean(name, known) + ": ignored";
}

}  // namespace

Arguments::Arguments(const Ast& ast, const Call& call, const Signature& signature, Warnings& warnings)
    : ast_(ast), call_(call) {
    std::size_t next = 0;
    bound_.reserve(call.argument_count);
    for (const Argument& argument : ast.arguments_of(call)) {
        if (argument.name == Argument::no_name) {
            if (next < signature.positional.size())
                bind(signature.positional[next++], argument, warnings);
            else if (!signature.any_arguments)
                warnings.once("argument:" + ast.name(call), where(), ast.name(call) + "() has too many arguments");
            continue;
        }
        const std::string& name = ast.texts[argument.name];
        if (contains(signature.positional, name) || contains(signature.named, name) || name[0] == '$')
            bind(name, argument, warnings);
        else if (!signature.any_arguments)
            warnings.once("parameter:" + ast.name(call) + ":" + name, ast.where(argument.place),
                          unknown_argument(ast.name(call), name, signature));
    }
}

void Arguments::bind(std::string_view name, const Argument& argument, Warnings& warnings) {
    if (argument.value.kind == ValueKind::identifier)
        warnings.add(ast_.where(argument.place),
                     "\"" + ast_.texts[argument.value.first] + "\" is not a value: taken as undef");
    for (Bound& old : bound_)
        if (old.name == name) {
            warnings.once("twice:" + ast_.name(call_) + ":" + std::string(name), ast_.where(argument.place),
                          std::string(name) + " is given twice: the last counts");
            old.argument = &argument;
            return;
        }
    bound_.push_back({name, &argument});
}

const Argument* Arguments::find(std::string_view name) const {
    for (const Bound& b : bound_)
        if (b.name == name) {
            const ValueKind kind = b.argument->value.kind;
            return kind == ValueKind::undef || kind == ValueKind::identifier ? nullptr : b.argument;
        }
    return nullptr;
}

bool Arguments::is(std::string_view name, ValueKind kind) const {
    const Argument* a = find(name);
    return a && a->value.kind == kind;
}

const Value* Arguments::value(std::string_view name) const {
    const Argument* a = find(name);
    return a ? &a->value : nullptr;
}

std::optional<double> Arguments::number(std::string_view name) const {
    const Argument* a = find(name);
    if (!a) return std::nullopt;
    if (a->value.kind == ValueKind::number) return ast_.numbers[a->value.first];
    wrong(name, "a number");
}

double Arguments::number(std::string_view name, double fallback) const { return number(name).value_or(fallback); }

bool Arguments::boolean(std::string_view name, bool fallback) const {
    const Argument* a = find(name);
    if (!a) return fallback;
    if (a->value.kind == ValueKind::boolean) return a->value.count != 0;
    if (a->value.kind == ValueKind::number) return ast_.numbers[a->value.first] != 0;
    wrong(name, "true or false");
}

std::string Arguments::text(std::string_view name) const {
    const Argument* a = find(name);
    if (!a) return {};
    if (a->value.kind == ValueKind::text) return ast_.texts[a->value.first];
    wrong(name, "a text in quotes");
}

std::optional<std::span<const double>> Arguments::numbers(std::string_view name, std::size_t least) const {
    const Argument* a = find(name);
    if (!a) return std::nullopt;
    if (a->value.kind != ValueKind::numbers || a->value.count < least)
        wrong(name, least > 1 ? "a list of " + std::to_string(least) + " numbers" : "a list of numbers");
    return ast_.numbers_of(a->value);
}

Vec3d Arguments::size(std::string_view name, double fallback) const {
    if (!has(name) || is(name, ValueKind::number)) {
        const double x = number(name, fallback);
        return {x, x, x};
    }
    if (const Value& v = *value(name); v.kind != ValueKind::numbers || v.count < 2)
        wrong(name, "a number or a list of numbers, as [1, 2, 3]");
    const auto xs = *numbers(name, 2);
    return {xs[0], xs[1], xs.size() > 2 ? xs[2] : fallback};
}

std::optional<Vec3d> Arguments::vector(std::string_view name, double missing) const {
    const auto xs = numbers(name, 1);
    if (!xs) return std::nullopt;
    return Vec3d{(*xs)[0], xs->size() > 1 ? (*xs)[1] : missing, xs->size() > 2 ? (*xs)[2] : missing};
}

Params Arguments::params() const {
    Params out(where());
    for (const Bound& b : bound_) {
        if (!find(b.name)) continue;
        auto value = param_value(ast_, b.argument->value);
        if (!value) wrong(b.name, "a number, a list of numbers, a text, true or false");
        out.set(std::string(b.name), std::move(*value));
    }
    return out;
}

void Arguments::wrong(std::string_view name, const std::string& wanted) const {
    const Argument* a = find(name);
    throw Error(ErrorCode::bad_input, ast_.where(a ? a->place : call_.place) + ": " + std::string(name) + " of " +
                                          ast_.name(call_) + "() must be " + wanted);
}

void Arguments::fail(const std::string& message) const { throw Error(ErrorCode::bad_input, where() + ": " + message); }

std::optional<ParamValue> param_value(const Ast& ast, const Value& value) {
    ParamValue out;
    switch (value.kind) {
        case ValueKind::boolean:
            out.kind = ParamValue::Kind::boolean;
            out.boolean = value.count != 0;
            return out;
        case ValueKind::text:
            out.kind = ParamValue::Kind::text;
            out.text = ast.texts[value.first];
            return out;
        case ValueKind::number:
            out.numbers = {ast.numbers[value.first]};
            return out;
        case ValueKind::numbers: {
            const auto xs = ast.numbers_of(value);
            out.numbers.assign(xs.begin(), xs.end());
            out.list = true;
            return out;
        }
        default:
            return std::nullopt;
    }
}

}  // namespace cardioid::formats::openscad
