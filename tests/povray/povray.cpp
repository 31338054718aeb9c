#include "tests/povray/povray.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <spawn.h>
#include <sstream>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "rt_core/math/sampler.hpp"
#include "tests/text_file.hpp"

namespace cardioid::test {
namespace {

namespace fs = std::filesystem;

const fs::path cache = CARDIOID_POVRAY_CACHE;

std::uint64_t hash_of(const std::string& text) {
    std::uint64_t h = text.size();
    for (const char c : text) h = mix64(h ^ static_cast<unsigned char>(c));
    return h;
}

/// The first line of a scene names its file and the version of the program: a picture does not depend on it.
std::string without_comments(const std::string& sdl) {
    std::istringstream lines(sdl);
    std::string text;
    for (std::string line; std::getline(lines, line);)
        if (!line.starts_with("//")) text += line + "\n";
    return text;
}

}  // namespace

Run run(const std::vector<std::string>& words, const fs::path& folder) {
    std::vector<std::string> copy = words;
    std::vector<char*> arguments;
    for (std::string& word : copy) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const fs::path caught = folder / fmt::format("messages.{}", getpid());
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, caught.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    pid_t process = -1;
    const int error = posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) return {};
    int status = 0;
    rusage usage{};
    wait4(process, &status, 0, &usage);
    Run out{WIFEXITED(status) ? WEXITSTATUS(status) : 128,
            static_cast<double>(usage.ru_utime.tv_sec) + static_cast<double>(usage.ru_utime.tv_usec) * 1e-6,
            file_text(caught)};
    fs::remove(caught);
    return out;
}

bool has_povray() {
    static const bool found = std::system("povray --version >/dev/null 2>&1") == 0;
    return found;
}

PovPicture draw_by_povray(const std::string& sdl, int width, int height) {
    fs::create_directories(cache);
    const std::string text = without_comments(sdl);
    const std::string name = fmt::format("{:016x}-{}x{}", hash_of(text), width, height);
    const fs::path image = cache / (name + ".exr"), seconds = cache / (name + ".seconds");
    if (!fs::exists(seconds)) {
        std::ofstream(cache / (name + ".pov"), std::ios::binary) << sdl;
        const Run done = run({"povray", "+I" + name + ".pov", "+O" + name + ".part.exr", "+FE",
                              fmt::format("+W{}", width), fmt::format("+H{}", height), "-D", "-A", "+WT1", "-GA"},
                             cache);
        if (done.status != 0 || !fs::exists(cache / (name + ".part.exr")))
            throw std::runtime_error(fmt::format("povray: status {}: {}", done.status, done.messages));
        fs::rename(cache / (name + ".part.exr"), image);
        std::ofstream(seconds) << done.user_s;
    }
    PovPicture out{read_picture(image.string()), 0, image};
    std::ifstream(seconds) >> out.user_s;
    return out;
}

}  // namespace cardioid::test
