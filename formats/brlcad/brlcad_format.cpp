#include "formats/brlcad/brlcad_format.hpp"

#include <array>
#include <filesystem>

#include "formats/brlcad/read/readers.hpp"
#include "formats/brlcad/scene/assemble.hpp"
#include "rt_core/api/error.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::formats {

namespace {

bool looks_like_database(std::string_view head) {
    return brlcad::looks_binary(head) || brlcad::looks_like_text_v4(head) || brlcad::looks_like_text_v5(head);
}

brlcad::Database read_database(const std::string& text, const std::string& file) {
    if (brlcad::looks_binary(text)) return brlcad::read_binary(text, file);
    if (brlcad::looks_like_text_v4(text)) return brlcad::read_text_v4(text, file);
    if (brlcad::looks_like_text_v5(text)) return brlcad::read_text_v5(text, file);
    const bool old = text.size() >= 8 && text[0] == 'I';
    throw Error(ErrorCode::bad_input,
                file + ":0: " +
                    (old ? "found a binary database of version 4, wanted version 5; BRL-CAD's dbupgrade makes one"
                         : "found no BRL-CAD database, wanted .g of version 5, or .asc that begins with "
                           "\"I 1 v4\", \"title\" or \"put\""));
}

Scene read(const std::string& text, const std::string& file, const ReadOptions& options) {
    brlcad::Database database = read_database(text, file);
    database.folder = options.base_dir.empty() ? std::filesystem::path(file).parent_path().string() : options.base_dir;
    return brlcad::assemble(std::move(database), file, options);
}

constexpr std::array extensions = {".g", ".asc"};

}  // namespace

const Format brlcad_format{"brlcad",   "BRL-CAD databases: .g of version 5, .asc of versions 4 and 5",
                           extensions, looks_like_database,
                           read,       nullptr,
                           true};

}  // namespace cardioid::formats
