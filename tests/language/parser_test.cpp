#include "formats/openscad/syntax/parser.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "formats/openscad/syntax/printer.hpp"

using namespace cardioid::formats::openscad;

namespace {

Ast parsed(const std::string& text) { return parse(text, "t.csg"); }

/// The only argument of the only call.
Value only_value(const Ast& ast) { return ast.arguments.at(0).value; }

double only_number(const std::string& spelled) {
    const Ast ast = parsed("f(" + spelled + ");");
    EXPECT_EQ(only_value(ast).kind, ValueKind::number) << spelled;
    return ast.numbers.at(0);
}

std::string only_text(const std::string& spelled) {
    const Ast ast = parsed("f(" + spelled + ");");
    EXPECT_EQ(only_value(ast).kind, ValueKind::text);
    return ast.texts.at(only_value(ast).first);
}

}  // namespace

TEST(Parser, ReadsEverySpellingOfANumber) {
    EXPECT_EQ(only_number("1"), 1);
    EXPECT_EQ(only_number(".5"), 0.5);
    EXPECT_EQ(only_number("1."), 1);
    EXPECT_EQ(only_number("1.e2"), 100);
    EXPECT_EQ(only_number("1e-07"), 1e-7);
    EXPECT_EQ(only_number("1.23457e-6"), 1.23457e-6);
    EXPECT_EQ(only_number("1e+10"), 1e10);
    EXPECT_EQ(only_number("1.5E+22"), 1.5e22);
    EXPECT_EQ(only_number("-+-3"), 3);
    EXPECT_EQ(only_number("- 3"), -3);
    EXPECT_EQ(only_number("1e-400"), 0);
    EXPECT_EQ(only_number("007"), 7);
}

TEST(Parser, ReadsInfiniteNumbersAndNan) {
    EXPECT_EQ(only_number("inf"), HUGE_VAL);
    EXPECT_EQ(only_number("-inf"), -HUGE_VAL);
    EXPECT_TRUE(std::isnan(only_number("nan")));
    EXPECT_TRUE(std::isnan(only_number("-nan")));
}

TEST(Parser, TakesWordsThatBeginWithADigitAsIdentifiers) {
    for (const char* word : {"0x10", "1_000", "12abc", "round"})
        EXPECT_EQ(only_value(parsed(std::string("f(") + word + ");")).kind, ValueKind::identifier) << word;
}

TEST(Parser, ReadsTruthValuesAndUndef) {
    const Ast ast = parsed("f(true, false, undef);");
    EXPECT_EQ(ast.arguments[0].value, AstBuilder::boolean(true));
    EXPECT_EQ(ast.arguments[1].value, AstBuilder::boolean(false));
    EXPECT_EQ(ast.arguments[2].value.kind, ValueKind::undef);
}

TEST(Parser, ResolvesEscapesInTexts) {
    EXPECT_EQ(only_text(R"("a\"b\\c\n\t\r")"), "a\"b\\c\n\t\r");
    EXPECT_EQ(only_text(R"("\x41\u00e9\U01F600")"), "A\xC3\xA9\xF0\x9F\x98\x80");
    EXPECT_EQ(only_text(R"("\xe9 \q")"), "\\xe9 \\q");  // \x stops at 7F, \q is no escape
    EXPECT_EQ(only_text("\"two\nlines\""), "twolines");
}

TEST(Parser, RecoversUnescapedStringsOfText) {
    const Ast ast = parsed("text(text = \"q\"uo\\te\", size = 10, font = \"\", $fn = 0);");
    EXPECT_EQ(ast.texts.at(ast.arguments[0].value.first), "q\"uo\\te");
    EXPECT_EQ(ast.arguments.size(), 4U);
    const Ast plain = parsed("text(text = \"a\\\"b\", size = 10);");
    EXPECT_EQ(plain.texts.at(plain.arguments[0].value.first), "a\"b");
}

TEST(Parser, KeepsListsOfNumbersFlat) {
    const Ast ast = parsed("f([1, 2.5, -3], [], [[1, 2], [3]], [1, \"a\", [2]]);");
    EXPECT_EQ(ast.arguments[0].value, (Value{ValueKind::numbers, 0, 3}));
    EXPECT_EQ(ast.arguments[1].value, (Value{ValueKind::numbers, 0, 0}));
    EXPECT_EQ(ast.arguments[2].value.kind, ValueKind::list);
    EXPECT_EQ(ast.values_of(ast.arguments[2].value)[1], (Value{ValueKind::numbers, 5, 1}));
    EXPECT_EQ(ast.arguments[3].value.kind, ValueKind::list);
}

TEST(Parser, AcceptsATrailingCommaInAList) {
    EXPECT_EQ(only_value(parsed("f([1,2,]);")), (Value{ValueKind::numbers, 0, 2}));
}

TEST(Parser, ReadsRanges) {
    const Ast ast = parsed("f([0 : 2], [0:1:5]);");
    EXPECT_EQ(ast.arguments[0].value.kind, ValueKind::range);
    EXPECT_EQ(ast.arguments[0].value.count, 2U);
    EXPECT_EQ(ast.arguments[1].value.count, 3U);
}

TEST(Parser, SkipsFunctionLiterals) {
    const Ast ast = parsed("polyhedron(points = function(x) (x + [1, \")\"][0]), faces = 1);");
    EXPECT_EQ(ast.arguments[0].value.kind, ValueKind::function);
    EXPECT_EQ(ast.arguments.size(), 2U);
}

TEST(Parser, SkipsCommentsSpaceAndNoBreakSpace) {
    const Ast ast = parsed("\xEF\xBB\xBF// one\n/* two * / */ cube(/*x*/1)\xC2\xA0; // end");
    EXPECT_EQ(ast.calls.size(), 1U);
}

TEST(Parser, AcceptsLeadingAndDoubleCommasBetweenArguments) {
    EXPECT_EQ(parsed("cube(, 1,, center = true);").arguments.size(), 2U);
}

TEST(Parser, ReadsTheThreeFormsOfACall) {
    const Ast ast = parsed("a(); b() { c(); d(); } e() f() g(); ;;");
    EXPECT_EQ(ast.roots.size(), 3U);
    EXPECT_EQ(ast.calls[ast.roots[1]].child_count, 2U);
    const Call& e = ast.calls[ast.roots[2]];
    EXPECT_EQ(e.child_count, 1U);
    EXPECT_EQ(ast.name(ast.calls[ast.children_of(e)[0]]), "f");
}

TEST(Parser, ReadsModifiersInAnyOrderWithSpaceBetween) {
    const Ast ast = parsed("%#a(); # /* c */ % b(); !*c();");
    EXPECT_EQ(ast.calls[0].modifiers, Modifier::background | Modifier::highlight);
    EXPECT_EQ(ast.calls[1].modifiers, Modifier::background | Modifier::highlight);
    EXPECT_EQ(ast.calls[2].modifiers, Modifier::only | Modifier::disabled);
}

TEST(Parser, PassesOverItsOwnLibrary) {
    EXPECT_EQ(parsed("use <cardioid.scad>\ninclude <lib/cardioid.scad>;\ncube();").calls.size(), 1U);
}

TEST(Parser, KnowsLongFractionsFromThoseOpenscadPrints) {
    for (const char* printed : {"0.707107", "1.23457e+06", "1599999999", "100000.0", "0.00000012"})
        EXPECT_FALSE(parsed(std::string("f(") + printed + ");").arguments[0].long_numbers) << printed;
    for (const char* own : {"0.7071068", "1.234567e+06", "[1, [0.1234567]]"})
        EXPECT_TRUE(parsed(std::string("f(") + own + ");").arguments[0].long_numbers) << own;
}

TEST(Parser, TellsPlacesByLineAndColumn) {
    const Ast ast = parsed("a();\n\n  b();");
    EXPECT_EQ(ast.where(ast.calls[1].place), "t.csg:3:3");
}

TEST(Printer, BringsBackWhatWasParsed) {
    const char* text =
        "%#a(x = [[1, 2], [true, \"t\\n\\\"\\\\\", [undef, [1e-300, nan, -inf]]]], round, [0 : 2 : 10], "
        "f = function(x) x);\n"
        "b() { c(1.0000000000000002); d() { } } *e() !f();";
    const Ast ast = parsed(text);
    const Ast again = parsed(print(ast));
    EXPECT_TRUE(equal(ast, again)) << print(ast);
    EXPECT_FALSE(equal(ast, parsed("a();")));
}

TEST(Printer, WritesOpenscadsOwnLayout) {
    const std::string text =
        "group() {\n%\tcube(size = [1, 2, 3], center = false);\n\tmultmatrix([[1, 0, 0, 0.5], [0, 1, 0, 0]]) {\n"
        "\t\tsphere($fn = 0, r = 1e-07);\n\t}\n}\ngroup();\n";
    EXPECT_EQ(print(parsed(text)), text);
}
