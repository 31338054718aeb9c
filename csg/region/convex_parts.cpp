#include "csg/region/convex_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "csg/leaves/solvers.hpp"

namespace cardioid::csg {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t most_leaves = 8;

/// One end of a leaf's interval.
struct End {
    double t;
    std::uint32_t input, face;
};

class Intervals {
public:
    Intervals(const SolidRegion& region, const Ray& ray)
        : region_(region),
          ray_(ray),
          exact_(exact_along(region.tolerances(), ray)),
          leaves_surface_(ray.from.region != FaceId::none),
          start_(leaves_surface_ ? exact_ : 0),
          near_(leaves_surface_ ? std::max(most_spread * region.tolerances().start, exact_) : 0) {}

    Answer first(Boundary& out) noexcept {
        if (!meet_parts()) return Answer::none;
        meet_cutters();
        if (unsure_) return Answer::unsure;
        if (leave_.t <= start_ || enter_.t >= leave_.t) return Answer::none;
        const bool outside = enter_.t > start_;
        End at = outside ? enter_ : End{start_, 0, 0};
        const bool entering = leave_cutters(at) || outside;
        if (!entering) at = next_end();
        if (unsure_) return Answer::unsure;
        if (entering && at.t >= leave_.t) return Answer::none;
        const Vec3d n = normal(region_.leaves()[at.input], at.face, ray_.o + ray_.d * at.t);
        if (is_near_another(at, std::abs(dot(n, ray_.d)))) return Answer::unsure;
        if (at.t >= ray_.t_max) return Answer::none;
        out = {at.t, (dot(n, ray_.d) < 0) == entering ? n : -n, at.input, entering};
        return Answer::found;
    }

private:
    [[nodiscard]] Span span_of(std::uint32_t input) noexcept {
        const Span span = convex_leaf_span(region_.leaves()[input], ray_.o, ray_.d);
        if (span.empty()) return span;
        spans_[input] = span;
        met_ |= 1U << input;
        // What is between exact and near of the origin may be the face that the ray leaves, or not.
        if (leaves_surface_) unsure_ = unsure_ || is_doubtful(span.t0) || is_doubtful(span.t1);
        return span;
    }
    [[nodiscard]] bool is_doubtful(double t) const noexcept { return std::abs(t) > exact_ && std::abs(t) <= near_; }

    /// Where the line is inside all parts; false where that is nowhere within its reach.
    bool meet_parts() noexcept {
        const auto& inputs = region_.gates().inputs;
        for (std::uint32_t i = 0; i < inputs.size(); ++i) {
            if (inputs[i].negated) continue;
            const Span span = span_of(i);
            if (span.empty()) return false;
            if (span.t0 > enter_.t) enter_ = {span.t0, i, span.face0};
            if (span.t1 < leave_.t) leave_ = {span.t1, i, span.face1};
            // Nothing within reach of the ray is left.
            if (leave_.t < -near_ || enter_.t >= std::max(ray_.t_max, near_)) return false;
        }
        return true;
    }
    void meet_cutters() noexcept {
        const auto& inputs = region_.gates().inputs;
        for (std::uint32_t i = 0; i < inputs.size(); ++i)
            if (inputs[i].negated && !span_of(i).empty()) cutters_ |= 1U << i;
    }
    /// Moves a point that is within cutters to where it is out of all of them; whether it was within one.
    bool leave_cutters(End& at) noexcept {
        bool moved = false;
        for (unsigned left = cutters_; left != 0;) {
            const auto i = static_cast<std::uint32_t>(__builtin_ctz(left));
            left &= left - 1;
            const Span& span = spans_[i];
            if (span.t0 > at.t || span.t1 <= at.t) continue;
            // Faces in one place are counted, which is for the sweep.
            if (at.t - span.t0 <= exact_ && at.t > start_) unsure_ = true;
            at = {span.t1, i, span.face1};
            moved = true;
            left = cutters_ & ~(1U << i);
        }
        return moved;
    }
    /// Where a point that is inside comes out.
    [[nodiscard]] End next_end() const noexcept {
        End next = leave_;
        for (unsigned left = cutters_; left != 0; left &= left - 1) {
            const auto i = static_cast<std::uint32_t>(__builtin_ctz(left));
            const Span& span = spans_[i];
            if (span.t0 > start_ && span.t0 < next.t) next = {span.t0, i, span.face0};
        }
        return next;
    }
    /// Whether another end is so close that it may tie with, or weld away, the boundary, whose normal the ray meets
    /// with the cosine `facing`. A thin part's own ends do not weld.
    [[nodiscard]] bool is_near_another(const End& at, double facing) const noexcept {
        const double tie = 2 * exact_;
        const double weld = std::max(region_.tolerances().weld / std::max(facing, 1 / most_spread), tie);
        int close = 0;
        for (unsigned left = met_; left != 0; left &= left - 1) {
            const auto i = static_cast<std::uint32_t>(__builtin_ctz(left));
            const double before = at.t - tie, beyond = at.t + (i == at.input ? tie : weld);
            const Span& span = spans_[i];
            close += (span.t0 >= before && span.t0 <= beyond) + (span.t1 >= before && span.t1 <= beyond);
        }
        return close > 1;
    }

    const SolidRegion& region_;
    const Ray& ray_;
    double exact_;
    bool leaves_surface_;
    double start_;  ///< what comes up to here is at the origin or behind it
    double near_;   ///< beyond it nothing is the surface that the ray leaves
    bool unsure_ = false;
    End enter_{-infinity, 0, 0}, leave_{infinity, 0, 0};
    unsigned met_ = 0, cutters_ = 0;  ///< a bit an input
    std::array<Span, most_leaves> spans_;
};

}  // namespace

bool is_one_and_of_convex(const GateTree& gates, const std::vector<SolvedLeaf>& leaves) {
    return gates.gates.size() == 1 && leaves.size() <= most_leaves && gates.required != GateTree::none &&
           static_cast<std::size_t>(gates.gates[0].threshold) == leaves.size() &&
           std::ranges::all_of(leaves, [](const SolvedLeaf& leaf) { return is_convex(leaf.solver); });
}

Answer first_by_intervals(const SolidRegion& region, const Ray& ray, Boundary& out) noexcept {
    return Intervals(region, ray).first(out);
}

}  // namespace cardioid::csg
