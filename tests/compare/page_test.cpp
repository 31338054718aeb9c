/// The page of `compare --report` in a real browser, without a network. Skipped where there is none: Chromium takes 400
/// MB, which is too much to be installed for this alone.
#include <cstdlib>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rt_core/image/image_file.hpp"
#include "tests/cli/program.hpp"

namespace cardioid::test {
namespace {

using ::testing::HasSubstr;

std::string browser() {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome", "chromium-headless-shell"})
        if (std::system((std::string("command -v ") + name + " >/dev/null 2>&1").c_str()) == 0) return name;
    return "";
}

Film film(float brightness) {
    Film out{64, 48, {{"", 3, {}}}};
    for (int i = 0; i < 64 * 48; ++i)
        for (int c = 0; c < 3; ++c)
            out.layers[0].pixels.push_back(brightness * static_cast<float>(i % 64 + c * (i / 64)) / 128);
    return out;
}

/// Presses keys and moves sliders as somebody would, and leaves what the page showed after each in its title.
constexpr const char* somebody = R"js(<script>
{
  const seen = [];
  const look = name => {
    const p = context.getImageData(0, 0, W, H).data;
    let sum = 0;
    for (let i = 0; i < p.length; i += 4) sum += p[i] + p[i + 1] + p[i + 2];
    seen.push(name + "=" + document.body.dataset.mode + ":" + sum);
    return sum;
  };
  const press = key => dispatchEvent(new KeyboardEvent("keydown", { key }));
  const check = (name, good) => seen.push((good ? "good " : "BAD ") + name);
  const slider = look("start");
  press("a"); const a = look("a");
  press("b"); const b = look("b");
  check("A and B are two pictures", a !== b);
  check("the slider shows a part of each", slider > Math.min(a, b) && slider < Math.max(a, b));
  press(" "); check("space goes from one to the other", look("space") === a);
  press("+"); const bright = look("brighter"); check("plus makes it brighter", bright > a);
  press("-"); check("minus makes it as it was", look("darker") === a);
  $("exposure").value = -2; $("exposure").dispatchEvent(new Event("input")); check("the slider of exposure darkens", look("exposure") < a);
  $("exposure").value = 0; $("exposure").dispatchEvent(new Event("input"));
  press("d"); const low = look("difference");
  $("gain").value = 4; $("gain").dispatchEvent(new Event("input")); check("the difference is made stronger", look("gain") > low);
  press("p"); look("flip"); check("FLIP is shown", document.body.dataset.mode === "flip");
  press("s"); press("ArrowLeft"); check("the arrow moves the slider", state.split < 0.5 && document.body.dataset.mode === "slider");
  document.querySelector("[data-mode=b]").click(); check("a button shows B", look("button") === b);
  check("the table has a row for all and each part", $("figures").rows.length === 6);
  press("s");
  const result = document.createElement("pre");
  result.id = "result"; result.textContent = seen.join("\n"); document.body.append(result);
}
</script>)js";

class Page : public testing::Test {
protected:
    void SetUp() override {
        if (browser().empty()) GTEST_SKIP() << "no browser is installed (chromium)";
        write_image(folder.path("a.exr").string(), film(1), {});
        write_image(folder.path("b.exr").string(), film(0.8F), {});
        ASSERT_EQ(
            folder.call({"compare", "a.exr", "b.exr", "--max-rmse", "0.01", "--grid", "2", "--report", "page"}).status,
            1);
        folder.write("acted.html", folder.read("page/index.html") + somebody);
    }
    [[nodiscard]] Outcome browse(const std::string& options, const std::string& page) const {
        return folder.shell(
            "HOME=$PWD timeout 120 " + browser() +
            " --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --user-data-dir=$PWD/profile "
            "--window-size=1100,1000 " +
            options + " file://$PWD/" + page);
    }
    Folder folder;
};

TEST_F(Page, DoesWhatKeysSlidersAndButtonsAskFor) {
    const Outcome shown = browse("--dump-dom", "acted.html");
    EXPECT_THAT(shown.out, HasSubstr("good A and B are two pictures")) << shown.err;
    EXPECT_THAT(shown.out, HasSubstr("good the table has a row for all and each part"));
    EXPECT_EQ(shown.out.find("BAD "), shown.out.rfind("BAD ")) << shown.out.substr(shown.out.find("id=\"result\""));
}

TEST_F(Page, HasAPictureThatABrowserDraws) {
    const Outcome shown = browse("--screenshot=shot.png", "page/index.html");
    ASSERT_TRUE(folder.has("shot.png")) << shown.err;
    const Film shot = read_image(folder.path("shot.png").string());
    EXPECT_EQ(shot.width, 1100);
    float least = 1, most = 0;
    for (const float x : shot.layers[0].pixels) least = std::min(least, x), most = std::max(most, x);
    EXPECT_LT(least, 0.2F);
    EXPECT_GT(most, 0.9F);
    if (const char* keep = std::getenv("CARDIOID_KEEP_SCREENSHOT"))
        std::filesystem::copy_file(folder.path("shot.png"), keep, std::filesystem::copy_options::overwrite_existing);
}

}  // namespace
}  // namespace cardioid::test
