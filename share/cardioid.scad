// Cardioid's calls as OpenSCAD modules: `use <cardioid.scad>`, and a model with materials, lights and cameras opens in
// OpenSCAD without a warning. `openscad -o scene.csg scene.scad` carries them along as texts that are no geometry
// (the modifier %), each in the place of its call, where Cardioid reads them. Numbers keep OpenSCAD's 6 digits.

// A call of the language, as it is written there; texts in it stand in single quotes.
module cardioid_mark(call) {
    %text(text = str("@cardioid ", call), size = 0.001);
}

function cardioid_value(v) = is_string(v) ? str("'", v, "'") : str(v);

// "name = value, ..." of a list of [name, value], without those that are undef.
function cardioid_arguments(pairs) =
    let (given = [for (p = pairs) if (!is_undef(p[1])) str(p[0], " = ", cardioid_value(p[1]))])
    cardioid_join(given, len(given));
function cardioid_join(parts, n) =
    n == 0 ? "" : n == 1 ? parts[0] : str(cardioid_join(parts, n - 1), ", ", parts[n - 1]);

module cardioid_call(name, pairs) {
    cardioid_mark(str(name, "(", cardioid_arguments(pairs), ")"));
}

module film(size, samples, exposure) {
    cardioid_call("film", [["size", size], ["samples", samples], ["exposure", exposure]]);
}

module camera(eye, look_at, up, fov, fov_axis, lens_radius, focus, name, projection, width) {
    cardioid_call("camera", [["eye", eye], ["look_at", look_at], ["up", up], ["fov", fov], ["fov_axis", fov_axis],
                             ["lens_radius", lens_radius], ["focus", focus], ["name", name],
                             ["projection", projection], ["width", width]]);
}

module define_material(name, kind, emission, reflectance, diffuse, specular, exponent, normalized, attenuation,
                       attenuation_p, ior, roughness, metal, eta, k, absorption, transmittance, distance, priority,
                       a, b, size) {
    cardioid_call("define_material",
                  [["name", name], ["kind", kind], ["emission", emission], ["reflectance", reflectance],
                   ["diffuse", diffuse], ["specular", specular], ["exponent", exponent], ["normalized", normalized],
                   ["attenuation", attenuation], ["attenuation_p", attenuation_p], ["ior", ior],
                   ["roughness", roughness], ["metal", metal], ["eta", eta], ["k", k], ["absorption", absorption],
                   ["transmittance", transmittance], ["distance", distance], ["priority", priority], ["a", a],
                   ["b", b], ["size", size]]);
}

// Holds for its children; the closing mark bounds it where OpenSCAD splices them into their parent.
module material(name) {
    cardioid_call("material", [["name", name]]);
    children();
    cardioid_mark("end");
}

module map_color(color, material) {
    cardioid_call("map_color", [["color", color], ["material", material]]);
}

module area_light(size, radiance, power, visible) {
    cardioid_call("area_light", [["size", size], ["radiance", radiance], ["power", power], ["visible", visible]]);
}

module sphere_light(r, radiance, power, visible) {
    cardioid_call("sphere_light", [["r", r], ["radiance", radiance], ["power", power], ["visible", visible]]);
}

module disk_light(r, radiance, power, visible) {
    cardioid_call("disk_light", [["r", r], ["radiance", radiance], ["power", power], ["visible", visible]]);
}

module point_light(intensity, power, shadows) {
    cardioid_call("point_light", [["intensity", intensity], ["power", power], ["shadows", shadows]]);
}

module spot_light(intensity, power, angle, inner) {
    cardioid_call("spot_light", [["intensity", intensity], ["power", power], ["angle", angle], ["inner", inner]]);
}

module sun(direction, irradiance, angle) {
    cardioid_call("sun", [["direction", direction], ["irradiance", irradiance], ["angle", angle]]);
}

module sky(radiance, file, rotation, cie, elevation) {
    cardioid_call("sky", [["radiance", radiance], ["file", file], ["rotation", rotation], ["cie", cie],
                          ["elevation", elevation]]);
}

module photons(count, mode, error, caustic_count) {
    cardioid_call("photons", [["count", count], ["mode", mode], ["error", error], ["caustic_count", caustic_count]]);
}

// Solids that OpenSCAD can show: Cardioid takes them as the true curves.
module torus(R, r) {
    rotate_extrude() translate([R, 0]) circle(r);
}

module ellipsoid(radii) {
    scale(radii) sphere(1);
}

module include_mesh(file) {
    import(file);
}

// Unbounded, so OpenSCAD shows nothing of it.
module half_space(n, d) {
    cardioid_call("half_space", [["n", n], ["d", d]]);
}
