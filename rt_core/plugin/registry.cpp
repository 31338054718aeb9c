#include "rt_core/plugin/registry.hpp"

#include <fmt/format.h>
#include <string_view>

namespace cardioid {
namespace {

/// Adds `kind` unless its name is taken.
template <class Kind>
void add_once(std::vector<Kind>& kinds, const Kind& kind, std::string_view what) {
    for (const Kind& old : kinds)
        if (std::string_view(old.name) == kind.name)
            throw Error(ErrorCode::usage, fmt::format("there is already a {} named \"{}\"", what, kind.name));
    kinds.push_back(kind);
}

class ProgramRegistry final : public Registry {
public:
    void add(const ShaderKind& kind) override { add_once(shaders_, kind, "shader"); }
    void add(const LightKind& kind) override { add_once(lights_, kind, "light"); }
    void add(const LightingKind& kind) override { add_once(lighting_, kind, "lighting"); }
    void add(const Format& format) override { add_once(formats_, format, "format"); }

    [[nodiscard]] std::span<const ShaderKind> shaders() const override { return shaders_; }
    [[nodiscard]] std::span<const LightKind> lights() const override { return lights_; }
    [[nodiscard]] std::span<const LightingKind> lighting() const override { return lighting_; }
    [[nodiscard]] std::span<const Format> formats() const override { return formats_; }

private:
    std::vector<ShaderKind> shaders_;
    std::vector<LightKind> lights_;
    std::vector<LightingKind> lighting_;
    std::vector<Format> formats_;
};

}  // namespace

std::unique_ptr<Registry> make_registry() { return std::make_unique<ProgramRegistry>(); }

}  // namespace cardioid
