#pragma once
#include "tests/brlcad/database_writer.hpp"

namespace cardioid::test {

/// A database with solids whose bodies have counts and sizes of their own: what a damaged file may get wrong.
inline std::string counted_solids() {
    using W = DatabaseWriter;
    W out;
    const std::string square = W::reals({2, 0, 0, 0, 2, 0, -2, 0, 0, 0, -2, 0});
    std::string top, bottom, numbers, plates, sketch = W::reals({0, 0, 0, 1, 0, 0, 0, 1, 0});
    for (int i = 0; i < 4; ++i) top += W::reals({0, 0, 3}), bottom += W::reals({0, 0, -1});
    out.add(1, 5, "ars", {}, W::whole(3, 4) + W::whole(4, 4) + top + square + bottom);
    out.add(1, 8, "poly", {},
            W::whole(1, 4) + W::whole(3, 4) + W::reals({0, 0, 0, 1, 0, 0, 0, 1, 0}) + square.substr(0, 72));
    out.add(1, 36, "metaball", {}, W::whole(2, 4) + W::whole(2, 4) + W::reals({0.5, 1, 2, 3, 2, 3, 4, 5, 6, -1, 1}));
    for (int i = 0; i < 12; ++i) numbers += W::whole(static_cast<unsigned>(i * i), 2);
    out.add(9, 5, "numbers", {}, numbers);
    out.add(1, 25, "dsp", {},
            W::whole(4, 4) + W::whole(3, 4) + W::reals({2, 0, 0, 5, 0, 3, 0, 6, 0, 0, 0.5, 7, 0, 0, 0, 1}) +
                W::whole(0, 2) + "oanumbers" + '\0');
    out.add(1, 12, "ebm", {},
            std::string("src=o name=\"numbers\" w=4 n=3 d=2 mat=1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1") + '\0');
    out.add(1, 13, "vol", {}, std::string("file=\"gone\" w=2 n=2 d=3 lo=1 hi=9 size=1,2,3") + '\0');
    plates = W::whole(3, 4) + W::whole(1, 4) + std::string("\1\3\0", 3) + W::reals({0, 0, 0, 3, 0, 0, 0, 3, 0});
    for (const unsigned corner : {0U, 1U, 2U}) plates += W::whole(corner, 4);
    out.add(1, 30, "plates", {}, plates + W::reals({0.5}) + "01" + '\0');
    sketch += W::whole(4, 4) + W::whole(2, 4) + W::reals({0, 0, 2, 0, 2, 2, 0, 2});
    for (const unsigned x : {0x6C736567U, 2U, 0U, 0x6E757262U, 3U, 5U, 6U}) sketch += W::whole(x, 4);
    sketch += W::reals({0, 0, 0, 1, 1, 1}) + W::whole(3, 4) + W::whole(0, 4) + W::whole(1, 4) + W::whole(2, 4) +
              W::reals({1, 0.7, 1});
    out.add(1, 26, "sketch", {}, sketch);
    out.add(1, 27, "extrude", {}, W::reals({0, 0, 0, 0, 0, 5, 1, 0, 0, 0, 1, 0}) + W::whole(0, 4) + "sketch" + '\0');
    out.add(1, 29, "cline", {}, W::reals({0.5, 2, 1, 2, 3, 0, 3, 4}));
    return out.bytes();
}

inline std::string counted_solids_v4() {
    return "I 1 v4\nx\nA 5 ars 3 4 1 3\nB 6 1 1 0 0 3 0 0 0 0 0 0 0 0 0\nB 6 2 1 2 0 -3 0 2 -3 -2 0 -3 0 -2 -3\n"
           "B 6 3 1 0 0 -4 0 0 -4 0 0 -4 0 0 -4\nP poly\nQ 3 0 0 0 0 3 0 3 0 0\nQ 3 0 0 0 3 0 0 0 0 3\n"
           "t plates 3 1 0 3 1\n 0: 0 0 0\n 1: 3 0 0\n 2: 0 3 0\n 0: 0 1 2 0.5 1\n"
           "d sketch 0 0 0 1 0 0 0 1 0 4 2\n 0 0 2 0 2 2 0 2\n  L 0 2 0\n  N 0 3 5 6 3\n  K 0 0 0 1 1 1\n  V 0 1 2\n"
           "e extrude sketch 0 0 0 0 0 0 5 1 0 0 0 1 0\nc cline 1 2 3 0 3 4 2 0.5\n"
           "s ebm ebm file=\"gone\" w=4 n=3 d=2 mat=1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1\n"
           "s dsp dsp file=\"gone\" sm=0 w=4 n=3 stom=2,0,0,5,0,3,0,6,0,0,0.5,7,0,0,0,1\n";
}

inline std::string counted_solids_v5() {
    return "title {x}\nput ars ars NC 3 PPC 3 C0 {{0 0 3} {0 0 3} {0 0 3}} C1 {{2 0 0} {0 2 0} {-2 0 0}} C2 {{0 0 -1} "
           "{0 0 "
           "-1} {0 0 -1}}\nput meta metaball 1 0.5 {{1 2 3 2 3}{4 5 6 -1 1}}\nput star superell V {1 2 3} A {2 0 0} B "
           "{0 3 "
           "0} C {0 0 4} n 3 e 2.5\nput n binunif T S D {1 2 3 4 5 6}\nput dsp dsp src o name n w 3 n 2 cut a stom {2 "
           "0 0 5 "
           "0 3 0 6 0 0 0.5 7 0 0 0 1}\nput b binunif T C D {0 1 1 0}\nput ebm ebm src o name b w 2 n 2 d 3\nput vol "
           "vol src "
           "o name b w 2 n 1 d 2 lo 1 hi 2\nput plates bot mode plate orient no V {{0 0 0} {3 0 0} {0 3 0}} F {{0 1 "
           "2}} T "
           "{0.5} fm 01\nput s sketch V {0 0 0} A {1 0 0} B {0 1 0} VL {{0 0} {2 0} {2 2}} SL {{line S 0 E 2} {nurb O "
           "3 T 5 "
           "K {0 0 0 1 1 1} P {0 1 2} W {1 0.7 1}}}\nput e extrude V {0 0 0} H {0 0 5} A {1 0 0} B {0 1 0} S s\n";
}

}  // namespace cardioid::test
