// A rotunda after the Pantheon: the sun through the eye of the dome is all the light there is.
use <../../share/cardioid.scad>

film([480, 560]);
camera([0, -20.2, 3.2], look_at = [1.5, 6, 13.2], fov = 74);

define_material("concrete", kind = "diffuse", reflectance = [0.66, 0.60, 0.52]);
define_material("marble", kind = "plastic", reflectance = [0.62, 0.46, 0.34], roughness = 0.1);
define_material("porphyry", kind = "plastic", reflectance = [0.34, 0.10, 0.08], roughness = 0.08);
define_material("cornice", kind = "diffuse", reflectance = [0.74, 0.70, 0.64]);
define_material("floor", kind = "checker", a = [0.66, 0.60, 0.50], b = [0.30, 0.17, 0.13], size = 2.4);

r = 21.6;     // of dome and drum; the dome's ball would touch the floor
eye = 4.4;
drum = 21.6;

// One coffer: three frames, each deeper and smaller, seen from the middle of the floor.
module coffer(row) {
    up = 10 + 12.6 * row;
    side = r * 0.166 * cos(up);
    rotate([0, -up, 0]) for (k = [0:2])
        translate([r - 0.5, -side * (1 - 0.2 * k) / 2, -1.75 + 0.33 * k + 0.12 * row])
            cube([1.0 + 0.45 * k, side * (1 - 0.2 * k), 3.4 - 0.66 * k - 0.24 * row]);
}

module dome() {
    material("concrete") difference() {
        translate([0, 0, drum]) sphere(r + 3);
        translate([0, 0, drum]) sphere(r);
        translate([-40, -40, -40]) cube([80, 80, 40 + drum]);
        // The eye widens outward, or little of a slanting beam would pass it.
        translate([0, 0, drum + 20]) cylinder(h = 8, r1 = eye - 1.14, r2 = eye + 7);
        for (row = [0:4], k = [0:27]) translate([0, 0, drum]) rotate([0, 0, (k + 0.5) * 360 / 28]) coffer(row);
    }
    material("cornice") translate([0, 0, drum + 20.8]) torus(eye + 0.1, 0.4);
}

// A recess with a round head, behind two columns.
module niche(round) {
    translate([r - 0.6, 0, 0]) {
        if (round) intersection() {
            union() {
                translate([0, 0, 1]) cylinder(h = 8.2, r = 3.4);
                translate([0, 0, 9.2]) sphere(3.4);
            }
            translate([-1, -6, 0]) cube([8, 12, 20]);
        }
        else translate([0, -3.4, 1]) cube([4, 6.8, 9.4]);
    }
}

module column() {
    material("porphyry") translate([0, 0, 1.5]) cylinder(h = 8.1, r1 = 0.56, r2 = 0.48);
    material("cornice") {
        translate([-0.8, -0.8, 0]) cube([1.6, 1.6, 1.0]);
        translate([0, 0, 1.0]) cylinder(h = 0.5, r1 = 0.76, r2 = 0.6);
        translate([0, 0, 9.6]) cylinder(h = 0.9, r1 = 0.5, r2 = 0.85);
        translate([-0.85, -0.85, 10.5]) cube([1.7, 1.7, 0.35]);
    }
}

module hall() {
    material("marble") difference() {
        cylinder(h = drum + 0.05, r = r + 6);
        translate([0, 0, -1]) cylinder(h = drum + 2, r = r);
        for (k = [0:7]) rotate([0, 0, 22.5 + 45 * k + 22.5]) niche(k % 2 == 1);
        // Blind windows of the attic.
        for (k = [0:15]) rotate([0, 0, 22.5 * k + 11.25]) translate([r - 0.5, -1.5, 14.6]) cube([1.6, 3, 4]);
    }
    material("cornice") {
        for (c = [[11.3, 0.9, 0.5], [12.2, 0.45, 0.85], [20.6, 0.6, 0.45], [21.2, 0.45, 0.8]]) difference() {
            translate([0, 0, c[0]]) cylinder(h = c[1], r = r + 1);
            translate([0, 0, c[0] - 1]) cylinder(h = c[1] + 2, r = r - c[2]);
        }
    }
    for (k = [0:7], y = [-3.95, 3.95]) rotate([0, 0, 45 * k]) translate([r - 0.4, y, 0]) column();
}

dome();
hall();
material("floor") translate([-30, -30, -2]) cube([60, 60, 2]);

// The sun stands behind the visitor's left shoulder and shines through the eye onto the coffers and the wall before him:
// a lamp far off whose cone is no wider than the eye. What the eye shows of the sky is a disc of it.
ray = [0.30, 0.62, -0.72] / norm([0.30, 0.62, -0.72]);
top = [0, 0, drum + sqrt(r * r - eye * eye)];
lamp = top - 900 * ray;
translate(lamp) rotate([0, acos(-ray[2]), atan2(-ray[1], -ray[0])])
    spot_light(intensity = [5.6e7, 5.2e7, 4.5e7], angle = 0.29, inner = 0.285);
translate(top + [0, 0, 4]) disk_light(eye + 2, radiance = [3, 4.2, 6], visible = false);
