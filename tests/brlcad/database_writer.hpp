#pragma once
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace cardioid::test {

/// Writes small databases of version 5, big-endian, for tests.
class DatabaseWriter {
public:
    DatabaseWriter() { bytes_ = std::string("\x76\x01\x00\x00\x00\x00\x01\x35", 8); }

    static std::string whole(std::uint64_t value, int bytes) {
        std::string out;
        for (int i = bytes; i-- > 0;) out += static_cast<char>(value >> (8 * i) & 255);
        return out;
    }
    static std::string reals(const std::vector<double>& values) {
        std::string out;
        for (const double v : values) out += whole(std::bit_cast<std::uint64_t>(v), 8);
        return out;
    }
    /// A tree of members in postfix steps, without matrices.
    static std::string tree(const std::vector<std::string>& members, const std::string& steps) {
        std::string leaves;
        for (const std::string& name : members) leaves += name + '\0' + '\xFF';
        return whole(0, 1) + whole(0, 1) + whole(members.size(), 1) + whole(leaves.size(), 1) + whole(steps.size(), 1) +
               whole(1, 1) + leaves + steps;
    }

    /// `packing` is 1 where body is gzip's output.
    void add(int major, int minor, const std::string& name, const std::vector<std::string>& attributes,
             const std::string& body, int packing = 0) {
        std::string pairs;
        for (const std::string& text : attributes) pairs += text + '\0';
        if (!pairs.empty()) pairs += '\0';
        std::string rest = whole(name.size() + 1, 1) + name + '\0';
        if (!pairs.empty()) rest += whole(pairs.size(), 2) + pairs;
        if (!body.empty()) rest += whole(body.size(), 4) + body;
        const std::size_t length = (6 + 4 + rest.size() + 1 + 7) / 8 * 8;
        std::string object = whole(0x76, 1) + whole(0xA0, 1) + whole(pairs.empty() ? 0 : 0x60, 1) +
                             whole(body.empty() ? 0 : 0xA0U | static_cast<unsigned>(packing), 1) +
                             whole(static_cast<unsigned>(major), 1) + whole(static_cast<unsigned>(minor), 1) +
                             whole(length / 8, 4) + rest;
        object.resize(length - 1);
        bytes_ += object + '\x35';
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

/// A ball without a bite, in red, on a box that has its colour by number: the same model in each form.
inline std::string small_binary() {
    using W = DatabaseWriter;
    W out;
    out.add(2, 0, "_GLOBAL", {"title", "Bite", "units", "25.4", "regionid_colortable", "{7 9 0 255 0}"}, "");
    out.add(1, 3, "ball.s", {}, W::reals({0, 0, 10, 5, 0, 0, 0, 5, 0, 0, 0, 5}));
    out.add(1, 3, "bite.s", {}, W::reals({4, 0, 12, 3, 0, 0, 0, 3, 0, 0, 0, 3}));
    out.add(1, 4, "box.s", {},
            W::reals({-9, -9, 0, 9, -9, 0, 9, 9, 0, -9, 9, 0, -9, -9, 4, 9, -9, 4, 9, 9, 4, -9, 9, 4}));
    out.add(1, 31, "ball.r", {"region", "R", "rgb", "255/0/0", "oshader", "plastic {sh 20}"},
            W::tree({"ball.s", "bite.s"}, "\x01\x01\x04"));
    out.add(1, 31, "box.r", {"region", "R", "region_id", "8"}, W::tree({"box.s"}, "\x01"));
    out.add(1, 31, "all.g", {}, W::tree({"ball.r", "box.r"}, "\x01\x01\x02"));
    return out.bytes();
}

inline std::string small_text_v5() {
    return R"(title {Bite}
units in
put {ball.s} ell V {0 0 10} A {5 0 0} B {0 5 0} C {0 0 5}
put {bite.s} ell V {4 0 12} A {3 0 0} B {0 3 0} C {0 0 3}
put {box.s} arb8 V1 {-9 -9 0} V2 {9 -9 0} V3 {9 9 0} V4 {-9 9 0} V5 {-9 -9 4} V6 {9 -9 4} V7 {9 9 4} V8 {-9 9 4}
put {ball.r} comb region yes tree {- {l ball.s} {l bite.s}}
attr set {ball.r} {rgb} {255/0/0} {oshader} {plastic {sh 20}}
put {box.r} comb region yes tree {l box.s}
attr set {box.r} {region_id} {8}
put {all.g} comb region no tree {u {l ball.r} {l box.r}}
color 7 9 0 255 0
)";
}

inline std::string small_text_v4() {
    const std::string identity = " 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 0\n", zeros = " 0 0 0 0 0 0 0 0 0 0 0 0\n";
    return "I 4 v4\nBite\nS 19 ball.s 3 0 0 10 5 0 0 0 5 0 0 0 5" + zeros + "S 19 bite.s 3 4 0 12 3 0 0 0 3 0 0 0 3" +
           zeros +
           "S 20 box.s 1 -9 -9 0 18 0 0 18 18 0 0 18 0 0 0 4 18 0 4 18 18 4 0 18 4\n"
           "C Y ball.r 0 0 2 0 1 100 1 255 0 0 1 1 0\nplastic\nsh=20\nM u ball.s" +
           identity + "M - bite.s" + identity + "C Y box.r 8 0 1 0 1 100 0 0 0 0 0 0 0\nM u box.s" + identity +
           "C N all.g 0 0 2 0 0 0 0 0 0 0 0 0 0\nM u ball.r" + identity + "M u box.r" + identity + "m 0 7 9 0 255 0\n";
}

}  // namespace cardioid::test
