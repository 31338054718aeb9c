#include "formats/openscad/run_openscad.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

#include "formats/openscad/library_path.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::formats::openscad {
namespace {

namespace fs = std::filesystem;

/// A folder of our own, removed at the end whatever happens.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string pattern = (fs::temp_directory_path() / "cardioid-XXXXXX").string();
        if (!mkdtemp(pattern.data()))
            throw Error(ErrorCode::io, "cannot make a temporary folder: " + std::string(std::strerror(errno)));
        path_ = pattern;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] std::string operator/(const char* name) const { return (path_ / name).string(); }

private:
    fs::path path_;
};

std::string read_all(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return std::move(out).str();
}

constexpr int not_found = 127;  // what shells say too

/// In the child: everything OpenSCAD says goes to `log`.
[[noreturn]] void become_openscad(const char* output, const char* input, const char* log, char** environment) {
    const int to_log = open(log, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (to_log < 0 || nothing < 0 || dup2(nothing, 0) < 0 || dup2(to_log, 1) < 0 || dup2(to_log, 2) < 0) _exit(126);
    const std::array<const char*, 5> words{"openscad", "-o", output, input, nullptr};
    execvpe("openscad", const_cast<char* const*>(words.data()), environment);
    _exit(errno == ENOENT ? not_found : 126);
}

/// Our environment, in which OpenSCAD finds cardioid.scad.
class Environment {
public:
    Environment() {
        if (const std::string path = library_search_path(); !path.empty()) path_ = "OPENSCADPATH=" + path;
        for (char** entry = environ; *entry; ++entry)
            if (path_.empty() || !std::string_view(*entry).starts_with("OPENSCADPATH=")) entries_.push_back(*entry);
        if (!path_.empty()) entries_.push_back(path_.data());
        entries_.push_back(nullptr);
    }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;
    [[nodiscard]] char** entries() { return entries_.data(); }

private:
    std::string path_;
    std::vector<char*> entries_;
};

/// The exit status; 128 + the signal that ended it.
int wait_for(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) throw Error(ErrorCode::io, "lost sight of openscad: " + std::string(std::strerror(errno)));
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// The lines of OpenSCAD's log that begin with `word`.
std::vector<std::string> lines_with(const std::string& log, const char* word) {
    constexpr std::size_t most = 20;
    std::vector<std::string> out;
    std::istringstream in(log);
    for (std::string line; out.size() < most && std::getline(in, line);)
        if (line.starts_with(word)) out.push_back(line);
    return out;
}

}  // namespace

Evaluated run_openscad(const std::string& text, const std::string& file) {
    const TemporaryFolder folder;
    // Absolute paths: OpenSCAD 2021.01 looks for a relative output beside the source; where it fails, its status is
    // still 0.
    const std::string output = folder / "out.csg", log = folder / "log";
    std::string input = folder / "in.scad";
    std::error_code failed;
    if (fs::is_regular_file(file, failed))
        input = fs::absolute(file).string();
    else
        std::ofstream(input, std::ios::binary) << text;
    Environment environment;  // before the fork: a child of many threads must not allocate
    const pid_t child = fork();
    if (child < 0) throw Error(ErrorCode::io, "cannot start openscad: " + std::string(std::strerror(errno)));
    if (child == 0) become_openscad(output.c_str(), input.c_str(), log.c_str(), environment.entries());
    const int status = wait_for(child);
    if (status == not_found)
        throw Error(ErrorCode::io, file +
                                       ": openscad is not installed, and only it evaluates .scad programs: "
                                       "apt install openscad, or run openscad -o m.csg m.scad elsewhere");
    const std::string said = read_all(log);
    Evaluated out{read_all(output), lines_with(said, "WARNING")};
    const std::vector<std::string> errors = lines_with(said, "ERROR");
    if (status != 0 || out.csg.find_first_not_of(" \t\r\n") == std::string::npos) {
        if (status == 0 && errors.empty())
            throw Error(ErrorCode::bad_input, file + ": openscad finds no model in it" +
                                                  (out.warnings.empty() ? "" : ": " + out.warnings[0]));
        const std::string why = !errors.empty() ? errors[0] : "exit status " + std::to_string(status);
        throw Error(ErrorCode::bad_input, file + ": openscad cannot evaluate it: " + why);
    }
    for (std::string& line : out.warnings) line = file + ": openscad: " + line;
    for (const std::string& line : errors) out.warnings.push_back(file + ": openscad: " + line);
    return out;
}

}  // namespace cardioid::formats::openscad
