#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/goals.hpp"
#include "bench/raw_embree.hpp"

namespace cardioid::bench {

/// A mesh both in our tracer and in Embree alone, with the same rays for both.
struct MeshSubject {
    MeshSubject(const TriangleMesh& mesh, const View& view);

    std::unique_ptr<Tracer> tracer;
    RawEmbree robust, plain;  ///< `robust` has the flags of our tracer
    Rays primary, incoherent;
    std::vector<RTCRay> raw_primary, raw_incoherent;
};

/// A CSG model in our tracer.
struct SolidSubject {
    explicit SolidSubject(const Model& model);

    std::unique_ptr<Tracer> tracer;
    Rays primary, random, inside;
};

/// A subject by name, made when a benchmark that was chosen first asks for it.
template <class Subject>
struct Named {
    std::string name;
    std::function<std::unique_ptr<Subject>()> make;
    std::unique_ptr<Subject> made{};  ///< null where no benchmark has asked

    const Subject& get() {
        if (!made) made = make();
        return *made;
    }
};

/// What the benchmarks trace; must outlive them and stay where it is.
struct Subjects {
    std::vector<Named<MeshSubject>> meshes;
    std::vector<Named<SolidSubject>> solids;
    std::vector<Named<SolidSubject>> growth;  ///< one model in four sizes
};

Subjects list_subjects();
void register_benchmarks(Subjects& subjects);
std::vector<Goal> speed_goals(const Subjects& subjects);
/// Of the subjects that were made.
std::vector<Bound> memory_bounds(const Subjects& subjects);

}  // namespace cardioid::bench
