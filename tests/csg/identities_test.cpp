#include <functional>
#include <gtest/gtest.h>

#include "tests/csg/models.hpp"

namespace cardioid::csg {
namespace {

using test::Random;

/// Three random solids on the integer grid and a world W around them.
struct Solids {
    SolidTree tree;
    std::uint32_t a, b, c, w;

    std::uint32_t unite(std::uint32_t x, std::uint32_t y) { return tree.add_node(SolidOp::unite, {x, y}); }
    std::uint32_t meet(std::uint32_t x, std::uint32_t y) { return tree.add_node(SolidOp::intersect, {x, y}); }
    std::uint32_t minus(std::uint32_t x, std::uint32_t y) { return tree.add_node(SolidOp::subtract, {x, y}); }
    std::uint32_t no(std::uint32_t x) { return minus(w, x); }
};

Solids random_solids(unsigned seed) {
    Random random(seed);
    Solids s;
    const auto leaf = [&] {
        const auto at = [&](int lo, int hi) { return static_cast<double>(random.whole(lo, hi)); };
        return test::box_leaf({at(0, 6), at(0, 6), at(0, 6)}, {at(1, 4), at(1, 4), at(1, 4)});
    };
    s.a = test::random_tree(s.tree, random, 2, leaf);
    s.b = test::random_tree(s.tree, random, 2, leaf);
    s.c = test::random_tree(s.tree, random, 2, leaf);
    s.w = s.tree.add_leaf(test::box_leaf({-5, -5, -5}, {30, 30, 30}));
    return s;
}

/// Axis-parallel rays through every half-grid point of the side, and some oblique ones.
std::vector<Ray> rays(Random& random) {
    std::vector<Ray> out;
    for (int axis = 0; axis < 3; ++axis)
        for (double u = 0; u <= 10; u += 0.5)
            for (double v = 0; v <= 10; v += 0.5) {
                Vec3d o{u, u, u}, d;
                o[(axis + 1) % 3] = v;
                o[axis] = -20, d[axis] = 1;
                out.push_back({o, d, 1e9, {}, {}});
            }
    for (int i = 0; i < 100; ++i) {
        const Vec3d d = random.direction();
        out.push_back({random.point(0, 10) - d * 40.0, d, 1e9, {}, {}});
    }
    return out;
}

using Build = std::function<std::uint32_t(Solids&)>;

/// Boundaries of both sides of an identity, bit for bit, over many solids and rays.
void expect_identical(const Build& left, const Build& right) {
    for (unsigned seed = 1; seed <= 25; ++seed) {
        Solids s = random_solids(seed);
        SolidTree other = s.tree;
        s.tree.roots = {left(s)};
        const auto l = test::whole(s.tree, false);
        std::swap(s.tree, other);
        s.tree.roots = {right(s)};
        const auto r = test::whole(s.tree, false);
        Random random(seed + 1000);
        std::vector<Boundary> bl, br;
        for (const Ray& ray : rays(random)) {
            bl.clear(), br.clear();
            if (l) l->boundaries(ray, bl);
            if (r) r->boundaries(ray, br);
            ASSERT_EQ(bl.size(), br.size()) << "seed " << seed << " o " << ray.o.x << ' ' << ray.o.y << ' ' << ray.o.z;
            for (std::size_t i = 0; i < bl.size(); ++i) {
                ASSERT_EQ(bl[i].t, br[i].t) << "seed " << seed;
                ASSERT_EQ(bl[i].entering, br[i].entering);
            }
        }
    }
}

TEST(Identities, DifferenceIsIntersectionWithTheComplement) {
    expect_identical([](Solids& s) { return s.minus(s.a, s.b); }, [](Solids& s) { return s.meet(s.a, s.no(s.b)); });
}
TEST(Identities, DeMorganForUnions) {
    expect_identical([](Solids& s) { return s.no(s.unite(s.a, s.b)); },
                     [](Solids& s) { return s.meet(s.no(s.a), s.no(s.b)); });
}
TEST(Identities, DeMorganForIntersections) {
    expect_identical([](Solids& s) { return s.no(s.meet(s.a, s.b)); },
                     [](Solids& s) { return s.unite(s.no(s.a), s.no(s.b)); });
}
TEST(Identities, UnionIsIdempotent) {
    expect_identical([](Solids& s) { return s.unite(s.a, s.a); }, [](Solids& s) { return s.a; });
}
TEST(Identities, IntersectionIsIdempotent) {
    expect_identical([](Solids& s) { return s.meet(s.a, s.a); }, [](Solids& s) { return s.a; });
}
TEST(Identities, NothingIsLeftOfASolidMinusItself) {
    expect_identical([](Solids& s) { return s.minus(s.a, s.a); },
                     [](Solids& s) { return s.tree.add_node(SolidOp::unite, {}); });
}
TEST(Identities, UnionAbsorbs) {
    expect_identical([](Solids& s) { return s.unite(s.a, s.meet(s.a, s.b)); }, [](Solids& s) { return s.a; });
}
TEST(Identities, IntersectionAbsorbs) {
    expect_identical([](Solids& s) { return s.meet(s.a, s.unite(s.a, s.b)); }, [](Solids& s) { return s.a; });
}
TEST(Identities, IntersectionDistributesOverUnion) {
    expect_identical([](Solids& s) { return s.meet(s.a, s.unite(s.b, s.c)); },
                     [](Solids& s) { return s.unite(s.meet(s.a, s.b), s.meet(s.a, s.c)); });
}
TEST(Identities, UnionDistributesOverIntersection) {
    expect_identical([](Solids& s) { return s.unite(s.a, s.meet(s.b, s.c)); },
                     [](Solids& s) { return s.meet(s.unite(s.a, s.b), s.unite(s.a, s.c)); });
}
TEST(Identities, TwoDifferencesAreOneOfTheUnion) {
    expect_identical([](Solids& s) { return s.minus(s.minus(s.a, s.b), s.c); },
                     [](Solids& s) { return s.minus(s.a, s.unite(s.b, s.c)); });
}
TEST(Identities, MinusADifferenceGivesTheCommonPartBack) {
    expect_identical([](Solids& s) { return s.minus(s.a, s.minus(s.b, s.c)); },
                     [](Solids& s) { return s.unite(s.minus(s.a, s.b), s.meet(s.a, s.c)); });
}
TEST(Identities, TheComplementOfTheComplementIsTheSolid) {
    expect_identical([](Solids& s) { return s.no(s.no(s.a)); }, [](Solids& s) { return s.a; });
}
TEST(Identities, UnionCommutes) {
    expect_identical([](Solids& s) { return s.unite(s.a, s.b); }, [](Solids& s) { return s.unite(s.b, s.a); });
}
TEST(Identities, IntersectionCommutes) {
    expect_identical([](Solids& s) { return s.meet(s.a, s.b); }, [](Solids& s) { return s.meet(s.b, s.a); });
}
TEST(Identities, SymmetricDifferenceHasTwoForms) {
    expect_identical([](Solids& s) { return s.unite(s.minus(s.a, s.b), s.minus(s.b, s.a)); },
                     [](Solids& s) { return s.minus(s.unite(s.a, s.b), s.meet(s.a, s.b)); });
}

TEST(Identities, AMovedSolidMeetsMovedRaysAtTheSameDistances) {
    for (unsigned seed = 1; seed <= 25; ++seed) {
        Solids s = random_solids(seed);
        s.tree.roots = {s.minus(s.unite(s.a, s.b), s.c)};
        SolidTree moved = s.tree;
        const Vec3d by{3, -7, 11};
        for (Leaf& leaf : moved.leaves) leaf.to_world = Affine::translation(by) * leaf.to_world;
        const auto here = test::whole(s.tree, false), there = test::whole(moved, false);
        if (!here) continue;
        Random random(seed);
        std::vector<Boundary> a, b;
        std::vector<Ray> all = rays(random);
        all.resize(all.size() - 100);  // the oblique ones round differently
        for (Ray ray : all) {
            here->boundaries(ray, a);
            ray.o += by;
            there->boundaries(ray, b);
            ASSERT_EQ(a.size(), b.size());
            for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(a[i].t, b[i].t);
        }
    }
}

}  // namespace
}  // namespace cardioid::csg
