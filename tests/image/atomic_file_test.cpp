#include "rt_core/image/atomic_file.hpp"

#include <csignal>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "scratch_folder.hpp"

#include "rt_core/api/error.hpp"

namespace cardioid {
namespace {

using test::read_text;
using test::ScratchFolder;
using test::write_text;

std::span<const std::byte> bytes(const std::string& text) { return std::as_bytes(std::span(text)); }

ErrorCode code_of(auto&& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.code();
    }
    return ErrorCode{0};
}

/// Files of this process cannot grow past `size` while this lives: what a full disk does.
class SizeLimit {
public:
    explicit SizeLimit(rlim_t size) {
        ::getrlimit(RLIMIT_FSIZE, &old_);
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{size, old_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~SizeLimit() { ::setrlimit(RLIMIT_FSIZE, &old_); }
    SizeLimit(const SizeLimit&) = delete;
    SizeLimit& operator=(const SizeLimit&) = delete;

private:
    rlimit old_{};
};

TEST(WholeFile, ReplacesTheOldOneAndLeavesNothingElseBehind) {
    const ScratchFolder folder;
    const std::string path = folder.file("a.txt");
    write_whole_file(path, bytes("one"));
    write_whole_file(path, bytes("two"));
    EXPECT_EQ(read_text(path), "two");
    EXPECT_EQ(folder.count(), 1U);
}

TEST(WholeFile, KeepsTheOldOneWhereTheNewDoesNotFit) {
    const ScratchFolder folder;
    const std::string path = folder.file("a.txt");
    write_text(path, "old");
    const std::string large(100'000, 'x');
    {
        const SizeLimit limit(4096);
        EXPECT_EQ(code_of([&] { write_whole_file(path, bytes(large)); }), ErrorCode::io);
    }
    EXPECT_EQ(read_text(path), "old");
    EXPECT_EQ(folder.count(), 1U);
}

TEST(WholeFile, TellsOfAFullDevice) {
    const ScratchFolder folder;
    const std::string link = folder.file("full.png");
    std::filesystem::create_symlink("/dev/full", link);
    EXPECT_EQ(code_of([&] { write_whole_file(link, bytes("x")); }), ErrorCode::io);
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_EQ(folder.count(), 1U);
}

TEST(WholeFile, FollowsALinkToAFile) {
    const ScratchFolder folder;
    const std::string target = folder.file("target"), link = folder.file("link");
    write_text(target, "old");
    std::filesystem::create_symlink(target, link);
    write_whole_file(link, bytes("new"));
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_EQ(read_text(target), "new");
}

TEST(WholeFile, RefusesAFolderAndAMissingFolder) {
    const ScratchFolder folder;
    EXPECT_EQ(code_of([&] { write_whole_file(folder.file(""), bytes("x")); }), ErrorCode::io);
    EXPECT_EQ(code_of([&] { write_whole_file(folder.file("no/such/a.txt"), bytes("x")); }), ErrorCode::io);
    EXPECT_EQ(code_of([&] { check_writable(folder.file("")); }), ErrorCode::io);
    EXPECT_EQ(code_of([&] { check_writable(folder.file("no/such/a.txt")); }), ErrorCode::io);
    EXPECT_EQ(code_of([&] { check_writable(folder.file("a.txt")); }), ErrorCode{0});
}

TEST(WholeFile, HasThePermissionsThatTheMaskLeaves) {
    const ScratchFolder folder;
    const mode_t old = ::umask(022);
    write_whole_file(folder.file("a"), bytes("x"));
    ::umask(old);
    struct stat status {};
    ASSERT_EQ(::stat(folder.file("a").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0644U);
}

}  // namespace
}  // namespace cardioid
