// A worked example: OpenSCAD previews it, Cardioid draws it with glass, a lamp and caustics.
//   cardioid samples/dish.scad --photons -o dish.png
use <../share/cardioid.scad>

film([480, 360], samples = 48);
camera([-40, -190, 120], look_at = [2, 0, 10], fov = 27);

// Light: a lamp is placed like any solid.
translate([-170, 90, 190]) sphere_light(6, radiance = [900, 850, 760]);
sky([0.25, 0.28, 0.33]);

// Materials: defined once, then put on what follows in braces.
define_material("paper", kind = "diffuse", reflectance = [0.75, 0.72, 0.66]);
define_material("green", kind = "dielectric", ior = 1.52, transmittance = [0.35, 0.85, 0.6], distance = 14);
define_material("clear", kind = "dielectric", ior = 1.5);
define_material("gold", kind = "conductor", metal = "gold");

// The colours are for OpenSCAD's preview: the material stands within them, and the inner one counts.
color("MediumSeaGreen", 0.6) material("green") difference() {
    cylinder(h = 18, r1 = 20, r2 = 30);
    translate([0, 0, 43]) sphere(38);
    for (a = [0:30:330]) rotate([0, 0, a]) translate([31, 0, 9]) cylinder(h = 30, r = 4, center = true);
}
color("LightBlue", 0.5) material("clear") translate([42, -18, 11]) sphere(11);
color("Gold") material("gold") translate([-38, -24, 0]) difference() {
    cylinder(h = 9, r = 16);
    translate([0, 0, -1]) cylinder(h = 12, r = 15);
}
color("OldLace") material("paper") translate([-150, -150, -4]) cube([300, 300, 4]);
