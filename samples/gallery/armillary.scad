// An armillary sphere of gold about a ball of glass; its rings draw their own curves of light on the table.
use <../../share/cardioid.scad>

film([480, 560]);
camera([120, -440, 255], look_at = [4, 0, 84], fov = 30);

define_material("gold", kind = "conductor", metal = "gold", roughness = 0);
define_material("satin", kind = "conductor", metal = "gold", roughness = 0.18);
define_material("glass", kind = "dielectric", ior = 1.5, transmittance = [0.94, 0.97, 0.99], distance = 60);
define_material("ebony", kind = "plastic", reflectance = [0.035, 0.022, 0.018], roughness = 0.04);
define_material("table", kind = "diffuse", reflectance = [0.66, 0.62, 0.56]);
define_material("wall", kind = "diffuse", reflectance = [0.10, 0.15, 0.18]);

// A flat band about z.
module band(r, high, thick = 1.6) {
    difference() {
        translate([0, 0, -high / 2]) cylinder(h = high, r = r);
        translate([0, 0, -high]) cylinder(h = 2 * high, r = r - thick);
    }
}

module rings() {
    material("gold") {
        band(74, 9);
        rotate([90, 0, 0]) band(72, 7);
        rotate([90, 0, 90]) band(70, 7);
        rotate([23.4, 0, 30]) band(67.5, 12);
        translate([0, 0, 29]) band(60, 3);
        translate([0, 0, -29]) band(60, 3);
    }
    // The axis, and pins where the rings are joined.
    material("satin") {
        translate([0, 0, -86]) cylinder(h = 172, r = 1.7);
        for (z = [-86, 86]) translate([0, 0, z]) sphere(4);
        for (a = [0:90:270]) rotate([0, 0, a]) translate([73.5, 0, 0]) sphere(2.6);
    }
    material("glass") sphere(24);
}

module stand() {
    material("satin") difference() {
        translate([0, 0, 108]) rotate([90, 0, 0]) difference() {
            translate([0, 0, -5]) cylinder(h = 10, r = 92);
            translate([0, 0, -6]) cylinder(h = 12, r = 87);
        }
        translate([-100, -100, 108]) cube([200, 200, 100]);
    }
    for (x = [-89.5, 89.5]) material("satin") translate([x, 0, 109]) sphere(6);
    material("ebony") rotate_extrude()
        polygon(concat([[0, 0], [52, 0], [53, 2], [53, 5], [50, 8]],
                       [for (k = [0:12]) let (a = 90 * k / 12) [46 - 32 * sin(a), 10 + 14 * (1 - cos(a))]],
                       [[9, 24.5], [9, 26], [0, 26]]));
}

translate([0, 0, 108]) rotate([0, 28, 20]) rings();
stand();

material("table") translate([-420, -420, -20]) cube([840, 860, 20]);
material("wall") translate([-420, 420, -20]) cube([840, 20, 520]);

translate([-330, -160, 420]) sphere_light(13, radiance = [1500, 1380, 1180]);
translate([320, -420, 500]) rotate([32, 28, 0]) area_light([200, 200], radiance = [4.5, 5.0, 5.6]);
sky([0.40, 0.42, 0.46]);
