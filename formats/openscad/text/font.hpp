#pragma once
#include <ft2build.h>
#include <memory>
#include <string>
#include FT_FREETYPE_H

namespace cardioid::formats::openscad {

/// A font file opened by FreeType, with the size that OpenSCAD asks for: 100000 units of 1/64 pixel at 100 dpi, of
/// which 100000 are one unit of text of size 1.
class Font {
public:
    /// The installed font nearest to a fontconfig name. Throws Error(io) where there is none.
    explicit Font(const std::string& name);
    [[nodiscard]] FT_Face face() const { return face_.get(); }
    [[nodiscard]] const std::string& family() const { return family_; }
    /// Whether one of the names of its family is the one that was asked for.
    [[nodiscard]] bool is_as_asked() const { return as_asked_; }

private:
    struct CloseLibrary {
        void operator()(FT_Library library) const { FT_Done_FreeType(library); }
    };
    struct CloseFace {
        void operator()(FT_Face face) const { FT_Done_Face(face); }
    };
    std::unique_ptr<FT_LibraryRec_, CloseLibrary> library_;
    std::unique_ptr<FT_FaceRec_, CloseFace> face_;
    std::string family_;
    bool as_asked_ = true;
};

/// One unit of text of size 1 in FreeType's units at the size of Font.
inline constexpr double font_units = 1e5;

}  // namespace cardioid::formats::openscad
