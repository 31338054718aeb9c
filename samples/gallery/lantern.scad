// A pierced copper lantern: one small lamp, two hundred windows.
use <../../share/cardioid.scad>

film([640, 480]);
camera([70, -330, 150], look_at = [-6, 10, 70], fov = 40);

define_material("copper", kind = "conductor", metal = "copper", roughness = 0.16);
define_material("plaster", kind = "diffuse", reflectance = [0.72, 0.56, 0.42]);
define_material("blue", kind = "diffuse", reflectance = [0.50, 0.52, 0.58]);
define_material("floor", kind = "plastic", reflectance = [0.34, 0.20, 0.12], roughness = 0.12);
define_material("glow", kind = "emitter", emission = [6200, 4000, 2050]);

// Windows along the golden angle, even over the ball, none where it stands and hangs.
module windows(count, r) {
    for (k = [0:count - 1]) {
        z = 1 - (2 * k + 1) / count;
        if (abs(z) < 0.93) rotate([0, 0, 137.50776 * k]) rotate([0, acos(z), 0])
            translate([0, 0, r * 0.7]) rotate([0, 0, 45]) cylinder(h = r, r = 1.7 + 1.6 * (1 - z * z), $fn = k % 3 == 0 ? 4 : 6);
    }
}

module lantern() {
    material("copper") {
        difference() {
            sphere(40);
            sphere(38.6);
            windows(230, 40);
            translate([0, 0, -60]) cylinder(h = 30, r = 9);
        }
        for (z = [-37, 37]) translate([0, 0, z]) torus(15.5, 1.6);
        translate([0, 0, 38]) cylinder(h = 9, r1 = 9, r2 = 3);
        translate([0, 0, 51]) rotate([90, 0, 30]) torus(4.6, 0.9);
        // Feet.
        for (a = [30:120:270]) rotate([0, 0, a]) {
            translate([21, 0, -46]) sphere(3);
            hull() {
                translate([21, 0, -46]) sphere(1.6);
                translate([15, 0, -37]) sphere(1.6);
            }
        }
    }
    material("glow") sphere(2.1);
}

translate([0, 0, 49]) lantern();

material("floor") translate([-400, -700, -10]) cube([800, 900, 10]);
material("plaster") translate([-400, 130, -10]) cube([800, 20, 500]);
material("blue") translate([-200, -700, -10]) cube([20, 900, 500]);
material("blue") translate([-400, -700, 360]) cube([900, 900, 10]);
material("plaster") translate([260, -700, -10]) cube([20, 900, 500]);
sky([0.09, 0.12, 0.2]);
