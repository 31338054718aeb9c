#include "csg/exact/boolean/run_plan.hpp"

#include <algorithm>
#include <atomic>
#include <exception>

#include "csg/exact/boolean/interruption.hpp"
#include "csg/exact/boolean/mesh_boolean.hpp"
#include "rt_core/api/parallel.hpp"

namespace cardioid::csg {

namespace {

class PlanRunner {
public:
    PlanRunner(std::span<const PlannedBoolean> plan, std::span<const TriangleMesh> leaves, Progress* progress)
        : plan_(plan), leaves_(leaves), progress_(progress), solids_(plan.size()), failures_(plan.size()) {
        levels_.resize(plan.back().height + 1);
        for (std::uint32_t i = 0; i < plan.size(); ++i) {
            levels_[plan[i].height].push_back(i);
            work_.push_back(plan[i].op == SolidOp::leaf ? 1 : 0);
            for (const std::uint32_t part : plan[i].parts) work_[i] += work_[part];
            all_work_ += work_[i];
        }
    }

    TriangleMesh run() {
        if (progress_) progress_->begin("evaluate");
        for (const std::vector<std::uint32_t>& level : levels_) run(level);
        return solids_.back().rounded();
    }

private:
    /// The failure told is that of the first step that fails, whichever thread is there first.
    void run(const std::vector<std::uint32_t>& level) {
        parallel_for(static_cast<std::int64_t>(level.size()), [&](std::int64_t i) {
            const std::uint32_t step = level[static_cast<std::size_t>(i)];
            try {
                run(step);
            } catch (...) {
                failures_[step] = std::current_exception();
            }
        });
        for (const std::uint32_t step : level)
            if (failures_[step]) std::rethrow_exception(failures_[step]);
        for (const std::uint32_t step : level)  // what a later level needs again stays with it
            for (const std::uint32_t part : plan_[step].parts)
                if (last_user(part) == plan_[step].height) solids_[part] = {};
    }

    void run(std::uint32_t step) {
        const Interruption interruption(progress_);
        Interruption::check();
        const PlannedBoolean& at = plan_[step];
        if (at.op == SolidOp::leaf) {
            solids_[step] = ExactSolid(leaves_[step]);
        } else {
            std::vector<ExactSolid> parts;
            for (const std::uint32_t part : at.parts) parts.push_back(solids_[part]);
            solids_[step] = mesh_boolean(at.op, std::move(parts));
        }
        if (progress_) progress_->update((done_ += work_[step]) / all_work_);
    }

    /// The height of the highest step that needs this one.
    std::uint32_t last_user(std::uint32_t part) {
        if (last_users_.empty()) {
            last_users_.resize(plan_.size());
            for (const PlannedBoolean& step : plan_)
                for (const std::uint32_t p : step.parts) last_users_[p] = std::max(last_users_[p], step.height);
        }
        return last_users_[part];
    }

    std::span<const PlannedBoolean> plan_;
    std::span<const TriangleMesh> leaves_;
    Progress* progress_;
    std::vector<ExactSolid> solids_;
    std::vector<std::exception_ptr> failures_;
    std::vector<std::vector<std::uint32_t>> levels_;
    std::vector<std::uint32_t> last_users_;
    std::vector<double> work_;  ///< leaves below each step: about how long it takes
    double all_work_ = 0;
    std::atomic<double> done_{0};
};

}  // namespace

TriangleMesh run_plan(std::span<const PlannedBoolean> plan, std::span<const TriangleMesh> leaves, Progress* progress) {
    return PlanRunner(plan, leaves, progress).run();
}

}  // namespace cardioid::csg
