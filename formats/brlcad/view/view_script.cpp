#include "formats/brlcad/view/view_script.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "csg/shapes/degrees.hpp"
#include "rt_core/api/error.hpp"
#include "rt_core/scene/nearest_name.hpp"

namespace cardioid::formats::brlcad {

namespace {

struct Word {
    std::string text;
    std::size_t offset;
};

class ScriptReader {
public:
    ScriptReader(const std::string& text, const std::string& file) : text_(text), file_(file) {}

    std::vector<View> run() {
        if (!old_form())
            while (next_command()) command();
        if (views_.empty()) views_.push_back(view_);
        views_.front().warnings = std::move(warnings_);
        return std::move(views_);
    }

private:
    [[noreturn]] void fail(std::size_t offset, const std::string& what) const {
        const std::string_view before = std::string_view(text_).substr(0, offset);
        const auto lines = std::count(before.begin(), before.end(), '\n');
        const std::size_t start = before.rfind('\n') + 1;  // none: npos + 1 is 0
        throw Error(ErrorCode::bad_input, fmt::format("{}:{}:{}: {}", file_, lines + 1, offset - start + 1, what));
    }

    /// Words up to a semicolon or the end.
    bool next_command() {
        words_.clear();
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '#') {
                at_ = std::min(text_.find('\n', at_), text_.size());
            } else if (c == ';') {
                ++at_;
                if (!words_.empty()) return true;
            } else if (std::isspace(static_cast<unsigned char>(c))) {
                ++at_;
            } else {
                const std::size_t end = std::min(text_.find_first_of("; \t\r\n#", at_), text_.size());
                words_.push_back({text_.substr(at_, end - at_), at_});
                at_ = end;
            }
        }
        return !words_.empty();
    }

    double number(std::size_t i) const {
        if (i >= words_.size())
            fail(words_[0].offset,
                 fmt::format("found {} numbers behind \"{}\", wanted more", words_.size() - 1, words_[0].text));
        const std::string& text = words_[i].text;
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
            fail(words_[i].offset, fmt::format("found \"{}\", wanted a number", text.substr(0, 40)));
        return value;
    }
    Vec3d vector(std::size_t i) const { return {number(i), number(i + 1), number(i + 2)}; }

    Vec3d axis(std::size_t i) const {
        const Vec3d v = vector(i);
        if (!(length(v) > 0)) fail(words_[0].offset, "found a rotation whose rows have no length");
        return normalize(v);
    }

    /// viewsize, eye and a matrix as bare numbers.
    bool old_form() {
        const std::size_t start = text_.find_first_not_of(" \t\r\n");
        if (start == std::string::npos ||
            (!std::isdigit(static_cast<unsigned char>(text_[start])) && text_[start] != '-'))
            return false;
        if (text_.find(';') != std::string::npos) return false;
        static_cast<void>(next_command());
        view_.size = number(0);
        view_.eye = vector(1);
        view_.axes = {axis(4), axis(8), axis(12)};
        return true;
    }

    void command() {
        const std::string& name = words_[0].text;
        if (name == "viewsize")
            view_.size = number(1);
        else if (name == "eye_pt")
            view_.eye = vector(1);
        else if (name == "lookat_pt")
            view_.look_at = vector(1);
        else if (name == "viewrot")
            turn({axis(1), axis(5), axis(9)});
        else if (name == "orientation")
            orientation();
        else if (name == "ae")
            angles();
        else if (name == "set")
            settings();
        else if (name == "opt")
            options();
        else if (name == "start" && words_.size() > 1)
            view_.name = words_[1].text;
        else if (name == "end")
            views_.push_back(view_);
        else
            other(name);
    }

    /// A quaternion x y z w; its rotation's columns are the axes.
    void orientation() {
        const double x = number(1), y = number(2), z = number(3), w = number(4);
        const double size = x * x + y * y + z * z + w * w;
        if (!(size > 0)) fail(words_[0].offset, "found a quaternion of no length");
        const double s = 2 / size;
        turn({Vec3d{1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)},
              Vec3d{s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x)},
              Vec3d{s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y)}});
    }

    void turn(const std::array<Vec3d, 3>& axes) {
        view_.axes = axes;
        view_.angles_deg.reset();
    }

    void angles() {
        view_.angles_deg = {number(1), number(2)};
        view_.axes = axes_from(view_.angles_deg->x, view_.angles_deg->y);
    }

    void settings() {
        for (std::size_t i = 1; i < words_.size(); ++i) {
            const std::string& word = words_[i].text;
            const std::size_t equals = word.find('=');
            const std::string name = word.substr(0, equals);
            const double value = equals == std::string::npos ? 0 : std::strtod(word.c_str() + equals + 1, nullptr);
            set(name, value);
        }
    }

    void options() {
        for (std::size_t i = 1; i < words_.size(); ++i) {
            const std::string& word = words_[i].text;
            if (word.size() < 2 || word[0] != '-') continue;
            const bool glued = word.size() > 2;
            const std::string value = glued ? word.substr(2) : i + 1 < words_.size() ? words_[i + 1].text : "";
            const double x = std::strtod(value.c_str(), nullptr);
            if (word[1] == 'p') set("perspective", x);
            if (word[1] == 's') set("width", x), set("height", x);
            if (word[1] == 'w') set("width", x);
            if (word[1] == 'n') set("height", x);
        }
    }

    void set(const std::string& name, double value) {
        constexpr double largest = 1 << 20;
        if (name == "perspective" && value > 0 && value < 180) view_.perspective_deg = value;
        if (name == "width" && value >= 1 && value <= largest) view_.width = static_cast<int>(value);
        if (name == "height" && value >= 1 && value <= largest) view_.height = static_cast<int>(value);
    }

    void other(const std::string& name) {
        static constexpr std::string_view passed[] = {"start", "clean", "tree", "draw",
                                                      "erase", "prep",  "anim", "multiview"};
        if (std::find(std::begin(passed), std::end(passed), name) == std::end(passed)) {
            static constexpr std::string_view known[] = {"viewsize", "eye_pt", "lookat_pt", "viewrot", "orientation",
                                                         "ae",       "set",    "opt",       "start",   "end"};
            fail(words_[0].offset, fmt::format("found command \"{}\", which is none of a view script{}",
                                               name.substr(0, 40), did_you_mean(name, known)));
        }
        if (name != "start" && name != "clean" && name != "prep")
            warnings_.push_back(
                fmt::format("{}: \"{}\" is left out: pictures are drawn of the objects named for them", file_, name));
    }

    const std::string& text_;
    const std::string& file_;
    std::vector<Word> words_;
    std::size_t at_ = 0;
    View view_;  ///< as far as it is known
    std::vector<View> views_;
    std::vector<std::string> warnings_;
};

CameraSettings camera_of(const View& view) {
    CameraSettings camera;
    camera.name = view.name;
    camera.eye = *view.eye;
    const double reach = view.size.value_or(1) > 0 ? view.size.value_or(1) : 1;
    if (view.look_at && !view.axes) {
        camera.look_at = *view.look_at;
    } else {
        const std::array<Vec3d, 3> axes = view.axes.value_or(axes_from(35, 25));
        camera.look_at = camera.eye - axes[2] * reach;
        camera.up = axes[1];
    }
    camera.width = reach;
    if (view.perspective_deg > 0) {
        camera.fov_deg = view.perspective_deg;
        camera.fov_is_horizontal = true;
    } else {
        camera.projection = CameraSettings::Projection::orthographic;
    }
    return camera;
}

/// Film and fitted camera by the first view.
void apply_first(const View& view, Scene& scene) {
    if (view.width) scene.film.width = view.width;
    if (view.height) scene.film.height = view.height;
    if (scene.film.width.has_value() != scene.film.height.has_value())
        scene.film.width = scene.film.height = scene.film.width.value_or(scene.film.height.value_or(512));
    if (view.eye) return;
    if (view.angles_deg && !view.look_at && !(view.perspective_deg > 0))
        scene.fitted = {view.angles_deg->x, view.angles_deg->y, true, std::max(view.size.value_or(0), 0.0), {}};
    else if (view.size || view.axes || view.look_at || view.perspective_deg > 0)
        scene.warnings.push_back(fmt::format(
            "{}: the view script has no eye_pt, and its view is left out: the camera is fitted", scene.file));
}

}  // namespace

std::array<Vec3d, 3> axes_from(double azimuth_deg, double elevation_deg) {
    const auto [sa, ca] = csg::sin_cos_deg(azimuth_deg);
    const auto [se, ce] = csg::sin_cos_deg(elevation_deg);
    return {Vec3d{-sa, ca, 0}, Vec3d{-se * ca, -se * sa, ce}, Vec3d{ce * ca, ce * sa, se}};
}

std::vector<View> read_views(const std::string& text, const std::string& file) {
    return ScriptReader(text, file).run();
}

void apply_views(const std::vector<View>& views, Scene& scene) {
    const View& first = views.front();
    scene.warnings.insert(scene.warnings.end(), first.warnings.begin(), first.warnings.end());
    apply_first(first, scene);
    std::vector<CameraSettings> cameras;
    std::string names;
    for (const View& view : views) {
        if (!view.eye) continue;
        cameras.push_back(camera_of(view));
        constexpr std::size_t named = 5;
        if (cameras.size() <= named + 1)
            names += (cameras.size() > 1 ? ", " : "") + (cameras.size() > named ? "..." : view.name);
    }
    if (views.size() > 1)
        scene.warnings.push_back(fmt::format("{}: {} pictures; the first is drawn unless --camera names another: {}",
                                             scene.file, views.size(), names));
    scene.cameras.insert(scene.cameras.begin(), cameras.begin(), cameras.end());
}

}  // namespace cardioid::formats::brlcad
