#pragma once
#include <filesystem>
#include <string>
#include <sys/types.h>
#include <vector>

namespace cardioid::test {

/// What a program left behind.
struct Outcome {
    int status = -1;  ///< of its exit; 128 + the signal that ended it
    std::string out, err;
};

/// How the program is started besides its arguments.
struct Start {
    std::string input;                     ///< its standard input
    std::vector<std::string> environment;  ///< "NAME=value", on top of ours
    std::string out_file;                  ///< where its standard output goes, "" to be caught
};

/// A folder of its own for one test, removed at the end; programs run in it.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::filesystem::path path(const std::string& name) const { return root_ / name; }
    [[nodiscard]] bool has(const std::string& name) const { return std::filesystem::exists(path(name)); }
    /// Names of all there is, sorted, hidden files too.
    [[nodiscard]] std::vector<std::string> names() const;
    void write(const std::string& name, const std::string& text) const;
    [[nodiscard]] std::string read(const std::string& name) const;

    /// Runs the built `cardioid` with these arguments to its end.
    [[nodiscard]] Outcome cardioid(const std::vector<std::string>& arguments, const Start& start = {}) const;
    /// The same within this process, which spares its start: for tables of many.
    [[nodiscard]] Outcome call(const std::vector<std::string>& arguments) const;
    /// Runs a line of the shell to its end; $CARDIOID names the built program.
    [[nodiscard]] Outcome shell(const std::string& line) const;
    /// Starts `cardioid` and returns at once; finish() waits for it.
    [[nodiscard]] pid_t begin(const std::vector<std::string>& arguments, const Start& start = {}) const;
    /// What the process that runs has written to standard error so far.
    [[nodiscard]] std::string messages() const;
    [[nodiscard]] Outcome finish(pid_t process, const Start& start = {}) const;

private:
    [[nodiscard]] pid_t spawn(const std::vector<std::string>& words, const Start& start) const;
    std::filesystem::path root_, streams_;
};

}  // namespace cardioid::test
