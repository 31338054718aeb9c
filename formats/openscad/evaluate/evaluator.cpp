#include "formats/openscad/evaluate/evaluator.hpp"

#include <algorithm>
#include <utility>

#include "formats/openscad/evaluate/markers.hpp"
#include "formats/openscad/evaluate/operate.hpp"
#include "formats/openscad/evaluate/settings.hpp"
#include "formats/openscad/evaluate/state.hpp"
#include "formats/openscad/geometry/plane_files.hpp"
#include "formats/openscad/geometry/transforms.hpp"
#include "formats/openscad/prune.hpp"
#include "formats/openscad/syntax/parser.hpp"
#include "formats/openscad/whole_file.hpp"
#include "rt_core/scene/nearest_name.hpp"

namespace cardioid::formats::openscad {
namespace {

/// Walks the tree with a stack of frames.
class Evaluator {
public:
    Evaluator(const Ast& ast, const ReadOptions& options, const std::string& base_dir)
        : ast_(ast),
          options_(options),
          materials_(options.registry, warnings_),
          shapes_{scene_.solids, options, base_dir, warnings_, limits_of(options)},
          results_(shapes_),
          markers_(find_markers(ast)) {
        scene_.file = ast.file;
        scene_.base_dir = base_dir;
    }

    Scene run() {
        scene_.six_digits = !has_long_numbers(ast_);
        const std::uint32_t root = root_modifier(ast_);
        makes_solids_ = root == no_call;
        if (!options_.materials_text.empty()) side_file(parse(options_.materials_text, options_.materials_file));
        walk(ast_.roots);
        if (root != no_call) {
            makes_solids_ = true;
            makes_settings_ = false;
            walk(std::span(&root, 1));
        }
        append(scene_.solids.roots, backdrop_);
        scene_.statements.resize(scene_.solids.roots.size());
        prune(scene_.solids);
        materials_.finish(scene_);
        scene_.warnings = warnings_.take();
        return std::move(scene_);
    }

private:
    // --- the walk

    void walk(std::span<const std::uint32_t> calls) {
        frames_.push_back({.rest = calls, .ast = &ast_, .state = {}});
        while (!frames_.empty()) {
            Frame& frame = frames_.back();
            if (frame.rest.empty()) {
                close();
                continue;
            }
            const std::uint32_t child = frame.rest[0];
            frame.rest = frame.rest.subspan(1);
            begin(child);
        }
    }

    void begin(std::uint32_t index) {
        const Call& call = ast_.calls[index];
        if (frames_.size() == 1) statement_starts_.push_back(results_.mark().solid);
        if ((call.modifiers & Modifier::disabled) != 0) return;
        if (markers_[index] != no_marker) return marker(ast_.calls[markers_[index]]);
        if ((call.modifiers & Modifier::background) != 0 && !options_.show_background) return;
        evaluate_call(ast_, call);
    }

    void evaluate_call(const Ast& ast, const Call& call) {
        const CallInfo* info = known_call(ast, call);
        if (!info) return;
        if (info->node == Node::later) refuse(ast, call);
        if (is_setting(info->node)) return setting(*info, ast, call);
        if (&ast != &ast_ && !is_shape(info->node)) refuse(ast, call);
        Frame frame{.rest = ast_.children_of(call),
                    .ast = &ast,
                    .call = &call,
                    .node = info->node,
                    .state = frames_.back().state,
                    .mark = results_.mark(),
                    .first_scope = scopes_.size(),
                    .first_leaf = scene_.solids.leaves.size(),
                    .backdrop = (call.modifiers & Modifier::background) != 0};
        if (is_shape(info->node)) frame.rest = {};  // OpenSCAD ignores what stands in a cube
        const Arguments args(ast, call, signature(*info), warnings_);
        enter(frame, args);
        frames_.push_back(frame);
        if (is_shape(info->node) && makes_solids_) shape(info->node, args);
    }

    /// What a call means for those inside it.
    void enter(Frame& frame, const Arguments& args) {
        State& state = frame.state;
        if (frame.backdrop && !state.fixed) {
            state.material = materials_.backdrop();
            state.fixed = true;
        }
        switch (frame.node) {
            case Node::multmatrix:
            case Node::translate:
            case Node::rotate:
            case Node::scale:
            case Node::mirror: {
                const Affine m = transform_of(frame.node, args);
                state.to_world = state.to_world * m;
                state.in_plane = state.in_plane * in_plane(m);
                break;
            }
            case Node::color:
                if (const auto rgba = colour_of(args, warnings_)) state.set_colour(materials_.coloured(*rgba));
                break;
            case Node::material:
                state.set_material(materials_.named(material_name(args), args.where()));
                break;
            case Node::linear_extrude:
            case Node::rotate_extrude:
            case Node::roof:
                state.in_plane = {};
                frame.dimension = Dimension::plane;
                break;
            case Node::hull:
            case Node::minkowski:
            case Node::resize:
            case Node::projection:
            case Node::offset:
            case Node::fill:
                state.to_world = state.in_plane = {};  // the children's own space
                frame.dimension = operand_dimension(frame.node);
                break;
            default:
                break;
        }
    }

    /// All children are evaluated: makes what the call makes of them, and hands it to the parent.
    void close() {
        const Frame frame = frames_.back();
        finish(frame);
        scopes_.resize(frame.first_scope);
        frames_.pop_back();
        if (!frame.call)
            finish_model();
        else if (frame.backdrop)
            append(backdrop_, results_.take_solids(frame.mark)), results_.drop(frame.mark);
        else
            hand_over(frame);
    }

    /// Plane figures are reckoned with elsewhere; their errors get the place of the call here.
    void finish(const Frame& frame) try {
        if (frame.empty)
            results_.drop(frame.mark);
        else if (frame.is_boolean())
            results_.combine(frame.node == Node::difference ? SolidOp::subtract : SolidOp::intersect, frame.mark);
        else if (frame.is_extrusion() && makes_solids_)
            extrude(frame);
        else if (is_operation(frame.node))
            operate(frame, frames_[frames_.size() - 2].state, arguments_of(frame), results_, shapes_);
    } catch (const Error& e) {
        if (std::string_view(e.what()).starts_with(ast_.file + ":")) throw;
        throw Error(e.code(), frame.where() + ": " + e.what());
    }

    // --- results

    /// A finished child's results become the parent's: of the parent's dimension only, and one for each child of a
    /// boolean.
    void hand_over(const Frame& child) {
        Frame& parent = frames_.back();
        const bool solid = results_.has_solids(child.mark);
        const bool first = !std::exchange(parent.first_done, true);
        if (!solid && !results_.has_planes(child.mark)) {
            parent.empty_child = true;
            if (parent.node == Node::intersection || (parent.node == Node::difference && first)) parent.empty = true;
            return;
        }
        const Dimension dimension = solid ? Dimension::solid : Dimension::plane;
        if (parent.dimension == Dimension::unknown && parent.call) parent.dimension = dimension;
        if (parent.dimension != dimension && parent.call) {
            results_.drop(child.mark);
            warnings_.add(child.where(),
                          solid ? "a solid among plane figures: left out" : "a plane figure among solids: left out");
            return;
        }
        if (!parent.joins_children()) return;
        results_.join(child.mark);
        if (solid && first && parent.node == Node::difference) parent.state.fallback = results_.last_material();
    }

    void extrude(const Frame& frame) {
        const Arguments args = arguments_of(frame);
        std::vector<Plane> parts = results_.take_planes(frame.mark);
        if (frame.node != Node::roof)
            if (auto from_file = figure_of_extrusion(args, shapes_)) parts.push_back(std::move(*from_file));
        if (parts.empty()) return;
        const Extrusion made = frame.node == Node::roof             ? roof(parts, args, shapes_)
                               : frame.node == Node::linear_extrude ? linear_extrusion(parts, args, shapes_)
                                                                    : rotate_extrusion(parts, args, shapes_);
        if (!made.body || !add_leaf(*made.body, args) || made.wedge.empty()) return;
        const ResultMark wedge = results_.mark();
        for (const Shape& half : made.wedge) add_leaf(half, args);
        if (!made.keep_wedge) results_.combine(SolidOp::intersect, wedge);
        results_.combine(made.keep_wedge ? SolidOp::intersect : SolidOp::subtract, frame.mark);
    }

    Arguments arguments_of(const Frame& frame) {
        return {*frame.ast, *frame.call, signature(*find_call(frame.ast->name(*frame.call))), warnings_};
    }

    void shape(Node node, const Arguments& args) {
        if (node >= Node::square || (node == Node::import_file && is_plane_file(args))) {
            if (auto plane = make_plane(node, args, frames_.back().state.in_plane, shapes_))
                results_.add_plane(std::move(*plane));
        } else if (const auto solid = make_solid(node, args, shapes_)) {
            add_leaf(*solid, args);
        }
    }

    /// Places a shape; false, and a warning, where the transforms leave nothing of it.
    bool add_leaf(const Shape& shape, const Arguments& args) {
        const State& state = frames_.back().state;
        return results_.place(shape, state.to_world, state.leaf_material(), {args.where(), line_of(args)});
    }

    std::uint32_t line_of(const Arguments& args) const {
        const Call* call = frames_.back().call;
        return &args.ast() == &ast_ ? ast_.line(call->place) : marker_line_;
    }

    /// The whole file is evaluated: what is left on the stacks is the model.
    void finish_model() {
        const std::vector<Plane> planes = results_.take_planes({});
        std::vector<std::uint32_t> solids = results_.take_solids({});
        if (!planes.empty() && solids.empty()) {
            draw_plate(planes);
            solids = results_.take_solids({});
        } else if (!planes.empty()) {
            warnings_.add(ast_.file, "plane figures beside solids are left out, as OpenSCAD leaves them out");
        }
        for (std::size_t i = 0; i < solids.size(); ++i)
            scene_.statements.push_back(static_cast<std::uint32_t>(
                std::upper_bound(statement_starts_.begin(), statement_starts_.end(), i) - statement_starts_.begin()));
        append(scene_.solids.roots, solids);
    }

    /// A model of plane figures alone is drawn as OpenSCAD's preview draws it: one unit thick.
    void draw_plate(std::span<const Plane> planes) {
        const auto shape = plate(planes, ast_.file, shapes_);
        if (!shape) return;
        warnings_.add(ast_.file, "the model is a plane figure: drawn as a plate one unit thick");
        results_.add_leaf({shape->kind, shape->local, shape->a, shape->b, shape->data, 0, 1});
    }

    static void append(std::vector<std::uint32_t>& to, const std::vector<std::uint32_t>& what) {
        to.insert(to.end(), what.begin(), what.end());
    }

    static std::string material_name(const Arguments& args) {
        const std::string name = args.text("name");
        if (name.empty()) args.fail("found no name, wanted material(\"name\")");
        return name;
    }

    // --- settings and markers

    void setting(const CallInfo& info, const Ast& ast, const Call& call) {
        if (!makes_settings_ && info.node != Node::end) return;
        const Affine& to_world = frames_.back().state.to_world;
        if (info.node == Node::define_material) return materials_.define(ast, call);
        if (info.node == Node::light) {
            const LightKind& kind = *find_light(options_.registry, ast.name(call));
            return scene_.lights.push_back(read_light(kind, ast, call, to_world, warnings_));
        }
        const Arguments args(ast, call, signature(info), warnings_);
        switch (info.node) {
            case Node::film:
                scene_.film = read_film(args);
                break;
            case Node::camera:
                scene_.cameras.push_back(read_camera(args, to_world, warnings_));
                break;
            case Node::photons:
                scene_.photons = read_photons(ast, call);
                break;
            case Node::precision:
                scene_.six_digits = args.number("digits", 6) <= 6;
                break;
            case Node::map_color:
                map_colour(args, materials_);
                break;
            default:
                end_material();
        }
    }

    /// The file of --materials: nothing but materials.
    void side_file(const Ast& side) {
        for (const std::uint32_t root : side.roots) {
            const Call& call = side.calls[root];
            const CallInfo* info = known_call(side, call);
            if (!info) continue;
            if (info->node == Node::define_material) {
                materials_.define(side, call);
                continue;
            }
            const Arguments args(side, call, signature(*info), warnings_);
            if (info->node != Node::map_color)
                args.fail("found " + side.name(call) + ", wanted define_material or map_color in a file of materials");
            map_colour(args, materials_);
        }
    }

    /// A call that went through OpenSCAD as a text. A material holds for what follows in the same group.
    void marker(const Call& call) {
        const std::string where = ast_.where(call.place);
        const Ast parsed = parse_marker(marker_text(ast_, call), where);
        const Call& inner = parsed.calls[parsed.roots[0]];
        const CallInfo* info = known_call(parsed, inner);
        if (!info) return;
        marker_line_ = ast_.line(call.place);
        if (info->node != Node::material) return evaluate_marker(parsed, inner);
        const Arguments args(parsed, inner, signature(*info), warnings_);
        scopes_.push_back(frames_.back().state);
        frames_.back().state.set_material(materials_.named(material_name(args), where));
    }

    /// A shape's frame would outlive the marker's tree, so it is closed at once.
    void evaluate_marker(const Ast& parsed, const Call& inner) {
        const std::size_t depth = frames_.size();
        evaluate_call(parsed, inner);
        if (frames_.size() > depth) close();
    }

    /// The marker `end` closes the nearest material marker beside it.
    void end_material() {
        if (scopes_.size() <= frames_.back().first_scope) return;
        State& state = frames_.back().state;
        state.material = scopes_.back().material;
        state.from_colour = scopes_.back().from_colour;
        scopes_.pop_back();
    }

    // --- names

    static Signature signature(const CallInfo& info) { return {info.positional, info.named, info.any_arguments}; }

    const CallInfo* known_call(const Ast& ast, const Call& call) {
        static const CallInfo light{"", Node::light, {}, {}, true}, group{"group", Node::group, {}, {}, true};
        const std::string& name = ast.name(call);
        if (const CallInfo* info = find_call(name)) return info;
        if (find_light(options_.registry, name)) return &light;
        std::vector<std::string_view> names(call_names().begin(), call_names().end());
        if (options_.registry)
            for (const LightKind& kind : options_.registry->lights()) names.emplace_back(kind.name);
        const std::string message = "no call \"" + name.substr(0, 40) + "\"" + did_you_mean(name, names);
        if (!options_.unknown_is_warning) throw Error(ErrorCode::bad_input, ast.where(call.place) + ": " + message);
        warnings_.once("call:" + name, ast.where(call.place), message + ": taken as a group");
        return &ast == &ast_ ? &group : nullptr;
    }

    [[noreturn]] static void refuse(const Ast& ast, const Call& call) {
        throw Error(ErrorCode::bad_input, ast.where(call.place) + ": " + ast.name(call) + "() is not supported yet");
    }

    const Ast& ast_;
    const ReadOptions& options_;
    Scene scene_;
    Warnings warnings_;
    MaterialTable materials_;
    ShapeContext shapes_;
    Results results_;
    std::vector<std::uint32_t> markers_;
    std::vector<Frame> frames_;
    std::vector<State> scopes_;                  ///< before each material marker that holds
    std::vector<std::size_t> statement_starts_;  ///< results before each statement at the top
    std::vector<std::uint32_t> backdrop_;        ///< nodes of what `%` marks
    std::uint32_t marker_line_ = 0;
    bool makes_solids_ = true, makes_settings_ = true;
};

}  // namespace

Scene evaluate(const Ast& ast, const ReadOptions& options, const std::string& base_dir) {
    return Evaluator(ast, options, base_dir).run();
}

}  // namespace cardioid::formats::openscad
