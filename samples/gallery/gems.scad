// Five stones, cut as jewellers cut them: light gathers beneath them.
use <../../share/cardioid.scad>

film([640, 480]);
camera([4, -128, 88], look_at = [1, -4, 5], fov = 27);

define_material("diamond", kind = "dielectric", ior = 2.42);
define_material("ruby", kind = "dielectric", ior = 1.77, transmittance = [0.86, 0.04, 0.07], distance = 12);
define_material("sapphire", kind = "dielectric", ior = 1.77, transmittance = [0.05, 0.16, 0.86], distance = 14);
define_material("emerald", kind = "dielectric", ior = 1.58, transmittance = [0.05, 0.74, 0.26], distance = 12);
define_material("citrine", kind = "dielectric", ior = 1.55, transmittance = [0.96, 0.66, 0.10], distance = 14);
define_material("stone", kind = "diffuse", reflectance = [0.70, 0.67, 0.62]);
define_material("gold", kind = "conductor", metal = "gold", roughness = 0.08);

// A point by its angle, distance from the axis, and height.
function at(around, far, high) = [far * cos(around), far * sin(around), high];

// The round brilliant, 1 in radius: 57 facets and a girdle. The main facets of crown and pavilion have the slopes of
// Tolkowsky (1919); `mid` and `low` say how far in the small ones reach.
module brilliant(crown = 34.5, pavilion = 40.75, high = 0.3, rim = 0.02, mid = 0.8, low = 0.3) {
    points = concat(
        [for (k = [0:7]) at(45 * k, 1 - high / tan(crown), rim + high)],
        [for (k = [0:7]) at(45 * k + 22.5, mid, rim + tan(crown) * (1 - mid * cos(22.5)))],
        [for (k = [0:15]) at(22.5 * k, 1, rim)],
        [for (k = [0:15]) at(22.5 * k, 1, -rim)],
        [for (k = [0:7]) at(45 * k + 22.5, low, -rim - tan(pavilion) * (1 - low * cos(22.5)))],
        [[0, 0, -rim - tan(pavilion)]]);
    function t(k) = k % 8;
    function m(k) = 8 + (k + 8) % 8;
    function g(k) = 16 + k % 16;
    function h(k) = 32 + k % 16;
    function l(k) = 48 + (k + 8) % 8;
    polyhedron(points, concat(
        [[for (k = [7:-1:0]) t(k)]],
        [for (k = [0:7]) [t(k), t(k + 1), m(k)]],
        [for (k = [0:7]) [t(k), m(k), g(2 * k), m(k - 1)]],
        [for (k = [0:7], j = [0, 1]) [m(k), g(2 * k + j + 1), g(2 * k + j)]],
        [for (k = [0:15]) [g(k), g(k + 1), h(k + 1), h(k)]],
        [for (k = [0:7]) [56, l(k - 1), h(2 * k), l(k)]],
        [for (k = [0:7], j = [0, 1]) [l(k), h(2 * k + j), h(2 * k + j + 1)]]));
}

// An oblong with its corners off, `in` within the girdle.
function oblong(in, high, a = 1.35, b = 1, c = 1.9) =
    let (x = a - in, y = b - in, w = c - in * sqrt(2), v = w - x, u = w - y)
    [for (p = [[x, v], [u, y], [-u, y], [-x, v], [-x, -v], [-u, -y], [u, -y], [x, -v]]) [p[0], p[1], high]];

// The step cut: oblongs one above the other.
module step_cut() {
    rings = [[0.70, -0.76], [0.38, -0.56], [0.14, -0.28], [0, -0.02], [0, 0.02], [0.11, 0.17], [0.28, 0.30]];
    last = len(rings) - 1;
    polyhedron([for (r = rings, p = oblong(r[0], r[1])) p], concat(
        [for (i = [0:last - 1], k = [0:7])
            let (n = (k + 1) % 8) [8 * i + k, 8 * i + 8 + k, 8 * i + 8 + n, 8 * i + n]],
        [[for (k = [0:7]) k], [for (k = [7:-1:0]) 8 * last + k]]));
}

// A brilliant that has come to rest on a facet of its pavilion.
module lying(r, turn) {
    rotate([0, 0, turn]) translate([0, 0, r * 0.655]) rotate([0, 90 - 49.25, 0]) scale(r) brilliant();
}

material("diamond") translate([-3, -14, 0]) lying(13, 250);
material("ruby") translate([-33, 3, 0]) lying(11, 300);
material("sapphire") translate([25, 6, 0]) lying(12, 215);
material("emerald") translate([-4, 25, 3.31]) rotate([0, 0, 24]) rotate([180, 0, 0]) scale(11) step_cut();
material("citrine") translate([29, -25, 0]) lying(7.5, 160);

// Beads that have rolled off a chain.
material("gold") for (b = [[-40, -26, 2.2], [-33, -31, 1.6], [44, -8, 2.4], [10, -37, 1.8], [-18, -33, 1.3]])
    translate([b[0], b[1], b[2]]) sphere(b[2]);

material("stone") translate([-300, -300, -10]) cube([600, 600, 10]);

translate([-150, 90, 170]) sphere_light(6, radiance = [1300, 1220, 1100]);
translate([190, 60, 90]) sphere_light(6, radiance = [300, 335, 400]);
sky([0.32, 0.35, 0.40]);
