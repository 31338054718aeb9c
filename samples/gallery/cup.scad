// The curve that the program is named after, where most people have met it: a lamp over the rim of a steel mug draws
// a bright cusp on milk coffee.
use <../../share/cardioid.scad>

film([640, 480]);
camera([52, -128, 225], look_at = [8, -2, 40], fov = 32, lens_radius = 1, focus = 220);

define_material("steel", kind = "conductor", metal = "chromium");
define_material("brushed", kind = "conductor", metal = "chromium", roughness = 0.22);
define_material("coffee", kind = "plastic", reflectance = [0.50, 0.29, 0.14], ior = 1.33);
define_material("china", kind = "plastic", reflectance = [0.78, 0.77, 0.74], ior = 1.5);
define_material("table", kind = "plastic", reflectance = [0.20, 0.085, 0.04], roughness = 0.25);
define_material("cloth", kind = "diffuse", reflectance = [0.13, 0.24, 0.36]);
define_material("sugar", kind = "diffuse", reflectance = [0.85, 0.84, 0.80]);

inner = 37;
outer = 39;
height = 82;

module mug() {
    material("steel") difference() {
        cylinder(h = height, r = outer - 0.6);
        translate([0, 0, 3]) cylinder(h = height, r = inner);
    }
    material("brushed") difference() {
        cylinder(h = height - 2, r = outer);
        translate([0, 0, -1]) cylinder(h = height + 1, r = outer - 0.5);
    }
    // The handle: half a ring that reaches into the wall.
    material("brushed") difference() {
        translate([outer - 2, 0, height / 2]) rotate([90, 0, 0]) torus(24, 4.2);
        cylinder(h = height, r = outer - 0.5);
    }
    // The coffee reaches into the wall, too, so that no gap is left.
    material("coffee") translate([0, 0, 4]) cylinder(h = 52, r = inner + 0.3);
}

// A plate turned from its outline.
module saucer() {
    material("china") rotate_extrude()
        polygon([[0, 0], [38, 0], [40, 1], [62, 7], [76, 13], [77.5, 14.4], [77, 15.4], [75, 15], [60, 9.6], [44, 4.4],
                 [40, 3.4], [0, 3.2]]);
}

module spoon() {
    material("steel") {
        intersection() {
            difference() {
                scale([17, 11, 7]) sphere(1);
                translate([0, 0, 1]) scale([16.2, 10.2, 6.6]) sphere(1);
            }
            translate([-30, -30, -20]) cube([60, 60, 20.5]);
        }
        hull() {
            translate([15, 0, -0.4]) sphere(1.5);
            translate([45, 0, 3.5]) sphere(1.5);
        }
        hull() {
            translate([45, 0, 3.5]) sphere(1.5);
            translate([88, 0, 1.5]) scale([4, 3.4, 1]) sphere(1.3);
        }
    }
}

translate([0, 0, 3.4]) mug();
saucer();
translate([-22, -62, 14.5]) rotate([0, 4, 18]) spoon();

material("sugar") {
    translate([88, 12, 0]) rotate([0, 0, 20]) cube([15, 15, 11]);
    translate([97, -12, 0]) rotate([0, 0, -35]) cube([15, 15, 11]);
    translate([91, 2, 11.05]) rotate([0, 0, 55]) cube([15, 15, 11]);
}

material("table") translate([-260, -220, -12]) cube([520, 520, 11]);
material("cloth") translate([-135, -150, -1]) rotate([0, 0, 8]) cube([270, 240, 1]);

// A lamp far off whose cone holds the table and no more.
lamp = [-490, 290, 232];
translate(lamp) rotate([0, acos(lamp[2] / norm(lamp)), atan2(lamp[1], lamp[0])])
    spot_light(intensity = [1.5e6, 1.36e6, 1.15e6], angle = 16, inner = 13);
sky([0.30, 0.36, 0.46]);
