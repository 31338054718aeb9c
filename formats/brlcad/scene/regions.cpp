#include "formats/brlcad/scene/regions.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>
#include <unordered_set>

#include "formats/brlcad/scene/node_list.hpp"
#include "formats/brlcad/scene/solids.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::formats::brlcad {

namespace {

constexpr std::size_t most_members = 10'000'000;
/// Combinations within combinations; each costs some of the stack.
constexpr std::size_t deepest = 500;
/// What single precision leaves in the last row of a matrix.
constexpr double no_perspective = 1e-6;

/// What is handed down from combination to combination.
struct State {
    Affine place;
    RegionLook look;
    bool colour_is_fixed = false, shader_is_fixed = false;  ///< a combination above said so
};

using Node = std::optional<std::uint32_t>;

class Walker {
public:
    Walker(const Database& database, Surfaces& surfaces, SolidTree& tree, std::vector<std::string>& warnings)
        : database_(database), surfaces_(surfaces), tree_(tree), warnings_(warnings) {}

    std::vector<Region> regions_of(const std::string& name) { return above(name, {}); }

private:
    void warn(const std::string& key, const std::string& text) {
        if (warned_.insert(key).second) warnings_.push_back(text);
    }

    /// The object, where it is there and not within itself.
    const Object* enter(const std::string& name) {
        if (++members_ > most_members)
            throw Error(ErrorCode::limit, fmt::format("\"{}\": more than ten million members", name));
        const Object* object = database_.find(name);
        const std::string within = path_.empty() ? "" : fmt::format(" (named in \"{}\")", path_.back());
        if (!object) {
            warn("?" + name, fmt::format("{}: there is no object \"{}\"{}; it counts as nothing",
                                         path_.empty() ? "" : database_.find(path_.back())->place, name, within));
            return nullptr;
        }
        if (path_.size() >= deepest || std::find(path_.begin(), path_.end(), name) != path_.end()) {
            warn("@" + name, fmt::format("{}: \"{}\" is within itself or too deep; it counts as nothing there",
                                         object->place, name));
            return nullptr;
        }
        return object;
    }

    std::optional<Affine> placed(const Affine& place, const Step& step, const Object& parent) {
        if (!step.matrix) return place;
        const Matrix& m = *step.matrix;
        const double scale = m[15];
        const bool finite = std::all_of(m.begin(), m.end(), [](double x) { return std::isfinite(x); });
        if (!finite || scale == 0 || std::abs(m[12]) + std::abs(m[13]) + std::abs(m[14]) > no_perspective) {
            warn("m" + parent.name + "/" + step.name,
                 fmt::format("{}: the matrix of \"{}\" in \"{}\" is no map of solids; it counts as nothing",
                             parent.place, step.name, parent.name));
            return std::nullopt;
        }
        const double f = 1 / scale;
        const Affine map{{Vec3d{m[0], m[1], m[2]} * f, Vec3d{m[4], m[5], m[6]} * f, Vec3d{m[8], m[9], m[10]} * f},
                         Vec3d{m[3], m[7], m[11]} * f};
        return place * map;
    }

    static void apply(const Combination& comb, State& state) {
        if (comb.colour && !state.colour_is_fixed) {
            state.look.colour = comb.colour;
            state.colour_is_fixed = comb.inherit;
        }
        if (!comb.shader.empty() && !state.shader_is_fixed) {
            state.look.shader = comb.shader;
            state.shader_is_fixed = comb.inherit;
        }
    }

    /// Colours by number, where no combination has one.
    void finish(RegionLook& look) const {
        if (look.colour) return;
        for (const ColourRange& range : database_.colours)
            if (look.region_id >= range.low && look.region_id <= range.high) {
                look.colour = range.colour;
                return;
            }
    }

    /// The regions of an object that stands above or at them.
    std::vector<Region> above(const std::string& name, State state) {
        const Object* object = enter(name);
        if (!object) return {};
        if (!object->combination) return region(*object, state);
        apply(*object->combination, state);
        if (object->combination->region) {
            if (object->combination->air_code != 0) return {};
            state.look.region_id = object->combination->region_id;
            return region(*object, state);
        }
        path_.push_back(name);
        std::vector<std::vector<Region>> stack;
        for (const Step& step : object->combination->steps) {
            if (step.op == Step::Op::member) {
                State below = state;
                const auto place = placed(state.place, step, *object);
                if (place) below.place = *place;
                stack.push_back(place ? above(step.name, below) : std::vector<Region>{});
            } else {
                join(step.op, stack);
            }
        }
        path_.pop_back();
        return stack.empty() ? std::vector<Region>{} : std::move(stack.back());
    }

    /// Operations above regions work on each region of the left side (db_non_union_push).
    void join(Step::Op op, std::vector<std::vector<Region>>& stack) {
        if (op == Step::Op::complement) return stack.back().clear();
        std::vector<Region> right = std::move(stack.back());
        stack.pop_back();
        std::vector<Region>& left = stack.back();
        if (op == Step::Op::unite || op == Step::Op::exclusive) {
            left.insert(left.end(), std::make_move_iterator(right.begin()), std::make_move_iterator(right.end()));
            return;
        }
        if (right.empty() && op == Step::Op::intersect) return left.clear();
        if (right.empty()) return;
        std::vector<std::uint32_t> nodes;
        for (const Region& r : right) nodes.push_back(r.node);
        const std::uint32_t other = nodes.size() == 1 ? nodes[0] : tree_.add_node(SolidOp::unite, nodes);
        for (Region& r : left)
            r.node = tree_.add_node(op == Step::Op::subtract ? SolidOp::subtract : SolidOp::intersect, {r.node, other});
    }

    std::vector<Region> region(const Object& object, const State& state) {
        Region out;
        for (const std::string& name : path_) out.path += "/" + name;
        out.path += "/" + object.name;
        out.look = state.look;
        finish(out.look);
        out.material = current_material_ = surfaces_.of_region(out.look);
        const Node node = object.combination ? tree_of(object, state.place) : solid(object, state.place);
        if (!node) return {};
        out.node = *node;
        return {out};
    }

    Node solid(const Object& object, const Affine& place) {
        SolidTarget target{tree_, place, surfaces_.of_solid(current_material_, object.solid, place), &database_};
        const Node node = add_solid(target, object.solid);
        if (!target.note.empty())
            warn(object.name, fmt::format("{}: solid \"{}\" {}", object.place, object.name, target.note));
        return node;
    }

    /// Everything below a region: colours and regions there mean nothing.
    Node below(const std::string& name, const Affine& place) {
        const Object* object = enter(name);
        if (!object) return std::nullopt;
        return object->combination ? tree_of(*object, place) : solid(*object, place);
    }

    Node tree_of(const Object& object, const Affine& place) {
        path_.push_back(object.name);
        std::vector<NodeList> stack;
        for (const Step& step : object.combination->steps) {
            if (step.op == Step::Op::member) {
                const auto here = placed(place, step, object);
                stack.push_back(NodeList(here ? below(step.name, *here) : Node{}));
                continue;
            }
            if (step.op == Step::Op::complement) {
                stack.back().complement(tree_);
                continue;
            }
            const NodeList right = std::move(stack.back());
            stack.pop_back();
            stack.back().join(step.op, right, tree_);
        }
        path_.pop_back();
        return stack.empty() ? Node{} : stack.back().node(tree_);
    }

    const Database& database_;
    Surfaces& surfaces_;
    SolidTree& tree_;
    std::vector<std::string>& warnings_;
    std::set<std::string> warned_;
    std::vector<std::string> path_;
    std::size_t members_ = 0;
    std::uint32_t current_material_ = 0;
};

}  // namespace

std::vector<Region> collect_regions(const Database& database, const std::vector<std::string>& objects,
                                    Surfaces& surfaces, SolidTree& tree, std::vector<std::string>& warnings) {
    Walker walker(database, surfaces, tree, warnings);
    std::vector<Region> out;
    for (const std::string& name : objects) {
        std::vector<Region> more = walker.regions_of(name);
        out.insert(out.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    }
    return out;
}

std::vector<std::string> top_objects(const Database& database) {
    std::unordered_set<std::string> members;
    for (const Object& object : database.objects)
        if (!object.combination) {
            if (object.solid.kind == SolidKind::data || object.solid.kind == SolidKind::sketch)
                members.insert(object.name);
        } else
            for (const Step& step : object.combination->steps)
                if (step.op == Step::Op::member) members.insert(step.name);
    std::vector<std::string> out;
    for (const Object& object : database.objects)
        if (!members.contains(object.name)) out.push_back(object.name);
    std::sort(out.begin(), out.end());
    return out;
}

}  // namespace cardioid::formats::brlcad
