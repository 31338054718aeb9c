#include "formats/openscad/text/font.hpp"

#include <fontconfig/fontconfig.h>
#include <mutex>

#include "rt_core/api/error.hpp"

namespace cardioid::formats::openscad {
namespace {

constexpr const char* usual_font = "Liberation Sans:style=Regular";

struct Destroy {
    void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
};
using Pattern = std::unique_ptr<FcPattern, Destroy>;

std::string text_of(const Pattern& pattern, const char* key, int index) {
    FcChar8* value = nullptr;
    if (FcPatternGetString(pattern.get(), key, index, &value) != FcResultMatch) return {};
    return reinterpret_cast<const char*>(value);
}

bool same_name(const std::string& a, const std::string& b) {
    return FcStrCmpIgnoreCase(reinterpret_cast<const FcChar8*>(a.c_str()),
                              reinterpret_cast<const FcChar8*>(b.c_str())) == 0;
}

struct Match {
    std::string file, family;
    int index = 0;
    bool as_asked = true;
};

Match find(const std::string& name) {
    static std::mutex one_at_a_time;  // fontconfig reads its files once, at the first call
    const std::lock_guard lock(one_at_a_time);
    const Pattern asked(FcNameParse(reinterpret_cast<const FcChar8*>(name.c_str())));
    if (!asked) throw Error(ErrorCode::bad_input, "font \"" + name + "\" is no name that fontconfig understands");
    const std::string wanted = text_of(asked, FC_FAMILY, 0);
    FcPatternAddBool(asked.get(), FC_OUTLINE, FcTrue);
    FcPatternAddBool(asked.get(), FC_SCALABLE, FcTrue);
    FcConfigSubstitute(nullptr, asked.get(), FcMatchPattern);
    FcDefaultSubstitute(asked.get());
    FcResult result = FcResultNoMatch;
    const Pattern found(FcFontMatch(nullptr, asked.get(), &result));
    if (!found || text_of(found, FC_FILE, 0).empty())
        throw Error(ErrorCode::io, "no font is installed: text() wants one, as apt install fonts-liberation gives");
    Match out{text_of(found, FC_FILE, 0), text_of(found, FC_FAMILY, 0)};
    FcPatternGetInteger(found.get(), FC_INDEX, 0, &out.index);
    out.as_asked = wanted.empty();
    for (int i = 0; !text_of(found, FC_FAMILY, i).empty(); ++i)
        out.as_asked = out.as_asked || same_name(wanted, text_of(found, FC_FAMILY, i));
    return out;
}

}  // namespace

Font::Font(const std::string& name) {
    const Match match = find(name.empty() ? usual_font : name);
    family_ = match.family;
    as_asked_ = match.as_asked;
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0) throw Error(ErrorCode::limit, "FreeType cannot be started");
    library_.reset(library);
    FT_Face face = nullptr;
    if (FT_New_Face(library, match.file.c_str(), match.index, &face) != 0)
        throw Error(ErrorCode::io, match.file + ": FreeType cannot read this font");
    face_.reset(face);
    constexpr FT_UInt dpi = 100;
    if (FT_Set_Char_Size(face, 0, static_cast<FT_F26Dot6>(font_units), dpi, dpi) != 0)
        throw Error(ErrorCode::io, match.file + ": FreeType cannot scale this font");
}

}  // namespace cardioid::formats::openscad
