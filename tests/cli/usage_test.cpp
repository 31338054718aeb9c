#include <gtest/gtest.h>

#include "tests/cli/program.hpp"

namespace cardioid::test {
namespace {

/// Words on the command line, and what the one line on standard error must have.
struct Wrong {
    std::vector<std::string> words;
    std::string message;
};

void expect_wrong(const std::vector<Wrong>& table) {
    const Folder folder;
    folder.write("a.csg", "camera([9, 9, 9], look_at = [0, 0, 0], name = \"front\"); cube(1);");
    for (const Wrong& wrong : table) {
        const Outcome run = folder.call(wrong.words);
        EXPECT_EQ(run.status, 2) << wrong.message;
        EXPECT_EQ(run.err.find("cardioid: "), 0U) << run.err;
        EXPECT_NE(run.err.find(wrong.message), std::string::npos) << run.err << wrong.message;
        EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err;
        EXPECT_EQ(run.out, "");
        EXPECT_EQ(folder.names(), std::vector<std::string>{"a.csg"});
    }
}

TEST(WrongUsage, OfRenderEndsWithTwoAndOneLineThatNamesTheMistake) {
    expect_wrong({Wrong{{}, "no SCENE is given"},
                  Wrong{{"render"}, "no SCENE is given"},
                  Wrong{{"a.csg", "--smaples", "3"}, "there is no option --smaples"},
                  Wrong{{"a.csg", "--elevaton=3"}, "(did you mean \"--elevation\"?)"},
                  Wrong{{"a.csg", "-x"}, "there is no option -x"},
                  Wrong{{"a.csg", "b.csg"}, "found \"b.csg\" after SCENE"},
                  Wrong{{"a.csg", "--frames", "1-3"}, "there is no option --frames"},
                  Wrong{{"a.csg", "--spp"}, "--spp needs a value"},
                  Wrong{{"a.csg", "--spp", "--seed", "1"}, "--spp needs a value N, found \"--seed\""},
                  Wrong{{"a.csg", "--spp", "many"}, "--spp: found \"many\", wanted a whole number from 1"},
                  Wrong{{"a.csg", "--spp", "0"}, "--spp: found \"0\""},
                  Wrong{{"a.csg", "--spp", "1.5"}, "--spp: found \"1.5\""},
                  Wrong{{"a.csg", "-s", "640*480"}, "--size: found \"640*480\", wanted WxH"},
                  Wrong{{"a.csg", "-s", "0x10"}, "--size: found \"0x10\""},
                  Wrong{{"a.csg", "-s", "-4"}, "--size: found \"-4\""},
                  Wrong{{"a.csg", "--time", "soon"}, "--time: found \"soon\", wanted a time"},
                  Wrong{{"a.csg", "--noise", "200%"}, "--noise: found \"200%\", wanted a share"},
                  Wrong{{"a.csg", "--quality", "hihg"}, "wanted draft, normal or high (did you mean \"high\"?)"},
                  Wrong{{"a.csg", "-j", "0"}, "--threads: found \"0\""},
                  Wrong{{"a.csg", "--seed", "-1"}, "--seed: found \"-1\""},
                  Wrong{{"a.csg", "-e", "91"}, "--elevation: found \"91\", wanted a number from -90 to 90"},
                  Wrong{{"a.csg", "--eye", "1,2"}, "--eye: found \"1,2\", wanted three numbers x,y,z"},
                  Wrong{{"a.csg", "--eye", "1,2,nan"}, "--eye: found \"1,2,nan\""},
                  Wrong{{"a.csg", "--target", "1,2,3"}, "--target needs --eye"},
                  Wrong{{"a.csg", "-o", "b.png", "--stats", "b.png"}, "--stats and -o name the same file"},
                  Wrong{{"a.csg", "--eye", "1,2,3", "--target", "1,2,3"}, "the same point"},
                  Wrong{{"a.csg", "-a", "3", "--eye", "1,2,3"}, "cannot be given together"},
                  Wrong{{"a.csg", "--camera", "fornt"}, "wanted front (did you mean \"front\"?)"},
                  Wrong{{"a.csg", "--crop", "0,0,9000,9"}, "--crop: found 0,0,9000,9"},
                  Wrong{{"a.csg", "--crop", "5,5,5,6"}, "--crop: found 5,5,5,6"},
                  Wrong{{"a.csg", "--aov", "normal,dept"}, "--aov: found \"dept\""},
                  Wrong{{"a.csg", "--aov", "nromal"}, "(did you mean \"normal\"?)"},
                  Wrong{{"a.csg", "--view", "regoin"}, "(did you mean \"region\"?)"},
                  Wrong{{"a.csg", "--progress", "loud"}, "--progress: found \"loud\", wanted auto, bar, lines or none"},
                  Wrong{{"a.csg", "-q", "-v"}, "cannot be given together"},
                  Wrong{{"a.csg", "--facets", "some"}, "wanted auto or openscad"},
                  Wrong{{"a.csg", "--unknown", "wran"}, "wanted error or warn (did you mean \"warn\"?)"},
                  Wrong{{"a.csg", "-o", "a.pgn"}, "a.pgn"},
                  Wrong{{"a.csg", "-o", "a"}, "a"}});
}

TEST(WrongUsage, OfLightingNamesWhatThereIs) {
    expect_wrong(
        {Wrong{{"a.csg", "--lighting", "dierct"}, "there is no lighting \"dierct\" in this program"},
         Wrong{{"a.csg", "--lighting", "dierct"}, "(did you mean \"direct\"?)"},
         Wrong{{"a.csg", "--photons", "--no-photons"}, "cannot be given together"},
         Wrong{{"a.csg", "--photons=few"}, "--photons: found \"few\""},
         Wrong{{"a.csg", "--photons=2.5"}, "--photons: found \"2.5\", wanted a whole number from 1 to 1e15, as"},
         Wrong{{"a.csg", "--photons=M"}, "--photons: found \"M\""},
         Wrong{{"a.csg", "--photons=1e99"}, "--photons: found \"1e99\""},
         Wrong{{"a.csg", "--set", "direct"}, "--set: found \"direct\", wanted module.option=value"},
         Wrong{{"a.csg", "--set", "dierct.x=1"}, "(did you mean \"direct\"?)"},
         Wrong{{"a.csg", "--set", "direct.bounces=1"}, "lighting \"direct\" has no option \"bounces\""},
         Wrong{{"a.csg", "--save-map", "m"}, "this lighting has no map to save"},
         Wrong{{"a.csg", "--load-map", "m"}, "this lighting has no map to load"}});
}

TEST(WrongUsage, OfTheOtherCommandsNamesTheNearest) {
    expect_wrong({Wrong{{"inof", "a.csg"}, "there is no command or file \"inof\" (did you mean \"info\"?)"},
                  Wrong{{"list"}, "no WHAT is given"}, Wrong{{"list", "lihgts"}, "(did you mean \"lights\"?)"},
                  Wrong{{"list", "shaders", "lights"}, "found \"lights\" after WHAT"},
                  Wrong{{"convert", "a.csg", "-o", "./a.csg"}, "-o: ./a.csg is the scene itself"},
                  Wrong{{"convert", "a.csg"}, "no -o FILE is given"},
                  Wrong{{"convert", "a.csg", "-o", "a.step"}, "found ending \".step\", can write .csg"},
                  Wrong{{"convert", "a.csg", "-o", "a.cgs"}, "(did you mean \".csg\"?)"},
                  Wrong{{"info"}, "no SCENE|IMAGE"},
                  Wrong{{"check", "a.csg", "--jsno", "f"}, "(did you mean \"--json\"?)"},
                  Wrong{{"a.csg", "--plugin", "velvet.so"}, "write ./velvet.so"}});
}

TEST(WrongUsage, IsTheExitStatusOfTheProcessToo) {
    const Outcome run = Folder().cardioid({"a.csg", "--smaples", "3"});
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.err.find("cardioid: there is no option --smaples"), 0U) << run.err;
}

TEST(Usage, PhotonsWithoutTheModuleNameTheLightingThereIs) {
    const Folder folder;
    folder.write("a.csg", "cube(1);");
    if (folder.call({"list", "lighting"}).out.find("photon:") != std::string::npos)
        GTEST_SKIP() << "this program has photons";
    const Outcome run = folder.call({"a.csg", "--photons"});
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("--photons: there is no lighting \"photon\" in this program, wanted direct"),
              std::string::npos)
        << run.err;
}

TEST(Usage, HelpAndVersionGoToStandardOutputAndEndWithZero) {
    const Folder folder;
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{"--help"},
                                                                                       {"-h"},
                                                                                       {"render", "--help"},
                                                                                       {"convert", "-h"},
                                                                                       {"info", "-h"},
                                                                                       {"check", "-h"},
                                                                                       {"list", "-h"}}) {
        const Outcome run = folder.call(words);
        EXPECT_EQ(run.status, 0);
        EXPECT_NE(run.out.find("Usage: cardioid"), std::string::npos) << run.out;
        EXPECT_EQ(run.err, "");
    }
    const Outcome run = folder.call({"--version"});
    EXPECT_EQ(run.status, 0);
    for (const char* const part : {"cardioid 0.", "Embree ", "OpenImageIO ", "CGAL ", "plug-in ABI "})
        EXPECT_NE(run.out.find(part), std::string::npos) << run.out;
}

TEST(Usage, HelpOfRenderNamesEveryGroup) {
    const std::string help = Folder().call({"render", "--help"}).out;
    for (const char* const part : {"Picture", "Quality", "Camera", "Light", "Reading the scene", "Messages", "Examples",
                                   "-s,--size WxH|N", "-o,--output FILE", "--no-photons"})
        EXPECT_NE(help.find(part), std::string::npos) << part;
    EXPECT_EQ(help.find("--frame"), std::string::npos);
}

}  // namespace
}  // namespace cardioid::test
