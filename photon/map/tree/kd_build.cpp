#include "photon/map/tree/kd_build.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <span>

#include "rt_core/api/error.hpp"
#include "rt_core/api/parallel.hpp"

namespace cardioid::photon {

namespace {

constexpr std::uint32_t bucket_size = 32;
/// Ranges up to this many keys, or this share of all, are one thread's work.
constexpr std::uint32_t least_job = 1U << 15, most_jobs = 32;
constexpr std::uint32_t chunk_size = 1U << 14;

struct Bounds {
    Vec3 lo{HUGE_VALF, HUGE_VALF, HUGE_VALF}, hi{-HUGE_VALF, -HUGE_VALF, -HUGE_VALF};
    void include(Vec3 p) { lo = min(lo, p), hi = max(hi, p); }
    void include(const Bounds& b) { lo = min(lo, b.lo), hi = max(hi, b.hi); }
};

struct Range {
    std::uint32_t first, count;
    int levels;  ///< how many splits may lie on a path from here
};

/// Left of the cut is what comes before (at, index): no key has both.
struct Cut {
    int axis;
    float at;
    std::uint32_t index;  ///< 0: ties go right
    [[nodiscard]] bool left(const KdKey& key) const {
        const float x = key.p[axis];
        return (x < at) | ((x == at) & (key.index < index));
    }
};

std::uint32_t chunk_count(std::size_t n) { return static_cast<std::uint32_t>((n + chunk_size - 1) / chunk_size); }
std::span<KdKey> chunk_of(std::span<KdKey> keys, std::size_t chunk) {
    const std::size_t first = chunk * chunk_size;
    return keys.subspan(first, std::min<std::size_t>(chunk_size, keys.size() - first));
}

Bounds bounds_of(std::span<const KdKey> keys) {
    Bounds b;
    for (const KdKey& key : keys) b.include(key.position());
    return b;
}

Bounds bounds_in_parallel(std::span<KdKey> keys) {
    if (keys.size() <= chunk_size) return bounds_of(keys);  // waking threads would take longer
    std::vector<Bounds> parts(chunk_count(keys.size()));
    parallel_for(static_cast<std::int64_t>(parts.size()), [&](std::int64_t i) {
        parts[static_cast<std::size_t>(i)] = bounds_of(chunk_of(keys, static_cast<std::size_t>(i)));
    });
    Bounds all;
    for (const Bounds& b : parts) all.include(b);
    return all;
}

/// How deep a balanced tree over n points is.
int balanced_levels(std::size_t n) { return static_cast<int>(std::bit_width((n + bucket_size - 1) / bucket_size - 1)); }

class Builder {
public:
    explicit Builder(UntouchedVector<KdKey>& keys)
        : keys_(keys),
          spare_(keys.size()),
          job_size_(std::max(least_job, static_cast<std::uint32_t>(keys.size() / most_jobs))) {}
    std::vector<KdNode> build();

private:
    /// The top of the tree, down to the jobs.
    struct Plan {
        Cut cut;
        std::size_t left, right;  ///< plans; both 0 in a job
        std::vector<KdNode> nodes;
    };
    struct Job {
        Range range;
        std::size_t plan;
    };

    std::size_t plan(Range r);
    void build(Range r, std::vector<KdNode>& nodes);
    void emit(std::size_t plan, std::vector<KdNode>& nodes);
    std::uint32_t split(Range r, Cut& cut);
    Cut median(Range r, int axis);
    void rejoin(Range r, std::uint32_t left);
    std::uint32_t partition(Range r, const Cut& cut);
    std::uint32_t partition_in_parallel(Range r, const Cut& cut);

    std::span<KdKey> keys_of(Range r) { return std::span(keys_).subspan(r.first, r.count); }
    KdKey* spare_of(Range r) { return spare_.data() + r.first; }

    UntouchedVector<KdKey>& keys_;
    UntouchedVector<KdKey> spare_;
    std::uint32_t job_size_;
    std::vector<Plan> plans_;
    std::vector<Job> jobs_;
};

/// Keeps the order on both sides; returns how many are left. Without branches: which way a key goes is a coin's toss.
std::uint32_t Builder::partition(Range r, const Cut& cut) {
    KdKey* const keys = keys_.data() + r.first;
    KdKey* const spare = spare_of(r);
    std::uint32_t left = 0, right = 0;
    for (std::uint32_t i = 0; i < r.count; ++i) {
        const KdKey key = keys[i];
        const bool is_left = cut.left(key);
        keys[left] = key;
        spare[right] = key;
        left += is_left;
        right += !is_left;
    }
    std::copy(spare, spare + right, keys + left);
    return left;
}

std::uint32_t Builder::partition_in_parallel(Range r, const Cut& cut) {
    const std::span<KdKey> keys = keys_of(r);
    std::vector<std::uint32_t> lefts(chunk_count(r.count) + 1);
    const auto chunks = static_cast<std::int64_t>(lefts.size() - 1);
    parallel_for(chunks, [&](std::int64_t i) {
        const auto chunk = chunk_of(keys, static_cast<std::size_t>(i));
        std::uint32_t left = 0;
        for (const KdKey& key : chunk) left += cut.left(key);
        lefts[static_cast<std::size_t>(i) + 1] = left;
    });
    for (std::size_t i = 1; i < lefts.size(); ++i) lefts[i] += lefts[i - 1];
    KdKey* const spare = spare_of(r);
    parallel_for(chunks, [&](std::int64_t i) {
        const auto c = static_cast<std::size_t>(i);
        KdKey* to[2] = {spare + (lefts.back() + c * chunk_size - lefts[c]), spare + lefts[c]};
        for (const KdKey& key : chunk_of(keys, c)) *to[cut.left(key)]++ = key;
    });
    parallel_for(chunks, [&](std::int64_t i) {
        const auto to = chunk_of(keys, static_cast<std::size_t>(i));
        std::copy_n(spare + static_cast<std::size_t>(i) * chunk_size, to.size(), to.begin());
    });
    return lefts.back();
}

/// Undoes a partition.
void Builder::rejoin(Range r, std::uint32_t left) {
    const std::span<KdKey> keys = keys_of(r);
    std::ranges::merge(keys.first(left), keys.subspan(left), spare_of(r), {}, &KdKey::index, &KdKey::index);
    std::copy_n(spare_of(r), r.count, keys.begin());
}

Cut Builder::median(Range r, int axis) {
    KdKey* const spare = spare_of(r);
    std::ranges::copy(keys_of(r), spare);
    KdKey* const middle = spare + r.count / 2;
    std::nth_element(spare, middle, spare + r.count, [axis](const KdKey& a, const KdKey& b) {
        return a.p[axis] < b.p[axis] || (a.p[axis] == b.p[axis] && a.index < b.index);
    });
    return {axis, middle->p[axis], middle->index};
}

/// Divides the keys of r, which has more than a bucket's; returns how many are left.
std::uint32_t Builder::split(Range r, Cut& cut) {
    const Bounds b = r.count > job_size_ ? bounds_in_parallel(keys_of(r)) : bounds_of(keys_of(r));
    const Vec3 half = b.hi * 0.5F - b.lo * 0.5F;  // halves, so that nothing overflows
    const int axis = half.x >= half.y && half.x >= half.z ? 0 : half.y >= half.z ? 1 : 2;
    const float lo = b.lo[axis], hi = b.hi[axis];
    const float middle = lo * 0.5F + hi * 0.5F;
    const auto divide = [&] { return r.count > job_size_ ? partition_in_parallel(r, cut) : partition(r, cut); };
    if (lo < hi) {
        cut = {axis, middle > lo ? middle : hi, 0};
        const std::uint32_t left = divide();
        if (balanced_levels(std::max(left, r.count - left)) < r.levels) return left;
        rejoin(r, left);
    }
    cut = median(r, axis);
    return divide();
}

void Builder::build(Range r, std::vector<KdNode>& nodes) {
    if (r.count <= bucket_size) {
        nodes.push_back(KdNode::bucket({r.first, r.count}));
        return;
    }
    Cut cut{};
    const std::uint32_t left = split(r, cut);
    const std::size_t self = nodes.size();
    nodes.push_back(KdNode::split(0, 0, 0));
    build({r.first, left, r.levels - 1}, nodes);
    nodes[self] =
        KdNode::split(static_cast<unsigned>(cut.axis), cut.at, static_cast<std::uint32_t>(nodes.size() - self));
    build({r.first + left, r.count - left, r.levels - 1}, nodes);
}

std::size_t Builder::plan(Range r) {
    const std::size_t self = plans_.size();
    plans_.emplace_back();
    if (r.count <= job_size_) {
        jobs_.push_back({r, self});
        return self;
    }
    Cut cut{};
    const std::uint32_t left = split(r, cut);
    const std::size_t left_plan = plan({r.first, left, r.levels - 1});
    const std::size_t right_plan = plan({r.first + left, r.count - left, r.levels - 1});
    plans_[self] = {cut, left_plan, right_plan, {}};
    return self;
}

void Builder::emit(std::size_t plan, std::vector<KdNode>& nodes) {
    Plan& p = plans_[plan];
    if (p.left == 0) {
        nodes.insert(nodes.end(), p.nodes.begin(), p.nodes.end());
        p.nodes = {};
        return;
    }
    const std::size_t self = nodes.size();
    nodes.push_back(KdNode::split(0, 0, 0));
    emit(p.left, nodes);
    nodes[self] =
        KdNode::split(static_cast<unsigned>(p.cut.axis), p.cut.at, static_cast<std::uint32_t>(nodes.size() - self));
    emit(p.right, nodes);
}

std::vector<KdNode> Builder::build() {
    plan({0, static_cast<std::uint32_t>(keys_.size()), kd_depth_bound(keys_.size())});
    const auto build_job = [&](std::int64_t i) {
        const Job& job = jobs_[static_cast<std::size_t>(i)];
        std::vector<KdNode>& nodes = plans_[job.plan].nodes;
        nodes.reserve(job.range.count / 8);
        build(job.range, nodes);
    };
    if (jobs_.size() == 1)
        build_job(0);
    else
        parallel_for(static_cast<std::int64_t>(jobs_.size()), build_job);
    std::size_t count = plans_.size();
    for (const Plan& p : plans_) count += p.nodes.size();
    std::vector<KdNode> nodes;
    nodes.reserve(count - jobs_.size());
    emit(0, nodes);
    return nodes;
}

void check_positions(std::span<const KdKey> keys, std::size_t count) {
    for (const KdKey& key : keys) {
        const auto [x, y, z] = key.position();
        if (!is_finite(key.position()))
            throw Error(
                ErrorCode::bad_input,
                fmt::format("point {} of {} is at ({}, {}, {}); wanted finite coordinates", key.index, count, x, y, z));
    }
}

}  // namespace

int kd_depth_bound(std::size_t points) noexcept {
    return points < 2 ? 1 : static_cast<int>(std::bit_width(points - 1)) + 1;
}

KdLayout lay_out_kd(UntouchedVector<KdKey> keys) {
    constexpr std::size_t most = std::size_t{1} << 30;
    if (keys.size() > most)
        throw Error(ErrorCode::limit, fmt::format("{} points in a tree; it holds at most {}", keys.size(), most));
    for_chunks(keys.size(), [&](std::size_t first, std::size_t last) {
        check_positions(std::span(keys).subspan(first, last - first), keys.size());
    });
    KdLayout out;
    if (keys.empty()) return out;
    out.keys = std::move(keys);
    const Bounds b = bounds_in_parallel(out.keys);
    out.lo = b.lo, out.hi = b.hi;
    out.nodes = Builder(out.keys).build();
    return out;
}

}  // namespace cardioid::photon
