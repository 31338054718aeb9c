#pragma once
#include <string>
#include <vector>

#include "formats/openscad/syntax/lexer.hpp"

namespace cardioid::formats::openscad {

/// Arguments and values, with a stack of the lists that are open instead of recursion.
class ValueParser {
public:
    /// `token` is the parser's next token, which is taken and moved on.
    ValueParser(Lexer& lexer, AstBuilder& build, Token& token) : lexer_(lexer), build_(build), token_(token) {}

    /// [ name = ] value
    Argument argument();
    /// Throws Error: what stands there can only be part of a program, and how to evaluate one.
    [[noreturn]] void program(const Token& found) const;
    /// Throws Error for the token behind a value: an operator makes it a program.
    [[noreturn]] void unexpected(const std::string& wanted) const;

private:
    struct OpenList {
        std::size_t first_pending;
        Place place;
        bool range = false;
    };
    Value value();
    Value scalar();
    Value word(Token token, bool negative);
    Value close_list();
    bool separator();
    void skip_function();
    void advance() { token_ = lexer_.next(); }

    Lexer& lexer_;
    AstBuilder& build_;
    Token& token_;
    std::vector<OpenList> open_;
    std::vector<Value> pending_;  ///< finished elements of the open lists
    bool long_numbers_ = false;
    bool has_word_ = false;  ///< word_ was read before it was known to be a value
    Token word_;
};

}  // namespace cardioid::formats::openscad
