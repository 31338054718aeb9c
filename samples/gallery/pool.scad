// The sun through moving water: the net of light on the floor of a pool.
use <../../share/cardioid.scad>

film([640, 480]);
camera([-330, -640, 420], look_at = [20, -30, -60], fov = 38);

define_material("water", kind = "dielectric", ior = 1.333, transmittance = [0.55, 0.86, 0.93], distance = 300);
define_material("tiles", kind = "checker", a = [0.70, 0.80, 0.84], b = [0.50, 0.68, 0.78], size = 25);
define_material("edge", kind = "diffuse", reflectance = [0.74, 0.70, 0.62]);
define_material("deck", kind = "checker", a = [0.60, 0.53, 0.44], b = [0.56, 0.49, 0.40], size = 60);
define_material("steel", kind = "conductor", metal = "chromium", roughness = 0.05);
define_material("red", kind = "plastic", reflectance = [0.68, 0.05, 0.03]);
define_material("white", kind = "plastic", reflectance = [0.80, 0.80, 0.78]);
define_material("yellow", kind = "plastic", reflectance = [0.80, 0.55, 0.03]);

wide = 560;
long = 620;
deep = 150;
cells = 120;

// Waves from a few directions, each [length, height, direction, phase].
waves = [[170, 2.6, 25, 40], [117, 1.9, 78, 130], [83, 1.2, -35, 260], [61, 0.75, 140, 10], [47, 0.5, 60, 300],
         [39, 0.4, -80, 200]];
function add(v, i = 0) = i == len(v) ? 0 : v[i] + add(v, i + 1);
function level(x, y) =
    add([for (w = waves) w[1] * sin(360 / w[0] * (x * cos(w[2]) + y * sin(w[2])) + w[3])]);

// A block of water; its sides reach into the walls.
module water() {
    x0 = -wide / 2 - 3;
    y0 = -long / 2 - 3;
    dx = (wide + 6) / cells;
    dy = (long + 6) / cells;
    n = cells + 1;
    top = [for (j = [0:cells], i = [0:cells]) [x0 + i * dx, y0 + j * dy, level(x0 + i * dx, y0 + j * dy) - 14]];
    base = [for (j = [0, 1], i = [0, 1]) [x0 + i * (wide + 6), y0 + j * (long + 6), -deep - 3]];
    b = n * n;
    polyhedron(
        points = concat(top, base),
        faces = concat(
            [for (j = [0:cells - 1], i = [0:cells - 1]) [j * n + i, (j + 1) * n + i, j * n + i + 1]],
            [for (j = [0:cells - 1], i = [0:cells - 1]) [j * n + i + 1, (j + 1) * n + i, (j + 1) * n + i + 1]],
            [[b, b + 1, b + 3, b + 2]],
            [concat([for (i = [0:cells]) i], [b + 1, b])],
            [concat([for (i = [cells:-1:0]) cells * n + i], [b + 2, b + 3])],
            [concat([for (j = [cells:-1:0]) j * n], [b, b + 2])],
            [concat([for (j = [0:cells]) j * n + cells], [b + 3, b + 1])]));
}

module ring(r, tube) {
    for (k = [0:7]) material(k % 2 == 0 ? "red" : "white") intersection() {
        torus(r, tube);
        rotate([0, 0, 45 * k]) linear_extrude(height = 4 * tube, center = true)
            polygon([[0, 0], [3 * r, 0], [3 * r * cos(45), 3 * r * sin(45)]]);
    }
}

module ladder() {
    material("steel") for (y = [-22, 22]) translate([0, y, 0]) {
        translate([-6, 0, -deep + 20]) cylinder(h = deep + 22, r = 2.6);
        translate([18, 0, 0]) cylinder(h = 42, r = 2.6);
        translate([6, 0, 42]) rotate([90, 0, 0]) difference() {
            torus(12, 2.6);
            translate([-20, -40, -10]) cube([40, 40, 20]);
        }
    }
    material("steel") for (z = [-110, -70, -30]) translate([-6, -22, z]) rotate([-90, 0, 0]) cylinder(h = 44, r = 2);
}

material("tiles") difference() {
    translate([-wide / 2 - 10, -long / 2 - 10, -deep - 20]) cube([wide + 20, long + 20, deep + 20 - 0.5]);
    translate([-wide / 2, -long / 2, -deep]) cube([wide, long, deep + 20]);
}
material("edge") difference() {
    translate([-wide / 2 - 30, -long / 2 - 30, -6]) cube([wide + 60, long + 60, 12]);
    translate([-wide / 2, -long / 2, -40]) cube([wide, long, 80]);
}
material("deck") difference() {
    translate([-700, -700, -40]) cube([1400, 1500, 42]);
    translate([-wide / 2 - 9, -long / 2 - 9, -80]) cube([wide + 18, long + 18, 120]);
}
material("water") water();

translate([70, 40, -12]) rotate([4, -3, 10]) ring(46, 15);
material("yellow") translate([-130, 95, 4]) sphere(24);
translate([wide / 2 - 2, 150, 0]) ladder();

sun([0.46, 0.30, -0.84], irradiance = [3.6, 3.35, 2.9], angle = 0.53);
sky([0.30, 0.42, 0.62]);
