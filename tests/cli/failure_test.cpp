#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/cli/program.hpp"

namespace cardioid::test {
namespace {

constexpr const char* small = "cube(1);";

void expect_failure(const Outcome& run, int status, const std::string& message) {
    EXPECT_EQ(run.status, status) << run.err;
    EXPECT_EQ(run.err.find("cardioid: "), 0U) << run.err;
    EXPECT_NE(run.err.find(message), std::string::npos) << run.err;
    EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err;
}

TEST(Failure, FilesThatCannotBeReadEndWithFour) {
    const Folder folder;
    expect_failure(folder.cardioid({"no.csg"}), 4, "no.csg: cannot be read: No such file");
    expect_failure(folder.call({"."}), 4, ".: cannot be read: it is a folder");
    expect_failure(folder.call({"info", "no.png"}), 4, "no.png: cannot be read");
    expect_failure(folder.call({"check", "no.csg"}), 4, "no.csg");
    expect_failure(folder.call({"convert", "no.csg", "-o", "x.csg"}), 4, "no.csg");
    EXPECT_TRUE(folder.names().empty());
}

TEST(Failure, AFileWithoutReadPermissionEndsWithFour) {
    if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
    const Folder folder;
    folder.write("a.csg", small);
    chmod(folder.path("a.csg").c_str(), 0);
    expect_failure(folder.call({"a.csg"}), 4, "a.csg: cannot be read: Permission denied");
}

struct Bad {
    const char* name;
    std::string text, message;
};
TEST(BadInput, EndsWithThreeNamesThePlaceAndWritesNothing) {
    for (const Bad& bad : std::vector<Bad>{Bad{"cut.csg", "cube(1);\nsphere(", "cut.csg:2:8: "},
                                           Bad{"sign.csg", "cube(1);\n  ) sphere(1);", "sign.csg:2:3: "},
                                           Bad{"bytes.csg",
                                               std::string("\x7f"
                                                           "ELF\x02\x01\x01\0\0\0",
                                                           10),
                                               "bytes.csg:1:"},
                                           Bad{"bytes.dat",
                                               std::string("\x7f"
                                                           "ELF\x02\x01\x01\0\0\0",
                                                           10),
                                               "bytes.dat: found no scene"},
                                           Bad{"part.stl", "solid part\nendsolid part\n", "import(\"part.stl\")"},
                                           Bad{"part.cgs", std::string("\0\0\0", 3), "(did you mean \".csg\"?)"},
                                           Bad{"program.csg", "module m() { cube(1); }\nm();", "openscad"}}) {
        const Folder folder;
        folder.write(bad.name, bad.text);
        for (const std::vector<std::string>& command :
             std::vector<std::vector<std::string>>{{"render"}, {"info"}, {"check"}, {"convert", "-o", "out.csg"}}) {
            std::vector<std::string> words = command;
            words.emplace_back(bad.name);
            expect_failure(folder.call(words), 3, bad.message);
        }
        EXPECT_EQ(folder.names(), std::vector<std::string>{bad.name});
    }
}

TEST(Failure, AnUnknownCallNamesThePlaceAndTheNearestCall) {
    const Folder folder;
    folder.write("a.csg", "cube(1);\n  shpere(2);");
    const Outcome run = folder.cardioid({"a.csg"});
    expect_failure(run, 3, "a.csg:2:3: ");
    EXPECT_NE(run.err.find("(did you mean \"sphere\"?)"), std::string::npos) << run.err;
    EXPECT_FALSE(folder.has("a.png"));
}

TEST(Failure, PlacesThatCannotBeWrittenEndWithFourBeforeAnyWork) {
    const Folder folder;
    folder.write("a.csg", small);
    std::filesystem::create_directory(folder.path("folder.png"));
    for (const char* const output : {"no/such/a.png", "folder.png"})
        expect_failure(folder.call({"a.csg", "-o", output, "--spp", "1000000"}), 4, output);
    expect_failure(folder.call({"a.csg", "--stats", "no/such.json", "--spp", "1000000"}), 4, "no/such.json");
    expect_failure(folder.call({"info", "a.csg", "--json", "no/such.json"}), 4, "no/such.json");
    expect_failure(folder.call({"check", "a.csg", "--json", "no/such.json"}), 4, "no/such.json");
    expect_failure(folder.call({"convert", "a.csg", "-o", "no/such.csg"}), 4, "no/such.csg");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.csg", "folder.png"}));
}

TEST(Failure, AFolderWithoutWritePermissionEndsWithFour) {
    if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
    const Folder folder;
    folder.write("a.csg", small);
    std::filesystem::create_directory(folder.path("closed"));
    chmod(folder.path("closed").c_str(), 0500);
    expect_failure(folder.call({"a.csg", "-o", "closed/a.png"}), 4, "closed/a.png");
}

TEST(Failure, AFullDeviceEndsWithFour) {
    const Folder folder;
    folder.write("a.csg", small);
    std::filesystem::create_symlink("/dev/full", folder.path("full.png"));
    expect_failure(folder.cardioid({"a.csg", "-s", "4", "--spp", "1", "-q", "-o", "full.png"}), 4, "full.png: ");
    expect_failure(folder.cardioid({"a.csg", "-s", "4", "--spp", "1", "-q", "--stats", "/dev/full"}), 4, "/dev/full: ");
    expect_failure(folder.cardioid({"convert", "a.csg", "-o", "-"}, {.out_file = "/dev/full"}), 4, "standard output: ");
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{"--help"},
                                                                                       {"--version"},
                                                                                       {"render", "--help"},
                                                                                       {"list", "shaders"},
                                                                                       {"info", "a.csg"},
                                                                                       {"check", "a.csg"}})
        expect_failure(folder.cardioid(words, {.out_file = "/dev/full"}), 4, "standard output: ");
}

TEST(Failure, ADiskThatFillsUpLeavesTheOldPictureAndNothingElse) {
    const Folder folder;
    folder.write("a.csg", small);
    folder.write("a.bmp", "old");
    expect_failure(folder.shell("ulimit -f 1; exec \"$CARDIOID\" a.csg -s 64 --spp 1 -q -o a.bmp"), 4, "a.bmp: ");
    EXPECT_EQ(folder.read("a.bmp"), "old");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.bmp", "a.csg"}));
}

TEST(Failure, APictureTooLargeForTheMachineEndsWithFive) {
    const Folder folder;
    folder.write("a.csg", small);
    expect_failure(folder.cardioid({"a.csg", "-s", "2000000x2000000"}), 5, "a picture of 2000000x2000000 pixels needs");
    EXPECT_FALSE(folder.has("a.png"));
}

}  // namespace
}  // namespace cardioid::test
