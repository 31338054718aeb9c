#include "cli/run.hpp"

#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/commands/commands.hpp"
#include "cli/io/text_output.hpp"
#include "cli/options/values.hpp"
#include "cli/version.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::cli {
namespace {

struct Command {
    const char* name;
    const char* summary;
    int (*run)(const std::vector<std::string>& words);
};

constexpr Command commands[] = {
    {"render", "Draw a scene; what is done where no command is named", run_render},
    {"probe", "Measure the light that arrives at given points", run_probe},
    {"compare", "Tell by how much two pictures differ", run_compare},
    {"convert", "Write a scene in another format", run_convert},
    {"info", "Tell what is in a scene, or what made a picture", run_info},
    {"check", "Look for faults in a scene", run_check},
    {"list", "Name the shaders, lights, lighting, formats or options there are", run_list},
};

std::string help_text() {
    std::string text =
        "Cardioid draws CSG models as they would look in real light.\n\n"
        "Usage: cardioid [render] SCENE [-o PICTURE] [options]\n"
        "       cardioid COMMAND [options]\n\n"
        "Commands (cardioid COMMAND --help tells more):\n";
    for (const Command& command : commands) text += fmt::format("  {:<10}{}\n", command.name, command.summary);
    return text +
           "\nExamples:\n"
           "  cardioid part.csg                          draws part.png, with a fitted camera and studio light\n"
           "  cardioid room.csg -o room.exr -s 1920x1080 --quality high\n"
           "  openscad -o - --export-format csg part.scad | cardioid - -o part.png -a 120 -e 10\n"
           "  cardioid check room.csg\n\n"
           "  -h, --help     Print this and leave\n"
           "  --version      Print the versions of the program and its libraries\n\n"
           "Exit status: 0 done, 1 faults found, 2 wrong usage, 3 bad input file, 4 cannot read or write,\n"
           "5 out of memory or over a limit, 130 interrupted.\n";
}

/// Throws where the first word is neither an option nor a file, but nearly a command.
void check_command_name(const std::string& word) {
    std::vector<std::string> names;
    for (const Command& command : commands) names.emplace_back(command.name);
    const std::string meant = suggestion(word, names);
    std::error_code error;
    if (!word.starts_with('-') && !meant.empty() && !std::filesystem::exists(word, error))
        throw Error(ErrorCode::usage, fmt::format("there is no command or file \"{}\"{}", word, meant));
}

int run_command(const std::vector<std::string>& words) {
    if (words.empty()) throw Error(ErrorCode::usage, "no SCENE is given; cardioid --help tells more");
    if (words[0] == "-h" || words[0] == "--help") return print_text(help_text()), 0;
    if (words[0] == "--version") return print_text(version_text()), 0;
    for (const Command& command : commands)
        if (words[0] == command.name) return command.run({words.begin() + 1, words.end()});
    check_command_name(words[0]);
    return run_render(words);
}

int report(int status, const std::string& text) {
    std::fputs(fmt::format("cardioid: {}\n", text).c_str(), stderr);
    return status;
}

}  // namespace

int run(const std::vector<std::string>& words) noexcept {
    try {
        return run_command(words);
    } catch (const Error& error) {
        return report(static_cast<int>(error.code()), error.what());
    } catch (const std::bad_alloc&) {
        return report(static_cast<int>(ErrorCode::limit), "out of memory; a smaller picture or scene may fit");
    } catch (const std::length_error&) {
        return report(static_cast<int>(ErrorCode::limit), "something is larger than this machine can address");
    } catch (const std::exception& error) {
        return report(static_cast<int>(ErrorCode::limit), error.what());
    }
}

}  // namespace cardioid::cli
