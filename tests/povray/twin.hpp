#pragma once
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "rt_core/api/format.hpp"
#include "rt_core/api/registry.hpp"
#include "rt_core/image/compare/picture.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::test {

/// How a scene is drawn by us.
struct Drawing {
    std::string lighting = "whitted";
    int samples = 1;  ///< a pixel; 1 goes through its middle
};

/// A scene of tests/povray/scenes: NAME.csg, and NAME.json with its limits and what it is for.
class Twin {
public:
    explicit Twin(const std::string& name);

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] std::filesystem::path csg() const;
    [[nodiscard]] std::filesystem::path limits() const;
    [[nodiscard]] std::string proves() const { return json_.at("proves"); }
    /// Pixels by which outlines may differ, -1 where they are not looked at.
    [[nodiscard]] int silhouette() const { return json_.at("scene").value("silhouette", -1); }
    /// Names of the mistakes that must be found.
    [[nodiscard]] std::vector<std::string> wrong() const { return json_.at("scene").at("wrong"); }
    [[nodiscard]] Drawing drawing() const {
        const nlohmann::json& scene = json_.at("scene");
        return {scene.value("lighting", "whitted"), scene.value("samples", 1)};
    }
    /// How it is written for POV-Ray: with photons and radiosity, lamps as one light.
    [[nodiscard]] WriteOptions writing() const {
        const nlohmann::json& scene = json_.at("scene");
        return {.photons = scene.value("photons", false), .light_arrays = scene.value("area", false)};
    }
    /// An example of OpenSCAD that the .csg file lights and looks at; "" for none.
    [[nodiscard]] std::string model() const { return json_.at("scene").value("model", ""); }
    /// Whether all it needs is installed.
    [[nodiscard]] bool can_run() const;

    /// The scene as both programs get it.
    [[nodiscard]] Scene read() const;

private:
    std::string name_;
    nlohmann::json json_;
};

/// All of them, sorted.
std::vector<std::string> twin_names();

/// The registry of the program.
const Registry& registry();

/// Our picture of a scene, with the layers that tell edges; made in this process.
Picture draw(const Scene& scene, const Drawing& drawing);

/// The scene with one mistake in it: "light", "size", "axis", "ior", "fade", "mirror", "phong", "checker".
Scene with_mistake(Scene scene, const std::string& mistake);

/// The scene with everything shining alike before black, so that its picture is its outline.
Scene outline_of(Scene scene);

}  // namespace cardioid::test
