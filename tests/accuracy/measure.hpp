#pragma once
#include <memory>
#include <string>
#include <vector>

#include "rt_core/api/lighting.hpp"
#include "rt_core/render/committed_scene.hpp"
#include "tests/accuracy/table.hpp"

namespace cardioid::test {

/// How long to measure.
struct Effort {
    double noise;                 ///< relative standard error to reach
    std::uint64_t most_samples;   ///< of all runs together
    std::uint32_t most_runs = 8;  ///< of a module that prepares something by chance; at least 8
};

/// The mean of independent runs, each with its own seed for the module and the probe.
struct Measured {
    double value = 0, standard_error = 0;
    int runs = 0;
    std::uint64_t samples = 0;  ///< of all runs together
    double cpu_s = 0;
    std::uint64_t bad_samples = 0;

    /// Probability that runs of mean `expected` differ from it so much or more: Student's t test.
    [[nodiscard]] double p_value(double expected) const;
};

/// Measures values of one scene by a lighting module, which is prepared once for all of them.
class Bench {
public:
    Bench(const KnownValue& first, std::string module, std::uint32_t first_seed, Params options);

    /// Runs are repeated from the beginning with more samples, or there are more of them, until their mean is sure
    /// enough, so that the last ones are independent of when they were stopped. `known` has the scene of the first.
    Measured measure(const KnownValue& known, const Effort& effort);

    /// What has been spent on preparing modules [s].
    [[nodiscard]] double prepared_s() const { return prepared_s_; }

private:
    struct Size {
        std::uint32_t runs, each;  ///< and samples of a run
    };
    [[nodiscard]] bool prepares() const { return module_ != "path"; }
    [[nodiscard]] Size first_size(const Place& place) const;
    [[nodiscard]] bool grow(Size& size, const Effort& effort, double lack, bool samples_help) const;
    Measured by_runs(const Place& place, Size size);
    Measured by_one_probe(const Place& place, std::uint32_t samples);
    double once(const Place& place, std::uint32_t run, std::uint32_t samples, Measured& all);
    std::vector<Reading> readings(const Place& place, std::uint32_t run, std::uint32_t samples,
                                  const std::vector<ProbePoint>& points, Measured& all);
    const LightingModule& lighting(std::uint32_t run);

    CommittedScene scene_;
    std::string module_;
    std::uint32_t first_seed_;
    Params options_;
    std::vector<std::unique_ptr<LightingModule>> lighting_;
    double prepared_s_ = 0;
};

/// Probability of |t| or more for Student's distribution.
double student_p(double t, int degrees);

/// Processor time of this thread [s].
double cpu_seconds();

}  // namespace cardioid::test
