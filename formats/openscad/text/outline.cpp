#include "formats/openscad/text/outline.hpp"

#include FT_GLYPH_H
#include FT_OUTLINE_H

namespace cardioid::formats::openscad {
namespace {

/// Gathers what FreeType tells of an outline.
class Pen {
public:
    explicit Pen(int segments) : segments_(segments) {}

    static int move(const FT_Vector* to, void* self) { return of(self).start(point(to)); }
    static int line(const FT_Vector* to, void* self) { return of(self).add(point(to)); }
    static int conic(const FT_Vector* c, const FT_Vector* to, void* self) {
        const Vec2d a = of(self).at_, b = point(c), d = point(to);
        return of(self).curve([=](double t) { return a * ((1 - t) * (1 - t)) + b * (2 * (1 - t) * t) + d * (t * t); });
    }
    static int cubic(const FT_Vector* c1, const FT_Vector* c2, const FT_Vector* to, void* self) {
        const Vec2d a = of(self).at_, b = point(c1), c = point(c2), d = point(to);
        return of(self).curve([=](double t) {
            const double s = 1 - t;
            return a * (s * s * s) + b * (3 * s * s * t) + c * (3 * s * t * t) + d * (t * t * t);
        });
    }

    Profile take() {
        std::erase_if(figure_.contours, [](const auto& contour) { return contour.size() < 3; });
        return std::move(figure_);
    }

private:
    static Pen& of(void* self) { return *static_cast<Pen*>(self); }
    static Vec2d point(const FT_Vector* v) {
        return {static_cast<double>(v->x) / font_units, static_cast<double>(v->y) / font_units};
    }
    int start(Vec2d p) {
        figure_.contours.emplace_back();
        return add(p);
    }
    int add(Vec2d p) {
        at_ = p;
        figure_.contours.back().push_back(p);
        return 0;
    }
    template <class Curve>
    int curve(Curve&& along) {
        for (int i = 1; i <= segments_; ++i) add(along(static_cast<double>(i) / segments_));
        return 0;
    }

    int segments_;
    Vec2d at_;
    Profile figure_;
};

}  // namespace

Outline draw_glyph(FT_Face face, unsigned glyph, int segments) {
    Outline out;
    // Hinted, as OpenSCAD has it: heights stand on the pixel grid.
    if (FT_Load_Glyph(face, glyph, FT_LOAD_DEFAULT) != 0 || face->glyph->format != FT_GLYPH_FORMAT_OUTLINE) return out;
    FT_Glyph copy = nullptr;
    if (FT_Get_Glyph(face->glyph, &copy) != 0) return out;
    FT_BBox box;
    FT_Glyph_Get_CBox(copy, FT_GLYPH_BBOX_GRIDFIT, &box);
    FT_Done_Glyph(copy);
    out.left = static_cast<double>(box.xMin), out.right = static_cast<double>(box.xMax);
    out.bottom = static_cast<double>(box.yMin), out.top = static_cast<double>(box.yMax);
    Pen pen(segments);
    const FT_Outline_Funcs funcs{Pen::move, Pen::line, Pen::conic, Pen::cubic, 0, 0};
    if (FT_Outline_Decompose(&face->glyph->outline, &funcs, &pen) == 0) out.figure = pen.take();
    return out;
}

}  // namespace cardioid::formats::openscad
