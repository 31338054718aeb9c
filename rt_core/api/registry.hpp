#pragma once
#include <span>

#include "rt_core/api/format.hpp"
#include "rt_core/api/light.hpp"
#include "rt_core/api/lighting.hpp"
#include "rt_core/api/shader.hpp"

namespace cardioid {

/// The one door by which every extension enters. Kinds are kept in the order they came; a name is taken once
/// (Error(usage) otherwise). Not thread-safe while kinds are added, which happens before a scene is read.
class Registry {
public:
    virtual ~Registry() = default;
    virtual void add(const ShaderKind&) = 0;
    virtual void add(const LightKind&) = 0;
    virtual void add(const LightingKind&) = 0;
    virtual void add(const Format&) = 0;

    [[nodiscard]] virtual std::span<const ShaderKind> shaders() const = 0;
    [[nodiscard]] virtual std::span<const LightKind> lights() const = 0;
    [[nodiscard]] virtual std::span<const LightingKind> lighting() const = 0;
    [[nodiscard]] virtual std::span<const Format> formats() const = 0;
};

}  // namespace cardioid
