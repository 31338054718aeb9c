#include "tests/cli/program.hpp"

#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <spawn.h>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/text_file.hpp"

namespace cardioid::test {
namespace {

namespace fs = std::filesystem;

fs::path make_folder() {
    std::string name = (fs::temp_directory_path() / "cardioid-test-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no folder for a test");
    return name;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
    std::vector<char*> all;
    for (std::string& word : words) all.push_back(word.data());
    all.push_back(nullptr);
    return all;
}

std::vector<std::string> environment_with(const std::vector<std::string>& more) {
    std::vector<std::string> all{std::string("CARDIOID=") + CARDIOID_PROGRAM};
    all.insert(all.end(), more.begin(), more.end());
    for (char** entry = environ; *entry; ++entry) all.emplace_back(*entry);
    return all;
}

}  // namespace

Folder::Folder() : root_(make_folder()), streams_(make_folder()) {}

Folder::~Folder() {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
    fs::remove_all(streams_, ignored);
}

std::vector<std::string> Folder::names() const {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(root_)) all.push_back(entry.path().filename().string());
    std::sort(all.begin(), all.end());
    return all;
}

void Folder::write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
}

std::string Folder::read(const std::string& name) const { return file_text(path(name)); }

pid_t Folder::spawn(const std::vector<std::string>& words, const Start& start) const {
    std::ofstream(streams_ / "in", std::ios::binary) << start.input;
    const std::string out = start.out_file.empty() ? (streams_ / "out").string() : start.out_file;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    constexpr int writing = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, (streams_ / "in").c_str(), O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), writing, 0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, (streams_ / "err").c_str(), writing, 0600);
    posix_spawn_file_actions_addchdir_np(&actions, root_.c_str());
    std::vector<std::string> arguments = words, environment = environment_with(start.environment);
    pid_t process = -1;
    const int error = posix_spawn(&process, words[0].c_str(), &actions, nullptr, pointers(arguments).data(),
                                  pointers(environment).data());
    posix_spawn_file_actions_destroy(&actions);
    if (error) throw std::runtime_error("cannot start " + words[0]);
    return process;
}

pid_t Folder::begin(const std::vector<std::string>& arguments, const Start& start) const {
    std::vector<std::string> words{CARDIOID_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return spawn(words, start);
}

Outcome Folder::finish(pid_t process, const Start& start) const {
    int status = 0;
    waitpid(process, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            start.out_file.empty() ? file_text(streams_ / "out") : "", file_text(streams_ / "err")};
}

Outcome Folder::cardioid(const std::vector<std::string>& arguments, const Start& start) const {
    return finish(begin(arguments, start), start);
}

std::string Folder::messages() const { return file_text(streams_ / "err"); }

Outcome Folder::shell(const std::string& line) const { return finish(spawn({"/bin/sh", "-c", line}, {})); }

}  // namespace cardioid::test
