#pragma once
#include <memory>
#include <vector>

#include "rt_core/math/box.hpp"
#include "rt_core/scene/triangle_mesh.hpp"

namespace cardioid::csg {

struct ExactData;

/// A solid between two booleans: a closed surface whose corners have exact numbers, so that a parent meets planes, not
/// what rounding left of them. Cheap to copy; copies may be used by one thread at a time.
class ExactSolid {
public:
    /// Nothing at all.
    ExactSolid() = default;
    explicit ExactSolid(const TriangleMesh& mesh);
    explicit ExactSolid(std::shared_ptr<const ExactData> data) : data_(std::move(data)) {}

    [[nodiscard]] bool empty() const { return data_ == nullptr; }
    [[nodiscard]] const ExactData& data() const { return *data_; }
    /// Whether it stands there as it was given, no boolean in between: rounding changes nothing.
    [[nodiscard]] bool is_plain() const;
    /// A box that holds it.
    [[nodiscard]] Box3d bounds() const;
    /// The nearest doubles, equal corners welded, without triangles that became none.
    [[nodiscard]] TriangleMesh rounded() const;

private:
    std::shared_ptr<const ExactData> data_;
};

}  // namespace cardioid::csg
