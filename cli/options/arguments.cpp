#include "cli/options/arguments.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>

#include "cli/io/text_output.hpp"
#include "cli/options/values.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::cli {
namespace {

/// Options with their usage line as we write it.
class Formatter final : public CLI::Formatter {
public:
    explicit Formatter(std::string usage) : usage_(std::move(usage)) { column_width(34); }
    std::string make_usage(const CLI::App*, std::string) const override {
        return fmt::format("Usage: cardioid {}\n", usage_);
    }
    std::string make_option_opts(const CLI::Option* option) const override {
        const std::string& type = option->get_option_text();
        return type.empty() ? "" : " " + type;
    }

private:
    std::string usage_;
};

}  // namespace

struct Arguments::App {
    CLI::App app;
    std::string heading = "Options";
    std::vector<std::string> positionals;
    std::vector<std::string>* more = nullptr;

    /// Every "--name" and "-n" there is.
    [[nodiscard]] std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const CLI::Option* option : app.get_options()) {
            for (const std::string& name : option->get_lnames()) all.push_back("--" + name);
            for (const std::string& name : option->get_snames()) all.push_back("-" + name);
        }
        return all;
    }
    void check_extras(const std::vector<std::string>& extras) const;
};

/// Words that belong to no option.
void Arguments::App::check_extras(const std::vector<std::string>& extras) const {
    if (more) more->clear();
    for (const std::string& word : extras) {
        if (word == "--") continue;  // CLI11 keeps the end of the options among the rest
        if (word.size() > 1 && word[0] == '-') {
            const std::string name = word.substr(0, word.find('='));
            throw Error(ErrorCode::usage, fmt::format("there is no option {}{}", name, suggestion(name, names())));
        }
        if (more) {
            more->push_back(word);
            continue;
        }
        throw Error(ErrorCode::usage,
                    positionals.empty()
                        ? fmt::format("found \"{}\" where no argument is wanted", word)
                        : fmt::format("found \"{}\" after {}, wanted one only", word, positionals.back()));
    }
}

Arguments::Arguments(const std::string& usage, const std::string& description) : app_(std::make_unique<App>()) {
    app_->app.description(description + "\n");
    app_->app.formatter(std::make_shared<Formatter>(usage));
    app_->app.set_help_flag("-h,--help", "Print this and leave")->group("Help");
    app_->app.allow_extras();
}

Arguments::~Arguments() = default;

void Arguments::group(const std::string& title) { app_->heading = title; }

void Arguments::value(const std::string& names, const std::string& shape, const std::string& help,
                      const std::function<void(const std::string&)>& take) {
    const std::string name = names.substr(names.rfind(',') + 1);
    const std::function<void(const std::string&)> checked = [name, shape, take](const std::string& text) {
        // CLI11 hands the next word over even where it is an option.
        if (text.empty() || text.starts_with("--"))
            throw Error(ErrorCode::usage, fmt::format("{} needs a value {}, found \"{}\"", name, shape, text));
        take(text);
    };
    app_->app.add_option_function(names, checked, help)->option_text(shape)->group(app_->heading)->take_last();
}

void Arguments::text(const std::string& names, const std::string& shape, const std::string& help, std::string& to) {
    value(names, shape, help, [&to](const std::string& text) { to = text; });
}

void Arguments::list(const std::string& names, const std::string& shape, const std::string& help,
                     std::vector<std::string>& to) {
    app_->app.add_option(names, to, help)
        ->option_text(shape)
        ->group(app_->heading)
        ->allow_extra_args(false)
        ->take_all();
}

void Arguments::flag(const std::string& names, const std::string& help, bool& to) {
    app_->app.add_flag(names, to, help)->group(app_->heading)->take_last();
}

void Arguments::optional_value(const std::string& names, const std::string& help, std::string& to) {
    app_->app.add_flag(names, to, help)->group(app_->heading)->take_last();
}

void Arguments::positional(const std::string& name, const std::string& help, std::string& to) {
    app_->positionals.push_back(name);
    app_->app.add_option(name, to, help)->option_text(" ")->group("Arguments");
}

void Arguments::more(std::vector<std::string>& to) { app_->more = &to; }

void Arguments::examples(const std::string& text) { app_->app.footer(text); }

bool Arguments::parse(std::vector<std::string> words) {
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    try {
        app_->app.parse(words);
    } catch (const CLI::CallForHelp&) {
        print_text(app_->app.help());
        return false;
    } catch (const CLI::ArgumentMismatch& error) {
        const std::string text = error.what();
        throw Error(ErrorCode::usage, text.substr(0, text.find(':')) + " needs a value");
    } catch (const CLI::ConversionError& error) {
        // Flags alone are left to CLI11: "Could not convert: --half = maybe".
        const std::string text = error.what();
        throw Error(ErrorCode::usage, text.substr(text.find(": ") + 2) + ", wanted true or false");
    } catch (const CLI::ParseError& error) {
        throw Error(ErrorCode::usage, error.what());
    }
    app_->check_extras(app_->app.remaining());
    for (const std::string& name : app_->positionals)
        if (app_->app.get_option(name)->count() == 0)
            throw Error(ErrorCode::usage, fmt::format("no {} is given; cardioid --help tells more", name));
    return true;
}

}  // namespace cardioid::cli
