#include "formats/openscad/syntax/ast.hpp"

#include <algorithm>
#include <cmath>

namespace cardioid::formats::openscad {
namespace {

std::uint32_t size32(std::size_t n) { return static_cast<std::uint32_t>(n); }

bool same_number(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool same_call(const Call& a, const Call& b) {
    return a.name == b.name && a.first_argument == b.first_argument && a.argument_count == b.argument_count &&
           a.first_child == b.first_child && a.child_count == b.child_count && a.modifiers == b.modifiers;
}

}  // namespace

std::uint32_t Ast::line(Place place) const {
    return size32(static_cast<std::size_t>(std::upper_bound(line_starts.begin(), line_starts.end(), place) -
                                           line_starts.begin()));
}

std::string Ast::where(Place place) const {
    if (!origin.empty()) return origin;
    const std::uint32_t n = line(place);
    const Place start = n == 0 ? 0 : line_starts[n - 1];
    return file + ":" + std::to_string(n) + ":" + std::to_string(place - start + 1);
}

bool equal(const Ast& a, const Ast& b) {
    const auto same_argument = [](const Argument& x, const Argument& y) {
        return x.name == y.name && x.value == y.value;
    };
    return a.texts == b.texts && a.roots == b.roots && a.children == b.children && a.values == b.values &&
           std::equal(a.numbers.begin(), a.numbers.end(), b.numbers.begin(), b.numbers.end(), same_number) &&
           std::equal(a.arguments.begin(), a.arguments.end(), b.arguments.begin(), b.arguments.end(), same_argument) &&
           std::equal(a.calls.begin(), a.calls.end(), b.calls.begin(), b.calls.end(), same_call);
}

std::uint32_t AstBuilder::text(std::string_view text) {
    const auto [at, fresh] = index_.try_emplace(std::string(text), size32(ast_.texts.size()));
    if (fresh) ast_.texts.push_back(at->first);
    return at->second;
}

std::uint32_t AstBuilder::open(std::string_view name, Place place, std::uint8_t modifiers) {
    const std::uint32_t index = size32(ast_.calls.size());
    ast_.calls.push_back(
        {.name = text(name), .place = place, .first_argument = size32(ast_.arguments.size()), .modifiers = modifiers});
    open_.push_back({index, pending_.size()});
    return index;
}

void AstBuilder::close() {
    const Open done = open_.back();
    open_.pop_back();
    const auto first = pending_.begin() + static_cast<std::ptrdiff_t>(done.first_pending);
    Call& call = ast_.calls[done.call];
    call.first_child = size32(ast_.children.size());
    call.child_count = size32(pending_.size() - done.first_pending);
    ast_.children.insert(ast_.children.end(), first, pending_.end());
    pending_.erase(first, pending_.end());
    if (open_.empty())
        ast_.roots.push_back(done.call);
    else
        pending_.push_back(done.call);
}

void AstBuilder::add(const Argument& argument) {
    ast_.arguments.push_back(argument);
    ++ast_.calls[open_.back().call].argument_count;
}

void AstBuilder::argument(std::string_view name, const Value& value) {
    add({.name = name.empty() ? Argument::no_name : text(name), .value = value});
}

Value AstBuilder::number(double x) {
    ast_.numbers.push_back(x);
    return {ValueKind::number, size32(ast_.numbers.size() - 1), 1};
}

Value AstBuilder::numbers(std::span<const double> xs) {
    const std::uint32_t first = size32(ast_.numbers.size());
    ast_.numbers.insert(ast_.numbers.end(), xs.begin(), xs.end());
    return {ValueKind::numbers, first, size32(xs.size())};
}

Value AstBuilder::list(std::span<const Value> elements, ValueKind kind) {
    const std::uint32_t first = size32(ast_.values.size());
    ast_.values.insert(ast_.values.end(), elements.begin(), elements.end());
    return {kind, first, size32(elements.size())};
}

}  // namespace cardioid::formats::openscad
