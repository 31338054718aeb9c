#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace cardioid::cli {

/// The options of one command. Wraps CLI11, whose messages and exit codes are not those of our contract.
class Arguments {
public:
    /// `usage` is what stands after "cardioid ".
    Arguments(const std::string& usage, const std::string& description);
    ~Arguments();
    Arguments(const Arguments&) = delete;
    Arguments& operator=(const Arguments&) = delete;

    /// Options added from here on stand under this heading in the help.
    void group(const std::string& title);
    /// An option with one value; `take` throws Error(usage) where it does not understand it. Given twice, the last
    /// counts. `names` as "-s,--size", `shape` as "WxH".
    void value(const std::string& names, const std::string& shape, const std::string& help,
               const std::function<void(const std::string&)>& take);
    void text(const std::string& names, const std::string& shape, const std::string& help, std::string& to);
    /// An option that may be given many times.
    void list(const std::string& names, const std::string& shape, const std::string& help,
              std::vector<std::string>& to);
    void flag(const std::string& names, const std::string& help, bool& to);
    /// A flag that may have a value, "--photons=1000"; "true" without.
    void optional_value(const std::string& names, const std::string& help, std::string& to);
    /// What must be given without a name.
    void positional(const std::string& name, const std::string& help, std::string& to);
    /// Words behind the last positional one go there, in place of an error.
    void more(std::vector<std::string>& to);
    /// Text after the options in the help.
    void examples(const std::string& text);

    /// Reads the words after the command. False: help was asked for and printed. Throws Error(usage).
    bool parse(std::vector<std::string> words);

private:
    struct App;
    std::unique_ptr<App> app_;
};

}  // namespace cardioid::cli
